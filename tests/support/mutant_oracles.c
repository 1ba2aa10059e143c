/* SPDX-License-Identifier: MIT */
/* Each mutant's callback asks the toy and then changes one thing. The toy is a mutant's first member, so one context serves both. */
#include "support/mutant_oracles.h"

#include <math.h>
#include <string.h>

/* ------------------------------------------------------------------------------------------- spoilt earliest_arrival */

#define SOUND_ARRIVAL(m) m->sound.earliest_arrival(m->sound.ctx, departure, arrival)

#define SPOILT_ARRIVAL(name, statements)                                                                                         \
    static tdsp_status name(void *ctx, double departure, double *arrival)                                                        \
    {                                                                                                                            \
        mutant *m = ctx;                                                                                                         \
        tdsp_status status = SOUND_ARRIVAL(m);                                                                                   \
        m->calls++;                                                                                                              \
        statements;                                                                                                              \
        return status;                                                                                                           \
    }

SPOILT_ARRIVAL(arrival_fails, if (m->calls % 7 == 0) status = TDSP_FAILED)
SPOILT_ARRIVAL(arrival_fails_at_first, if (m->calls == 1) status = TDSP_FAILED)
SPOILT_ARRIVAL(arrival_too_early, if (m->calls % 7 == 0) status = TDSP_ARRIVAL_TOO_EARLY)
SPOILT_ARRIVAL(arrival_unknown, if (m->calls % 7 == 0) status = (tdsp_status)99)
SPOILT_ARRIVAL(arrival_negative_status, if (m->calls % 7 == 0) status = (tdsp_status)-3)
SPOILT_ARRIVAL(arrival_nan, if (departure > 12) *arrival = NAN)
SPOILT_ARRIVAL(arrival_infinite, if (departure > 12) *arrival = INFINITY)
SPOILT_ARRIVAL(arrival_before, if (departure > 12) *arrival = departure - 1e-9)
SPOILT_ARRIVAL(arrival_wobbles, if (m->calls % 2 == 0) *arrival = nextafter(*arrival, INFINITY))
SPOILT_ARRIVAL(arrival_dips, if (departure > 12 && departure < 14) *arrival -= 1.5)
SPOILT_ARRIVAL(arrival_creeps, *arrival -= 0.3 * departure)
SPOILT_ARRIVAL(arrival_returns, if (departure > 12 && departure < 14) status = TDSP_UNREACHABLE)
SPOILT_ARRIVAL(arrival_slow, m->now += departure > 12 ? 5.0 : 0.001)

/* ------------------------------------------------------------------------------------------ spoilt latest_departure */

#define SPOILT_DEPARTURE(name, statements)                                                                                       \
    static tdsp_status name(void *ctx, double arrival, double *departure)                                                        \
    {                                                                                                                            \
        mutant *m = ctx;                                                                                                         \
        tdsp_status status = m->sound.latest_departure(m->sound.ctx, arrival, departure);                                        \
        m->calls++;                                                                                                              \
        statements;                                                                                                              \
        return status;                                                                                                           \
    }

SPOILT_DEPARTURE(departure_fails, if (m->calls % 7 == 0) status = TDSP_NO_ANSWER)
SPOILT_DEPARTURE(departure_beyond_table, if (m->calls % 7 == 0) status = TDSP_OUTSIDE_TABLE)
SPOILT_DEPARTURE(departure_wobbles, if (m->calls % 2 == 0) *departure = nextafter(*departure, 0))
/* The first round has fewer questions than this. */
SPOILT_DEPARTURE(departure_changes_its_mind, if (m->calls > 121) status = TDSP_ARRIVAL_TOO_EARLY)
SPOILT_DEPARTURE(departure_nan, *departure = NAN)
SPOILT_DEPARTURE(departure_negative, *departure = -1)
SPOILT_DEPARTURE(departure_infinite, if (isfinite(arrival)) *departure = INFINITY)
SPOILT_DEPARTURE(departure_says_too_early, if (arrival < 7) status = TDSP_ARRIVAL_TOO_EARLY)
SPOILT_DEPARTURE(departure_is_never_late_enough, if (isinf(arrival)) status = TDSP_ARRIVAL_TOO_EARLY)
SPOILT_DEPARTURE(departure_never_too_early, if (status != TDSP_OK) *departure = 0; status = TDSP_OK)
SPOILT_DEPARTURE(departure_has_no_way, if (arrival > 20) status = TDSP_CUT_OFF)
SPOILT_DEPARTURE(departure_late, *departure += 0.1)
SPOILT_DEPARTURE(departure_early, *departure = fmax(*departure - 0.1, 0))
/* The mistake that everybody makes once: within a jump, a path that arrives exactly at `arrival`, and there is none. */
SPOILT_DEPARTURE(departure_misses_jumps, if (arrival > 16 && arrival < 18) *departure = 9)
SPOILT_DEPARTURE(departure_ends_too_soon, if (isinf(arrival)) *departure = 29)
SPOILT_DEPARTURE(departure_never_ends, if (isinf(arrival)) *departure = INFINITY)

