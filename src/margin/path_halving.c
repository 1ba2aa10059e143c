/* SPDX-License-Identifier: MIT */
/* The argument is in path_halving.h. */
#include "margin/path_halving.h"

#include <math.h>

#include "tdsp/growth.h"
#include "tdsp/path.h"
#include "tdsp/verify.h"

/* Factors are tried up to this, and as many of the robot's speeds for added rates. */
#define MOST 1048576.0 /* 2^20 */

/* The amount is found to this share of itself. */
#define SAME 1e-12

typedef struct halving {
    const tdsp_scene *scene;
    tdsp_raise how;
    const tdsp_leg *legs;
    size_t count;
    double departure;
    tdsp_verdict met; /* by the least amount known to do harm */
    uint32_t scenes;
} halving;

/* Does the path stay clear in the scene raised by an amount? */
static tdsp_status halving_try(halving *self, double amount, int *is_clear)
{
    tdsp_scene *raised;
    tdsp_verdict verdict;
    tdsp_status status = tdsp_scene_raise(self->scene, self->how, amount, &raised);
    if (status != TDSP_OK) return status;
    const double arrival = self->count > 0 ? self->legs[self->count - 1].end_time : self->departure;
    status = tdsp_verify_path(raised, self->legs, self->count, self->departure, arrival, &verdict);
    tdsp_scene_free(raised);
    if (status == TDSP_OK && (verdict.problems & TDSP_PROBLEM_LEG)) status = TDSP_BAD_PATH;
    if (status != TDSP_OK) return status;
    self->scenes++;
    *is_clear = !(verdict.problems & TDSP_PROBLEM_CLEARANCE);
    if (!*is_clear) self->met = verdict;
    return TDSP_OK;
}

/* Between an amount that does no harm and one that does. */
static tdsp_status halving_narrow(halving *self, double *low, double high)
{
    tdsp_status status = TDSP_OK;
    while (status == TDSP_OK && high - *low > SAME * high) {
        const double middle = 0.5 * (*low + high);
        int is_clear = 0;
        if (!(middle > *low && middle < high)) break;
        status = halving_try(self, middle, &is_clear);
        if (is_clear)
            *low = middle;
        else
            high = middle;
    }
    return status;
}

/* From an amount that does no harm, which is the scene as it is, upwards. */
static tdsp_status halving_rise(halving *self, double *most, double unit)
{
    const double base = *most;
    double step = unit / 1024.0;
    while (step <= MOST * unit) {
        int is_clear;
        const tdsp_status status = halving_try(self, base + step, &is_clear);
        if (status != TDSP_OK) return status;
        if (!is_clear) return halving_narrow(self, most, base + step);
        *most = base + step;
        step *= 2.0;
    }
    *most = INFINITY;
    return TDSP_OK;
}

/* How much the disc that was met gains at a time by so much more than the amount that stands for the scene as it is. */
static double gained(const halving *self, double more)
{
    double radius = 0.0, first = 0.0;
    if (self->how == TDSP_RAISE_ADDED) return more * self->met.time;
    if (tdsp_scene_disc_at(self->scene, self->met.disc, self->met.time, &radius, NULL) != TDSP_OK) return INFINITY;
    (void)tdsp_scene_disc_at(self->scene, self->met.disc, 0.0, &first, NULL);
    return more * (radius - first);
}

static tdsp_point place_at(const halving *self, double time)
{
    tdsp_point place = tdsp_scene_journey(self->scene)->source;
    if (self->count > 0) (void)tdsp_path_position(self->legs, self->count, time, &place);
    return place;
}

tdsp_status halving_margin(const tdsp_scene *scene, tdsp_raise how, const tdsp_leg *legs, size_t count, double departure, tdsp_margin *out)
{
    const double base = how == TDSP_RAISE_FACTOR ? 1.0 : 0.0, unit = how == TDSP_RAISE_FACTOR ? 1.0 : tdsp_scene_journey(scene)->speed;
    halving self = {scene, how, legs, count, departure, {.disc = TDSP_NO_DISC}, 0};
    const double end = count > 0 ? legs[count - 1].end_time : departure;
    double most = base;
    int is_clear;
    tdsp_status status = halving_try(&self, base, &is_clear);
    if (status == TDSP_OK && is_clear) {
        status = halving_rise(&self, &most, unit);
        if (status == TDSP_OK && most < INFINITY && gained(&self, most - base) <= 2.0 * self.met.tolerance) most = base;
    } else if (status == TDSP_OK) {
        most = 0.0;
        status = how == TDSP_RAISE_FACTOR ? halving_try(&self, most, &is_clear) : TDSP_NOT_SUPPORTED;
        if (status == TDSP_OK && is_clear) status = halving_narrow(&self, &most, base);
        if (status == TDSP_OK && !is_clear) most = -INFINITY;
    }
    if (status != TDSP_OK) return status;
    const tdsp_witness none = {TDSP_LIMIT_NONE, TDSP_NO_DISC, TDSP_NO_DISC, INFINITY, place_at(&self, end)};
    const tdsp_witness touch = {TDSP_LIMIT_TOUCH, self.met.disc, TDSP_NO_DISC, self.met.time, place_at(&self, self.met.time)};
    *out = (tdsp_margin){most, most == -INFINITY ? TDSP_BAD_PATH : TDSP_OK, end, most == INFINITY ? none : touch, self.scenes};
    return TDSP_OK;
}
