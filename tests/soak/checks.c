/* SPDX-License-Identifier: MIT */
/* See checks.h. */
#include "soak/checks.h"

static const struct {
    const char *name;
    void (*run)(soak_case *c);
    unsigned share;
    size_t rates, growth;
} checks[SOAK_CHECK_COUNT] = {
#define X(name, share, rates, growth, text) {#name, soak_check_##name, share, rates, growth},
    SOAK_CHECKS(X)
#undef X
};

const char *soak_check_name(size_t check)
{
    return checks[check].name;
}

unsigned soak_check_share(size_t check, const soak_scene *scene)
{
    const size_t most = soak_has_rates_only(scene) ? checks[check].rates : checks[check].growth;
    return scene->count <= most ? checks[check].share : 0;
}

void soak_check_run(size_t check, soak_case *c)
{
    c->failed = 0;
    c->looser = c->touches = 1.0;
    checks[check].run(c);
}
