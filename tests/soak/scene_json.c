/* SPDX-License-Identifier: MIT */
/* See scene_json.h. What is read was written here, or by hand: it is not held to the rules of the command's reader. */
#include "soak/scene_json.h"

#include <json-glib/json-glib.h>

static void write_numbers(FILE *out, const char *name, const double *numbers, size_t count)
{
    (void)fprintf(out, "%s[", name);
    for (size_t i = 0; i < count; i++) (void)fprintf(out, "%s%.17g", i ? ", " : "", numbers[i]);
    (void)fprintf(out, "]");
}

static void write_growth(FILE *out, const soak_disc *disc)
{
    const tdsp_growth *g = &disc->growth;
    const grown_parts *p = &disc->parts;
    switch (g->kind) {
    case TDSP_GROWTH_RATE: (void)fprintf(out, "\"growth\": %.17g", g->rate); break;
    case TDSP_GROWTH_POLYNOMIAL: write_numbers(out, "\"growth\": ", disc->values, g->count); break;
    case TDSP_GROWTH_RATES:
        write_numbers(out, "\"growth\": {\"times\": ", disc->times, g->count);
        write_numbers(out, ", \"rates\": ", disc->values, g->count);
        (void)fprintf(out, "}");
        break;
    case TDSP_GROWTH_LAW:
        (void)fprintf(out, "\"law\": \"by callback\", \"sharp\": %d, \"until\": %.17g", p->sharp, g->until);
        write_numbers(out, ", \"begins\": ", p->begins, p->count);
        write_numbers(out, ", \"spans\": ", p->spans, p->count);
        write_numbers(out, ", \"shares\": ", p->shares, p->count);
    }
}

void soak_write(FILE *out, const soak_scene *scene, const char *name)
{
    const tdsp_journey *j = &scene->journey;
    (void)fprintf(out, "{\"name\": \"%s\",\n \"robot\": {\"speed\": %.17g, \"radius\": %.17g},\n", name, j->speed, j->radius);
    (void)fprintf(out, " \"source\": [%.17g, %.17g], \"destination\": [%.17g, %.17g],\n \"discs\": [", j->source.x, j->source.y,
                  j->destination.x, j->destination.y);
    for (size_t i = 0; i < scene->count; i++) {
        const soak_disc *disc = &scene->discs[i];
        (void)fprintf(out, "%s\n  {\"center\": [%.17g, %.17g], \"radius\": %.17g, ", i ? "," : "", disc->center.x, disc->center.y,
                      disc->radius);
        write_growth(out, disc);
        (void)fprintf(out, "}");
    }
    (void)fprintf(out, "]}\n");
}

/* -------------------------------------------------------------------------------------------------------------- reading */

static tdsp_point read_point(JsonObject *object, const char *name)
{
    JsonArray *numbers = json_object_get_array_member(object, name);
    return (tdsp_point){json_array_get_double_element(numbers, 0), json_array_get_double_element(numbers, 1)};
}

static size_t read_numbers(JsonArray *array, double *numbers)
{
    const guint count = MIN(json_array_get_length(array), GROWTH_MOST_VALUES);
    for (guint i = 0; i < count; i++) numbers[i] = json_array_get_double_element(array, i);
    return count;
}

static void read_disc(JsonObject *object, soak_disc *disc)
{
    JsonNode *growth = json_object_get_member(object, "growth");
    *disc = (soak_disc){.center = read_point(object, "center"), .radius = json_object_get_double_member(object, "radius")};
    if (!growth)
        g_printerr("a law by callback is read as a disc that does not grow\n");
    else if (JSON_NODE_HOLDS_ARRAY(growth)) {
        disc->growth.kind = TDSP_GROWTH_POLYNOMIAL;
        disc->growth.count = read_numbers(json_node_get_array(growth), disc->values);
    } else if (JSON_NODE_HOLDS_OBJECT(growth)) {
        disc->growth.kind = TDSP_GROWTH_RATES;
        disc->growth.count = read_numbers(json_object_get_array_member(json_node_get_object(growth), "times"), disc->times);
        (void)read_numbers(json_object_get_array_member(json_node_get_object(growth), "rates"), disc->values);
    } else
        disc->growth.rate = json_node_get_double(growth);
}

int soak_read(const char *path, soak_scene *scene)
{
    g_autoptr(JsonParser) parser = json_parser_new();
    g_autoptr(GError) error = NULL;
    if (!json_parser_load_from_file(parser, path, &error)) {
        g_printerr("%s\n", error->message);
        return 0;
    }
    JsonObject *root = json_node_get_object(json_parser_get_root(parser));
    JsonObject *robot = json_object_get_object_member(root, "robot");
    JsonArray *discs = json_object_get_array_member(root, "discs");
    scene->mix = "file";
    scene->moment = -1.0;
    scene->journey =
        (tdsp_journey){json_object_get_double_member(robot, "speed"),
                       json_object_has_member(robot, "radius") ? json_object_get_double_member(robot, "radius") : 0.0,
                       read_point(root, "source"), read_point(root, "destination")};
    scene->count = MIN(json_array_get_length(discs), SOAK_MOST_DISCS);
    for (guint i = 0; i < scene->count; i++) read_disc(json_array_get_object_element(discs, i), &scene->discs[i]);
    return 1;
}
