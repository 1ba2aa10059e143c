/* SPDX-License-Identifier: MIT */
/*
 * The soak: random scenes of all mixes through all checks. A scene is made from a seed and its number alone, so any part of a run can be done by any
 * process, and one scene again by itself. tests/soak/soak.py spreads a million of them over processes.
 */
#include <glib.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

#include "soak/checks.h"
#include "soak/departures.h"
#include "soak/mixes.h"
#include "soak/scene_json.h"
#include "soak/shrink.h"
#include "support/chance.h"

enum { MOST_SECONDS = 60 }; /* of the processor for one scene: else it hangs */

static gint64 seed = 1, from = 0, count = 1, one = -1, shrunk_of_each = 2;
static char *found = NULL, *report = NULL, *only_mix = NULL, *only_check = NULL, *file = NULL;
static char *at_text = NULL, *later_text = NULL, *pick_text = NULL;
static double shrink_seconds = 5.0;
static gboolean quiet = FALSE;

static const GOptionEntry entries[] = {
    {"seed", 0, 0, G_OPTION_ARG_INT64, &seed, "Of all scenes", "S"},
    {"from", 0, 0, G_OPTION_ARG_INT64, &from, "The first scene", "K"},
    {"count", 0, 0, G_OPTION_ARG_INT64, &count, "How many", "N"},
    {"scene", 0, 0, G_OPTION_ARG_INT64, &one, "This one scene", "K"},
    {"mix", 0, 0, G_OPTION_ARG_STRING, &only_mix, "All scenes are of this mix", "NAME"},
    {"check", 0, 0, G_OPTION_ARG_STRING, &only_check, "This check only", "NAME"},
    {"file", 0, 0, G_OPTION_ARG_FILENAME, &file, "Put a check to the scene in a file, at the departure --at", "FILE"},
    {"at", 0, 0, G_OPTION_ARG_STRING, &at_text, "The departure", "T"},
    {"later", 0, 0, G_OPTION_ARG_STRING, &later_text, "The later departure, for checks of two", "T"},
    {"pick", 0, 0, G_OPTION_ARG_STRING, &pick_text, "What the check chooses by", "P"},
    {"found", 0, 0, G_OPTION_ARG_FILENAME, &found, "Where minimal scenes are written", "DIR"},
    {"report", 0, 0, G_OPTION_ARG_FILENAME, &report, "Where the counts are written", "FILE"},
    {"shrink", 0, 0, G_OPTION_ARG_DOUBLE, &shrink_seconds, "Make a scene smaller for so long", "SECONDS"},
    {"each", 0, 0, G_OPTION_ARG_INT64, &shrunk_of_each, "Make so many scenes of each check smaller", "N"},
    {"quiet", 0, 0, G_OPTION_ARG_NONE, &quiet, "No lines for checks that hold", NULL},
    {NULL, 0, 0, 0, NULL, NULL, NULL}};

typedef struct tally {
    unsigned long done, failed, forgiven;
} tally;

static tally by_mix[SOAK_ALL_MIXES], by_check[SOAK_CHECK_COUNT];

/* What the handler of a crash says. */
static volatile sig_atomic_t current_check;
static volatile gint64 current_scene;

static void crashed(int signal_number)
{
    char text[160];
    const int length = snprintf(text, sizeof text, "not ok signal %d: --seed %lld --scene %lld, check %s\n", signal_number,
                                (long long)seed, (long long)current_scene, soak_check_name((size_t)current_check));
    if (write(STDOUT_FILENO, text, (size_t)length) < 0) _exit(98);
    _exit(97);
}

static void watch(void)
{
    static const int signals[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGVTALRM};
    for (size_t i = 0; i < sizeof signals / sizeof *signals; i++) (void)signal(signals[i], crashed);
}

static void wind_up(void)
{
    const struct itimerval time = {{0, 0}, {MOST_SECONDS, 0}};
    (void)setitimer(ITIMER_VIRTUAL, &time, NULL);
}

