/* SPDX-License-Identifier: MIT */
/*
 * Read a table, then make one: what the wrappers in examples/cpp, go, java, node and rust do too, each printing the same lines to the bit.
 *
 *   read_table [TABLE [NEW]]    TABLE: tests/golden/answered/two-discs.tdsp unless it is given; NEW receives the table that is made
 *
 * A number is shown with six decimals and, in brackets, as the 64 bits of the double.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tdsp/build.h"
#include "tdsp/scene.h"
#include "tdsp/solver.h"
#include "tdsp/table.h"

typedef struct shown {
    char text[48];
} shown;

static shown number(double value)
{
    shown out;
    uint64_t bits = 0;
    memcpy(&bits, &value, sizeof bits);
    snprintf(out.text, sizeof out.text, "%.6f[%08lx%08lx]", value, (unsigned long)(bits >> 32), (unsigned long)(bits & 0xffffffffu));
    return out;
}

static void must(const char *what, tdsp_status status)
{
    if (status == TDSP_OK) return;
    fprintf(stderr, "read_table: %s: %s\n", what, tdsp_status_text(status));
    exit(EXIT_FAILURE);
}

static void print_info(const tdsp_table *table)
{
    tdsp_table_info info;
    must("info", tdsp_table_get_info(table, &info));
    printf("%lu rows, %lu legs, %lu bytes, in %s and %s\n", (unsigned long)info.rows, (unsigned long)info.legs, (unsigned long)info.length, info.length_unit,
           info.time_unit);
    printf("departures up to %s, then %s\n", number(info.last_departure).text, tdsp_status_name(info.last_reason));
}

static void print_arrival(const tdsp_table *table, double departure)
{
    double lower = 0.0, upper = 0.0;
    tdsp_status status = tdsp_table_arrival(table, departure, &lower, &upper);
    if (status == TDSP_OK) printf("leave at %s: arrive from %s to %s\n", number(departure).text, number(lower).text, number(upper).text);
    else printf("leave at %s: %s\n", number(departure).text, tdsp_status_text(status));
}

static void print_departure(const tdsp_table *table, double arrival)
{
    double departure = 0.0, none_after = 0.0;
    tdsp_status status = tdsp_table_departure(table, arrival, &departure, &none_after);
    if (status == TDSP_OK) printf("arrive by %s: leave by %s, none after %s\n", number(arrival).text, number(departure).text, number(none_after).text);
    else printf("arrive by %s: %s\n", number(arrival).text, tdsp_status_text(status));
}

static void print_leg(const tdsp_leg *leg)
{
    printf("  %s from %s at (%s, %s) to %s at (%s, %s)\n", leg->kind == TDSP_LEG_LINE ? "line" : "ride", number(leg->start_time).text,
           number(leg->from.x).text, number(leg->from.y).text, number(leg->end_time).text, number(leg->to.x).text, number(leg->to.y).text);
    if (leg->kind != TDSP_LEG_LINE)
        printf("    on disc %lu, turn %d, from angle %s by %s, radius %s to %s\n", (unsigned long)leg->disc, (int)leg->turn, number(leg->angle_from).text,
               number(leg->sweep).text, number(leg->radius_from).text, number(leg->radius_to).text);
}

static void print_path(const tdsp_table *table, double departure)
{
    size_t count = 0;
    tdsp_status status = tdsp_table_path(table, departure, NULL, 0, &count);
    if (status != TDSP_BUFFER_TOO_SMALL) must("path", status);
    tdsp_leg *legs = malloc((count + 1) * sizeof *legs);
    if (!legs) must("path", TDSP_NO_MEMORY);
    must("path", tdsp_table_path(table, departure, legs, count, &count));
    printf("path for %s: %lu legs\n", number(departure).text, (unsigned long)count);
    for (size_t i = 0; i < count; i++) print_leg(&legs[i]);
    free(legs);
}

static void print_positions(const tdsp_table *table, double departure)
{
    for (int i = 0; i < 6; i++) {
        double time = departure + 5.0 * i;
        tdsp_point place;
        must("position", tdsp_table_position(table, departure, time, &place));
        printf("at %s: (%s, %s)\n", number(time).text, number(place.x).text, number(place.y).text);
    }
}

static void print_batch(const tdsp_table *table)
{
    enum { COUNT = 8 };
    double departures[COUNT], lower[COUNT], upper[COUNT];
    tdsp_status statuses[COUNT];
    for (int i = 0; i < COUNT; i++) departures[i] = 10.0 * i;
    must("batch", tdsp_table_arrivals(table, departures, COUNT, lower, upper, statuses));
    for (int i = 0; i < COUNT; i++) {
        printf("batch %d: %s", i, tdsp_status_name(statuses[i]));
        if (statuses[i] == TDSP_OK) printf(" %s %s", number(lower[i]).text, number(upper[i]).text);
        printf("\n");
    }
}

/* A jump is at a row, and the last row is none: the next may be at the row after it. */
static void print_jumps(const tdsp_table *table)
{
    tdsp_jump jump;
    tdsp_row next = {0};
    while (tdsp_table_next_jump(table, next.departure, &jump) == TDSP_OK) {
        printf("after %s: jump from %s to %s\n", number(jump.departure).text, number(jump.before).text, number(jump.after).text);
        if (jump.gap.first != TDSP_NO_DISC)
            printf("  discs %lu and %lu close at %s, at (%s, %s)\n", (unsigned long)jump.gap.first, (unsigned long)jump.gap.second,
                   number(jump.gap.time).text, number(jump.gap.place.x).text, number(jump.gap.place.y).text);
        must("row", tdsp_table_row(table, jump.row + 1, &next));
    }
}

