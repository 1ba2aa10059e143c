/* SPDX-License-Identifier: MIT */
/* The shape of A(t): no jump is missed, every jump has its gap, pieces say what paths do, and the number of pieces grows as N^2. */
#include "support/cmocka_all.h"

#include <string.h>

#include "support/chance.h"
#include "support/property.h"
#include "support/world.h"
#include "tdsp/generate.h"
#include "tdsp/shape.h"

#define LEAST 0.01 /* jumps looked for, of the longest travel time */
#define LONGEST 6.0 /* departures looked at, in journeys */

static tdsp_shape_options options_for(const property_case *c)
{
    tdsp_shape_options options;
    tdsp_shape_options_init(&options);
    options.until = LONGEST * c->unit;
    return options;
}

/* T(t), with a way. */
static double travel(property_case *c, double departure)
{
    const double arrival = property_arrival(c, departure);
    property_holds(c, arrival < INFINITY);
    return arrival - departure;
}

static double fine(const property_case *c, double departure)
{
    return 1e-8 * (c->unit + departure);
}

static int listed(const tdsp_jumps *jumps, double departure, double slack)
{
    tdsp_arrival_jump jump;
    for (size_t i = 0; tdsp_jumps_get(jumps, i, &jump) == TDSP_OK; i++)
        if (fabs(jump.departure - departure) <= slack) return 1;
    return 0;
}

/* By halving alone: where T rises by more than `least` within next to nothing there is a jump. Smooth rises as steep as that do not occur. */
static void no_jump_between(property_case *c, const tdsp_jumps *jumps, double least, double low, double high)
{
    const double t_low = travel(c, low), t_high = travel(c, high);
    if (!(t_high - t_low > least)) return;
    if (high - low <= fine(c, high)) {
        property_holds(c, listed(jumps, low, 10.0 * fine(c, high)));
        return;
    }
    const double middle = 0.5 * (low + high);
    no_jump_between(c, jumps, least, low, middle);
    no_jump_between(c, jumps, least, middle, high);
}

static size_t found, explained;

static void jump_is_one(property_case *c, const tdsp_arrival_jump *jump, double least)
{
    const double step = fine(c, jump->departure);
    property_relates(c, jump->size, >, least);
    property_relates(c, fabs(travel(c, jump->departure) - jump->travel_before), <=, 1e-10 * (c->unit + jump->departure));
    property_relates(c, travel(c, jump->departure + step), >=, jump->travel_after - 1e-10 * (c->unit + jump->departure));
    property_relates(c, travel(c, jump->departure + step), <=, jump->travel_after + 1e-4 * c->unit);
    found++;
    if (jump->gap.first == TDSP_NO_DISC) return;
    explained++;
    property_holds(c, jump->gap.first < jump->gap.second && jump->gap.second < c->count);
    property_relates(c, jump->gap.time, >=, jump->departure);
    property_relates(c, jump->gap.time, <=, jump->departure + jump->travel_before + step);
}

/* The gap's place is where both discs' boundaries are, and the path of the jump is there then. */
static void gap_is_met(property_case *c, const tdsp_arrival_jump *jump)
{
    if (jump->gap.first == TDSP_NO_DISC) return;
    const uint32_t pair[] = {jump->gap.first, jump->gap.second};
    const double slack = 1e-5 * c->journey.speed * c->unit;
    for (size_t k = 0; k < 2; k++) {
        const tdsp_disc *disc = &c->discs[pair[k]];
        const double radius = disc->radius + disc->growth * jump->gap.time + c->journey.radius;
        property_relates(c, fabs(hypot(jump->gap.place.x - disc->center.x, jump->gap.place.y - disc->center.y) - radius), <=, slack);
    }
}