/* ---------------------------------------------------------------------------------- spoilt latest_departure_between */

#define SPOILT_BETWEEN(name, statements)                                                                                         \
    static tdsp_status name(void *ctx, double arrival, double after, double before, double *departure, double *arrives)          \
    {                                                                                                                            \
        mutant *m = ctx;                                                                                                         \
        tdsp_status status = m->sound.latest_departure_between(m->sound.ctx, arrival, after, before, departure, arrives);        \
        m->calls++;                                                                                                              \
        statements;                                                                                                              \
        return status;                                                                                                           \
    }

SPOILT_BETWEEN(between_fails, if (m->calls % 7 == 0) status = TDSP_NO_MEMORY)
SPOILT_BETWEEN(between_too_early, if (m->calls % 7 == 0) status = TDSP_ARRIVAL_TOO_EARLY)
SPOILT_BETWEEN(between_wobbles, if (m->calls % 2 == 0) *departure = fmax(nextafter(*departure, 0), after))
SPOILT_BETWEEN(between_nan, *departure = NAN)
SPOILT_BETWEEN(between_arrives_wobbles, if (m->calls % 2 == 0) *arrives = nextafter(*arrives, 0))
SPOILT_BETWEEN(between_before, *departure = after - 1)
SPOILT_BETWEEN(between_after, if (isfinite(before)) *departure = before + 1)
SPOILT_BETWEEN(between_late, *departure = fmin(*departure + 0.1, before); *arrives = (double)toy_arrival(&m->toy, *departure))
SPOILT_BETWEEN(between_early, *departure = fmax(*departure - 0.1, after); *arrives = (double)toy_arrival(&m->toy, *departure))
SPOILT_BETWEEN(between_arrives_later, *arrives += 0.5)
SPOILT_BETWEEN(between_arrives_nowhere, *arrives = NAN)

/* ----------------------------------------------------------------------------------- spoilt earliest_arrival_within */

#define SPOILT_WITHIN(name, statements)                                                                                          \
    static tdsp_status name(void *ctx, double departure, double delta, double *arrival, double *lower)                           \
    {                                                                                                                            \
        mutant *m = ctx;                                                                                                         \
        tdsp_status status = m->sound.earliest_arrival_within(m->sound.ctx, departure, delta, arrival, lower);                   \
        m->calls++;                                                                                                              \
        statements;                                                                                                              \
        return status;                                                                                                           \
    }

SPOILT_WITHIN(within_fails, if (m->calls % 7 == 0) status = TDSP_NOT_SUPPORTED)
SPOILT_WITHIN(within_horizon, if (m->calls % 7 == 0) status = TDSP_HORIZON)
SPOILT_WITHIN(within_nan, *lower = NAN)
SPOILT_WITHIN(within_infinite, *arrival = INFINITY)
SPOILT_WITHIN(within_wobbles, if (m->calls % 2 == 0) *lower = nextafter(*lower, 0))
/* Every fourth question is asked twice, from the first on. */
SPOILT_WITHIN(within_arrival_wobbles, if (m->calls % 5 == 2) *arrival = nextafter(*arrival, 0))
SPOILT_WITHIN(within_changes_its_mind, if (m->calls % 5 == 2) status = TDSP_CUT_OFF)
SPOILT_WITHIN(within_wide, *arrival += 0.01)
SPOILT_WITHIN(within_crossed, *lower = *arrival + 1)
SPOILT_WITHIN(within_high, *lower += 0.5; *arrival = departure + (*lower - departure) * (1 + delta))
SPOILT_WITHIN(within_low, *lower -= 0.5; *arrival = *lower)
SPOILT_WITHIN(within_has_no_way, status = TDSP_CUT_OFF)

/* --------------------------------------------------------------------------------------- spoilt path and last_reason */