static void print_table(const tdsp_table *table)
{
    print_info(table);
    print_arrival(table, 0.0);
    print_arrival(table, 5.0);
    print_arrival(table, 40.0);
    print_arrival(table, 61.0);
    print_departure(table, 10.0);
    print_departure(table, 30.0);
    print_departure(table, 1000.0);
    print_path(table, 12.0);
    print_positions(table, 12.0);
    print_batch(table);
    print_jumps(table);
}

static void read_file(const char *name, void **bytes, size_t *length)
{
    FILE *file = fopen(name, "rb");
    long size = -1;
    if (file && !fseek(file, 0, SEEK_END)) size = ftell(file);
    *length = size > 0 ? (size_t)size : 0;
    *bytes = malloc(*length + 1);
    if (!file || size < 0 || !*bytes || fseek(file, 0, SEEK_SET) || fread(*bytes, 1, *length, file) != *length) {
        fprintf(stderr, "read_table: %s: cannot be read\n", name);
        exit(EXIT_FAILURE);
    }
    fclose(file);
}

static void write_file(const char *name, const void *bytes, size_t length)
{
    FILE *file = fopen(name, "wb");
    if (file && fwrite(bytes, 1, length, file) == length && !fclose(file)) return;
    fprintf(stderr, "read_table: %s: cannot be written\n", name);
    exit(EXIT_FAILURE);
}

/* Through the gap between two discs while it is open, around them afterwards. */
static void make_table(void **bytes, size_t *length)
{
    const tdsp_journey journey = {.speed = 1.0, .radius = 0.0, .source = {-10.0, 0.0}, .destination = {10.0, 0.0}};
    const tdsp_disc discs[] = {{.center = {0.0, 3.0}, .radius = 1.0, .growth = 0.1}, {.center = {0.0, -3.0}, .radius = 1.0, .growth = 0.1}};
    tdsp_scene *scene = NULL;
    tdsp_solver *solver = NULL;
    tdsp_oracle oracle;
    tdsp_build_options options;
    double arrival = 0.0, departure = 0.0;
    must("scene", tdsp_scene_create(&journey, discs, 2, NULL, &scene));
    must("solver", tdsp_solver_create(scene, &solver));
    must("arrival", tdsp_earliest_arrival(solver, 9.0, &arrival));
    must("departure", tdsp_latest_departure(solver, 33.0, &departure, NULL));
    printf("made: from 9 to %s; to 33 from %s\n", number(arrival).text, number(departure).text);

    tdsp_build_options_init(&options);
    options.epsilon = 0.05;
    options.world.scene_hash = tdsp_scene_hash(scene);
    options.world.speed = journey.speed;
    options.world.source = journey.source;
    options.world.destination = journey.destination;
    options.world.length_unit = "m";
    options.world.time_unit = "s";
    must("oracle", tdsp_solver_oracle(solver, &oracle));
    must("build", tdsp_build(&oracle, &options, NULL, bytes, length, NULL));
    tdsp_solver_free(solver);
    tdsp_scene_free(scene);
}

int main(int argc, char **argv)
{
    const char *name = argc > 1 ? argv[1] : "tests/golden/answered/two-discs.tdsp";
    void *bytes = NULL;
    size_t length = 0;
    tdsp_table table;
    read_file(name, &bytes, &length);
    must(name, tdsp_table_open(&table, bytes, length));
    print_table(&table);
    free(bytes);

    make_table(&bytes, &length);
    must("made", tdsp_table_open(&table, bytes, length));
    print_table(&table);
    if (argc > 2) write_file(argv[2], bytes, length);
    tdsp_bytes_free(NULL, bytes, length);
    return EXIT_SUCCESS;
}
