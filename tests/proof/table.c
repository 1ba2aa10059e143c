/* SPDX-License-Identifier: MIT */
/*
 * What the proof of the table reader runs: every table of LENGTH bytes, opened by OPEN, and, where ASK is 1, every question to it.
 *
 * Frama-C's Eva follows all runs of this program at once. A byte is any byte, an argument any value of its type, so an alarm-free analysis says that no
 * table of that length leads any function asked here to read or write outside its objects, to read what was never set, or
 * into any other undefined behaviour. The bytes are an object of exactly LENGTH bytes: one byte farther is outside.
 *
 * The length that is told is any from LENGTH to LONGEST, which is LENGTH by itself: what holds of a told length and fewer bytes holds of as many bytes.
 *
 * Eva keeps bounds of each number, not how two of them belong together. That a row's place is inside the bytes needs the number of rows, so it is
 * taken case by case: each number that the bytes have room for, and all the others, which opening has to refuse.
 */
#include <stdlib.h>

#include "__fc_builtin.h"

#include "proof/any.h"
#include "table/format.h"
#include "tdsp/path.h"
#include "tdsp/table.h"

/* As many as make the look-ups of a batch go on to a second group. */
#define TIMES 18
#define LEGS 3

/* Rows that `length` bytes have room for, each with three numbers: fewer than a byte can say, as the proof needs. */
#define MOST_ROWS (LENGTH / 24)
#if MOST_ROWS > 254
#error "the cases of the number of rows are told apart by their first byte"
#endif

static void ask_rows(const tdsp_table *table)
{
    tdsp_row row;
    tdsp_leg leg;
    const void *opaque;
    size_t length;
    tdsp_table_row(table, any_u64(), &row);
    tdsp_table_row_leg(table, any_u64(), any_u64(), &leg);
    tdsp_table_row_bytes(table, any_u64(), &opaque, &length);
}

static void ask_times(const tdsp_table *table)
{
    uint64_t row;
    double lower, upper;
    float low, high;
    tdsp_jump jump;
    tdsp_table_find(table, any_double(), &row);
    tdsp_table_arrival(table, any_double(), any_bit() ? &lower : NULL, any_bit() ? &upper : NULL);
    tdsp_table_arrival_float(table, any_float(), any_bit() ? &low : NULL, any_bit() ? &high : NULL);
    tdsp_table_departure(table, any_double(), any_bit() ? &lower : NULL, any_bit() ? &upper : NULL);
    tdsp_table_next_jump(table, any_double(), &jump);
    tdsp_table_previous_jump(table, any_double(), &jump);
}

static void ask_many(const tdsp_table *table)
{
    double times[TIMES], lower[TIMES], upper[TIMES];
    uint64_t rows[TIMES];
    tdsp_status statuses[TIMES];
    size_t count = any_size(TIMES);
    any_bytes(times, sizeof times);
    tdsp_table_arrivals(table, times, count, any_bit() ? lower : NULL, any_bit() ? upper : NULL, any_bit() ? statuses : NULL);
    tdsp_table_departures(table, times, count, any_bit() ? lower : NULL, any_bit() ? upper : NULL, any_bit() ? statuses : NULL);
    tdsp_table_rows(table, times, count, any_bit() ? rows : NULL, any_bit() ? statuses : NULL);
}

static void ask_paths(const tdsp_table *table)
{
    tdsp_leg legs[LEGS];
    tdsp_point place;
    size_t count;
    tdsp_table_leg(table, any_double(), any_u64(), &legs[0]);
    tdsp_table_position(table, any_double(), any_double(), &place);
    tdsp_table_path(table, any_double(), legs, any_size(LEGS), &count);
}

/* Legs need not come from a table. */
static void ask_legs(void)
{
    tdsp_leg legs[LEGS];
    tdsp_point place;
    any_bytes(legs, sizeof legs);
    tdsp_path_position(legs, any_size(LEGS), any_double(), &place);
    legs[0] = tdsp_leg_shifted(&legs[0], any_double());
}

static void ask(const tdsp_table *table)
{
    tdsp_table_info info;
    tdsp_table_get_info(table, &info);
    ask_rows(table);
    ask_times(table);
    ask_many(table);
    ask_paths(table);
    ask_legs();
}

static size_t told_length(void)
{
    return LENGTH == LONGEST ? LENGTH : (size_t)Frama_C_interval(LENGTH, LONGEST);
}

/*
 * OPEN: tdsp_table_open or tdsp_table_reopen. The second accepts all that the first accepts, and makes the same view of it, since what the first checks besides leaves the
 * view as it is: so the questions are put to what the second accepts, and answered for both. That neither accepts what is shorter than a header is what matrix.c builds on.
 */
static void open_and_ask(const unsigned char *bytes)
{
    tdsp_table table = {0};
    size_t length = told_length();
    if (OPEN(&table, bytes, length) != TDSP_OK) return;
    /*@ assert length >= FORMAT_HEADER_LENGTH; */
    if (ASK) ask(&table);
}

#if LENGTH >= FORMAT_AT_ROWS + 8

/* Of any bytes, those whose number of rows has `first` for its first byte and nothing else. */
static void with_rows(unsigned char *bytes, unsigned char first)
{
    any_bytes(bytes, LENGTH);
    for (size_t i = 0; i < 8; i++) bytes[FORMAT_AT_ROWS + i] = 0;
    bytes[FORMAT_AT_ROWS] = first;
    open_and_ask(bytes);
}

/* All numbers of rows that fit, the others below 256, and those that are not: they have some other byte that is not 0. */
static void all_tables(unsigned char *bytes)
{
    for (unsigned rows = 1; rows <= MOST_ROWS; rows++) with_rows(bytes, (unsigned char)rows);
    with_rows(bytes, 0);
    with_rows(bytes, (unsigned char)Frama_C_interval(MOST_ROWS + 1, 255));
    for (size_t i = 1; i < 8; i++) {
        any_bytes(bytes, LENGTH);
        bytes[FORMAT_AT_ROWS + i] = (unsigned char)Frama_C_interval(1, 255);
        open_and_ask(bytes);
    }
}

#else

/* Too short to say how many rows. */
static void all_tables(unsigned char *bytes)
{
    any_bytes(bytes, LENGTH);
    open_and_ask(bytes);
}

#endif

int main(void)
{
    unsigned char *bytes = malloc(LENGTH);
    if (bytes) all_tables(bytes);
    free(bytes);
    return 0;
}
