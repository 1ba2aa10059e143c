/* SPDX-License-Identifier: MIT */
/*
 * The conformance kit: does an oracle keep what tdsp/oracle.h asks of it? Run it over an oracle of your own before trusting a table.
 *
 * The kit asks, and compares the answers with each other: it knows nothing of the world behind them. What it reports is broken; what it does not
 * report has not been seen broken at the departures it looked at. docs/oracles.md says what each rule is for.
 */
#ifndef TDSP_ORACLE_CHECK_H
#define TDSP_ORACLE_CHECK_H

#include "tdsp/oracle.h"
#include "tdsp/status.h"
#include "tdsp/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The rules, in the order in which they are looked at. Values are part of the ABI; new rules come at the end. */
typedef enum tdsp_oracle_rule {
    TDSP_RULE_DECLARED = 0,       /* members are present and in their ranges */
    TDSP_RULE_ERROR = 1,          /* no callback fails */
    TDSP_RULE_STATUS = 2,         /* answers are those that the question can have */
    TDSP_RULE_ARRIVAL = 3,        /* arrivals are finite and not before their departures */
    TDSP_RULE_REPEATABLE = 4,     /* the same question has the same answer, to the bit */
    TDSP_RULE_ORDER = 5,          /* travel times, or arrivals, never decrease */
    TDSP_RULE_NO_WAY = 6,         /* where there is no way there is none later */
    TDSP_RULE_PATH_FORM = 7,      /* paths have memory behind them, and legs are well formed */
    TDSP_RULE_PATH_JOINS = 8,     /* each leg starts when and where the one before ends */
    TDSP_RULE_PATH_ENDS = 9,      /* legs start at the departure and end at the arrival */
    TDSP_RULE_PATH_REPEATABLE = 10, /* the same question has the same path, to the bit */
    TDSP_RULE_DEPARTURE = 11,     /* latest departures are numbers in their range */
    TDSP_RULE_TOO_EARLY = 12,     /* arrival_too_early is said before A(0), and only there */
    TDSP_RULE_BOTH_WAYS = 13,     /* there is a way backwards exactly where there is one forwards */
    TDSP_RULE_LATE = 14,          /* a latest departure arrives in time */
    TDSP_RULE_EARLY = 15,         /* nobody who leaves after a latest departure arrives in time */
    TDSP_RULE_ARRIVES = 16,       /* the arrival that comes with a latest departure is A of it */
    TDSP_RULE_WITHIN = 17,        /* the two bounds of an answer within a share are no farther apart than that */
    TDSP_RULE_BOUNDS = 18,        /* ... and A lies between them */
    TDSP_RULE_REASON = 19,        /* the last reason is one of the four */
    TDSP_RULE_SLOW = 20           /* no call takes longer than the limit */
} tdsp_oracle_rule;

#define TDSP_ORACLE_RULES 21 /* how many rules there are, and numbers of rules end below it */

/** Which member of tdsp_oracle. */
typedef enum tdsp_oracle_callback {
    TDSP_ORACLE_MEMBERS = 0, /* what is declared */
    TDSP_ORACLE_EARLIEST_ARRIVAL = 1,
    TDSP_ORACLE_LATEST_DEPARTURE = 2,
    TDSP_ORACLE_PATH = 3,
    TDSP_ORACLE_LAST_REASON = 4,
    TDSP_ORACLE_EARLIEST_ARRIVAL_WITHIN = 5,
    TDSP_ORACLE_LATEST_DEPARTURE_BETWEEN = 6
} tdsp_oracle_callback;

/** A rule seen broken. NaN stands for a number that means nothing there. docs/oracles.md has the meaning of each for each rule. */
typedef struct tdsp_oracle_finding {
    tdsp_oracle_rule rule;         /* which is broken */
    tdsp_oracle_callback callback; /* by which member */
    tdsp_status status; /* what the callback returned */
    double asked;       /* the departure asked about; of the two reverse callbacks the arrival */
    double answered;    /* of the two reverse callbacks the departure answered */
    double other;       /* the departure that the answer does not go together with, or the share asked for */
    double seen;        /* the number that is wrong; of RULE_SLOW the seconds */
    double expected;    /* what it is compared with: a bound, or the answer before; infinite where no way was expected */
} tdsp_oracle_finding;

