/* SPDX-License-Identifier: MIT */
/* The units that are known, and what they are worth. */
#include "units.h"

#include <string.h>

#include "cli.h"

typedef struct Unit {
    const char *name;
    double worth;
} Unit;

/* The international foot, mile and nautical mile are exact. */
static const Unit lengths[] = {{"m", 1}, {"km", 1000}, {"cm", 0.01}, {"ft", 0.3048}, {"mi", 1609.344}, {"nmi", 1852}, {NULL, 0}};
static const Unit times[] = {{"s", 1}, {"ms", 0.001}, {"min", 60}, {"h", 3600}, {"d", 86400}, {NULL, 0}};

static gboolean find(const Unit *units, const char *quantity, const char *file, const char *name, double *worth, GError **error)
{
    g_autoptr(GString) names = g_string_new(NULL);
    for (const Unit *unit = units; unit->name; unit++) {
        *worth = unit->worth;
        if (strcmp(unit->name, name) == 0) return TRUE;
        g_string_append_printf(names, "%s%s", names->len > 0 ? ", " : "", unit->name);
    }
    if (*name == '\0') return cli_fail(error, CLI_USAGE, "%s needs the unit of %s, which nothing says: --units LENGTH,TIME (%s)", file, quantity, names->str);
    return cli_fail(error, CLI_INPUT, "%s needs a known unit of %s, not \"%s\" (%s)", file, quantity, name, names->str);
}

gboolean unit_metres(const char *file, const char *unit, double *metres, GError **error)
{
    return find(lengths, "length", file, unit, metres, error);
}

gboolean unit_seconds(const char *file, const char *unit, double *seconds, GError **error)
{
    return find(times, "time", file, unit, seconds, error);
}
