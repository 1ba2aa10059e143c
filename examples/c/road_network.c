/*
 * A table over roads: congestion comes and goes, a ferry leaves every half hour, and the answer is still a look-up.
 *
 * The network is FIFO: who leaves a town earlier arrives earlier or at the same time, waiting where that helps. So A(t) never decreases and
 * the oracle is monotone in arrival. It has no discs and no backward search; its one question is answered by Dijkstra's algorithm on the same
 * loop that the disc engine runs on. A route is stored with each row as bytes: the towns in order. Times are in minutes after six.
 */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "tdsp/build.h"
#include "tdsp/oracle.h"
#include "tdsp/search.h"
#include "tdsp/table.h"

enum { HOME, BRIDGE, RING, HARBOUR, ISLAND, SUBURB, WORK, TOWNS };

static const char *const names[TOWNS] = {"home", "bridge", "ring", "harbour", "island", "suburb", "work"};

/* A road takes `free` minutes, up to `jam` more around half past seven. A ferry leaves at every full `every` minutes. */
typedef struct road {
    uint32_t from, to;
    double free;
    double jam;
    double every; /* 0: not a ferry */
} road;

static const road roads[] = {
    {HOME, BRIDGE, 10, 5, 0},    {BRIDGE, WORK, 12, 40, 0}, {HOME, RING, 16, 6, 0},
    {RING, SUBURB, 14, 10, 0},   {SUBURB, WORK, 11, 8, 0},  {HOME, HARBOUR, 9, 1, 0},
    {HARBOUR, ISLAND, 8, 0, 30}, {ISLAND, WORK, 13, 2, 0},  {BRIDGE, SUBURB, 15, 4, 0},
};

#define ROADS (sizeof roads / sizeof *roads)

typedef struct network {
    tdsp_search *search;
    unsigned char settled[TOWNS];
    uint32_t previous[TOWNS];
    double arrival;
    unsigned char route[TOWNS];
} network;

/* The jam builds up over an hour and dissolves in an hour: a tent, so steep at most -40/60 > -1 that nobody overtakes. */
static double arrival_over(const road *r, double departure)
{
    if (r->every > 0) return ceil(departure / r->every) * r->every + r->free;
    double tent = fmax(0, 1 - fabs(departure - 90) / 60);
    return departure + r->free + r->jam * tent;
}

static tdsp_status expand(void *ctx, const tdsp_label *label, tdsp_search *open, int *done)
{
    network *n = ctx;
    if (n->settled[label->id]) return TDSP_OK;
    n->settled[label->id] = 1;
    n->previous[label->id] = label->kind;
    if (label->id == WORK) {
        n->arrival = label->time;
        *done = 1;
        return TDSP_OK;
    }
    for (size_t i = 0; i < ROADS; i++) {
        if (roads[i].from != label->id || n->settled[roads[i].to]) continue;
        tdsp_label next = {arrival_over(&roads[i], label->time), roads[i].to, label->id};
        tdsp_status status = tdsp_search_push(open, &next);
        if (status != TDSP_OK) return status;
    }
    return TDSP_OK;
}

static tdsp_status earliest_arrival(void *ctx, double departure, double *arrival)
{
    network *n = ctx;
    tdsp_search_problem problem = {.size = sizeof problem, .ctx = n, .expand = expand};
    tdsp_label home = {departure, HOME, HOME};
    int found = 0;
    for (size_t i = 0; i < TOWNS; i++)
        n->settled[i] = 0;
    tdsp_status status = tdsp_search_run(n->search, &problem, &home, 1, &found);
    if (status != TDSP_OK) return status;
    if (!found) return TDSP_UNREACHABLE;
    *arrival = n->arrival;
    return TDSP_OK;
}

/* The route of the last answer, from the goal backwards. */
static tdsp_status route(void *ctx, tdsp_oracle_path *out)
{
    network *n = ctx;
    size_t first = TOWNS;
    for (uint32_t town = WORK; town != HOME; town = n->previous[town])
        n->route[--first] = (unsigned char)town;
    n->route[--first] = HOME;
    *out = (tdsp_oracle_path){.bytes = n->route + first, .byte_count = TOWNS - first};
    return TDSP_OK;
}

static void must(tdsp_status status)
{
    if (status == TDSP_OK) return;
    fprintf(stderr, "road_network: %s\n", tdsp_status_text(status));
    exit(EXIT_FAILURE);
}

static void build(void **bytes, size_t *length)
{
    network n = {.search = NULL};
    tdsp_oracle oracle;
    tdsp_build_options options;
    tdsp_build_report report;
    must(tdsp_search_create(NULL, &n.search));
    tdsp_oracle_init(&oracle);
    oracle.ctx = &n;
    oracle.monotone = TDSP_MONOTONE_ARRIVAL;
    oracle.earliest_arrival = earliest_arrival;
    oracle.path = route;
    tdsp_build_options_init(&options);
    options.guarantee = TDSP_GUARANTEE_ABSOLUTE;
    options.delta = 2;
    options.horizon = 240; /* roads never close */
    options.world.time_unit = "min";
    must(tdsp_build(&oracle, &options, NULL, bytes, length, &report));
    tdsp_search_free(n.search);
    printf("%u rows, good to 2 minutes\n", (unsigned)report.rows);
}

static void print_answer(const tdsp_table *table, double departure)
{
    double lower = 0, upper = 0;
    uint64_t row = 0;
    const void *towns = NULL;
    size_t count = 0;
    must(tdsp_table_arrival(table, departure, &lower, &upper));
    must(tdsp_table_find(table, departure, &row));
    must(tdsp_table_row_bytes(table, row, &towns, &count));
    printf("leave at %3.0f: arrive by %5.1f, %s, over", departure, upper,
           upper - lower <= 2 ? "within 2 minutes of the best" : "wrong");
    for (size_t i = 0; i < count; i++)
        printf(" %s", names[((const unsigned char *)towns)[i]]);
    printf("\n");
}

int main(void)
{
    void *bytes = NULL;
    size_t length = 0;
    tdsp_table table;
    double departure = 0, upper = 0;
    build(&bytes, &length);
    must(tdsp_table_open(&table, bytes, length));
    print_answer(&table, 0);
    print_answer(&table, 75);
    print_answer(&table, 80);
    print_answer(&table, 110);
    print_answer(&table, 200);
    must(tdsp_table_departure(&table, 150, &departure, &upper));
    printf("to arrive by 150, leave at %.0f; whoever leaves after %.0f is late\n", departure, upper);
    tdsp_bytes_free(NULL, bytes, length);
    return EXIT_SUCCESS;
}
