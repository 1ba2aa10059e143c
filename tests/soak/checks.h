/* SPDX-License-Identifier: MIT */
/* What every scene goes through: each check by itself, how often, and for how large scenes it is affordable. */
#ifndef SOAK_CHECKS_H
#define SOAK_CHECKS_H

#include "soak/case.h"

/* One line each: the name, of how many departures in a hundred, discs at most where rates are constant, and where they change; what it is for. */
#define SOAK_CHECKS(X)                                                                                                           \
    X(bounds, 100, 512, 512,                                                                                                     \
      "no arrival beats the straight line or comes after the destination is covered; statuses say what is covered")              \
    X(path, 100, 512, 512, "the verifier accepts the path")                                                                      \
    X(sample, 60, 512, 512, "so do samples of the path, placed and measured by formulas of this test's own")                     \
    X(rise, 60, 512, 512, "the travel time of a later departure is no shorter")                                                  \
    X(sides, 40, 16, 8, "at a jump the answer is that of one of its sides")                                                      \
    X(general_sides, 15, 8, 0, "likewise by the engine for changing rates in scenes of constant rates")                          \
    X(repeat, 10, 64, 64, "the same question has the same bits after others")                                                    \
    X(latest, 40, 64, 8, "the latest departure for A(t) is no earlier than t and arrives in time; a later one does not")         \
    X(too_early, 5, 64, 8, "before A(0) nothing arrives")                                                                        \
    X(last, 8, 64, 8, "the last departure arrives, and right after it nothing does, for the reason given")                       \
    X(general, 25, 8, 0, "the engine for changing rates has the arrival of that for constant rates")                             \
    X(within, 30, 512, 512, "an interval within a share holds the arrival, and its path is accepted")                            \
    X(quarter, 20, 64, 64, "turning the scene by right angles changes no bit")                                                   \
    X(doubled, 15, 64, 64, "other units of length and time by powers of two change no bit")                                      \
    X(turned, 15, 64, 64, "turning by any angle changes no answer")                                                              \
    X(moved, 15, 64, 64, "nor does moving")                                                                                      \
    X(scaled, 15, 64, 64, "nor other units")                                                                                     \
    X(mirrored, 20, 64, 64, "nor mirroring")                                                                                     \
    X(relabelled, 20, 64, 64, "nor another order of the discs")                                                                  \
    X(fewer, 20, 64, 64, "with a disc less nothing arrives later, and a disc inside another changes nothing")                    \
    X(slow, 6, 3, 2, "the slow solvers have the same arrival")                                                                   \
    X(many, 5, 64, 8, "one search for many destinations has the arrivals that they have one by one")                             \
    X(ends, 8, 64, 8, "a solver asked about other ends has the arrival of a scene that has these ends")                          \
    X(table, 1, 16, 4, "a table is verified, and its intervals hold the arrivals")

typedef enum soak_check {
#define X(name, share, rates, growth, text) SOAK_CHECK_##name,
    SOAK_CHECKS(X)
#undef X
        SOAK_CHECK_COUNT
} soak_check;

#define X(name, share, rates, growth, text) void soak_check_##name(soak_case *c);
SOAK_CHECKS(X)
#undef X

const char *soak_check_name(size_t check);

/* Of how many departures in a hundred, in a scene of this size. */
unsigned soak_check_share(size_t check, const soak_scene *scene);

/* Put the check to the case, whose world is open. */
void soak_check_run(size_t check, soak_case *c);

#endif