static void jumps_are_all_and_only_those(property_case *c)
{
    tdsp_shape_options options = options_for(c);
    tdsp_jumps *jumps;
    tdsp_arrival_jump jump;
    double last = options.until;
    if (!(property_arrival(c, 0.0) < INFINITY)) return;
    if (isinf(property_arrival(c, last))) property_holds(c, tdsp_latest_departure(c->solver, INFINITY, &last, NULL) == TDSP_OK);
    options.least = LEAST * travel(c, last);
    property_holds(c, tdsp_jumps_find(c->solver, &options, &jumps) == TDSP_OK);
    for (size_t i = 0; tdsp_jumps_get(jumps, i, &jump) == TDSP_OK; i++) {
        if (jump.departure + fine(c, last) < last) jump_is_one(c, &jump, options.least);
        gap_is_met(c, &jump);
    }
    no_jump_between(c, jumps, 1.01 * options.least, 0.0, last);
    tdsp_jumps_free(jumps);
}

static void no_jump_is_missed_and_none_invented(void **state)
{
    (void)state;
    property_each(12, 16, jumps_are_all_and_only_those);
    print_message("%zu jumps, the gaps of %zu of them found\n", found, explained);
    assert_true(found >= 60);
    assert_true(100 * explained >= 98 * found);
}

enum { LEGS = 256 };

/* The rides of the last path that turn by more than 1e-9. */
static size_t rides_of(property_case *c, tdsp_ride *rides)
{
    tdsp_leg legs[LEGS];
    size_t count, kept = 0;
    property_holds(c, tdsp_solver_path(c->solver, legs, LEGS, &count) == TDSP_OK);
    for (size_t i = 0; i < count; i++)
        if (legs[i].kind != TDSP_LEG_LINE && legs[i].sweep > 1e-9) rides[kept++] = (tdsp_ride){legs[i].disc, legs[i].turn};
    return kept;
}

static int same_rides(const tdsp_piece *piece, const tdsp_ride *rides, size_t count)
{
    if (piece->ride_count != count) return 0;
    for (size_t i = 0; i < count; i++)
        if (piece->rides[i].disc != rides[i].disc || piece->rides[i].turn != rides[i].turn) return 0;
    return 1;
}

/* In a scene that is its own mirror image the mirrored path is as fast: either may be named. */
static int is_mirrored(const tdsp_piece *piece, const tdsp_ride *rides, size_t count)
{
    if (piece->ride_count != count) return 0;
    for (size_t i = 0; i < count; i++)
        if (piece->rides[i].disc != rides[i].disc || piece->rides[i].turn != -rides[i].turn) return 0;
    return 1;
}

static size_t samples, other_forms;

static void piece_says_what_paths_do(property_case *c, const tdsp_piece *piece)
{
    tdsp_ride rides[LEGS];
    for (int i = 0; i < 3; i++) {
        const double departure = piece->from + chance_between(&c->chance, 0.01, 0.99) * (piece->until - piece->from);
        const double t = travel(c, departure), slack = 1e-10 * (c->unit + departure);
        property_relates(c, t, >=, piece->travel_from - slack);
        property_relates(c, t, <=, piece->travel_until + slack);
        samples++;
        const size_t count = rides_of(c, rides);
        if (!same_rides(piece, rides, count) && !is_mirrored(piece, rides, count)) other_forms++;
    }
}

/* Where T is the same all along, paths of several forms are the fastest. */
static int is_flat(const property_case *c, const tdsp_piece *piece)
{
    return piece->travel_until - piece->travel_from <= 1e-10 * (c->unit + piece->until);
}

static void pieces_follow_one_another(property_case *c)
{
    tdsp_shape_options options = options_for(c);
    tdsp_envelope *envelope;
    tdsp_piece piece, before = {.until = 0.0};
    if (!(property_arrival(c, 0.0) < INFINITY)) return;
    options.resolution = options.until / 256.0;
    property_holds(c, tdsp_envelope_find(c->solver, &options, &envelope) == TDSP_OK);
    for (size_t i = 0; tdsp_envelope_piece(envelope, i, &piece) == TDSP_OK; i++, before = piece) {
        property_relates(c, piece.from, ==, before.until);
        property_relates(c, piece.until, >=, piece.from);
        if (i > 0) property_relates(c, piece.travel_from, >=, before.travel_until - 1e-10 * (c->unit + piece.from));
        if (i > 0) property_holds(c, piece.form != before.form || before.change == TDSP_CHANGE_JUMP);
        property_holds(c, (before.change == TDSP_CHANGE_JUMP) == (i > 0 && piece.travel_from > before.travel_until + 1e-9 * (c->unit + piece.from)));
        if (!is_flat(c, &piece) && piece.until - piece.from > 10.0 * fine(c, piece.until)) piece_says_what_paths_do(c, &piece);
    }
    property_holds(c, before.change == TDSP_CHANGE_END);
    tdsp_envelope_free(envelope);
}

