/* SPDX-License-Identifier: MIT */
/*
 * A robot's firmware: the table is an array in flash, and two headers are all that is needed. No heap, no files, no solver.
 *
 * The array is made on a workstation from examples/scenes/two-discs.json:
 *     tdsp build two-discs.json -o route.tdsp
 *     tdsp embed route.tdsp -o route.c
 * This file and route.c link with libtdsp-query.a. Printing stands for what firmware does with its motors.
 */
#include <stdio.h>

#include "tdsp/path.h"
#include "tdsp/table.h"

extern const unsigned char route[];
extern const size_t route_length;

/* Where a robot that left at `departure` has to be at `now`: what a control loop asks some hundred times a second. */
static tdsp_status set_point(const tdsp_table *table, double departure, double now, tdsp_point *place)
{
    return tdsp_table_position(table, departure, now, place);
}

static void drive(const tdsp_table *table, double departure)
{
    double arrival = 0.0;
    tdsp_status status = tdsp_table_arrival(table, departure, NULL, &arrival);
    if (status != TDSP_OK) {
        printf("leave at %.1f s: stay, %s\n", departure, tdsp_status_text(status));
        return;
    }
    printf("leave at %.1f s: there by %.2f s, by way of", departure, arrival);
    for (int step = 0; step <= 4; step++) {
        tdsp_point place;
        status = set_point(table, departure, departure + step * (arrival - departure) / 4.0, &place);
        if (status == TDSP_OK) printf(" (%.2f, %.2f)", place.x + 0.0, place.y + 0.0);
    }
    printf("\n");
}

int main(void)
{
    tdsp_table table;
    tdsp_status status = tdsp_table_open(&table, route, route_length);
    if (status != TDSP_OK) {
        printf("the table in flash is unusable: %s\n", tdsp_status_text(status));
        return 1;
    }
    drive(&table, 0.0);
    drive(&table, 5.0);
    drive(&table, 9.9);
    double departure = 0.0;
    if (tdsp_table_departure(&table, 33.0, &departure, NULL) == TDSP_OK) {
        printf("to be there by 33.0 s leave by %.2f s\n", departure);
    }
    return 0;
}
