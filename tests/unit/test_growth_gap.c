/* SPDX-License-Identifier: MIT */
/*
 * In the moment in which a gap closes a touch decides who still gets past. Who does may change over to the other disc as well, or there would be a third way: that of a robot which is let into the
 * gap and cannot make use of it. Each window here lies around such a moment; the general method had a third travel time in it.
 */
#include "support/cmocka_all.h"

#include <math.h>

#include "tdsp/growth.h"
#include "tdsp/solver.h"

enum { LOOKS = 400 };

#define SAME 1e-7

static tdsp_growing_disc grows(double x, double y, double radius, tdsp_growth growth)
{
    tdsp_growing_disc disc = {{x, y}, radius, growth};
    return disc;
}

static tdsp_growth polynomial(const double *values, size_t count)
{
    tdsp_growth growth = {.kind = TDSP_GROWTH_POLYNOMIAL, .count = count, .values = values};
    return growth;
}

static tdsp_growth rates(const double *values, const double *times, size_t count)
{
    tdsp_growth growth = {.kind = TDSP_GROWTH_RATES, .count = count, .values = values, .times = times};
    return growth;
}

static double travel_time(tdsp_solver *solver, double departure)
{
    double arrival = INFINITY;
    assert_int_equal(tdsp_earliest_arrival(solver, departure, &arrival), TDSP_OK);
    return arrival - departure;
}

/* From the first departure to the last there is one jump, of these travel times, and nothing else. */
static void jumps_once(const tdsp_journey *journey, const tdsp_growing_disc *discs, size_t count, double from, double to, double before, double after)
{
    tdsp_scene *scene;
    tdsp_solver *solver;
    int has_jumped = 0;
    assert_int_equal(tdsp_scene_create_growing(journey, discs, count, NULL, &scene), TDSP_OK);
    assert_int_equal(tdsp_solver_create_for(scene, TDSP_METHOD_GENERAL, &solver), TDSP_OK);
    assert_near(travel_time(solver, from), before, SAME);
    for (int i = 0; i <= LOOKS; i++) {
        const double seen = travel_time(solver, from + (to - from) * i / (double)LOOKS);
        has_jumped |= fabs(seen - before) > SAME;
        assert_near(seen, has_jumped ? after : before, SAME);
    }
    assert_true(has_jumped);
    tdsp_solver_free(solver);
    tdsp_scene_free(scene);
}

static const tdsp_journey plain = {1.0, 0.0, {0.0, 0.0}, {2.0, 0.0}}, middle = {1.0, 0.0, {-1.0, 0.0}, {1.0, 0.0}};

/* A touch of the larger disc is several of the smaller one's, in which the rider on the larger then begins: it was stopped there. */
static void who_changes_over_to_a_larger_disc_is_forgiven_a_touch_of_that_disc(void **state)
{
    (void)state;
    static const double slow[] = {0.15526910331064572, -0.048414632109099999, 0.0075101262369699998, -0.00057951329800000004, 1.7797072599999999e-05};
    static const double short_lived[] = {0.16, -0.26, 0.2, -0.07, 0.01, 0.0, 0.0};
    static const double fast[] = {1.3184379773235317, -1.6024016765953952, 1.0003371053088119, -0.34332166143199999, 0.064671119432599997, -0.0061860310669500001, 0.000233792564};
    const tdsp_growing_disc laws[] = {grows(0.17816488739240266, 0.12304523155938973, 0.048404804798699998, polynomial(slow, 5)),
                                      grows(1.0, 0.3, 0.0, polynomial(short_lived, 7)),
                                      grows(0.149934308185, -0.34213859349652004, 0.027829866975199999, polynomial(fast, 7))};
    jumps_once(&plain, laws, 3, 0.22065206012, 0.22065206012103493, 2.0018689590, 2.1520801570);

    static const double r[] = {0.12134616467380616, 0.0, 0.28712652802867428, 0.1, 0.0015317095351600001, 0.075224748370441116};
    const tdsp_growing_disc around[] = {grows(0.2346355912153516, -0.22246576532724854, 0.0125023476204, polynomial(&r[0], 1)),
                                        grows(0.0, -0.22, 0.2, polynomial(&r[1], 1)),
                                        grows(0.36319707338200002, 0.26904418315385525, 0.13107738027775609, polynomial(&r[2], 1))};
    jumps_once(&plain, around, 3, 0.587860771534154, 0.587860771535154, 2.0377164268, 2.6832177056);
    const tdsp_growing_disc wall[] = {grows(1.0, -0.6, 0.0, polynomial(&r[3], 1)),
                                      grows(0.99176884096999995, -0.188693637498, 0.0569238349348, polynomial(&r[4], 1)),
                                      grows(1.0433666413, 0.262391333311, 0.075166054013299996, polynomial(&r[5], 1)),
                                      grows(1.0, 0.7, 0.0, polynomial(&r[3], 1))};
    jumps_once(&plain, wall, 4, 3.18531434904, 3.18531434906, 2.0179414469, 3.0368955712);
}