/* Two legs from the departure to the arrival, joined half way. */
static void lend_legs(mutant *m, tdsp_oracle_path *out)
{
    double middle = (m->toy.asked + m->toy.arrival) / 2;
    m->legs[0] = (tdsp_leg){.disc = TDSP_NO_DISC, .start_time = m->toy.asked, .end_time = middle, .to = {1, 0}};
    m->legs[1] = (tdsp_leg){.disc = TDSP_NO_DISC, .start_time = middle, .end_time = m->toy.arrival, .from = {1, 0}, .to = {1, 2}};
    *out = (tdsp_oracle_path){m->legs, 2, NULL, 0};
}

#define SPOILT_PATH(name, statements)                                                                                            \
    static tdsp_status name(void *ctx, tdsp_oracle_path *out)                                                                    \
    {                                                                                                                            \
        mutant *m = ctx;                                                                                                         \
        tdsp_status status = TDSP_OK;                                                                                            \
        lend_legs(m, out);                                                                                                       \
        m->calls++;                                                                                                              \
        statements;                                                                                                              \
        return status;                                                                                                           \
    }

SPOILT_PATH(path_sound, (void)m)
SPOILT_PATH(path_fails, if (m->calls % 7 == 0) status = TDSP_NO_ANSWER)
SPOILT_PATH(path_cut_off, if (m->calls % 7 == 0) status = TDSP_CUT_OFF)
SPOILT_PATH(path_null_legs, out->legs = NULL)
SPOILT_PATH(path_null_bytes, out->byte_count = 1)
SPOILT_PATH(path_long_bytes, out->bytes = m->legs; out->byte_count = (size_t)1 << 31)
SPOILT_PATH(path_odd_kind, m->legs[1].kind = 9)
SPOILT_PATH(path_nan, m->legs[1].to.y = NAN)
SPOILT_PATH(path_backwards, m->legs[1].end_time = m->legs[1].start_time - 1)
SPOILT_PATH(path_line_on_disc, m->legs[1].disc = 3)
SPOILT_PATH(path_arc_without_radius, m->legs[1].kind = TDSP_LEG_ARC; m->legs[1].turn = 1)
SPOILT_PATH(path_curve_too_fast, m->legs[1].kind = TDSP_LEG_CURVE; m->legs[1].turn = 1; m->legs[1].radius_from = m->legs[1].radius_to = 1;
            m->legs[1].rate_to = 2; m->legs[1].speed = 1)
SPOILT_PATH(path_reserved, m->legs[1].reserved = 1)
#define SPOILT_LINE(member, value) SPOILT_PATH(path_line_##member, m->legs[1].member = value)
SPOILT_LINE(turn, 1)
SPOILT_PATH(path_line_center_x, m->legs[1].center.x = 1)
SPOILT_PATH(path_line_center_y, m->legs[1].center.y = 1)
SPOILT_LINE(radius_from, 1)
SPOILT_LINE(radius_to, 1)
SPOILT_LINE(angle_from, 1)
SPOILT_LINE(sweep, 1)
SPOILT_LINE(rate_from, 1)
SPOILT_LINE(rate_to, 1)
SPOILT_LINE(bend_from, 1)
SPOILT_LINE(bend_to, 1)
SPOILT_LINE(speed, 1)
#define SPOILT_ARC(member, value)                                                                                                \
    SPOILT_PATH(path_arc_##member, m->legs[1].kind = TDSP_LEG_ARC; m->legs[1].turn = 1; m->legs[1].radius_from = 1;               \
                m->legs[1].radius_to = 1; m->legs[1].member = value)
SPOILT_ARC(turn, 0)
SPOILT_ARC(sweep, -1)
SPOILT_ARC(radius_to, 0)
SPOILT_ARC(speed, 1)
SPOILT_ARC(kind, TDSP_LEG_CURVE)
SPOILT_PATH(path_curve_without_turn, m->legs[1].kind = TDSP_LEG_CURVE)
SPOILT_PATH(path_absurdly_long, out->leg_count = SIZE_MAX)
SPOILT_PATH(path_torn_in_place, m->legs[1].from.x += 1e-6)
SPOILT_PATH(path_torn_in_time, m->legs[0].end_time = nextafter(m->legs[0].end_time, 0))
SPOILT_PATH(path_starts_later, m->legs[0].start_time += 1e-6)
SPOILT_PATH(path_ends_later, m->legs[1].end_time += 1e-6)
SPOILT_PATH(path_ends_sooner, m->legs[1].end_time -= 1e-6)
SPOILT_PATH(path_wobbles, if (m->calls % 2 == 0) m->legs[1].to.y = 3)
SPOILT_PATH(path_counts, m->bytes = m->calls; out->leg_count = 0; out->bytes = &m->bytes; out->byte_count = sizeof m->bytes)

