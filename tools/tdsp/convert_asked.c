/* SPDX-License-Identifier: MIT */
/* Options of tdsp convert. An option that would change nothing is a mistake of whoever gave it, and refused. */
#include "convert_asked.h"

#include <string.h>

#include "cli.h"
#include "json_read.h"
#include "words.h"

const char *convert_kind_word(ConvertKind kind)
{
    return kind == CONVERT_PATH ? "path" : words_format(kind);
}

/* What an option is for, by bits of the kinds of input. */
enum { PLAIN = 1 << CONVERT_CSV, MAPPED = 1 << CONVERT_GEOJSON, SCENES = PLAIN | MAPPED | 1 << CONVERT_JSON, PATHS = 1 << CONVERT_PATH, ALL = SCENES | PATHS };

typedef struct Option {
    const char *name;
    gsize at; /* of its text in ConvertAsked */
    int inputs;
    const char *help, *value;
} Option;

#define AT(member) G_STRUCT_OFFSET(ConvertAsked, member)
static const Option options[] = {
    {"format", AT(format), ALL, "json (a scene file), csv, geojson or gpx; else the ending of -o FILE decides", "FORMAT"},
    {"output", AT(output), ALL, "Write to FILE, not to standard output", "FILE"},
    {"scene", AT(scene), ALL, "Take from this scene what the file does not say; of a path, the scene that it belongs to", "SCENE"},
    {"name", AT(draft.name), ALL, "The scene's or path's name", "NAME"},
    {"units", AT(draft.units), ALL, "Units of length and time, as m,s (on the earth m,s if nothing says them)", "LENGTH,TIME"},
    {"origin", AT(draft.origin), ALL, "Where the plane's (0, 0) is on the earth (projecting: by default the middle)", "LON,LAT"},
    {"from", AT(draft.from), SCENES, "The source, in the coordinates of the file", "X,Y"},
    {"to", AT(draft.to), SCENES, "The destination, in the coordinates of the file", "X,Y"},
    {"speed", AT(draft.speed), ALL, "The robot's speed", "V"},
    {"robot-radius", AT(draft.robot_radius), SCENES, "The robot's radius", "R"},
    {"radius", AT(radius), PLAIN | MAPPED, "Radius of discs that say none", "R"},
    {"growth", AT(growth), PLAIN | MAPPED, "Growth rate of discs that say none", "G"},
    {"radius-field", AT(radius_field), PLAIN | MAPPED, "Column or property that is the radius (default radius)", "NAME"},
    {"growth-field", AT(growth_field), PLAIN | MAPPED, "Column or property that is the growth (default growth)", "NAME"},
    {"role-field", AT(role_field), PLAIN | MAPPED, "Column or property that says disc, source or destination (default role)", "NAME"},
    {"x-field", AT(x_field), PLAIN, "Column of x (default x)", "NAME"},
    {"y-field", AT(y_field), PLAIN, "Column of y (default y)", "NAME"},
    {"lon-field", AT(lon_field), PLAIN, "Column of longitudes, in degrees (default lon, longitude)", "NAME"},
    {"lat-field", AT(lat_field), PLAIN, "Column of latitudes, in degrees (default lat, latitude)", "NAME"},
    {"epoch", AT(epoch), PATHS, "The instant of the scene's time 0, as 2026-06-01T12:00:00Z", "INSTANT"},
    {"tolerance", AT(tolerance), PATHS, "Points so dense that straight lines between them are the path within this length", "LENGTH"},
};

static char **text_of(ConvertAsked *asked, const Option *option)
{
    return G_STRUCT_MEMBER_P(asked, option->at);
}

GOptionEntry *convert_asked_entries(ConvertAsked *asked)
{
    GOptionEntry *entries = g_new0(GOptionEntry, G_N_ELEMENTS(options) + 1);
    for (gsize i = 0; i < G_N_ELEMENTS(options); i++) {
        const gboolean output = options[i].at == AT(output), file = output || options[i].at == AT(scene);
        entries[i] = (GOptionEntry){options[i].name, output ? 'o' : 0, 0, file ? G_OPTION_ARG_FILENAME : G_OPTION_ARG_STRING,
                                    text_of(asked, &options[i]), options[i].help, options[i].value};
    }
    return entries;
}

void convert_asked_clear(ConvertAsked *asked)
{
    for (gsize i = 0; i < G_N_ELEMENTS(options); i++) g_clear_pointer(text_of(asked, &options[i]), g_free);
}

/* ---------------------------------------------------------------------------------------------------------------- the kinds */

