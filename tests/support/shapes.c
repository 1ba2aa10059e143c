/* SPDX-License-Identifier: MIT */
/* Values by the powers of time, angles by Gauss's rule: the description is in shapes.h. */
#include "support/cmocka_all.h"

#include "support/shapes.h"

/* How often a part is halved: a root at an end loses as many digits. */
#define MOST_HALVINGS 48

void shapes_open(shape_world *w, uint64_t seed, grown_mix mix, size_t count)
{
    random_growth(seed, mix, count, &w->grown);
    w->chance = seed * 1000003u;
    assert_int_equal(tdsp_scene_create_growing(&w->grown.journey, w->grown.discs, count, NULL, &w->scene), TDSP_OK);
    assert_int_equal(growth_create(w->scene, &w->growth), TDSP_OK);
    w->shapes = w->growth->engine.shapes;
}

void shapes_close(shape_world *w)
{
    growth_free(w->growth);
    tdsp_scene_free(w->scene);
}

void shapes_each(int scenes, size_t count, uint64_t seed, void (*check)(shape_world *w))
{
    shape_world w;
    print_message("seed %d\n", (int)seed);
    for (int mix = 0; mix < GROWTH_MIX_COUNT; ++mix)
        for (int i = 0; i < scenes; ++i) {
            shapes_open(&w, seed + (uint64_t)i, (grown_mix)mix, count);
            check(&w);
            shapes_close(&w);
        }
}

long double piece_law(const law_piece *piece, long double time, int order)
{
    long double sum = 0.0L, at = time - (long double)piece->start;
    for (int k = (int)piece->degree; k >= order; --k) {
        long double factor = 1.0L;
        for (int i = 0; i < order; ++i) factor *= k - i;
        sum = sum * at + factor * (long double)piece->c[k];
    }
    return sum;
}

long double shape_law(const growth_shape *shape, long double time, int order)
{
    uint32_t low = 0, high = shape->piece_count;
    while (high - low > 1) {
        uint32_t middle = (low + high) / 2;
        *((long double)shape->pieces[middle].start <= time ? &low : &high) = middle;
    }
    return piece_law(&shape->pieces[low], time, order);
}

static long double turning(const law_piece *piece, long double time)
{
    long double rate = piece_law(piece, time, 1), squared = (1.0L - rate) * (1.0L + rate);
    return squared > 0.0L ? sqrtl(squared) / piece_law(piece, time, 0) : 0.0L;
}

/* Gauss's rule with 7 points. */
static long double gauss(const law_piece *piece, long double from, long double to)
{
    static const long double at[3] = {0.405845151377397166906606412076961463L, 0.741531185599394439863864773280788407L,
                                      0.949107912342758524526189684047851262L};
    static const long double weight[4] = {0.417959183673469387755102040816326531L, 0.381830050505118944950369775488975134L,
                                          0.279705391489276667901467771423779582L, 0.129484966168869693270611432679082018L};
    long double half = 0.5L * (to - from), middle = 0.5L * (from + to), sum = weight[0] * turning(piece, middle);
    for (int i = 0; i < 3; ++i) sum += weight[i + 1] * (turning(piece, middle - half * at[i]) + turning(piece, middle + half * at[i]));
    return half * sum;
}

static long double halved(const law_piece *piece, long double from, long double to, long double whole, int depth)
{
    long double middle = 0.5L * (from + to), left = gauss(piece, from, middle), right = gauss(piece, middle, to);
    if (depth == 0 || fabsl(left + right - whole) <= 1e-17L * fabsl(whole) + 1e-22L) return left + right;
    return halved(piece, from, middle, left, depth - 1) + halved(piece, middle, to, right, depth - 1);
}

long double piece_turned(const law_piece *piece, long double from, long double to)
{
    return from < to ? halved(piece, from, to, gauss(piece, from, to), MOST_HALVINGS) : 0.0L;
}

double shape_clearance(const growth_shape *shape, tdsp_point place, double time)
{
    long double x = (long double)place.x - (long double)shape->center.x, y = (long double)place.y - (long double)shape->center.y;
    return (double)(sqrtl(x * x + y * y) - shape_law(shape, time, 0));
}