static void pieces_say_what_the_paths_between_their_ends_do(void **state)
{
    (void)state;
    property_each(8, 16, pieces_follow_one_another);
    print_message("%zu of %zu paths are of another form than their piece\n", other_forms, samples);
    assert_true(samples >= 300);
    assert_true(200 * other_forms <= samples);
}

/* The form of gap m with `joined` discs of the chain: over wall disc m - 1, under m, over the last discs of the chain (docs/math/pieces.md). */
static int is_form(const tdsp_piece *piece, uint32_t gaps, uint32_t m, uint32_t joined)
{
    tdsp_ride rides[LEGS] = {{m - 1, -1}, {m, 1}};
    for (uint32_t i = 0; i < joined; i++) rides[2 + i] = (tdsp_ride){2 * gaps + 1 - joined + i, -1};
    return same_rides(piece, rides, 2 + joined);
}

static void every_form_appears(uint32_t gaps)
{
    Generated scene = {.discs = g_array_new(FALSE, FALSE, sizeof(tdsp_disc))};
    const GenerateOptions options = {.n = gaps};
    tdsp_envelope *envelope;
    tdsp_piece piece;
    generate_nsquared(&options, &scene);
    const tdsp_disc *discs = (const tdsp_disc *)(void *)scene.discs->data;
    for (guint i = 1; i < scene.discs->len; i++) assert_exact(discs[i].growth, discs[0].growth);
    world w = world_make(scene.journey, discs, scene.discs->len);
    assert_int_equal(tdsp_envelope_find(w.solver, NULL, &envelope), TDSP_OK);
    uint32_t seen = 0;
    for (size_t i = 0; tdsp_envelope_piece(envelope, i, &piece) == TDSP_OK; i++)
        if (is_form(&piece, gaps, seen / gaps + 1, seen % gaps + 1)) seen++;
    print_message("N = %u: %zu pieces\n", gaps, tdsp_envelope_pieces(envelope));
    assert_int_equal(seen, gaps * gaps);
    assert_true(tdsp_envelope_pieces(envelope) <= gaps * gaps + 2 * gaps);
    tdsp_envelope_free(envelope);
    world_free(w);
    g_array_unref(scene.discs);
}

static void discs_of_one_rate_make_n_squared_pieces(void **state)
{
    (void)state;
    for (uint32_t gaps = 2; gaps <= 8; gaps++) every_form_appears(gaps);
}

/* A chain behind two columns of gaps joins the path once, not once for each gap. */
static void a_chain_behind_columns_makes_only_a_linear_number(void **state)
{
    (void)state;
    for (uint32_t k = 2; k <= 6; k++) {
        Generated scene = {.discs = g_array_new(FALSE, FALSE, sizeof(tdsp_disc))};
        const GenerateOptions options = {.n = 3 * k};
        tdsp_shape_options shape;
        tdsp_envelope *envelope;
        generate_columns(&options, &scene);
        world w = world_make(scene.journey, (const tdsp_disc *)(void *)scene.discs->data, scene.discs->len);
        tdsp_shape_options_init(&shape);
        shape.until = 300.0;
        assert_int_equal(tdsp_envelope_find(w.solver, &shape, &envelope), TDSP_OK);
        assert_int_equal(tdsp_envelope_pieces(envelope), 2 * k);
        tdsp_envelope_free(envelope);
        world_free(w);
        g_array_unref(scene.discs);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_jump_is_missed_and_none_invented),
        cmocka_unit_test(pieces_say_what_the_paths_between_their_ends_do),
        cmocka_unit_test(discs_of_one_rate_make_n_squared_pieces),
        cmocka_unit_test(a_chain_behind_columns_makes_only_a_linear_number),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
