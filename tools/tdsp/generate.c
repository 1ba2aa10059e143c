/* SPDX-License-Identifier: MIT */
/*
 * Random, crowd, mixed and wall: scenes in a square of 100 by 100 that a robot of speed 1 crosses. The unit of thought is the
 * mean spacing a = 100 / sqrt(n), so that the difficulty of a kind does not change with n.
 */
#include "generate.h"

#include <math.h>
#include <string.h>

#include "rng.h"

#define SIDE 100.0
#define SPEED 1.0
#define TRIES 1000 /* places tried for a disc before it is made smaller */

/* A point that must stay outside the discs, with room around it. */
typedef struct Free {
    tdsp_point at;
    double room;
} Free;

/* Discs that keep `gap` from each other, in buckets as large as two of the largest: neighbours are in the nine around. */
typedef struct Layout {
    Rng *rng;
    Free ends[2];
    double gap;
    gint side; /* buckets along a side */
    double bucket;
    gint32 *heads; /* first disc of a bucket, -1 for none */
    GArray *next;  /* of gint32, as long as discs */
    GArray *discs;
} Layout;

/* Six decimals are plenty, and keep the files short. */
static double rounded(double value)
{
    return rint(value * 1e6) / 1e6;
}

static gint bucket_of(const Layout *layout, double coordinate)
{
    return CLAMP((gint)(coordinate / layout->bucket), 0, layout->side - 1);
}

static gboolean clear_of_ends(const Layout *layout, tdsp_point at, double radius)
{
    for (gsize i = 0; i < G_N_ELEMENTS(layout->ends); i++) {
        const Free *end = &layout->ends[i];
        if (hypot(at.x - end->at.x, at.y - end->at.y) < radius + end->room) return FALSE;
    }
    return TRUE;
}

static gboolean clear_of_bucket(const Layout *layout, gint x, gint y, tdsp_point at, double radius)
{
    if (x < 0 || y < 0 || x >= layout->side || y >= layout->side) return TRUE;
    for (gint32 i = layout->heads[y * layout->side + x]; i >= 0; i = g_array_index(layout->next, gint32, i)) {
        const tdsp_disc *disc = &g_array_index(layout->discs, tdsp_disc, i);
        if (hypot(at.x - disc->center.x, at.y - disc->center.y) < radius + disc->radius + layout->gap) return FALSE;
    }
    return TRUE;
}

static gboolean fits(const Layout *layout, tdsp_point at, double radius)
{
    gint x = bucket_of(layout, at.x), y = bucket_of(layout, at.y);
    if (!clear_of_ends(layout, at, radius)) return FALSE;
    for (gint i = 0; i < 9; i++)
        if (!clear_of_bucket(layout, x + i % 3 - 1, y + i / 3 - 1, at, radius)) return FALSE;
    return TRUE;
}

static void put(Layout *layout, tdsp_disc disc)
{
    gint32 *head = &layout->heads[bucket_of(layout, disc.center.y) * layout->side + bucket_of(layout, disc.center.x)];
    gint32 index = (gint32)layout->discs->len;
    g_array_append_val(layout->next, *head);
    g_array_append_val(layout->discs, disc);
    *head = index;
}

/* Throw darts; a disc that finds no room becomes smaller, so that this always ends. */
static void place(Layout *layout, double radius)
{
    for (guint tries = 1;; tries++) {
        tdsp_point at = {rounded(rng_uniform(layout->rng, 0, SIDE)), rounded(rng_uniform(layout->rng, 0, SIDE))};
        if (fits(layout, at, radius)) {
            put(layout, (tdsp_disc){at, radius, 0});
            return;
        }
        if (tries % TRIES == 0) radius = rounded(radius / 2);
    }
}

static gint larger_first(gconstpointer one, gconstpointer other)
{
    double a = *(const double *)one, b = *(const double *)other;
    return (a < b) - (a > b);
}

static void shuffle(Rng *rng, GArray *discs)
{
    for (guint i = discs->len; i > 1; i--) {
        tdsp_disc *last = &g_array_index(discs, tdsp_disc, i - 1), *other = &g_array_index(discs, tdsp_disc, rng_below(rng, i)),
                  kept = *last;
        *last = *other;
        *other = kept;
    }
}