/* The least clearance lies between two looks at the ride; both looks saw more than a touch. */
static void a_touch_between_two_looks_at_a_ride_is_one(void **state)
{
    (void)state;
    static const double first[] = {0.1933287460731844, 0.18299852116109763, 0.21519554294403792, 0.061796089501222277};
    static const double first_times[] = {0.0, 2.1636580123239497, 4.53902846290796, 8.2922664525956939};
    static const double second[] = {0.1465179535630525, 0.0, 0.11263739347889043, 0.028859281868061623, 0.17313876937436637};
    static const double second_times[] = {0.0, 0.87997738541509118, 9.3778116969816381, 15.232542504108352, 16.813454110928845};
    static const double third[] = {0.19508243383306748, 0.060652070325160984, 0.48565882650804609, 0.032034384250622237};
    static const double third_times[] = {0.0, 2.3253760303292599, 5.7507994333051728, 10.945302594135919};
    const tdsp_journey journey = {0.93304304758365064, 0.0, {-5.0737990625517693, -4.7044069058152811}, {-1.5251306061273158, 3.6055762586799016}};
    const tdsp_growing_disc discs[] = {grows(-3.0027912160904817, -2.3514908696350538, 0.0, rates(first, first_times, 4)),
                                       grows(-3.1429038338429032, 1.2496030738261317, 1.1946597506850054, rates(second, second_times, 5)),
                                       grows(-6.2039570486267372, -2.5827884703448456, 0.089459830999177273, rates(third, third_times, 4))};
    jumps_once(&journey, discs, 3, 4.87228318865, 4.87228318867, 10.595505877, 11.576638119);
}

/* The gap is narrowest in the moment in which the rates fall, and the rider turns away from the other disc on the spot. */
static void who_turns_on_the_spot_in_a_gap_may_change_over(void **state)
{
    (void)state;
    static const double times[] = {0.0, 0.74490456207918254}, first[] = {0.39716532985959208, 0.042609307409285271};
    static const double second[] = {0.12408381105451038, 0.080335742896084333}, third[] = {0.089199322525145577};
    const tdsp_growing_disc discs[] = {grows(-0.58860431022313586, -0.32275825797374791, 0.097217342838001222, rates(first, times, 2)),
                                 grows(-0.35123143561876924, 0.2500498072112245, 0.14694462605253589, rates(second, times, 2)),
                                 grows(0.17074834237774617, -0.1870484895742606, 0.041440884833530027, polynomial(third, 1))};
    jumps_once(&middle, discs, 3, 0.12860339938, 0.12860339939, 2.0008840800, 2.2798273700);
}

