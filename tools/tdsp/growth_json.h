/* SPDX-License-Identifier: MIT */
/* The member `growth` of a disc in a scene file. */
#ifndef GROWTH_JSON_H
#define GROWTH_JSON_H

#include <glib.h>

#include "json_out.h"
#include "json_read.h"
#include "tdsp/growth.h"

/*
 * Read disc->growth in its three forms, and check it with the disc's centre and radius, which are set. `kept` takes over the arrays; `warned` as
 * for json_read_warn_unknown().
 */
gboolean growth_json_read(const JsonValue *value, tdsp_growing_disc *disc, GPtrArray *kept, GHashTable *warned, GError **error);

/* The growth in the form that it has; a law by callback has none. */
void growth_json_write(const tdsp_growth *growth, JsonOut *out);

/* Is this one rate, whatever it is written as? */
gboolean growth_json_is_rate(const tdsp_growth *growth, double *rate);

#endif
