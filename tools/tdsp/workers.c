/* SPDX-License-Identifier: MIT */
/*
 * Threads for the sampler.
 *
 * Invariant: while workers_run() runs, `next` is the first task that nobody has taken and `busy` the number of helpers that have not
 * finished; both are guarded by `lock`. A worker's solver is touched only by the thread that runs under that worker's number.
 */
#include "workers.h"

#include <signal.h>

#include "cli.h"

struct Workers {
    guint count;
    tdsp_solver **solvers;
    tdsp_oracle *oracles;
    GThreadPool *pool; /* the helpers; NULL with one worker */
    GMutex lock;
    GCond finished;
    tdsp_task task;
    void *task_ctx;
    gsize tasks;
    gsize next;
    guint busy;
};

static gboolean take(Workers *workers, gsize *task)
{
    g_mutex_lock(&workers->lock);
    gboolean any = workers->next < workers->tasks;
    if (any) *task = workers->next++;
    g_mutex_unlock(&workers->lock);
    return any;
}

static void work(Workers *workers, gsize worker)
{
    gsize task;
    while (take(workers, &task)) workers->task(workers->task_ctx, task, worker);
}

/* A helper's number comes as a pointer, for GLib hands over nothing else; it is never 0, the caller's. */
static void help(gpointer number, gpointer context)
{
    Workers *workers = context;
    work(workers, GPOINTER_TO_SIZE(number));
    g_mutex_lock(&workers->lock);
    if (--workers->busy == 0) g_cond_signal(&workers->finished);
    g_mutex_unlock(&workers->lock);
}

void workers_run(void *context, tdsp_task task, void *task_ctx, size_t count)
{
    Workers *workers = context;
    workers->task = task;
    workers->task_ctx = task_ctx;
    workers->tasks = count;
    workers->next = 0;
    guint helpers = (guint)MIN((gsize)workers->count, count);
    workers->busy = helpers > 0 ? helpers - 1 : 0;
    for (gsize i = 1; i < helpers; i++) g_thread_pool_push(workers->pool, GSIZE_TO_POINTER(i), NULL);
    work(workers, 0);
    g_mutex_lock(&workers->lock);
    while (workers->busy > 0) g_cond_wait(&workers->finished, &workers->lock);
    g_mutex_unlock(&workers->lock);
}

static tdsp_status make_oracle(Workers *workers, const tdsp_scene *scene, guint i)
{
    tdsp_status status = tdsp_solver_create(scene, &workers->solvers[i]);
    return status == TDSP_OK ? tdsp_solver_oracle(workers->solvers[i], &workers->oracles[i]) : status;
}

/*
 * The helpers take no signal that ends the process: one that outlives its pool by a moment would, while the main thread has held them back to
 * write a file. A thread inherits what its maker holds back.
 */
static GThreadPool *quiet_pool(Workers *workers, GError **error)
{
    const int ending[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGALRM, SIGUSR1, SIGUSR2};
    sigset_t held, before;
    sigemptyset(&held);
    for (gsize i = 0; i < G_N_ELEMENTS(ending); i++) sigaddset(&held, ending[i]);
    pthread_sigmask(SIG_BLOCK, &held, &before);
    GThreadPool *pool = g_thread_pool_new(help, workers, (gint)workers->count - 1, TRUE, error);
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    return pool;
}

Workers *workers_new(const tdsp_scene *scene, guint count, GError **error)
{
    g_autoptr(Workers) workers = g_new0(Workers, 1);
    g_mutex_init(&workers->lock);
    g_cond_init(&workers->finished);
    workers->count = count;
    workers->solvers = g_new0(tdsp_solver *, count);
    workers->oracles = g_new0(tdsp_oracle, count);
    for (guint i = 0; i < count; i++) {
        tdsp_status status = make_oracle(workers, scene, i);
        if (status != TDSP_OK) {
            cli_fail_status(error, "solver", status);
            return NULL;
        }
    }
    if (count == 1) return g_steal_pointer(&workers);
    g_autoptr(GError) wrong = NULL;
    workers->pool = quiet_pool(workers, &wrong);
    if (wrong) {
        cli_fail(error, CLI_SYSTEM, "cannot start %u threads: %s", count, wrong->message);
        return NULL;
    }
    return g_steal_pointer(&workers);
}

void workers_free(Workers *workers)
{
    if (!workers) return;
    if (workers->pool) g_thread_pool_free(workers->pool, FALSE, TRUE);
    for (guint i = 0; i < workers->count; i++) tdsp_solver_free(workers->solvers[i]);
    g_free(workers->solvers);
    g_free(workers->oracles);
    g_mutex_clear(&workers->lock);
    g_cond_clear(&workers->finished);
    g_free(workers);
}

guint workers_count(const Workers *workers)
{
    return workers->count;
}

tdsp_solver *workers_solver(const Workers *workers, gsize worker)
{
    return workers->solvers[worker];
}

const tdsp_oracle *workers_oracles(const Workers *workers)
{
    return workers->oracles;
}