static void write_found(const soak_scene *scene, const soak_failure *failure, const char *name)
{
    g_autofree char *path = g_strdup_printf("%s/%s.json", found, name), *text_path = g_strdup_printf("%s/%s.txt", found, name);
    FILE *out = fopen(path, "w"), *text = fopen(text_path, "w");
    if (!out || !text) g_error("%s: cannot write", found);
    soak_write(out, scene, name);
    (void)fprintf(text, "%s: %s\nexcess %.3g of the journey's time\n", soak_check_name(failure->check), failure->what,
                  failure->excess);
    (void)fprintf(text, "build/tests/soak/soak --file %s --check %s --at %.17g --later %.17g --pick %llu\n", path,
                  soak_check_name(failure->check), failure->departure, failure->later, (unsigned long long)failure->pick);
    (void)fprintf(text, "build/tdsp arrive %s %.17g %.17g\n", path, failure->departure, failure->later);
    if (fclose(out) != 0 || fclose(text) != 0) g_error("%s: cannot write", found);
}

/* Say what is wrong, and where the same can be seen in a smaller scene. */
static void tell(const soak_scene *scene, soak_failure *failure)
{
    static soak_scene smaller;
    (void)printf("not ok %s: --seed %lld --scene %lld (%s, %zu discs, --at %.17g --later %.17g): %s, excess %.3g\n",
                 soak_check_name(failure->check), (long long)seed, (long long)current_scene, scene->mix, scene->count,
                 failure->departure, failure->later, failure->what, failure->excess);
    if (!found || by_check[failure->check].failed > (unsigned long)shrunk_of_each) return;
    g_autofree char *name =
        g_strdup_printf("%s-%lld-%lld", soak_check_name(failure->check), (long long)seed, (long long)current_scene);
    soak_copy(&smaller, scene);
    soak_shrink(&smaller, failure, shrink_seconds);
    write_found(&smaller, failure, name);
    (void)printf("  smaller: %s/%s.json, %zu discs: %s\n", found, name, smaller.count, failure->what);
}

static void run_check(const soak_world *world, size_t check, double departure, double later, uint64_t pick, tally *mix)
{
    soak_case c = {.scene = world->is, .world = *world, .departure = departure, .later = later, .pick = pick};
    current_check = (sig_atomic_t)check;
    soak_check_run(check, &c);
    by_check[check].done++;
    by_check[check].forgiven += c.forgiven > 0;
    if (!c.failed) return;
    by_check[check].failed++;
    mix->failed++;
    soak_failure failure = {check, departure, later, pick, "", c.excess};
    memcpy(failure.what, c.what, sizeof failure.what);
    tell(world->is, &failure);
}

static double some_later(uint64_t *chance, const soak_world *world, double departure)
{
    if (chance_below(chance, 2)) return departure + pow(10.0, chance_between(chance, -15.0, -3.0)) * (world->unit + departure);
    return departure + chance_between(chance, 0.0, 1.0) * world->unit;
}

static void run_checks(const soak_world *world, uint64_t *chance, tally *mix)
{
    double departures[SOAK_DEPARTURES];
    const size_t number = soak_departures(world, chance, departures);
    for (size_t i = 0; i < number; i++) {
        const double later = some_later(chance, world, departures[i]);
        for (size_t check = 0; check < SOAK_CHECK_COUNT; check++) {
            const unsigned share = soak_check_share(check, world->is);
            const uint64_t lot = chance_below(chance, 100), pick = chance_u64(chance);
            const int wanted = only_check ? strcmp(only_check, soak_check_name(check)) == 0 : lot < share;
            if (wanted && share > 0) run_check(world, check, departures[i], later, pick, mix);
        }
    }
}

