/* SPDX-License-Identifier: MIT */
/* Appending pieces of growth laws. */
#include "scene/pieces.h"

#include <float.h>
#include <math.h>

/* Round-off between a line and the same line begun anew, as a share of the radius. */
#define LINE_ERROR (64.0 * DBL_EPSILON)

int pieces_add(piece_list *list, law_piece piece)
{
    while (piece.degree > 0 && piece.c[piece.degree] == 0.0) --piece.degree;
    if (list->allocator) {
        list->status = memory_reserve(list->allocator, (void **)&list->pieces, &list->capacity, list->count + 1, sizeof piece);
        if (list->status != TDSP_OK) return 0;
        list->pieces[list->count] = piece;
    }
    list->last = piece;
    ++list->count;
    return 1;
}

law_jet pieces_last_jet(const piece_list *list, double time)
{
    return law_piece_jet(&list->last, time);
}

int pieces_add_line(piece_list *list, double start, double radius, double rate)
{
    law_piece line = {start, {radius, rate}, 1};
    if (list->count > list->begun && list->last.degree <= 1 && list->last.c[1] == rate) {
        double goes_on = pieces_last_jet(list, start).radius;
        if (fabs(goes_on - radius) <= LINE_ERROR * radius) return 1;
    }
    return pieces_add(list, line);
}

void pieces_free(piece_list *list)
{
    memory_free(list->allocator, list->pieces, list->capacity * sizeof *list->pieces);
}
