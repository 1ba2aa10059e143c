/* SPDX-License-Identifier: MIT */
/* Units of length and time, by the names that scenes give them. They matter only where metres or seconds come in: on the earth, and on a clock. */
#ifndef UNITS_H
#define UNITS_H

#include <glib.h>

/* How many metres, or seconds, a unit has; else an error that says which file needs to know, which units there are and how to say one. */
gboolean unit_metres(const char *file, const char *unit, double *metres, GError **error);
gboolean unit_seconds(const char *file, const char *unit, double *seconds, GError **error);

#endif
