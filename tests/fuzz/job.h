/* SPDX-License-Identifier: MIT */
/*
 * A scene from bytes with a solver, the question asked in every way, and what an answer is held to.
 *
 * Two answers to one question may differ by the solver's stated error; next to a jump, by the side of it they are on. So an answer at t is held between
 * the other's at t - d and at t + d, d being ten times that error, which is what the solver states for a jump.
 */
#ifndef FUZZ_JOB_H
#define FUZZ_JOB_H

#include "tdsp/solver.h"
#include "world.h"

typedef struct fuzz_job {
    const world *w;
    tdsp_scene *scene;
    tdsp_solver *solver;
    double valid; /* up to when no radius shrinks */
} fuzz_job;

/* The solver of a method; 0 where there is no scene, or the method does not apply. */
int job_open(fuzz_job *job, const world *w, tdsp_method method);
void job_close(fuzz_job *job);

/* Is this status one that a question about this scene may have? TDSP_OK and TDSP_ARRIVAL_TOO_EARLY are told apart by the caller. */
int job_answered(const fuzz_job *job, tdsp_status status);

/* A(t): infinite without a way, NaN where the library says that it cannot tell. Its path is checked. */
double job_arrival(const fuzz_job *job, double departure);

/* The path of the solver's last answer is good. */
void job_check_path(const fuzz_job *job, double departure, double arrival);

/* The solver's stated error of an arrival. */
double job_error(const fuzz_job *job, double departure, double arrival);

/* The time in which the radius of the largest disc is crossed: rounding of angles makes a share of it. */
double job_largest(const fuzz_job *job);

/*
 * Is a time so far away that its own rounding is over 1e-10 of the journey? A gap narrower than that is then open or closed by chance from one departure to the next, and a
 * ride around a pebble cannot be aimed: only arrivals are compared.
 */
int job_is_far(const fuzz_job *job, double time);

/* `arrival` is A(departure), as this job knows A. */
void job_agrees(const fuzz_job *job, double departure, double arrival, const char *wrong);

#endif