/* Fill out->discs with discs of these radii, large ones placed first. */
static void lay_out(Rng *rng, GArray *radii, double gap, double room, Generated *out)
{
    g_array_sort(radii, larger_first);
    Layout layout = {.rng = rng, .gap = gap, .discs = out->discs};
    layout.ends[0] = (Free){out->journey.source, room};
    layout.ends[1] = (Free){out->journey.destination, room};
    layout.bucket = 2 * g_array_index(radii, double, 0) + gap;
    layout.side = MAX(1, (gint)(SIDE / layout.bucket));
    layout.heads = g_new(gint32, (gsize)layout.side * (gsize)layout.side);
    memset(layout.heads, 0xff, (gsize)layout.side * (gsize)layout.side * sizeof *layout.heads);
    layout.next = g_array_new(FALSE, FALSE, sizeof(gint32));
    for (guint i = 0; i < radii->len; i++) place(&layout, g_array_index(radii, double, i));
    g_free(layout.heads);
    g_array_unref(layout.next);
    shuffle(rng, out->discs);
}

static double spacing(guint n)
{
    return SIDE / sqrt(n);
}

static tdsp_point near_corner(Rng *rng, double low)
{
    double x = rng_uniform(rng, low, low + 4);
    return (tdsp_point){rounded(x), rounded(rng_uniform(rng, low, low + 4))};
}

static void journey(Rng *rng, Generated *out)
{
    tdsp_point source = near_corner(rng, 2);
    out->journey = (tdsp_journey){SPEED, 0, source, near_corner(rng, 94)};
}

/* A rate that adds `growth` mean spacings to a radius while the robot crosses. */
static double rate(const Generated *out, guint n, double growth)
{
    const tdsp_journey *way = &out->journey;
    double length = hypot(way->destination.x - way->source.x, way->destination.y - way->source.y);
    return rounded(growth * spacing(n) * SPEED / length);
}

/* Radii from `low` to `high` mean spacings, evenly spread in their logarithm. */
static void scatter(Rng *rng, guint n, double low, double high, double gap, double room, Generated *out)
{
    g_autoptr(GArray) radii = g_array_new(FALSE, FALSE, sizeof(double));
    for (guint i = 0; i < n; i++) {
        double radius = rounded(spacing(n) * low * pow(high / low, rng_uniform(rng, 0, 1)));
        g_array_append_val(radii, radius);
    }
    lay_out(rng, radii, gap * spacing(n), room * spacing(n), out);
}

static void grow_alike(const GenerateOptions *options, Generated *out)
{
    for (guint i = 0; i < out->discs->len; i++)
        g_array_index(out->discs, tdsp_disc, i).growth = rate(out, options->n, options->growth);
}

static void make_random(const GenerateOptions *options, Generated *out)
{
    Rng rng = {options->seed};
    journey(&rng, out);
    scatter(&rng, options->n, 0.08, 0.42, 0.10, 0.25, out);
    grow_alike(options, out);
}

static void make_crowd(const GenerateOptions *options, Generated *out)
{
    Rng rng = {options->seed};
    journey(&rng, out);
    scatter(&rng, options->n, 0.10, 0.10, 0.30, 0.30, out);
    grow_alike(options, out);
}

/* Standing, slow and fast discs side by side. */
static void make_mixed(const GenerateOptions *options, Generated *out)
{
    static const double factors[] = {0, 1, 3};
    Rng rng = {options->seed};
    journey(&rng, out);
    scatter(&rng, options->n, 0.08, 0.42, 0.10, 0.25, out);
    for (guint i = 0; i < out->discs->len; i++) {
        double factor = factors[rng_below(&rng, G_N_ELEMENTS(factors))];
        g_array_index(out->discs, tdsp_disc, i).growth = factor * rate(out, options->n, options->growth);
    }
}

#define MOST_GAPS 3

/* A column's gaps: before which discs, and how wide in disc spacings. */
typedef struct Gaps {
    guint count;
    guint before[MOST_GAPS]; /* ascending, different */
    double width[MOST_GAPS];
    double total;
} Gaps;