/* Likewise for one who comes there straight, in the very moment. */
static void who_meets_both_discs_of_a_gap_as_their_rates_fall_may_ride_either(void **state)
{
    (void)state;
    static const double times[] = {0.0, 1.2715490624891113}, first[] = {0.32441160840689687, 0.021594834404350085}, second[] = {0.14909618777340281, 0.038722585111978951};
    static const double third[] = {0.15434708419345322}, fourth[] = {0.10582261308484121};
    const tdsp_growing_disc discs[] = {grows(-0.53749797689286116, -0.37468698310275028, 0.0077414627230713955, rates(first, times, 2)),
                                       grows(-0.54286653763077675, 0.30932189863965243, 0.079361305155962042, rates(second, times, 2)),
                                       grows(0.41227231283394794, -0.4994703939350057, 0.015996464290417206, polynomial(third, 1)),
                                       grows(0.31782711080619641, 0.3017975761458801, 0.13508362839234639, polynomial(fourth, 1))};
    jumps_once(&middle, discs, 4, 0.769360934137, 0.769360934142, 2.0105172167, 2.6899901253);
}

/* From the other disc's fan straight to the goal: it begins as deep in the smaller disc as was forgiven to who changed over. */
static void who_changes_over_as_a_rate_falls_may_leave_at_once(void **state)
{
    (void)state;
    static const double times[] = {0.0, 1.5393318540591157}, first[] = {0.23498493288074973, 0.19320198549482118}, fourth[] = {0.33831343119096829, 0.071784482126511867};
    static const double r[] = {0.24899481898206788, 0.31221622841590974, 0.19321548993367249};
    const tdsp_growing_disc discs[] = {grows(0.065781922899338596, -0.48937980330787589, 0.026464280207267099, rates(first, times, 2)),
                                       grows(-0.17909533006532635, 0.29369759902663306, 0.09771977381151925, polynomial(&r[0], 1)),
                                       grows(-0.58886654172461006, -0.46769803031655077, 0.082868768701745796, polynomial(&r[1], 1)),
                                       grows(0.035962556806152346, 0.51040053332352986, 0.127162777703588, rates(fourth, times, 2)),
                                       grows(-0.25521038594012541, -0.51844266875502898, 0.12865707406922988, polynomial(&r[2], 1))};
    jumps_once(&middle, discs, 5, 0.34718670853, 0.34718670854, 2.0155735061, 3.3268597711);
}

/* The disc ridden grows faster from that moment on, and is ridden again on the other side of the gap's narrowest. */
static void who_changes_over_as_a_rate_falls_may_change_back_at_once(void **state)
{
    (void)state;
    static const double times[] = {0.0, 1.0085443792270523}, first[] = {0.2499306414958779, 0.25472961469760996}, second[] = {0.36014664885546388, 0.16526720976362408};
    static const double third[] = {0.34928069407229728};
    const tdsp_growing_disc discs[] = {grows(-0.46114252879622275, -0.28688608692477713, 0.057262268652099629, rates(first, times, 2)),
                                       grows(-0.54010059172944058, 0.49967466789667825, 0.14600598430652434, rates(second, times, 2)),
                                       grows(-0.53168213767352734, -0.51597981738648402, 0.10918164927504602, polynomial(third, 1))};
    jumps_once(&middle, discs, 3, 0.3964277852, 0.39642778521, 2.0002215892, 3.3809588810);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(who_changes_over_to_a_larger_disc_is_forgiven_a_touch_of_that_disc),
        cmocka_unit_test(a_touch_between_two_looks_at_a_ride_is_one),
        cmocka_unit_test(who_turns_on_the_spot_in_a_gap_may_change_over),
        cmocka_unit_test(who_meets_both_discs_of_a_gap_as_their_rates_fall_may_ride_either),
        cmocka_unit_test(who_changes_over_as_a_rate_falls_may_leave_at_once),
        cmocka_unit_test(who_changes_over_as_a_rate_falls_may_change_back_at_once),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
