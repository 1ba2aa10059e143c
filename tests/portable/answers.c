/* SPDX-License-Identifier: MIT */
/*
 * Everything that the reader says about files, to the bit: run on any machine, the output must be the same. It needs the reader's library only
 * (layers 0 to 2), so it runs where nothing else of the library does.
 *
 *   answers FILE...
 *
 * Numbers are printed as the bits of the double, places on arcs and curves too: the library brings its own sine, cosine and logarithm.
 */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tdsp/matrix.h"
#include "tdsp/path.h"
#include "tdsp/table.h"

#define MOST_LEGS 64

static void say(const char *what, double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    printf(" %s=%016" PRIx64, what, bits);
}

static void say_info(const tdsp_table *table)
{
    tdsp_table_info info;
    if (tdsp_table_get_info(table, &info) != TDSP_OK) return;
    printf("  info %u.%u %" PRIu32 " %" PRIu32 " %" PRIu32 " rows %" PRIu64 " legs %" PRIu64 " curves %" PRIu64 " gaps %" PRIu64, info.version_major,
           info.version_minor, info.monotone, info.guarantee, info.sampling, info.rows, info.legs, info.curves, info.gaps);
    printf(" hash %016" PRIx64 " guide %" PRIu64 " %s '%s' '%s'", info.scene_hash, info.guide_length, tdsp_status_name(info.last_reason),
           info.length_unit, info.time_unit);
    say("epsilon", info.epsilon);
    say("delta", info.delta);
    say("error", info.error);
    say("speed", info.speed);
    say("first", info.first_lower);
    say("last", info.last_departure);
    printf("\n");
}

static void say_arrival(const tdsp_table *table, double departure)
{
    double lower = 0, upper = 0;
    tdsp_status status = tdsp_table_arrival(table, departure, &lower, &upper);
    printf("  arrival");
    say("t", departure);
    printf(" %s", tdsp_status_name(status));
    say("lower", lower);
    say("upper", upper);
    printf("\n");
}

static void say_departure(const tdsp_table *table, double arrival)
{
    double departure = 0, upper = 0;
    tdsp_status status = tdsp_table_departure(table, arrival, &departure, &upper);
    printf("  departure");
    say("a", arrival);
    printf(" %s", tdsp_status_name(status));
    say("safe", departure);
    say("none", upper);
    printf("\n");
}

static void say_leg(const tdsp_leg *leg)
{
    const double numbers[] = {leg->start_time, leg->end_time,  leg->from.x,     leg->from.y,     leg->to.x,       leg->to.y,     leg->center.x,
                              leg->center.y,   leg->radius_from, leg->radius_to, leg->angle_from, leg->sweep,      leg->rate_from, leg->rate_to,
                              leg->bend_from,  leg->bend_to,   leg->speed};
    printf("  leg %" PRIu32 " %" PRIu32 " %" PRId32, leg->kind, leg->disc, leg->turn);
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) say("", numbers[i]);
    printf("\n");
    tdsp_point middle = tdsp_leg_position(leg, leg->start_time + 0.375 * (leg->end_time - leg->start_time));
    printf("  place");
    say("x", middle.x);
    say("y", middle.y);
    printf("\n");
}

static void say_path(const tdsp_table *table, double departure)
{
    tdsp_leg legs[MOST_LEGS];
    size_t count = 0;
    tdsp_status status = tdsp_table_path(table, departure, legs, MOST_LEGS, &count);
    printf("  path %s %" PRIu64 "\n", tdsp_status_name(status), (uint64_t)count);
    for (size_t i = 0; status == TDSP_OK && i < count; i++) say_leg(&legs[i]);
}

static void say_jump(const tdsp_table *table, double departure)
{
    tdsp_jump jump;
    if (tdsp_table_next_jump(table, departure, &jump) != TDSP_OK) return;
    printf("  jump %" PRIu64 " gap %" PRIu32 " %" PRIu32, jump.row, jump.gap.first, jump.gap.second);
    say("at", jump.departure);
    say("before", jump.before);
    say("after", jump.after);
    say("time", jump.gap.time);
    printf("\n");
}

