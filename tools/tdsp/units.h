/* SPDX-License-Identifier: MIT */
/* Units of length and time, by the names that scenes give them. They matter only where metres or seconds come in: on the earth, and on a clock. */
#ifndef UNITS_H
#define UNITS_H

#include <glib.h>

/* How many metres, or seconds, a unit has; else an error that says what needs to know (`what`), which units there are and how to say one. */
gboolean unit_metres(const char *what, const char *unit, double *metres, GError **error);
gboolean unit_seconds(const char *what, const char *unit, double *seconds, GError **error);

#endif
