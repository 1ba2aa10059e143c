/* SPDX-License-Identifier: MIT */
/* Growth laws being made: a list of pieces, of one disc after the other. */
#ifndef SCENE_PIECES_H
#define SCENE_PIECES_H

#include "geom/law.h"
#include "scene/allocator.h"

typedef struct piece_list {
    const tdsp_allocator *allocator; /* NULL: the pieces are counted, and only the last is kept */
    law_piece *pieces;
    size_t count;
    size_t capacity;
    size_t begun;   /* where the disc at hand begins */
    law_piece last; /* valid where count > begun */
    tdsp_status status;
} piece_list;

/* Add a piece. 0 where there is no memory: `status` then says so. */
int pieces_add(piece_list *list, law_piece piece);

/* Add a piece of degree 1, or 0; one that goes on as the last does, up to round-off, is left out. */
int pieces_add_line(piece_list *list, double start, double radius, double rate);

/* What the disc at hand has at a time, by its last piece. */
law_jet pieces_last_jet(const piece_list *list, double time);

void pieces_free(piece_list *list);

#endif