#define SPOILT_REASON(name, answer, found)                                                                                       \
    static tdsp_status name(void *ctx, double departure, tdsp_status *reason)                                                    \
    {                                                                                                                            \
        (void)ctx;                                                                                                               \
        (void)departure;                                                                                                         \
        *reason = found;                                                                                                         \
        return answer;                                                                                                           \
    }

SPOILT_REASON(reason_sound, TDSP_OK, TDSP_CUT_OFF)
SPOILT_REASON(reason_fails, TDSP_FAILED, TDSP_CUT_OFF)
SPOILT_REASON(reason_returned, TDSP_CUT_OFF, TDSP_CUT_OFF)
SPOILT_REASON(reason_horizon, TDSP_OK, TDSP_HORIZON)
SPOILT_REASON(reason_ok, TDSP_OK, TDSP_OK)
SPOILT_REASON(reason_negative, TDSP_OK, (tdsp_status)-1)

/* ------------------------------------------------------------------------------------------------------------- mutants */

#define MUTATIONS(X)                                                                                                               \
    X(DECLARED, MEMBERS, size = 3)                                                                                               \
    X(DECLARED, MEMBERS, earliest_arrival = NULL)                                                                                \
    X(DECLARED, MEMBERS, latest_departure = NULL)                                                                                \
    X(DECLARED, MEMBERS, monotone = (tdsp_monotone)7)                                                                            \
    X(DECLARED, MEMBERS, error = -1e-9)                                                                                          \
    X(DECLARED, MEMBERS, error = 0.2)                                                                                            \
    X(DECLARED, MEMBERS, error = NAN)                                                                                            \
    X(DECLARED, MEMBERS, time_scale = -1)                                                                                        \
    X(DECLARED, MEMBERS, time_scale = INFINITY)                                                                                  \
    X(ERROR, EARLIEST_ARRIVAL, earliest_arrival = arrival_fails)                                                                 \
    X(ERROR, EARLIEST_ARRIVAL, earliest_arrival = arrival_fails_at_first)                                                       \
    X(ERROR, LATEST_DEPARTURE, latest_departure = departure_fails)                                                               \
    X(ERROR, LATEST_DEPARTURE_BETWEEN, latest_departure_between = between_fails)                                                 \
    X(ERROR, EARLIEST_ARRIVAL_WITHIN, earliest_arrival_within = within_fails)                                                    \
    X(ERROR, PATH, path = path_fails)                                                                                            \
    X(ERROR, LAST_REASON, last_reason = reason_fails)                                                                            \
    X(STATUS, EARLIEST_ARRIVAL, earliest_arrival = arrival_too_early)                                                            \
    X(STATUS, EARLIEST_ARRIVAL, earliest_arrival = arrival_unknown)                                                              \
    X(STATUS, EARLIEST_ARRIVAL, earliest_arrival = arrival_negative_status)                                                      \
    X(STATUS, LATEST_DEPARTURE, latest_departure = departure_beyond_table)                                                       \
    X(STATUS, LATEST_DEPARTURE_BETWEEN, latest_departure_between = between_too_early)                                            \
    X(STATUS, EARLIEST_ARRIVAL_WITHIN, earliest_arrival_within = within_horizon)                                                 \
    X(STATUS, PATH, path = path_cut_off)                                                                                         \
    X(STATUS, LAST_REASON, last_reason = reason_returned)                                                                        \
    X(ARRIVAL, EARLIEST_ARRIVAL, earliest_arrival = arrival_nan)                                                                 \
    X(ARRIVAL, EARLIEST_ARRIVAL, earliest_arrival = arrival_infinite)                                                            \
    X(ARRIVAL, EARLIEST_ARRIVAL, earliest_arrival = arrival_before)                                                              \
    X(ARRIVAL, EARLIEST_ARRIVAL_WITHIN, earliest_arrival_within = within_nan)                                                    \
    X(ARRIVAL, EARLIEST_ARRIVAL_WITHIN, earliest_arrival_within = within_infinite)                                               \
    X(REPEATABLE, EARLIEST_ARRIVAL, earliest_arrival = arrival_wobbles)                                                          \
    X(REPEATABLE, LATEST_DEPARTURE, latest_departure = departure_wobbles)                                                        \
    X(REPEATABLE, LATEST_DEPARTURE, latest_departure = departure_changes_its_mind)                                              \
    X(REPEATABLE, LATEST_DEPARTURE_BETWEEN, latest_departure_between = between_wobbles)                                          \
    X(REPEATABLE, LATEST_DEPARTURE_BETWEEN, latest_departure_between = between_arrives_wobbles)                                 \
    X(REPEATABLE, EARLIEST_ARRIVAL_WITHIN, earliest_arrival_within = within_wobbles)                                             \
    X(REPEATABLE, EARLIEST_ARRIVAL_WITHIN, earliest_arrival_within = within_arrival_wobbles)                                    \
    X(REPEATABLE, EARLIEST_ARRIVAL_WITHIN, earliest_arrival_within = within_changes_its_mind)                                   \
    X(ORDER, EARLIEST_ARRIVAL, earliest_arrival = arrival_dips)                                                                  \
    X(ORDER, EARLIEST_ARRIVAL, earliest_arrival = arrival_creeps)                                                                \
    X(NO_WAY, EARLIEST_ARRIVAL, earliest_arrival = arrival_returns)                                                              \
    X(PATH_FORM, PATH, path = path_null_legs)                                                                                    \
    X(PATH_FORM, PATH, path = path_null_bytes)                                                                                   \
    X(PATH_FORM, PATH, path = path_long_bytes)                                                                                   \
    X(PATH_FORM, PATH, path = path_odd_kind)                                                                                     \
    X(PATH_FORM, PATH, path = path_nan)                                                                                          \
    X(PATH_FORM, PATH, path = path_backwards)                                                                                    \
    X(PATH_FORM, PATH, path = path_line_on_disc)                                                                                 \
    X(PATH_FORM, PATH, path = path_arc_without_radius)                                                                           \
    X(PATH_FORM, PATH, path = path_curve_too_fast)                                                                               \
    X(PATH_FORM, PATH, path = path_reserved)                                                                                     \
    X(PATH_FORM, PATH, path = path_line_turn)                                                                                   \
    X(PATH_FORM, PATH, path = path_line_center_x)                                                                               \
    X(PATH_FORM, PATH, path = path_line_center_y)                                                                               \
    X(PATH_FORM, PATH, path = path_line_radius_from)                                                                            \
    X(PATH_FORM, PATH, path = path_line_radius_to)                                                                              \
    X(PATH_FORM, PATH, path = path_line_angle_from)                                                                             \
    X(PATH_FORM, PATH, path = path_line_sweep)                                                                                  \
    X(PATH_FORM, PATH, path = path_line_rate_from)                                                                              \
    X(PATH_FORM, PATH, path = path_line_rate_to)                                                                                \
    X(PATH_FORM, PATH, path = path_line_bend_from)                                                                              \
    X(PATH_FORM, PATH, path = path_line_bend_to)                                                                                \
    X(PATH_FORM, PATH, path = path_line_speed)                                                                                  \
    X(PATH_FORM, PATH, path = path_arc_turn)                                                                                    \
    X(PATH_FORM, PATH, path = path_arc_sweep)                                                                                   \
    X(PATH_FORM, PATH, path = path_arc_radius_to)                                                                               \
    X(PATH_FORM, PATH, path = path_arc_speed)                                                                                   \
    X(PATH_FORM, PATH, path = path_arc_kind)                                                                                    \
    X(PATH_FORM, PATH, path = path_curve_without_turn)                                                                          \
    X(PATH_FORM, PATH, path = path_absurdly_long)                                                                               \
    X(PATH_JOINS, PATH, path = path_torn_in_place)                                                                               \
    X(PATH_JOINS, PATH, path = path_torn_in_time)                                                                                \
    X(PATH_ENDS, PATH, path = path_starts_later)                                                                                 \
    X(PATH_ENDS, PATH, path = path_ends_later)                                                                                   \
    X(PATH_ENDS, PATH, path = path_ends_sooner)                                                                                  \
    X(PATH_REPEATABLE, PATH, path = path_wobbles)                                                                                \
    X(PATH_REPEATABLE, PATH, path = path_counts)                                                                                 \
    X(DEPARTURE, LATEST_DEPARTURE, latest_departure = departure_nan)                                                             \
    X(DEPARTURE, LATEST_DEPARTURE, latest_departure = departure_negative)                                                        \
    X(DEPARTURE, LATEST_DEPARTURE, latest_departure = departure_infinite)                                                        \
    X(DEPARTURE, LATEST_DEPARTURE_BETWEEN, latest_departure_between = between_nan)                                               \
    X(DEPARTURE, LATEST_DEPARTURE_BETWEEN, latest_departure_between = between_before)                                            \
    X(DEPARTURE, LATEST_DEPARTURE_BETWEEN, latest_departure_between = between_after)                                             \
    X(TOO_EARLY, LATEST_DEPARTURE, latest_departure = departure_says_too_early)                                                  \
    X(TOO_EARLY, LATEST_DEPARTURE, latest_departure = departure_is_never_late_enough)                                           \
    X(TOO_EARLY, LATEST_DEPARTURE, latest_departure = departure_never_too_early)                                                 \
    X(BOTH_WAYS, LATEST_DEPARTURE, latest_departure = departure_has_no_way)                                                      \
    X(LATE, LATEST_DEPARTURE, latest_departure = departure_late)                                                                 \
    X(LATE, LATEST_DEPARTURE, latest_departure = departure_never_ends)                                                           \
    X(LATE, LATEST_DEPARTURE_BETWEEN, latest_departure_between = between_late)                                                   \
    X(EARLY, LATEST_DEPARTURE, latest_departure = departure_early)                                                               \
    X(EARLY, LATEST_DEPARTURE, latest_departure = departure_misses_jumps)                                                        \
    X(EARLY, LATEST_DEPARTURE, latest_departure = departure_ends_too_soon)                                                       \
    X(EARLY, LATEST_DEPARTURE_BETWEEN, latest_departure_between = between_early)                                                 \
    X(ARRIVES, LATEST_DEPARTURE_BETWEEN, latest_departure_between = between_arrives_later)                                       \
    X(ARRIVES, LATEST_DEPARTURE_BETWEEN, latest_departure_between = between_arrives_nowhere)                                     \
    X(WITHIN, EARLIEST_ARRIVAL_WITHIN, earliest_arrival_within = within_wide)                                                    \
    X(WITHIN, EARLIEST_ARRIVAL_WITHIN, earliest_arrival_within = within_crossed)                                                 \
    X(BOUNDS, EARLIEST_ARRIVAL_WITHIN, earliest_arrival_within = within_high)                                                    \
    X(BOUNDS, EARLIEST_ARRIVAL_WITHIN, earliest_arrival_within = within_low)                                                     \
    X(BOUNDS, EARLIEST_ARRIVAL_WITHIN, earliest_arrival_within = within_has_no_way)                                              \
    X(REASON, LAST_REASON, last_reason = reason_horizon)                                                                         \
    X(REASON, LAST_REASON, last_reason = reason_ok)                                                                              \
    X(REASON, LAST_REASON, last_reason = reason_negative)                                                                        \
    X(SLOW, EARLIEST_ARRIVAL, earliest_arrival = arrival_slow)