#define TDSP_ORACLE_FINDINGS 64 /* room for findings */
#define TDSP_ORACLE_EXAMPLES 3 /* findings kept of each rule */

/** What came out. */
typedef struct tdsp_oracle_findings {
    uint64_t looked_at;                 /* bit 1 << rule: the rule was looked at */
    uint64_t broken;                    /* bit 1 << rule: the rule is broken */
    uint64_t times[TDSP_ORACLE_RULES];  /* how often each was seen broken */
    size_t count;                       /* findings in `found` */
    tdsp_oracle_finding found[TDSP_ORACLE_FINDINGS]; /* the first few of each rule, in the order in which they were seen */
    uint64_t calls;                     /* callbacks called */
    double last_departure;              /* the last that was seen to have a way; negative when none has */
    double slowest;                     /* seconds of the slowest call; 0 without a clock */
    int complete;                       /* 0 when options.calls ended it */
} tdsp_oracle_findings;

/** How much to look at. Initialise with tdsp_oracle_check_options_init(), then set members. */
typedef struct tdsp_oracle_check_options {
    size_t size;         /* sizeof(tdsp_oracle_check_options), set by tdsp_oracle_check_options_init() */
    double horizon;      /* departures are looked at up to this; infinity: to the last one, or, where nothing seems to end them, to 1024 times the
                            larger of T(0) and the oracle's time_scale */
    uint32_t departures; /* how many are spread over them, 2 to 1,000,000; questions to each other callback are as many */
    uint64_t calls;      /* at most so many callbacks are called */
    uint64_t seed;       /* of the choice of departures */
    double (*clock)(void *ctx); /* seconds since whenever; NULL: calls are not timed */
    void *clock_ctx;     /* handed to clock */
    double seconds;      /* how long a call may take; infinity for any */
} tdsp_oracle_check_options;

/** Defaults: no horizon, 100 departures, 100,000 calls, seed 1, no clock, no limit. Since 0.1. */
TDSP_API void tdsp_oracle_check_options_init(tdsp_oracle_check_options *options);

/**
 * Exercise an oracle.
 *
 * @param oracle     any; what it declares is looked at too. It is called from this thread, one call at a time
 * @param options    see above; NULL for the defaults
 * @param allocator  for the answers to be compared; NULL for the C library's
 * @param out        receives what was found; filled when TDSP_OK or TDSP_BAD_ORACLE is returned, else untouched
 * @return TDSP_OK when nothing is wrong; TDSP_BAD_ORACLE when something is; TDSP_INVALID_ARGUMENT; TDSP_NO_MEMORY
 *
 * Everything else is held against the forward function: where earliest_arrival breaks one of the rules 1 to 6, rules 11 to 19 are not looked at. About ten calls
 * for each departure with all callbacks, some hundred more where A jumps and at its end, and O(calls^2) comparisons at worst. Since 0.1.
 */
TDSP_API tdsp_status tdsp_oracle_check(const tdsp_oracle *oracle, const tdsp_oracle_check_options *options, const tdsp_allocator *allocator,
                                       tdsp_oracle_findings *out);

/** A finding as one English sentence without its numbers and without a full stop. Never NULL; static storage; any thread. Since 0.1. */
TDSP_API const char *tdsp_oracle_finding_text(const tdsp_oracle_finding *finding);

/** The rule's name in lower case, e.g. "path_joins"; "unknown" for any other value. As above. Since 0.1. */
TDSP_API const char *tdsp_oracle_rule_name(tdsp_oracle_rule rule);

/** The member's name, e.g. "earliest_arrival"; "members" for what is declared; "unknown" for any other value. As above. Since 0.1. */
TDSP_API const char *tdsp_oracle_callback_name(tdsp_oracle_callback callback);

#ifdef __cplusplus
}
#endif

#endif
