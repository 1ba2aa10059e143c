/* SPDX-License-Identifier: MIT */
/* Distance between words: optimal string alignment, by rows of the usual table. */
#include "suggest.h"

#include <string.h>

guint suggest_distance(const char *from, const char *to)
{
    gsize columns = strlen(to) + 1, rows = strlen(from) + 1;
    g_autofree guint *cost = g_new0(guint, rows * columns);
    for (gsize i = 0; i < rows; i++) {
        for (gsize j = 0; j < columns; j++) {
            guint *cell = cost + i * columns + j;
            *cell = (guint)(i + j);
            if (i == 0 || j == 0) continue;
            guint changed = cell[-(gssize)columns - 1] + (from[i - 1] != to[j - 1]);
            *cell = MIN(changed, MIN(cell[-1], cell[-(gssize)columns]) + 1);
            if (i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1])
                *cell = MIN(*cell, cell[-2 * (gssize)columns - 2] + 1);
        }
    }
    return cost[rows * columns - 1]; /* NOLINT(clang-analyzer-unix.Malloc): a cell is a place in what frees itself here */
}
