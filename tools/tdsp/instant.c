/* SPDX-License-Identifier: MIT */
/* Instants by GDateTime, which knows the calendar; microseconds are added here, so that they stay whole. */
#include "instant.h"

#include <math.h>
#include <string.h>

#define SECOND 1000000
#define FARTHEST 4e17 /* microseconds: over ten thousand years */

const char *epoch_parse(const char *text, double unit, Epoch *epoch)
{
    g_autoptr(GDateTime) instant = g_date_time_new_from_iso8601(text, NULL);
    if (!instant) return "must be an instant with its zone, as 2026-06-01T12:00:00Z";
    epoch->known = TRUE;
    epoch->microseconds = g_date_time_to_unix(instant) * SECOND + g_date_time_get_microsecond(instant);
    epoch->unit = unit;
    return NULL;
}

/* .25 and the like; nothing for whole seconds. */
static void append_fraction(char *text, gsize room, gint64 fraction)
{
    gsize length = strlen(text);
    if (fraction == 0) return;
    g_snprintf(text + length, room - length, ".%06" G_GINT64_FORMAT, fraction);
    for (length = strlen(text); text[length - 1] == '0'; length--) text[length - 1] = '\0';
}

const char *instant_format(char buffer[INSTANT_ROOM], const Epoch *epoch, double time)
{
    double later = rint(time * epoch->unit * SECOND);
    if (!(fabs(later) < FARTHEST)) return NULL;
    gint64 instant = epoch->microseconds + (gint64)later, fraction = instant % SECOND;
    if (fraction < 0) fraction += SECOND;
    g_autoptr(GDateTime) at = g_date_time_new_from_unix_utc((instant - fraction) / SECOND);
    if (!at) return NULL;
    g_snprintf(buffer, INSTANT_ROOM, "%04d-%02d-%02dT%02d:%02d:%02d", g_date_time_get_year(at), g_date_time_get_month(at),
               g_date_time_get_day_of_month(at), g_date_time_get_hour(at), g_date_time_get_minute(at), g_date_time_get_second(at));
    append_fraction(buffer, INSTANT_ROOM - 1, fraction);
    g_strlcat(buffer, "Z", INSTANT_ROOM);
    return buffer;
}
