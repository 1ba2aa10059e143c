/* SPDX-License-Identifier: MIT */
/* See swell.h. */
#include "verify/swell.h"

#include <math.h>

#include "scene/scene.h" /* the pieces that it keeps, read by means of its own */

swell_piece swell_of_rate(double radius, double growth)
{
    return (swell_piece){0.0, INFINITY, 1, {radius, growth}};
}

int swell_is_rate(const tdsp_scene *scene, uint32_t disc)
{
    const uint32_t first = scene->first_piece[disc];
    return scene->first_piece[disc + 1] == first + 1 && scene->pieces[first].degree <= 1;
}

/* Before the piece `behind` all that are looked for begin in time; `behind` does not. */
static uint32_t piece_number(const tdsp_scene *scene, uint32_t disc, double time)
{
    uint32_t first = scene->first_piece[disc], behind = scene->first_piece[disc + 1];
    while (behind - first > 1) {
        const uint32_t middle = first + (behind - first) / 2;
        if (scene->pieces[middle].start > time)
            behind = middle;
        else
            first = middle;
    }
    return first;
}

swell_piece swell_at(const tdsp_scene *scene, uint32_t disc, double time)
{
    const uint32_t number = piece_number(scene, disc, time);
    const law_piece *kept = &scene->pieces[number];
    swell_piece piece = {kept->start, INFINITY, (int)kept->degree, {0.0}};
    if (number + 1 < scene->first_piece[disc + 1]) piece.end = kept[1].start;
    for (int k = 0; k <= piece.degree; k++) piece.c[k] = kept->c[k];
    piece.c[0] += scene->journey.radius;
    return piece;
}

double swell_radius(const swell_piece *piece, double time)
{
    const double u = time - piece->start;
    double sum = 0.0;
    for (int k = piece->degree; k >= 0; k--) sum = sum * u + piece->c[k];
    return sum;
}

double swell_magnitude(const swell_piece *piece, double time)
{
    const double u = fabs(time - piece->start);
    double sum = 0.0;
    for (int k = piece->degree; k >= 0; k--) sum = sum * u + fabs(piece->c[k]);
    return sum;
}

bernstein swell_over(const swell_piece *piece, double from, double to)
{
    return bernstein_of_powers(piece->c, piece->degree, from - piece->start, to - piece->start);
}
