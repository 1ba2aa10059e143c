/* SPDX-License-Identifier: MIT */
/* cgo cannot take the address of an exported Go function: these stand in their places. */
#include "oracle.h"

#include "_cgo_export.h"

static tdsp_status earliest_arrival(void *ctx, double departure, double *arrival)
{
    return (tdsp_status)goEarliestArrival((uintptr_t)ctx, departure, arrival);
}

static tdsp_status path(void *ctx, tdsp_oracle_path *out)
{
    return (tdsp_status)goPath((uintptr_t)ctx, out);
}

void go_oracle_init(tdsp_oracle *oracle, uintptr_t handle)
{
    tdsp_oracle_init(oracle);
    oracle->ctx = (void *)handle;
    oracle->earliest_arrival = earliest_arrival;
    oracle->path = path;
}
