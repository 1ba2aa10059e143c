/* SPDX-License-Identifier: MIT */
/* Random rows have flat stretches, slopes, jumps, and departures that are neighbouring doubles. */
#include "support/sample.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/round.h"
#include "support/chance.h"
#include "support/cmocka_all.h"

void sample_free(sample *s)
{
    free(s->bytes);
    free(s->rows);
}

sample sample_golden(size_t which)
{
    const golden_table *golden = &golden_tables[which];
    sample s = {0};
    size_t length;
    s.count = golden->row_count;
    s.rows = malloc(s.count * sizeof *s.rows);
    s.bytes = golden_write(golden, &length);
    assert_true(s.rows && s.bytes);
    memcpy(s.rows, golden->rows, s.count * sizeof *s.rows);
    s.first_lower = golden->header.first_lower;
    s.travel = golden->header.monotone == TDSP_MONOTONE_TRAVEL;
    assert_int_equal(tdsp_table_open(&s.table, s.bytes, length), TDSP_OK);
    return s;
}

static void sample_random_rows(uint64_t *chance, writer_row *rows, size_t count, int travel)
{
    double b = 0, low = chance_between(chance, 0, 10), high = low;
    memset(rows, 0, count * sizeof *rows);
    for (size_t i = 0; i < count; i++) {
        if (i > 0) b = chance_below(chance, 20) ? b + chance_between(chance, 0, 1) + 1e-9 : nextafter(b, INFINITY);
        if (!travel && low < b) low = b;
        if (chance_below(chance, 3)) low += chance_between(chance, 0, 1);
        high = chance_below(chance, 10) ? low : low + chance_between(chance, 0, 3);
        rows[i].departure = b;
        rows[i].left = travel ? low : round_subtract_up(low, b);
        rows[i].right = travel ? high : round_subtract_down(high, b);
        low = high;
    }
}

sample sample_random(uint64_t *chance, size_t count, int travel, int horizon)
{
    sample s = {0};
    size_t length;
    writer_header header = golden_tables[travel ? 2 : 1].header;
    header.last_reason = horizon ? TDSP_HORIZON : TDSP_CUT_OFF;
    s.rows = malloc(count * sizeof *s.rows);
    assert_non_null(s.rows);
    sample_random_rows(chance, s.rows, count, travel);
    if (!horizon) s.rows[count - 1].right = INFINITY;
    s.count = count;
    s.travel = travel;
    s.first_lower = header.first_lower = s.rows[0].left * 0.75;
    s.bytes = golden_rows(&header, s.rows, count, &length);
    assert_non_null(s.bytes);
    assert_int_equal(tdsp_table_open(&s.table, s.bytes, length), TDSP_OK);
    return s;
}

double sample_departure(uint64_t *chance, const sample *s)
{
    double b = s->rows[chance_below(chance, s->count)].departure;
    switch (chance_below(chance, 4)) {
    case 0: return b;
    case 1: return nextafter(b, INFINITY);
    case 2: return b > 0 ? nextafter(b, 0) : 0;
    default: return chance_between(chance, 0, s->rows[s->count - 1].departure * 1.1 + 1);
    }
}

double sample_arrival(uint64_t *chance, const sample *s)
{
    const writer_row *row = &s->rows[chance_below(chance, s->count)];
    double right = row->right < INFINITY ? row->right : row->left;
    switch (chance_below(chance, 5)) {
    case 0: return row->departure + row->left;
    case 1: return row->departure + right;
    case 2: return nextafter(row->departure + row->left, chance_below(chance, 2) ? INFINITY : 0);
    case 3: return nextafter(row->departure + right, chance_below(chance, 2) ? INFINITY : 0);
    default: return chance_between(chance, 0, s->rows[s->count - 1].departure * 1.1 + s->rows[s->count - 1].left * 1.2);
    }
}

size_t sample_scan_row(const sample *s, double departure)
{
    size_t row = 0;
    while (row < s->count && s->rows[row].departure < departure) row++;
    return row;
}
