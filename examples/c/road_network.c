/* SPDX-License-Identifier: MIT */
/*
 * A table over roads: congestion comes and goes, a ferry leaves every half hour, and the answer is still a look-up.
 *
 * Each road takes a piecewise linear time that depends on when it is entered. The network must be FIFO: who enters a road earlier leaves it no later,
 * so the slopes are at least -1 (on a slope of -1 everybody leaves at once, as from a ferry that is waited for) and jumps go up. Then waiting never
 * helps, Dijkstra's algorithm is exact, and A(t) never decreases: the oracle is monotone in arrival. It knows both directions, runs them on the
 * loop that the disc engine runs on, and hands out its routes as bytes: the places in order, two bytes each, the low byte first. Times are in
 * minutes after six.
 */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tdsp/build.h"
#include "tdsp/oracle.h"
#include "tdsp/oracle_check.h"
#include "tdsp/search.h"
#include "tdsp/table.h"

/* ---------------------------------------------------------------------------------------------------------- the network */

/* Who enters at `time` takes `minutes`; linear between, constant before the first and after the last. Of two at one time the first holds there. */
typedef struct profile_point {
    double time, minutes;
} profile_point;

typedef struct road {
    uint32_t from, to;
    const profile_point *profile;
    uint32_t points;
} road;

/* Adjacency arrays: the roads out of place p are out[first_out[p]] up to out[first_out[p + 1] - 1], those into it likewise. */
typedef struct network {
    uint32_t places, source, destination;
    const road *roads;
    uint32_t *first_out, *out;
    uint32_t *first_in, *in;
    tdsp_search *search;
    unsigned char *settled; /* of each place, in the search that runs */
    uint32_t *previous;     /* of each place, in the last forward search: the road to it */
    double reached;         /* when the goal was */
    unsigned char *route;   /* the last one handed out */
    double last_time;       /* of any profile */
} network;

static double point_arrival(const profile_point *p)
{
    return p->time + p->minutes;
}

/* When does who enters a road at `time` leave it? */
static double road_arrival(const road *r, double time)
{
    const profile_point *p = r->profile;
    uint32_t next = 0;
    while (next < r->points && p[next].time < time)
        next++;
    if (next == 0) return time + p[0].minutes;
    if (next == r->points) return time + p[next - 1].minutes;
    double share = (time - p[next - 1].time) / (p[next].time - p[next - 1].time);
    return time + p[next - 1].minutes + (p[next].minutes - p[next - 1].minutes) * share;
}

/* When must one enter it at the latest, to leave it at `arrival`? The end of a plateau, the lower side of a jump. */
static double road_departure(const road *r, double arrival)
{
    const profile_point *p = r->profile;
    uint32_t next = 0;
    while (next < r->points && point_arrival(&p[next]) <= arrival)
        next++;
    if (next == 0) return arrival - p[0].minutes;
    if (next == r->points) return arrival - p[next - 1].minutes;
    double before = point_arrival(&p[next - 1]);
    double share = (arrival - before) / (point_arrival(&p[next]) - before);
    return fmin(p[next - 1].time + (p[next].time - p[next - 1].time) * share, arrival);
}

/* 1, or 0 and what is wrong. */
static int road_is_fifo(const road *r, uint32_t number, char *message, size_t room)
{
    for (uint32_t i = 0; i < r->points; i++) {
        const profile_point *p = &r->profile[i];
        if (!isfinite(p->time) || !isfinite(p->minutes) || p->minutes < 0) {
            snprintf(message, room, "road %u from %u to %u: point %u is %g minutes at %g", number, r->from, r->to, i, p->minutes, p->time);
            return 0;
        }
        if (i == 0 || (p[-1].time <= p->time && point_arrival(&p[-1]) <= point_arrival(p))) continue;
        const char *format = p[-1].time > p->time ? "road %u from %u to %u: its times run back from %g (arriving at %g) to %g (arriving at %g)"
                                                  : "road %u from %u to %u is not FIFO: who enters at %g arrives at %g, who enters at %g "
                                                    "overtakes and arrives at %g";
        snprintf(message, room, format, number, r->from, r->to, p[-1].time, point_arrival(&p[-1]), p->time, point_arrival(p));
        return 0;
    }
    if (r->points > 0) return 1;
    snprintf(message, room, "road %u from %u to %u has no profile", number, r->from, r->to);
    return 0;
}

