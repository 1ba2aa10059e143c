/* SPDX-License-Identifier: MIT */
/* The shape of the arrival: its jumps and its pieces. */
#include "page.h"

static tdsp_shape_options options_for(double from, double until)
{
    tdsp_shape_options options;
    tdsp_shape_options_init(&options);
    options.from = from;
    options.until = until;
    options.progress = page_progress;
    return options;
}

#define JUMP_NUMBERS (4 + PAGE_GAP_NUMBERS)

static tdsp_status jumps_write(const tdsp_jumps *jumps, PageNumbers *out)
{
    size_t count = tdsp_jumps_count(jumps);
    tdsp_arrival_jump jump;
    tdsp_status status = page_numbers(count * JUMP_NUMBERS, out);
    if (status != TDSP_OK) return status;
    double *at = out->at;
    for (size_t i = 0; tdsp_jumps_get(jumps, i, &jump) == TDSP_OK; i++) {
        *at++ = jump.departure;
        *at++ = jump.travel_before;
        *at++ = jump.travel_after;
        *at++ = jump.size;
        at = page_gap_write(&jump.gap, at);
    }
    return TDSP_OK;
}

/* departure, travel before and after, size, gap; of each */
PAGE_EXPORT(scene_jumps) tdsp_status page_scene_jumps(PageScene *page, double from, double until, double least, PageNumbers *out)
{
    tdsp_jumps *jumps;
    tdsp_shape_options options = options_for(from, until);
    options.least = least;
    tdsp_status status = tdsp_jumps_find(page->solver, &options, &jumps);
    if (status != TDSP_OK) return status;
    status = jumps_write(jumps, out);
    tdsp_jumps_free(jumps);
    return status;
}

#define PIECE_NUMBERS (7 + PAGE_GAP_NUMBERS)

static size_t envelope_numbers(const tdsp_envelope *envelope)
{
    size_t count = 2;
    tdsp_piece piece;
    for (size_t i = 0; tdsp_envelope_piece(envelope, i, &piece) == TDSP_OK; i++) count += PIECE_NUMBERS + 2 * piece.ride_count;
    return count;
}

static double *piece_write(const tdsp_piece *piece, double *at)
{
    const double parts[] = {piece->from,         piece->until,         piece->travel_from,        piece->travel_until,
                            (double)piece->form, (double)piece->change, (double)piece->ride_count};
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++) *at++ = parts[i];
    at = page_gap_write(&piece->gap, at);
    for (size_t i = 0; i < piece->ride_count; i++) {
        *at++ = piece->rides[i].disc;
        *at++ = piece->rides[i].turn;
    }
    return at;
}

static tdsp_status envelope_write(const tdsp_envelope *envelope, PageNumbers *out)
{
    tdsp_piece piece;
    tdsp_status status = page_numbers(envelope_numbers(envelope), out);
    if (status != TDSP_OK) return status;
    double *at = out->at;
    *at++ = (double)tdsp_envelope_forms(envelope);
    *at++ = tdsp_envelope_resolution(envelope);
    for (size_t i = 0; tdsp_envelope_piece(envelope, i, &piece) == TDSP_OK; i++) at = piece_write(&piece, at);
    return TDSP_OK;
}

/* forms, resolution; then of each piece from, until, travel from and until, form, change, number of rides, gap, and of each ride disc and turn */
PAGE_EXPORT(scene_curve) tdsp_status page_scene_curve(PageScene *page, double from, double until, double resolution, PageNumbers *out)
{
    tdsp_envelope *envelope;
    tdsp_shape_options options = options_for(from, until);
    options.resolution = resolution;
    tdsp_status status = tdsp_envelope_find(page->solver, &options, &envelope);
    if (status != TDSP_OK) return status;
    status = envelope_write(envelope, out);
    tdsp_envelope_free(envelope);
    return status;
}
