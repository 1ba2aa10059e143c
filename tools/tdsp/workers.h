/* SPDX-License-Identifier: MIT */
/* The library has no threads; here are some for it: each worker has a solver and an oracle of its own for one shared scene. */
#ifndef WORKERS_H
#define WORKERS_H

#include <glib.h>

#include "tdsp/build.h"
#include "tdsp/solver.h"

typedef struct Workers Workers;

/* `count` workers, the caller's thread being the first of them. */
Workers *workers_new(const tdsp_scene *scene, guint count, GError **error);
void workers_free(Workers *workers);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(Workers, workers_free)

guint workers_count(const Workers *workers);
tdsp_solver *workers_solver(const Workers *workers, gsize worker);
const tdsp_oracle *workers_oracles(const Workers *workers); /* one a worker */

/* A tdsp_run_tasks whose context is the Workers. Returns when all tasks are done. */
void workers_run(void *workers, tdsp_task task, void *task_ctx, size_t count);

#endif
