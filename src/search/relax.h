/* SPDX-License-Identifier: MIT */
/*
 * Relaxation: the shortest path among some of the discs is a lower bound on the one among all. So start with few, find the path,
 * add the discs that it runs into, and repeat: a path that runs into none is the shortest of all, and where some discs alone leave no
 * way, all of them leave none.
 *
 * The work grows with what the path meets, not with the scene. Where it meets a large part of the scene, or rounds take long, the whole is searched: at once when
 * scouts find a path, otherwise after some more patience. Each question starts afresh, so that an answer does not depend on the questions before it.
 */
#ifndef SEARCH_RELAX_H
#define SEARCH_RELAX_H

#include "search/engine.h"

/* How all discs are to be asked. */
typedef enum relax_stage {
    RELAX_LAST,   /* whatever it costs */
    RELAX_SCOUTED /* scouts go first, and the answer may be TDSP_NO_ANSWER when they are lost */
} relax_stage;

typedef struct relaxation {
    const tdsp_scene *scene;
    relax_stage stage;
    disc_set working;
    unsigned char *is_member; /* for each of the scene's discs */
    uint32_t *members;
    uint32_t member_count;
    uint64_t rounds; /* questions put to a part of the discs, so far */
} relaxation;

tdsp_status relax_create(relaxation *self, const tdsp_scene *scene);
void relax_free(relaxation *self);
uint64_t relax_bytes(const relaxation *self);

/*
 * A question put to a set of discs. It leaves in the engine the path of its answer, or no path when there is no answer. Its answer among some
 * discs must be at least as good as among more of them. TDSP_NO_ANSWER: it gave up.
 */
typedef tdsp_status (*relax_question)(void *ctx, const disc_set *set);

/* Ask among all the scene's discs, by way of as few as possible. */
tdsp_status relax_run(relaxation *self, disc_engine *engine, relax_question ask, void *ctx);

/* The user's index of a disc of a set. */
uint32_t relax_given(const relaxation *self, const disc_set *set, uint32_t disc);

#endif
