/* SPDX-License-Identifier: MIT */
/* What the commands share that ask a scene's solver about times: `arrive` and `depart`. */
#ifndef ANSWERS_H
#define ANSWERS_H

#include <glib.h>

#include "scene_solver.h"
#include "tdsp/margin.h"

#define ANSWER_NUMBERS 3 /* the time asked about first */

typedef struct Answer {
    double numbers[ANSWER_NUMBERS]; /* infinite where there is none */
    double lower;                   /* of an answer within a share of the best */
    tdsp_status status;
    double seconds; /* that solving took */
    tdsp_witness witness; /* where asked for: what limits it */
} Answer;

typedef struct AnswerKind AnswerKind;
struct AnswerKind {
    const char *command;
    const char *what;                  /* is asked about, for messages */
    const char *names[ANSWER_NUMBERS]; /* of the numbers, as columns and as keys */
    SceneEnds ends;
    double within;                     /* the share; 0: exact, without a lower bound */
    guint32 method;                    /* a tdsp_method */
    /* Fill in an answer whose first number is the time asked about. */
    gboolean (*ask)(const AnswerKind *kind, const SceneSolver *solver, Answer *answer, GError **error);
    /* Find its witness; its time is not counted. NULL: answers have none. */
    gboolean (*explain)(const SceneSolver *solver, Answer *answer, GError **error);
};

/* Solve argv[1], a scene, for the times in argv[2] on, and print the answers. Returns an exit status. */
int answers_run(const AnswerKind *kind, int argc, char **argv, gboolean json, GError **error);

#endif