/* Sort the roads by one of their ends, by counting. */
static void adjacency(const network *n, uint32_t count, int by_head, uint32_t *first, uint32_t *sorted)
{
    for (uint32_t i = 0; i < count; i++)
        first[(by_head ? n->roads[i].to : n->roads[i].from) + 1]++;
    for (uint32_t p = 0; p < n->places; p++)
        first[p + 1] += first[p];
    for (uint32_t i = count; i-- > 0;) {
        uint32_t place = by_head ? n->roads[i].to : n->roads[i].from;
        sorted[--first[place + 1]] = i;
    }
    /* Each count was used up from its end to its beginning: one place to the left of where it belongs. */
    memmove(first, first + 1, n->places * sizeof *first);
    first[n->places] = count;
}

static void network_free(network *n)
{
    tdsp_search_free(n->search);
    free(n->first_out);
    free(n->out);
    free(n->first_in);
    free(n->in);
    free(n->settled);
    free(n->previous);
    free(n->route);
    memset(n, 0, sizeof *n);
}

static int network_allocate(network *n, uint32_t count)
{
    n->first_out = calloc(n->places + 1, sizeof *n->first_out);
    n->first_in = calloc(n->places + 1, sizeof *n->first_in);
    n->out = calloc(count + 1, sizeof *n->out);
    n->in = calloc(count + 1, sizeof *n->in);
    n->settled = calloc(n->places, 1);
    n->previous = calloc(n->places, sizeof *n->previous);
    n->route = calloc(n->places, 2);
    return n->first_out && n->first_in && n->out && n->in && n->settled && n->previous && n->route &&
           tdsp_search_create(NULL, &n->search) == TDSP_OK;
}

/* Places are numbered from 0, at most 65,536. The roads are borrowed. 1, or 0 and what is wrong with them. */
static int network_make(network *n, uint32_t places, const road *roads, uint32_t count, char *message, size_t room)
{
    memset(n, 0, sizeof *n);
    n->places = places;
    n->destination = places - 1;
    n->roads = roads;
    for (uint32_t i = 0; i < count; i++) {
        if (roads[i].from >= places || roads[i].to >= places) {
            snprintf(message, room, "road %u from %u to %u: there are only %u places", i, roads[i].from, roads[i].to, places);
            return 0;
        }
        if (!road_is_fifo(&roads[i], i, message, room)) return 0;
        n->last_time = fmax(n->last_time, roads[i].profile[roads[i].points - 1].time);
    }
    if (!network_allocate(n, count)) {
        network_free(n);
        snprintf(message, room, "there is not enough memory");
        return 0;
    }
    adjacency(n, count, 0, n->first_out, n->out);
    adjacency(n, count, 1, n->first_in, n->in);
    return 1;
}

/* ------------------------------------------------------------------------------------------------------------ the search */

/* The first label of a place is its best; `kind` is the road that it came by. */
static int settle(network *n, const tdsp_label *label, uint32_t goal, int *done)
{
    if (n->settled[label->id]) return 0;
    n->settled[label->id] = 1;
    if (label->id != goal) return 1;
    n->reached = label->time;
    *done = 1;
    return 0;
}

static tdsp_status expand_forward(void *ctx, const tdsp_label *label, tdsp_search *open, int *done)
{
    network *n = ctx;
    tdsp_status status = TDSP_OK;
    if (!n->settled[label->id]) n->previous[label->id] = label->kind;
    if (!settle(n, label, n->destination, done)) return TDSP_OK;
    for (uint32_t i = n->first_out[label->id]; i < n->first_out[label->id + 1] && status == TDSP_OK; i++) {
        const road *r = &n->roads[n->out[i]];
        tdsp_label next = {road_arrival(r, label->time), r->to, n->out[i]};
        if (!n->settled[r->to]) status = tdsp_search_push(open, &next);
    }
    return status;
}

/* Backwards the latest moment at a place is what is best: labels hold it with its sign turned. */
static tdsp_status expand_backward(void *ctx, const tdsp_label *label, tdsp_search *open, int *done)
{
    network *n = ctx;
    tdsp_status status = TDSP_OK;
    if (!settle(n, label, n->source, done)) return TDSP_OK;
    for (uint32_t i = n->first_in[label->id]; i < n->first_in[label->id + 1] && status == TDSP_OK; i++) {
        const road *r = &n->roads[n->in[i]];
        tdsp_label next = {-road_departure(r, -label->time), r->from, n->in[i]};
        if (!n->settled[r->from]) status = tdsp_search_push(open, &next);
    }
    return status;
}

