/* SPDX-License-Identifier: MIT */
/*
 * A robot's firmware, whole: from reset (startup.c) to places along the way, with the table in flash (route.c, made by `tdsp embed`).
 *
 * It is run on three processors in qemu by `make firmware`; docs/embedding.md goes through it. Printing stands for what firmware does with
 * its motors, and brings in the C library's heap. The reader has none.
 */
#include <stdio.h>

#include "tdsp/path.h"
#include "tdsp/table.h"

extern const unsigned char route[];
extern const size_t route_length;

#define STEPS 5

/* Where the robot has to be, from its departure to its arrival: what a control loop asks at every tick. */
static void follow(const tdsp_table *table, double departure, double arrival)
{
    for (int step = 0; step <= STEPS; step++) {
        double now = departure + (arrival - departure) * step / STEPS;
        tdsp_point place;
        if (tdsp_table_position(table, departure, now, &place) == TDSP_OK) printf("  %6.2f s  (%.3f, %.3f) m\n", now, place.x + 0.0, place.y + 0.0);
    }
}

static void leave(const tdsp_table *table, double departure)
{
    double earliest, latest;
    tdsp_status status = tdsp_table_arrival(table, departure, &earliest, &latest);
    if (status != TDSP_OK) {
        printf("leave at %.1f s: stay. %s\n", departure, tdsp_status_text(status));
        return;
    }
    printf("leave at %.1f s: there between %.3f and %.3f s\n", departure, earliest, latest);
    follow(table, departure, latest);
}

/* A machine that does floats in hardware and doubles in software need not leave floats to ask when it will be there. */
static void leave_float(const tdsp_table *table, float departure)
{
    float earliest, latest;
    if (tdsp_table_arrival_float(table, departure, &earliest, &latest) == TDSP_OK)
        printf("in floats, leave at %.1f s: there between %.3f and %.3f s\n", (double)departure, (double)earliest, (double)latest);
}

int main(void)
{
    tdsp_table table;
    tdsp_status status = tdsp_table_open(&table, route, route_length);
    if (status != TDSP_OK) {
        printf("the table in flash is unusable: %s\n", tdsp_status_text(status));
        return 1;
    }
    leave(&table, 0.0);
    leave(&table, 9.5);
    leave_float(&table, 9.5F);
    leave(&table, 1000.0);
    return 0;
}
