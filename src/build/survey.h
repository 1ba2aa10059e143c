/* SPDX-License-Identifier: MIT */
/* Where the large jumps are: rows end there whatever the rows before, so the stretches between them can be sampled independently. */
#ifndef BUILD_SURVEY_H
#define BUILD_SURVEY_H

#include "build/crew.h"
#include "build/invert.h"

#define SURVEY_MOST 48 /* intervals under way, jumps, samples kept */

/* A jump so large that no row crosses it, inverted: bracket.after is certified right after bracket.low. */
typedef struct landmark {
    bracket bracket;
    kept_path path; /* at bracket.low */
} landmark;

/* A stretch of departures under way. */
typedef struct stretch {
    sample low;
    sample high;
    unsigned halvings;
    int suspected; /* nearly all of its rise is a jump's: find it */
    tdsp_status status;
    sample middle;  /* what its task found, */
    bracket bracket; /* or this */
    kept_path path;
} stretch;

typedef struct survey {
    stretch stretches[SURVEY_MOST];
    size_t stretch_count;
    landmark landmarks[SURVEY_MOST]; /* by departure */
    size_t landmark_count;
    sample known[SURVEY_MOST]; /* by departure */
    size_t known_count;
    const crew *crew;
} survey;

/* All of it; *out is the caller's, to be released in any case with the sampler's allocator. */
tdsp_status survey_make(survey *out, const crew *c);
void survey_release(survey *self, const tdsp_allocator *allocator);

#endif