/* JSON is told by its members: a path has legs, GeoJSON a type, and a scene neither. */
static gboolean kind_of_json(const char *file, const char *text, gsize length, ConvertKind *kind, GError **error)
{
    g_autoptr(JsonParser) parser = NULL;
    JsonValue root, member;
    if (!json_read_document(file, text, length, &parser, &root, error) || !json_read_object(&root, error)) return FALSE;
    *kind = json_read_optional(&root, "legs", &member) ? CONVERT_PATH : json_read_optional(&root, "type", &member) ? CONVERT_GEOJSON : CONVERT_JSON;
    return TRUE;
}

gboolean convert_kind_of(const char *file, const char *text, gsize length, ConvertKind *kind, GError **error)
{
    const char *begin = g_str_has_prefix(text, "\xef\xbb\xbf") ? text + 3 : text;
    begin += strspn(begin, " \t\r\n");
    if (*begin == '{' || *begin == '[') return kind_of_json(file, text, length, kind, error);
    if ((unsigned char)*begin == 0x89) return cli_fail(error, CLI_INPUT, "%s: a table or matrix; tdsp path TABLE T --json makes a path of one", file);
    if (*begin == '<') return cli_fail(error, CLI_INPUT, "%s: XML, which is written and not read", file);
    if (*begin == '\0') return cli_fail(error, CLI_INPUT, "%s: %s", file, length == 0 ? "empty" : "neither JSON nor CSV");
    *kind = CONVERT_CSV;
    return TRUE;
}

/* The ending of a file's name. */
static gboolean kind_of_ending(const char *name, ConvertKind *kind)
{
    const char *dot = name ? strrchr(name, '.') : NULL;
    for (*kind = CONVERT_JSON; dot && *kind < CONVERT_PATH; ++*kind)
        if (g_ascii_strcasecmp(dot + 1, words_format(*kind)) == 0) return TRUE;
    return FALSE;
}

static gboolean find_format(const ConvertAsked *asked, const char *file, ConvertKind from, ConvertKind *to, GError **error)
{
    guint32 word = 0;
    if (!words_parse_format("--format", asked->format, &word, error)) return FALSE;
    *to = (ConvertKind)word;
    if (asked->format || kind_of_ending(asked->output, to)) return TRUE;
    *to = CONVERT_JSON;
    if ((from == CONVERT_CSV || from == CONVERT_GEOJSON) && !asked->output) return TRUE;
    return cli_fail(error, CLI_USAGE, "into which format? %s is %s: --format %s", file, from == CONVERT_PATH ? "a path" : "a scene",
                    from == CONVERT_PATH ? "csv, geojson or gpx" : "json, csv or geojson");
}

/* -------------------------------------------------------------------------------------------------------------- the options */

static gboolean check_purpose(ConvertAsked *asked, const char *file, ConvertKind from, GError **error)
{
    static const char *const kinds[CONVERT_KINDS] = {"a scene file", "CSV", "GeoJSON", "", "a path"};
    for (gsize i = 0; i < G_N_ELEMENTS(options); i++)
        if (*text_of(asked, &options[i]) && !(options[i].inputs & 1 << from))
            return cli_fail(error, CLI_USAGE, "--%s is not for %s, and %s is that", options[i].name, kinds[from], file);
    return TRUE;
}

static gboolean parse_numbers(ConvertAsked *asked, GError **error)
{
    DraftFields *fields = &asked->fields;
    *fields = (DraftFields){asked->role_field ? asked->role_field : "role", asked->radius_field ? asked->radius_field : "radius",
                            asked->growth_field ? asked->growth_field : "growth", asked->x_field, asked->y_field, asked->lon_field, asked->lat_field, -1, -1};
    if (!cli_option_number("--radius", asked->radius, &fields->missing_radius, error) || !cli_option_number("--growth", asked->growth, &fields->missing_growth, error) ||
        !cli_option_number("--tolerance", asked->tolerance, &asked->tolerance_length, error))
        return FALSE;
    if (asked->tolerance && !(asked->tolerance_length > 0)) return cli_fail(error, CLI_USAGE, "--tolerance must be greater than zero");
    return (fields->x || fields->y) && (fields->lon || fields->lat) ? cli_fail(error, CLI_USAGE, "--x-field, --y-field or --lon-field, --lat-field, not both") : TRUE;
}

gboolean convert_asked_check(ConvertAsked *asked, const char *file, ConvertKind from, ConvertKind *to, GError **error)
{
    if (asked->json && !asked->output) return cli_fail(error, CLI_USAGE, "--json reports about the file of -o FILE");
    if (!find_format(asked, file, from, to, error) || !check_purpose(asked, file, from, error) || !parse_numbers(asked, error)) return FALSE;
    if (from == CONVERT_PATH && *to == CONVERT_JSON) return cli_fail(error, CLI_USAGE, "%s is a path in JSON: it goes into csv, geojson or gpx", file);
    if (from != CONVERT_PATH && *to == CONVERT_GPX) return cli_fail(error, CLI_USAGE, "GPX is for paths, and %s is a scene", file);
    return TRUE;
}
