/* SPDX-License-Identifier: MIT */
/*
 * Outcomes of libtdsp's functions: one list for answers, mistakes of the caller, bad data and the system.
 *
 * Values are part of the ABI: a value is never reused, new ones are added inside their family.
 */
#ifndef TDSP_STATUS_H
#define TDSP_STATUS_H

#include "tdsp/export.h"

#ifdef __cplusplus
extern "C" {
#endif

/** What every function that can fail returns: success, an answer without a number, or an error. Values are never used again. */
typedef enum tdsp_status {
    TDSP_OK = 0,

    /* Answers (1 to 15): the question was understood, and this is why there is no number. */
    TDSP_SOURCE_COVERED = 1,      /* the source lies inside a disc at the departure */
    TDSP_DESTINATION_COVERED = 2, /* the way is open, but longer than the destination stays free */
    TDSP_CUT_OFF = 3,             /* growing discs close every way to the destination */
    TDSP_ARRIVAL_TOO_EARLY = 4,   /* the arrival asked for is before A(0) */
    TDSP_HORIZON = 5,             /* the departure is after the user's horizon */
    TDSP_OUTSIDE_TABLE = 6,       /* the table says nothing about this departure */
    TDSP_UNREACHABLE = 7,         /* a user's oracle found no way */

    /* Mistakes of the caller (16 to 31). */
    TDSP_INVALID_ARGUMENT = 16, /* a null pointer, NaN, infinity or a value out of its stated range */
    TDSP_BUFFER_TOO_SMALL = 17, /* the buffer's capacity is below the required count, which was returned */
    TDSP_NO_ANSWER = 18,        /* there is no last answer with a path */
    TDSP_NOT_SUPPORTED = 19,    /* this oracle, guarantee or table cannot do that, or a time or a disc is too far away */
    TDSP_NEEDS_HORIZON = 20,    /* no disc ever ends the departures, and no horizon was given */
    TDSP_TOO_MANY_ROWS = 21,    /* the guarantee needs more than TDSP_MAX_ROWS rows */

    /* Bad data (32 to 63). */
    TDSP_BAD_SCENE = 32,     /* a number of the scene is out of its range */
    TDSP_BAD_MAGIC = 33,     /* these bytes are not a table */
    TDSP_BAD_VERSION = 34,   /* a table of a newer major format version */
    TDSP_BAD_LENGTH = 35,    /* shorter or longer than the header says */
    TDSP_BAD_CHECKSUM = 36,  /* the bytes were changed */
    TDSP_BAD_TABLE = 37,     /* offsets, order, ranges or finiteness are wrong */
    TDSP_BAD_PATH = 38,      /* legs that do not join, or run backwards in time */
    TDSP_STALE_TABLE = 39,   /* the table was built for another scene */
    TDSP_BAD_ORACLE = 40,    /* the oracle broke what it declared, e.g. travel times that decrease */
    TDSP_SHRINKS = 41,       /* the question reaches to a time at which a disc's radius shrinks */

    /* The system (64 and on). */
    TDSP_NO_MEMORY = 64, /* the allocator returned NULL */
    TDSP_CANCELLED = 65, /* a progress callback asked to stop */
    TDSP_FAILED = 66     /* a callback failed without saying more */
} tdsp_status;

/** Is this an answer (0 to 15) rather than an error? Pure; any thread. Since 0.1. */
TDSP_API int tdsp_status_is_answer(tdsp_status status);

/**
 * The status's stable name in lower case, e.g. "cut_off" (the word of the JSON output); "unknown" for any
 * other value. Never NULL; static storage; any thread. Since 0.1.
 */
TDSP_API const char *tdsp_status_name(tdsp_status status);

/** One English sentence without a full stop, for a message to a person. As tdsp_status_name(). Since 0.1. */
TDSP_API const char *tdsp_status_text(tdsp_status status);

#ifdef __cplusplus
}
#endif

#endif
