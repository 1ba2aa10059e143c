/* SPDX-License-Identifier: MIT */
/* What `tdsp margin` finds out about a departure, and how it is printed. */
#ifndef MARGINS_H
#define MARGINS_H

#include "json_out.h"
#include "tdsp/margin.h"

typedef struct DepartureMargins {
    double departure;
    tdsp_slack slack;
    tdsp_margin anew[2];     /* by tdsp_raise: with planning anew */
    tdsp_margin path[2];     /* of the very path */
    tdsp_status path_status; /* TDSP_OK, or why there is no path */
    double seconds;
} DepartureMargins;

/* `all` is of DepartureMargins. */
gboolean margins_print_text(const GArray *all, GError **error);
gboolean margins_print_json(const GArray *all, double deadline, double prepare_seconds, GError **error);

/* Members that name a limit: "limit", "disc", "other", "time", "place"; null where there is none. */
void margins_json_witness(JsonOut *out, const tdsp_witness *witness);

#endif
