/* SPDX-License-Identifier: MIT */
/*
 * Names and sentences of the status codes.
 *
 * Each function is one switch over the enumeration without a default, so that a code added to the header and
 * forgotten here is a compiler warning; values outside the enumeration fall through to "unknown".
 */
#include "tdsp/status.h"

int tdsp_status_is_answer(tdsp_status status)
{
    return (unsigned)status < 16;
}

const char *tdsp_status_name(tdsp_status status)
{
    switch (status) {
    case TDSP_OK: return "ok";
    case TDSP_SOURCE_COVERED: return "source_covered";
    case TDSP_DESTINATION_COVERED: return "destination_covered";
    case TDSP_CUT_OFF: return "cut_off";
    case TDSP_ARRIVAL_TOO_EARLY: return "arrival_too_early";
    case TDSP_HORIZON: return "horizon";
    case TDSP_OUTSIDE_TABLE: return "outside_table";
    case TDSP_UNREACHABLE: return "unreachable";
    case TDSP_INVALID_ARGUMENT: return "invalid_argument";
    case TDSP_BUFFER_TOO_SMALL: return "buffer_too_small";
    case TDSP_NO_ANSWER: return "no_answer";
    case TDSP_NOT_SUPPORTED: return "not_supported";
    case TDSP_NEEDS_HORIZON: return "needs_horizon";
    case TDSP_TOO_MANY_ROWS: return "too_many_rows";
    case TDSP_BAD_SCENE: return "bad_scene";
    case TDSP_BAD_MAGIC: return "bad_magic";
    case TDSP_BAD_VERSION: return "bad_version";
    case TDSP_BAD_LENGTH: return "bad_length";
    case TDSP_BAD_CHECKSUM: return "bad_checksum";
    case TDSP_BAD_TABLE: return "bad_table";
    case TDSP_BAD_PATH: return "bad_path";
    case TDSP_STALE_TABLE: return "stale_table";
    case TDSP_BAD_ORACLE: return "bad_oracle";
    case TDSP_SHRINKS: return "shrinks";
    case TDSP_NO_MEMORY: return "no_memory";
    case TDSP_CANCELLED: return "cancelled";
    case TDSP_FAILED: return "failed";
    }
    return "unknown";
}

const char *tdsp_status_text(tdsp_status status)
{
    switch (status) {
    case TDSP_OK: return "Done";
    case TDSP_SOURCE_COVERED: return "The source lies inside a disc at the departure";
    case TDSP_DESTINATION_COVERED: return "The destination is covered before it can be reached";
    case TDSP_CUT_OFF: return "Growing discs close every way to the destination";
    case TDSP_ARRIVAL_TOO_EARLY: return "No departure arrives that early";
    case TDSP_HORIZON: return "The departure is after the horizon";
    case TDSP_OUTSIDE_TABLE: return "The table says nothing about this departure";
    case TDSP_UNREACHABLE: return "There is no way to the destination";
    case TDSP_INVALID_ARGUMENT: return "An argument is missing, not a number or out of its range";
    case TDSP_BUFFER_TOO_SMALL: return "The buffer is too small for the result";
    case TDSP_NO_ANSWER: return "There is no such answer";
    case TDSP_NOT_SUPPORTED: return "This oracle, guarantee, table or time is not supported";
    case TDSP_NEEDS_HORIZON: return "Nothing ever ends the departures, so a horizon is needed";
    case TDSP_TOO_MANY_ROWS: return "The guarantee needs more rows than are allowed";
    case TDSP_BAD_SCENE: return "A number of the scene is out of its range";
    case TDSP_BAD_MAGIC: return "These bytes are not a table";
    case TDSP_BAD_VERSION: return "The table has a format version that this library cannot read";
    case TDSP_BAD_LENGTH: return "The table is shorter or longer than it says";
    case TDSP_BAD_CHECKSUM: return "The table's bytes were changed";
    case TDSP_BAD_TABLE: return "The table contradicts its format";
    case TDSP_BAD_PATH: return "The legs of a path do not join or run backwards in time";
    case TDSP_STALE_TABLE: return "The table was built for another scene";
    case TDSP_BAD_ORACLE: return "The oracle broke what it declared";
    case TDSP_SHRINKS: return "The answer needs a time at which a disc's radius would shrink";
    case TDSP_NO_MEMORY: return "There is not enough memory";
    case TDSP_CANCELLED: return "Cancelled";
    case TDSP_FAILED: return "A callback failed";
    }
    return "Unknown status";
}