static const toy_piece pieces[] = {{10, 5, 0.1, 0}, {20, 8, 0.05, 0.01}, {30, 12, 0.2, 0}};

void mutant_make(mutant *m)
{
    memset(m, 0, sizeof *m);
    m->toy = toy_over(pieces, sizeof pieces / sizeof pieces[0], 0);
    m->toy.rough = 1;
}

tdsp_oracle mutant_sound(mutant *m)
{
    m->sound = toy_oracle(&m->toy, 0);
    tdsp_oracle oracle = m->sound;
    oracle.path = path_sound;
    oracle.last_reason = reason_sound;
    return oracle;
}

double mutant_clock(void *ctx)
{
    const mutant *m = ctx;
    return m->now;
}

int mutant_spoil(int which, tdsp_oracle *oracle, mutation *out)
{
    int number = 0;
    const mutant *m = oracle->ctx;
    oracle->path = m->sound.path; /* bytes, which do not say what else is wrong */
#define X(broken, member, change)                                                                                                \
    if (number++ == which) {                                                                                                     \
        oracle->change;                                                                                                          \
        *out = (mutation){#change, TDSP_RULE_##broken, TDSP_ORACLE_##member};                                                    \
        return 1;                                                                                                                \
    }
    MUTATIONS(X)
#undef X
    return 0;
}