/* At each row, between it and the one before, and a little after it; backwards at each row's arrival and beside it. */
static void say_row(const tdsp_table *table, uint64_t i, double *before)
{
    tdsp_row row;
    const void *bytes = NULL;
    size_t length = 0;
    if (tdsp_table_row(table, i, &row) != TDSP_OK) return;
    tdsp_status status = tdsp_table_row_bytes(table, i, &bytes, &length);
    printf("  row %" PRIu64 " %s", i, tdsp_status_name(status));
    for (size_t k = 0; status == TDSP_OK && k < length; k++) printf(" %02x", ((const unsigned char *)bytes)[k]);
    say("b", row.departure);
    say("left", row.left);
    say("right", row.right);
    printf("\n");
    say_arrival(table, row.departure);
    say_arrival(table, (*before + row.departure) / 2);
    say_departure(table, row.departure + row.left);
    say_departure(table, row.departure + row.right);
    say_departure(table, row.departure + 0.75 * row.left);
    say_path(table, (*before + row.departure) / 2);
    say_jump(table, *before);
    *before = row.departure;
}

static void say_table(const tdsp_table *table)
{
    double before = 0;
    tdsp_table_info info = {0};
    say_info(table);
    tdsp_table_get_info(table, &info);
    for (uint64_t i = 0; i < info.rows; i++) say_row(table, i, &before);
    say_arrival(table, before * 2 + 1);
    say_arrival(table, -1);
    say_departure(table, 0);
}

static void say_matrix(const tdsp_matrix *matrix)
{
    uint64_t sources = 0, destinations = 0;
    if (tdsp_matrix_size(matrix, &sources, &destinations) != TDSP_OK) return;
    for (uint64_t k = 0; k < sources * destinations; k++) {
        tdsp_matrix_end end;
        tdsp_table table;
        if (tdsp_matrix_source(matrix, k / destinations, &end) != TDSP_OK) return;
        printf(" from '%.*s'", (int)end.name_length, end.name);
        say("x", end.place.x);
        say("y", end.place.y);
        if (tdsp_matrix_destination(matrix, k % destinations, &end) != TDSP_OK) return;
        tdsp_status status = tdsp_matrix_table(matrix, k / destinations, k % destinations, &table);
        printf(" to '%.*s' %s\n", (int)end.name_length, end.name, tdsp_status_name(status));
        if (status == TDSP_OK) say_table(&table);
    }
}

static void say_file(const char *name, const unsigned char *bytes, size_t length)
{
    tdsp_table table;
    tdsp_matrix matrix;
    size_t stem = strlen(name);
    int is_matrix = stem > 6 && strcmp(name + stem - 6, ".tdspm") == 0;
    tdsp_status status = is_matrix ? tdsp_matrix_open(&matrix, bytes, length) : tdsp_table_open(&table, bytes, length);
    const char *slash = strrchr(name, '/');
    printf("%s %s\n", slash ? slash + 1 : name, tdsp_status_name(status));
    if (status != TDSP_OK) return;
    if (is_matrix)
        say_matrix(&matrix);
    else
        say_table(&table);
}

/* The bytes lie at an odd address, in a block of just their length: a reader that asks for alignment, or too far, is found out. */
static int read_and_say(const char *name)
{
    FILE *file = fopen(name, "rb");
    long length = -1;
    if (file && fseek(file, 0, SEEK_END) == 0) length = ftell(file);
    unsigned char *block = length >= 0 ? malloc((size_t)length + 1) : NULL;
    int read = block && fseek(file, 0, SEEK_SET) == 0 && fread(block + 1, 1, (size_t)length, file) == (size_t)length;
    if (read)
        say_file(name, block + 1, (size_t)length);
    else
        fprintf(stderr, "answers: cannot read %s\n", name);
    free(block);
    if (file) fclose(file);
    return read;
}

int main(int argc, char **argv)
{
    int read = argc > 1;
    for (int i = 1; i < argc; i++) read = read_and_say(argv[i]) && read;
    return read ? 0 : 1;
}
