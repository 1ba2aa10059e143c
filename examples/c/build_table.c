/* SPDX-License-Identifier: MIT */
/*
 * Build a table once, then answer from its bytes alone: arrivals with their guarantee, the path, the robot's position.
 *
 * The bytes are what `tdsp build` writes to a file. After tdsp_table_open() neither scene nor solver is needed any more; here they
 * are freed first to show it.
 */
#include <stdio.h>
#include <stdlib.h>

#include "tdsp/build.h"
#include "tdsp/scene.h"
#include "tdsp/solver.h"
#include "tdsp/table.h"

static void must(tdsp_status status)
{
    if (status == TDSP_OK) return;
    fprintf(stderr, "build_table: %s\n", tdsp_status_text(status));
    exit(EXIT_FAILURE);
}

static void build(void **bytes, size_t *length)
{
    const tdsp_journey journey = {.speed = 1.5, .radius = 0.25, .source = {0.0, 0.0}, .destination = {12.0, 1.0}};
    const tdsp_disc people[] = {
        {.center = {3.0, 0.5}, .radius = 0.3, .growth = 0.3},
        {.center = {6.0, -1.0}, .radius = 0.3, .growth = 0.0},
        {.center = {7.5, 2.0}, .radius = 0.3, .growth = 0.2},
    };
    tdsp_scene *scene = NULL;
    tdsp_solver *solver = NULL;
    tdsp_oracle oracle;
    tdsp_build_options options;
    tdsp_build_report report;
    must(tdsp_scene_create(&journey, people, 3, NULL, &scene));
    must(tdsp_solver_create(scene, &solver));
    must(tdsp_solver_oracle(solver, &oracle));

    tdsp_build_options_init(&options);
    options.guarantee = TDSP_GUARANTEE_TRAVEL;
    options.epsilon = 0.01;
    options.world.scene_hash = tdsp_scene_hash(scene);
    options.world.speed = journey.speed;
    options.world.source = journey.source;
    options.world.destination = journey.destination;
    options.world.length_unit = "m";
    options.world.time_unit = "s";
    must(tdsp_build(&oracle, &options, NULL, bytes, length, &report));
    printf("departures up to %.3f s, then: %s\n", report.last_departure, tdsp_status_text(report.last_reason));

    tdsp_solver_free(solver);
    tdsp_scene_free(scene);
}

static void print_arrival(const tdsp_table *table, double departure)
{
    double lower = 0.0, upper = 0.0;
    tdsp_status status = tdsp_table_arrival(table, departure, &lower, &upper);
    if (status != TDSP_OK) {
        printf("leave at %.2f s: %s\n", departure, tdsp_status_text(status));
        return;
    }
    int kept = upper - departure <= 1.01 * (lower - departure);
    printf("leave at %.2f s: arrive by %.2f s; within 1 %% of the best: %s\n", departure, upper, kept ? "yes" : "no");
}

int main(void)
{
    void *bytes = NULL;
    size_t length = 0;
    tdsp_table table;
    tdsp_point halfway;
    double upper = 0.0;
    build(&bytes, &length);
    must(tdsp_table_open(&table, bytes, length));
    print_arrival(&table, 0.0);
    print_arrival(&table, 2.5);
    print_arrival(&table, 1000.0);
    must(tdsp_table_arrival(&table, 2.5, NULL, &upper));
    must(tdsp_table_position(&table, 2.5, 0.5 * (2.5 + upper), &halfway));
    printf("halfway at (%.1f, %.1f)\n", halfway.x, halfway.y);
    tdsp_bytes_free(NULL, bytes, length);
    return EXIT_SUCCESS;
}