static void run_scene(gint64 number, size_t only)
{
    static soak_scene scene;
    soak_world world;
    uint64_t chance = (uint64_t)seed * 7919u + (uint64_t)number;
    current_scene = number;
    wind_up();
    const size_t mix = soak_make((uint64_t)seed, (uint64_t)number, only, &scene);
    const tdsp_status status = soak_open(&scene, TDSP_METHOD_AUTO, &world);
    by_mix[mix].done++;
    if (status == TDSP_BAD_SCENE && !soak_has_rates_only(&scene)) return; /* rounded polynomials may shrink from the start */
    if (status != TDSP_OK) {
        by_mix[mix].failed++;
        (void)printf("not ok open: --seed %lld --scene %lld (%s): %s\n", (long long)seed, (long long)number, scene.mix,
                     tdsp_status_name(status));
        return;
    }
    run_checks(&world, &chance, &by_mix[mix]);
    soak_close(&world);
}

static void write_report(FILE *out, double seconds)
{
    for (size_t i = 0; i < SOAK_ALL_MIXES; i++)
        (void)fprintf(out, "mix %s %lu %lu\n", soak_mix_name(i), by_mix[i].done, by_mix[i].failed);
    for (size_t i = 0; i < SOAK_CHECK_COUNT; i++)
        (void)fprintf(out, "check %s %lu %lu %lu\n", soak_check_name(i), by_check[i].done, by_check[i].failed,
                      by_check[i].forgiven);
    (void)fprintf(out, "seconds %.2f\n", seconds);
}

static int conclude(double seconds)
{
    unsigned long failed = 0;
    for (size_t i = 0; i < SOAK_ALL_MIXES; i++) failed += by_mix[i].failed;
    for (size_t i = 0; i < SOAK_CHECK_COUNT && !quiet; i++)
        if (by_check[i].failed == 0)
            (void)printf("ok %s: %lu times, %lu told apart by a touch\n", soak_check_name(i), by_check[i].done,
                         by_check[i].forgiven);
    FILE *out = report ? fopen(report, "w") : NULL;
    if (out) write_report(out, seconds);
    if (report && (!out || fclose(out) != 0)) g_error("%s: cannot write", report);
    return failed > 0;
}

static int run_file(void)
{
    static soak_scene scene;
    soak_failure failure = {.departure = at_text ? g_ascii_strtod(at_text, NULL) : 0.0,
                            .pick = pick_text ? g_ascii_strtoull(pick_text, NULL, 10) : 0};
    failure.later = later_text ? g_ascii_strtod(later_text, NULL) : failure.departure;
    if (!soak_read(file, &scene)) return 2;
    int failed = 0;
    for (failure.check = 0; failure.check < SOAK_CHECK_COUNT; failure.check++) {
        if (only_check && strcmp(only_check, soak_check_name(failure.check)) != 0) continue;
        const int wrong = soak_fails(&scene, &failure);
        (void)printf(wrong ? "not ok %s: %s\n" : "ok %s\n", soak_check_name(failure.check), failure.what);
        failed |= wrong;
    }
    return failed;
}

static size_t mix_of(const char *name)
{
    for (size_t i = 0; name && i < SOAK_ALL_MIXES; i++)
        if (strcmp(name, soak_mix_name(i)) == 0) return i;
    return SOAK_ALL_MIXES;
}

int main(int argc, char **argv)
{
    g_autoptr(GOptionContext) context = g_option_context_new("- random scenes through all checks");
    g_autoptr(GError) error = NULL;
    g_option_context_add_main_entries(context, entries, NULL);
    if (!g_option_context_parse(context, &argc, &argv, &error) || (only_mix && mix_of(only_mix) == SOAK_ALL_MIXES)) {
        g_printerr("%s\n", error ? error->message : "no such mix");
        return 2;
    }
    if (file) return run_file();
    watch();
    if (one >= 0) {
        from = one;
        count = 1;
    }
    const clock_t begin = clock();
    for (gint64 i = from; i < from + count; i++) run_scene(i, mix_of(only_mix));
    return conclude((double)(clock() - begin) / CLOCKS_PER_SEC);
}