static tdsp_status run(network *n, uint32_t start, double time, tdsp_status (*expand)(void *, const tdsp_label *, tdsp_search *, int *))
{
    tdsp_search_problem problem = {.size = sizeof problem, .ctx = n, .expand = expand};
    tdsp_label first = {time, start, UINT32_MAX};
    int found = 0;
    memset(n->settled, 0, n->places);
    tdsp_status status = tdsp_search_run(n->search, &problem, &first, 1, &found);
    return status == TDSP_OK && !found ? TDSP_UNREACHABLE : status;
}

/* ------------------------------------------------------------------------------------------------------------ the oracle */

static tdsp_status earliest_arrival(void *ctx, double departure, double *arrival)
{
    network *n = ctx;
    tdsp_status status = run(n, n->source, departure, expand_forward);
    if (status == TDSP_OK) *arrival = n->reached;
    return status;
}

/* Roads never close: who may arrive whenever he likes may leave whenever he likes. */
static tdsp_status latest_departure(void *ctx, double arrival, double *departure)
{
    network *n = ctx;
    tdsp_status status = run(n, n->destination, isinf(arrival) ? -n->last_time : -arrival, expand_backward);
    if (status != TDSP_OK) return status;
    if (isinf(arrival)) n->reached = -INFINITY;
    if (-n->reached < 0) return TDSP_ARRIVAL_TOO_EARLY;
    *departure = -n->reached;
    return TDSP_OK;
}

/* The route of the last forward search, written from the goal backwards. */
static tdsp_status route(void *ctx, tdsp_oracle_path *out)
{
    network *n = ctx;
    size_t first = 2 * (size_t)n->places;
    for (uint32_t place = n->destination;; place = n->roads[n->previous[place]].from) {
        n->route[--first] = (unsigned char)(place >> 8);
        n->route[--first] = (unsigned char)(place & 255);
        if (place == n->source) break;
    }
    *out = (tdsp_oracle_path){.bytes = n->route + first, .byte_count = 2 * (size_t)n->places - first};
    return TDSP_OK;
}

/* The stated error covers the rounding of each road, stretched by the slopes of those that follow. */
static tdsp_oracle oracle_over(network *n)
{
    tdsp_oracle oracle;
    tdsp_oracle_init(&oracle);
    oracle.ctx = n;
    oracle.monotone = TDSP_MONOTONE_ARRIVAL;
    oracle.error = 1e-11;
    oracle.time_scale = n->last_time;
    oracle.earliest_arrival = earliest_arrival;
    oracle.latest_departure = latest_departure;
    oracle.path = route;
    return oracle;
}

/* -------------------------------------------------------------------------------------------------------------- the town */

enum { HOME, BRIDGE, RING, HARBOUR, ISLAND, SUBURB, WORK, PLACES };

static const char *const names[PLACES] = {"home", "bridge", "ring", "harbour", "island", "suburb", "work"};

/* Jams that build up over an hour to half past seven and dissolve in an hour. */
static const profile_point to_bridge[] = {{30, 10}, {90, 15}, {150, 10}};
static const profile_point over_bridge[] = {{30, 12}, {90, 52}, {150, 12}};
static const profile_point to_ring[] = {{30, 16}, {90, 22}, {150, 16}};
static const profile_point along_ring[] = {{30, 14}, {90, 24}, {150, 14}};
static const profile_point through_suburb[] = {{30, 11}, {90, 19}, {150, 11}};
static const profile_point to_harbour[] = {{0, 9}};
static const profile_point from_island[] = {{30, 13}, {90, 15}, {150, 13}};
static const profile_point behind_bridge[] = {{30, 15}, {90, 19}, {150, 15}};
/* A ferry every half hour until half past ten takes 8 minutes: who is there in time takes 8, who is a moment late 38. Then a bridge is lowered. */
static const profile_point ferry[] = {{0, 8},   {0, 38},   {30, 8},  {30, 38},  {60, 8},  {60, 38},  {90, 8},  {90, 38},  {120, 8}, {120, 38},
                                      {150, 8}, {150, 38}, {180, 8}, {180, 38}, {210, 8}, {210, 38}, {240, 8}, {240, 38}, {270, 8}};

