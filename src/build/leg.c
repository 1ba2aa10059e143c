/* A table does not store what a kind of leg does not have, so that must be zero: what goes in comes out. */
#include "build/leg.h"

#include "base/round.h"
#include "table/check.h"

static int leg_is_bare(const tdsp_leg *leg)
{
    return leg->disc == TDSP_NO_DISC && leg->turn == 0 && leg->center.x == 0 && leg->center.y == 0 && leg->radius_from == 0 &&
           leg->radius_to == 0 && leg->angle_from == 0 && leg->sweep == 0;
}

static int leg_has_no_rates(const tdsp_leg *leg)
{
    return leg->rate_from == 0 && leg->rate_to == 0 && leg->bend_from == 0 && leg->bend_to == 0 && leg->speed == 0;
}

static int leg_is_finite(const tdsp_leg *leg)
{
    const double numbers[] = {leg->start_time, leg->end_time, leg->from.x,      leg->from.y,    leg->to.x,       leg->to.y,
                              leg->center.x,   leg->center.y, leg->radius_from, leg->radius_to, leg->angle_from, leg->sweep};
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        if (!round_is_finite(numbers[i])) return 0;
    }
    return 1;
}

static int leg_is_ride(const tdsp_leg *leg)
{
    return (leg->turn == 1 || leg->turn == -1) && leg->sweep >= 0 && leg->radius_from > 0 && leg->radius_to > 0;
}

int leg_is_good(const tdsp_leg *leg)
{
    if (leg->reserved != 0 || !leg_is_finite(leg) || !(leg->start_time <= leg->end_time)) return 0;
    switch (leg->kind) {
    case TDSP_LEG_LINE: return leg_is_bare(leg) && leg_has_no_rates(leg);
    case TDSP_LEG_ARC: return leg_is_ride(leg) && leg_has_no_rates(leg);
    case TDSP_LEG_CURVE: return leg_is_ride(leg) && check_curve(leg);
    default: return 0;
    }
}
