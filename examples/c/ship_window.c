/* SPDX-License-Identifier: MIT */
/*
 * A ship's departure window: the day's table of departures, when the voyage gets longer, and when to cast off to be there in time.
 *
 *   ship_window [NEW]    NEW receives the table, for `tdsp embed` and the ship's own computer
 *
 * Fields of drift ice spread between two harbours: what is not known of their drift makes them grow. Lengths are nautical miles, times hours.
 * The ice is made up, and none of this is for navigation.
 */
#include <stdio.h>
#include <stdlib.h>

#include "tdsp/build.h"
#include "tdsp/scene.h"
#include "tdsp/solver.h"
#include "tdsp/table.h"

static const tdsp_journey voyage = {.speed = 12.0, .radius = 1.0, .source = {0.0, 0.0}, .destination = {120.0, 10.0}};
static const tdsp_disc ice[] = {
    {.center = {35.0, 14.0}, .radius = 4.0, .growth = 0.30}, {.center = {40.0, -12.0}, .radius = 6.0, .growth = 0.40},
    {.center = {70.0, 28.0}, .radius = 9.0, .growth = 0.25}, {.center = {75.0, -2.0}, .radius = 5.0, .growth = 0.45},
    {.center = {95.0, 18.0}, .radius = 3.0, .growth = 0.20},
};

static void must(tdsp_status status)
{
    if (status == TDSP_OK) return;
    fprintf(stderr, "ship_window: %s\n", tdsp_status_text(status));
    exit(EXIT_FAILURE);
}

static void build(void **bytes, size_t *length)
{
    tdsp_scene *scene = NULL;
    tdsp_solver *solver = NULL;
    tdsp_oracle oracle;
    tdsp_build_options options;
    must(tdsp_scene_create(&voyage, ice, sizeof ice / sizeof *ice, NULL, &scene));
    must(tdsp_solver_create(scene, &solver));
    must(tdsp_solver_oracle(solver, &oracle));
    tdsp_build_options_init(&options);
    options.epsilon = 0.01;
    options.horizon = 24.0;
    options.world = (tdsp_build_world){tdsp_scene_hash(scene), voyage.speed, voyage.source, voyage.destination, "nmi", "h"};
    must(tdsp_build(&oracle, &options, NULL, bytes, length, NULL));
    tdsp_solver_free(solver);
    tdsp_scene_free(scene);
}

/* A window ends where the voyage jumps: whoever leaves later has to go around what has closed. */
static void print_windows(const tdsp_table *table)
{
    tdsp_table_info info;
    tdsp_jump jump;
    double from = 0.0;
    must(tdsp_table_get_info(table, &info));
    printf("%u rows, %u bytes, each good to 1 %%\n", (unsigned)info.rows, (unsigned)info.length);
    while (tdsp_table_next_jump(table, from, &jump) == TDSP_OK && jump.departure < info.last_departure) {
        printf("window until %5.2f h: a voyage of up to %.2f h; then %.2f h", jump.departure, jump.before, jump.after);
        if (jump.gap.first != TDSP_NO_DISC) printf(", as ice %u and %u have met", (unsigned)jump.gap.first, (unsigned)jump.gap.second);
        printf("\n");
        from = jump.departure + 1e-6;
    }
    printf("window until %5.2f h: %s\n", info.last_departure, tdsp_status_text(info.last_reason));
}

static void print_best(const tdsp_table *table, double arrive_by)
{
    double departure = 0.0, upper = 0.0;
    tdsp_status status = tdsp_table_departure(table, arrive_by, &departure, NULL);
    if (status != TDSP_OK) {
        printf("to be there at %4.1f h: %s\n", arrive_by, tdsp_status_text(status));
        return;
    }
    must(tdsp_table_arrival(table, departure, NULL, &upper));
    printf("to be there at %4.1f h: cast off by %5.2f h, there by %5.2f h\n", arrive_by, departure, upper);
}

static void write_file(const char *name, const void *bytes, size_t length)
{
    FILE *file = fopen(name, "wb");
    if (file && fwrite(bytes, 1, length, file) == length && !fclose(file)) return;
    fprintf(stderr, "ship_window: %s: cannot be written\n", name);
    exit(EXIT_FAILURE);
}

int main(int argc, char **argv)
{
    void *bytes = NULL;
    size_t length = 0;
    tdsp_table table;
    build(&bytes, &length);
    must(tdsp_table_open(&table, bytes, length));
    print_windows(&table);
    for (double arrive_by = 10.0; arrive_by <= 35.0; arrive_by += 5.0) print_best(&table, arrive_by);
    if (argc > 1) write_file(argv[1], bytes, length);
    tdsp_bytes_free(NULL, bytes, length);
    return EXIT_SUCCESS;
}