#define ROAD(from, to, profile) {from, to, profile, sizeof(profile) / sizeof *(profile)}

static const road town[] = {
    ROAD(HOME, BRIDGE, to_bridge),   ROAD(BRIDGE, WORK, over_bridge),     ROAD(HOME, RING, to_ring),
    ROAD(RING, SUBURB, along_ring),  ROAD(SUBURB, WORK, through_suburb),  ROAD(HOME, HARBOUR, to_harbour),
    ROAD(HARBOUR, ISLAND, ferry),    ROAD(ISLAND, WORK, from_island),     ROAD(BRIDGE, SUBURB, behind_bridge),
};

#define ROADS ((uint32_t)(sizeof town / sizeof *town))

static void must(tdsp_status status)
{
    if (status == TDSP_OK) return;
    fprintf(stderr, "road_network: %s\n", tdsp_status_text(status));
    exit(EXIT_FAILURE);
}

/* An hour's jam that is gone within ten minutes would let the last car overtake: such a network is refused. */
static void print_refusal(void)
{
    static const profile_point impossible[] = {{30, 12}, {90, 52}, {100, 12}};
    const road overtaking[] = {ROAD(0, 1, impossible)};
    char message[200];
    network n;
    if (!network_make(&n, 2, overtaking, 1, message, sizeof message)) printf("refused: %s\n", message);
}

static void check(const tdsp_oracle *oracle)
{
    tdsp_oracle_findings found;
    tdsp_status status = tdsp_oracle_check(oracle, NULL, NULL, &found);
    for (size_t i = 0; status == TDSP_BAD_ORACLE && i < found.count; i++)
        printf("%s: %s\n", tdsp_oracle_callback_name(found.found[i].callback), tdsp_oracle_finding_text(&found.found[i]));
    must(status);
    printf("the oracle keeps its promises\n");
}

static void build(const tdsp_oracle *oracle, void **bytes, size_t *length)
{
    tdsp_build_options options;
    tdsp_build_report report;
    tdsp_build_options_init(&options);
    options.guarantee = TDSP_GUARANTEE_ABSOLUTE;
    options.delta = 2;
    options.horizon = 240; /* roads never close */
    options.world.time_unit = "min";
    must(tdsp_build(oracle, &options, NULL, bytes, length, &report));
    printf("%u rows, good to 2 minutes\n", (unsigned)report.rows);
}

static void print_answer(const tdsp_table *table, double departure)
{
    double lower = 0, upper = 0;
    uint64_t row = 0;
    const void *bytes = NULL;
    size_t count = 0;
    must(tdsp_table_arrival(table, departure, &lower, &upper));
    must(tdsp_table_find(table, departure, &row));
    must(tdsp_table_row_bytes(table, row, &bytes, &count));
    printf("leave at %3.0f: arrive by %5.1f, %s, over", departure, upper,
           upper - lower <= 2 ? "within 2 minutes of the best" : "wrong");
    const unsigned char *places = bytes;
    for (size_t i = 0; i + 1 < count; i += 2)
        printf(" %s", names[places[i] + 256 * places[i + 1]]);
    printf("\n");
}

int main(void)
{
    static const double departures[] = {0, 75, 80, 110, 200};
    void *bytes = NULL;
    size_t length = 0;
    tdsp_table table;
    double departure = 0, upper = 0;
    char message[200];
    network n;
    print_refusal();
    if (!network_make(&n, PLACES, town, ROADS, message, sizeof message)) {
        fprintf(stderr, "road_network: %s\n", message);
        return EXIT_FAILURE;
    }
    tdsp_oracle oracle = oracle_over(&n);
    check(&oracle);
    build(&oracle, &bytes, &length);
    network_free(&n);
    must(tdsp_table_open(&table, bytes, length));
    for (size_t i = 0; i < sizeof departures / sizeof *departures; i++)
        print_answer(&table, departures[i]);
    must(tdsp_table_departure(&table, 150, &departure, &upper));
    printf("to arrive by 150, leave at %.0f; whoever leaves after %.0f is late\n", departure, upper);
    tdsp_bytes_free(NULL, bytes, length);
    return EXIT_SUCCESS;
}
