/*
 * Jumps of the travel time.
 *
 * T(b) <= left and right <= T(b+) are rounded outward, so right over left already proves that T rises between b and the next
 * double. What is called a jump rises by more than error and resolution explain: twice the stated error once more,
 * and 2^-40 of the arrival, since right may have been taken at the next double, where a steep T has risen a little.
 */
#include "base/round.h"
#include "query/locate.h"
#include "tdsp/table.h"

static int jump_at(const tdsp_table *table, uint64_t row, tdsp_jump *out)
{
    double departure = table_departure(table, row);
    double left = table_left(table, row);
    double right = table_right(table, row);
    double error = table_header_f64(table, FORMAT_AT_ERROR) * (left + table_header_f64(table, FORMAT_AT_TIME_SCALE));
    double resolution = (departure + left) / 1099511627776.0;
    if (!round_is_finite(right) || !(right - left > 2 * error + resolution)) return 0;
    out->row = row;
    out->departure = departure;
    out->before = left;
    out->after = right;
    return 1;
}

static int jump_asked(const tdsp_table *table, double departure, const tdsp_jump *out)
{
    return table && table->bytes && out && departure == departure;
}

tdsp_status tdsp_table_next_jump(const tdsp_table *table, double departure, tdsp_jump *out)
{
    if (!jump_asked(table, departure, out)) return TDSP_INVALID_ARGUMENT;
    for (uint64_t row = locate_first_row(table, departure); row < table->rows; row++) {
        if (jump_at(table, row, out)) return TDSP_OK;
    }
    return TDSP_NO_ANSWER;
}

tdsp_status tdsp_table_previous_jump(const tdsp_table *table, double departure, tdsp_jump *out)
{
    if (!jump_asked(table, departure, out)) return TDSP_INVALID_ARGUMENT;
    for (uint64_t row = locate_first_row(table, departure); row > 0; row--) {
        if (jump_at(table, row - 1, out)) return TDSP_OK;
    }
    return TDSP_NO_ANSWER;
}