static void insert_ascending(guint *values, guint count, guint value)
{
    while (count > 0 && values[count - 1] > value) {
        values[count] = values[count - 1];
        count--;
    }
    values[count] = value;
}

static gboolean contains(const guint *values, guint count, guint value)
{
    for (guint i = 0; i < count; i++)
        if (values[i] == value) return TRUE;
    return FALSE;
}

/* High in one column and low in the next, so that the way is a zigzag. */
static Gaps choose_gaps(Rng *rng, guint column, guint discs)
{
    Gaps gaps = {.count = discs < 30 ? 2 : MOST_GAPS};
    guint low = column % 2 == 1 ? discs * 55 / 100 : MAX(1, discs * 5 / 100);
    guint high = MAX(column % 2 == 1 ? discs * 95 / 100 : discs * 45 / 100, low + gaps.count);
    for (guint i = 0; i < gaps.count; i++) {
        guint before;
        do before = low + (guint)rng_below(rng, high - low);
        while (contains(gaps.before, i, before));
        insert_ascending(gaps.before, i, before);
        gaps.width[i] = rng_uniform(rng, 0.8, 3.0);
        gaps.total += gaps.width[i];
    }
    return gaps;
}

static void add_column(Rng *rng, guint column, double x, guint discs, double growth, Generated *out)
{
    Gaps gaps = choose_gaps(rng, column, discs);
    double pitch = SIDE / (discs + gaps.total), y = 0.5 * pitch;
    for (guint i = 0, gap = 0; i < discs; i++) {
        if (gap < gaps.count && i == gaps.before[gap]) y += gaps.width[gap++] * pitch;
        double shifted = x + rng_uniform(rng, -0.1, 0.1) * pitch;
        tdsp_disc disc = {{rounded(shifted), rounded(y)}, rounded(0.52 * pitch), growth};
        g_array_append_val(out->discs, disc);
        y += pitch;
    }
}

/* Columns of touching discs with two or three gaps each; some gaps close while the robot travels. */
static void make_wall(const GenerateOptions *options, Generated *out)
{
    Rng rng = {options->seed};
    guint n = options->n, columns = MAX(1, (guint)sqrt(n / 10.0));
    double growth = rounded(options->growth * (SIDE * columns / n) * SPEED / 150);
    out->journey = (tdsp_journey){SPEED, 0, {2, 50}, {98, 50}};
    for (guint i = 0; i < columns; i++)
        add_column(&rng, i, SIDE * (i + 1) / (columns + 1), n / columns + (i < n % columns ? 1 : 0), growth, out);
}

#define MOST_DISCS 1000000
#define MOST_FAMILY 1000 /* the floor's radius grows as their number to the fourth */

static const GenerateKind kinds[] = {
    {"random", 1, MOST_DISCS, 0.10, make_random}, {"crowd", 1, MOST_DISCS, 0.15, make_crowd},
    {"wall", 1, MOST_DISCS, 0.5, make_wall},      {"mixed", 1, MOST_DISCS, 0.08, make_mixed},
    {"columns", 6, MOST_DISCS, -1, generate_columns}, {"nsquared", 2, MOST_FAMILY, -1, generate_nsquared},
};

const GenerateKind *generate_kind(const char *name)
{
    for (gsize i = 0; i < G_N_ELEMENTS(kinds); i++)
        if (strcmp(kinds[i].name, name) == 0) return &kinds[i];
    return NULL;
}

const char **generate_kind_names(void)
{
    const char **names = g_new0(const char *, G_N_ELEMENTS(kinds) + 1);
    for (gsize i = 0; i < G_N_ELEMENTS(kinds); i++) names[i] = kinds[i].name;
    return names;
}

char *generate_kinds(void)
{
    GString *names = g_string_new(NULL);
    for (gsize i = 0; i < G_N_ELEMENTS(kinds); i++) g_string_append_printf(names, "%s%s", i > 0 ? ", " : "", kinds[i].name);
    return g_string_free(names, FALSE);
}
