/* SPDX-License-Identifier: MIT */
/* Instants of the calendar for a scene's times, to a microsecond, as ISO 8601 in UTC. */
#ifndef INSTANT_H
#define INSTANT_H

#include <glib.h>

/* Which instant the scene's time 0 is, and how many seconds its unit of time has. */
typedef struct Epoch {
    gboolean known;
    gint64 microseconds; /* since 1970-01-01T00:00:00Z */
    double unit;
} Epoch;

/* An instant as ISO 8601 with its zone, as 2026-06-01T12:00:00Z or 2026-06-01T14:00:00.5+02:00. NULL, or what is wrong. */
const char *epoch_parse(const char *text, double unit, Epoch *epoch);

#define INSTANT_ROOM 40

/* The instant of a time. NULL before the year 1 or after the year 9999, else `buffer`. */
const char *instant_format(char buffer[INSTANT_ROOM], const Epoch *epoch, double time);

#endif
