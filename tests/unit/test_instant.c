/* SPDX-License-Identifier: MIT */
/* Instants of a scene's times: the calendar, zones, fractions, and the ends of what has four digits. */
#include "support/cmocka_all.h"

#include <string.h>

#include "tdsp/instant.h"

static const char *instant(const char *epoch, double unit, double time)
{
    static char buffer[INSTANT_ROOM];
    Epoch at;
    if (epoch_parse(epoch, unit, &at)) fail_msg("%s", epoch);
    return instant_format(buffer, &at, time);
}

static void times_are_counted_from_the_epoch(void **state)
{
    (void)state;
    assert_string_equal(instant("2026-06-01T12:00:00Z", 1, 0), "2026-06-01T12:00:00Z");
    assert_string_equal(instant("2026-06-01T12:00:00Z", 60, 90), "2026-06-01T13:30:00Z");
    assert_string_equal(instant("2024-02-28T23:59:59Z", 1, 1), "2024-02-29T00:00:00Z");
    assert_string_equal(instant("2026-12-31T23:00:00Z", 3600, 1.5), "2027-01-01T00:30:00Z");
}

static void zones_become_utc(void **state)
{
    (void)state;
    assert_string_equal(instant("2026-06-01T14:00:00+02:00", 1, 0), "2026-06-01T12:00:00Z");
    assert_string_equal(instant("2026-06-01T05:30:00-06:30", 1, 0), "2026-06-01T12:00:00Z");
}

static void fractions_are_microseconds_without_idle_zeros(void **state)
{
    (void)state;
    assert_string_equal(instant("2026-06-01T12:00:00.5Z", 1, 0.25), "2026-06-01T12:00:00.75Z");
    assert_string_equal(instant("2026-06-01T12:00:00Z", 0.001, 1.0004), "2026-06-01T12:00:00.001Z");
    assert_string_equal(instant("2026-06-01T12:00:00Z", 1, 0.9999996), "2026-06-01T12:00:01Z");
    assert_string_equal(instant("1969-12-31T23:59:58Z", 1, 0.000001), "1969-12-31T23:59:58.000001Z");
}

static void nothing_is_said_beyond_the_calendar(void **state)
{
    (void)state;
    assert_string_equal(instant("0001-01-01T00:00:00Z", 1, 0), "0001-01-01T00:00:00Z");
    assert_string_equal(instant("9999-12-31T23:59:59Z", 1, 0), "9999-12-31T23:59:59Z");
    assert_null(instant("9999-12-31T23:59:59Z", 1, 1));
    assert_null(instant("2026-06-01T12:00:00Z", 1, 1e15));
    assert_null(instant("2026-06-01T12:00:00Z", 86400, 1e300));
}

static void an_instant_without_a_zone_is_none(void **state)
{
    (void)state;
    static const char *const wrong[] = {"2026-06-01T12:00:00", "2026-06-01", "12:00:00Z", "", "now", "2026-13-01T12:00:00Z", "2026-06-01T25:00:00Z"};
    Epoch epoch;
    for (gsize i = 0; i < G_N_ELEMENTS(wrong); i++) assert_non_null(epoch_parse(wrong[i], 1, &epoch));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(times_are_counted_from_the_epoch),
        cmocka_unit_test(zones_become_utc),
        cmocka_unit_test(fractions_are_microseconds_without_idle_zeros),
        cmocka_unit_test(nothing_is_said_beyond_the_calendar),
        cmocka_unit_test(an_instant_without_a_zone_is_none),
    };
    return cmocka_run_group_tests_name("instant", tests, NULL, NULL);
}
