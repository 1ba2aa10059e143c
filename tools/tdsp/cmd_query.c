/* SPDX-License-Identifier: MIT */
/* tdsp query: certified intervals from a table, for departures or, the other way round, for arrivals. */
#include <math.h>

#include "commands.h"
#include "file_in.h"
#include "json_out.h"
#include "matrix_pair.h"
#include "text_table.h"
#include "times.h"

typedef struct Asked {
    gboolean json;
    gboolean by_arrival;
    char *table; /* the first positional argument */
    char *times_file;
    char *from, *to; /* of a matrix: which table */
    GArray *departures; /* given before --arrive-by, or without it */
    GArray *arrivals;   /* given after it */
} Asked;

static void asked_clear(Asked *asked)
{
    g_free(asked->table);
    g_free(asked->times_file);
    g_free(asked->from);
    g_free(asked->to);
    g_clear_pointer(&asked->departures, g_array_unref);
    g_clear_pointer(&asked->arrivals, g_array_unref);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(Asked, asked_clear)

/* GOption calls these in the order of the command line, and that order tells departures from arrivals. */
static gboolean take_positional(const char *option, const char *value, gpointer data, GError **error)
{
    Asked *asked = data;
    (void)option;
    if (!asked->table) {
        asked->table = g_strdup(value);
        return TRUE;
    }
    return asked->by_arrival ? times_add(asked->arrivals, value, "arrival", error)
                             : times_add(asked->departures, value, "departure", error);
}

static gboolean take_arrive_by(const char *option, const char *value, gpointer data, GError **error)
{
    Asked *asked = data;
    (void)option;
    asked->by_arrival = TRUE;
    return value ? take_positional(NULL, value, data, error) : TRUE;
}

static gboolean parse(const CliCommand *command, Asked *asked, int argc, char **argv, GError **error)
{
    const GOptionEntry entries[] = {
        {"arrive-by", 0, G_OPTION_FLAG_OPTIONAL_ARG, G_OPTION_ARG_CALLBACK, (gpointer)(void *)(gsize)take_arrive_by,
         "The numbers that follow are arrivals: ask for latest departures", "A..."},
        {"times", 0, 0, G_OPTION_ARG_FILENAME, &asked->times_file,
         "Read times from FILE (-: standard input), one a line, # comments", "FILE"},
        {"from", 0, 0, G_OPTION_ARG_STRING, &asked->from, "Of a matrix: the source, by number (from 0) or name", "I"},
        {"to", 0, 0, G_OPTION_ARG_STRING, &asked->to, "Of a matrix: the destination, likewise", "J"},
        {G_OPTION_REMAINING, 0, G_OPTION_FLAG_FILENAME, G_OPTION_ARG_CALLBACK, (gpointer)(void *)(gsize)take_positional, NULL, NULL},
        G_OPTION_ENTRY_NULL,
    };
    asked->departures = times_new();
    asked->arrivals = times_new();
    if (!cli_parse_data(command, entries, asked, &asked->json, &argc, &argv, error)) return FALSE;
    if (!asked->table) return cli_fail(error, CLI_USAGE, "TABLE is missing (more: tdsp query --help)");
    if (asked->by_arrival && asked->departures->len > 0)
        return cli_fail(error, CLI_USAGE, "departures and arrivals in one call: numbers go after --arrive-by, or it goes");
    GArray *list = asked->by_arrival ? asked->arrivals : asked->departures;
    if (asked->times_file) return times_add_file(list, asked->times_file, error);
    return list->len > 0 ? TRUE : cli_fail(error, CLI_USAGE, "no time to ask for: give numbers or --times FILE");
}

/* Two results and a status for each time asked. */
typedef struct Answers {
    double *first;
    double *second;
    tdsp_status *statuses;
    gsize count;
} Answers;

static void answers_clear(Answers *answers)
{
    g_free(answers->first);
    g_free(answers->second);
    g_free(answers->statuses);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(Answers, answers_clear)

static gboolean look_up(const tdsp_table *table, const Asked *asked, Answers *answers, GError **error)
{
    const GArray *list = asked->by_arrival ? asked->arrivals : asked->departures;
    const double *times = (const double *)list->data;
    answers->count = list->len;
    answers->first = g_new(double, list->len);
    answers->second = g_new(double, list->len);
    answers->statuses = g_new(tdsp_status, list->len);
    tdsp_status status = asked->by_arrival
                             ? tdsp_table_departures(table, times, list->len, answers->first, answers->second, answers->statuses)
                             : tdsp_table_arrivals(table, times, list->len, answers->first, answers->second, answers->statuses);
    for (gsize i = 0; i < answers->count && status == TDSP_OK; i++) {
        if (!tdsp_status_is_answer(answers->statuses[i])) status = answers->statuses[i];
        if (answers->statuses[i] != TDSP_OK) answers->first[i] = answers->second[i] = INFINITY;
    }
    return status == TDSP_OK ? TRUE : cli_fail_status(error, "query", status);
}

/* All the times have this one answer. */
static void answer_all(const Asked *asked, tdsp_status status, Answers *answers)
{
    answers->count = asked->by_arrival ? asked->arrivals->len : asked->departures->len;
    answers->first = g_new(double, answers->count);
    answers->second = g_new(double, answers->count);
    answers->statuses = g_new(tdsp_status, answers->count);
    for (gsize i = 0; i < answers->count; i++) {
        answers->first[i] = answers->second[i] = INFINITY;
        answers->statuses[i] = status;
    }
}

/* In a table, or in that of a matrix's pair. */
static gboolean answer(FileIn *file, const Asked *asked, Answers *answers, GError **error)
{
    guint64 i, j;
    if (file->kind == FILE_MATRIX) {
        if (!matrix_pair_find(file, asked->from, asked->to, &i, &j, error)) return FALSE;
        tdsp_status status = tdsp_matrix_table(&file->matrix, i, j, &file->table);
        if (status == TDSP_OK) return look_up(&file->table, asked, answers, error);
        answer_all(asked, status, answers);
        return TRUE;
    }
    if (!file_in_need_table(file, error)) return FALSE;
    if (asked->from || asked->to) return cli_fail(error, CLI_USAGE, "--from and --to go with a matrix; %s is a table", cli_file_name(file->path));
    return look_up(&file->table, asked, answers, error);
}

typedef struct Names {
    const char *time, *first, *second;
} Names;

static Names names_of(const Asked *asked)
{
    return asked->by_arrival ? (Names){"arrival", "departure", "departure_upper"} : (Names){"departure", "lower", "upper"};
}

static gboolean print_text(const Asked *asked, const Answers *answers, GError **error)
{
    Names names = names_of(asked);
    const char *const heading[] = {names.time, names.first, names.second, "status", NULL};
    const GArray *list = asked->by_arrival ? asked->arrivals : asked->departures;
    g_auto(TextTable) table = text_table_new(heading);
    for (guint i = 0; i < list->len; i++) {
        text_table_number(&table, g_array_index(list, double, i));
        text_table_number(&table, answers->first[i]); /* NOLINT(clang-analyzer-core.NullDereference): there are as many answers as times */
        text_table_number(&table, answers->second[i]);
        text_table_string(&table, tdsp_status_name(answers->statuses[i]));
    }
    return text_table_print(&table, error);
}

static gboolean print_json(const Asked *asked, const Answers *answers, GError **error)
{
    Names names = names_of(asked);
    const GArray *list = asked->by_arrival ? asked->arrivals : asked->departures;
    g_auto(JsonOut) out = json_out_new();
    json_out_begin(&out, '{');
    json_out_key(&out, "results");
    json_out_begin(&out, '[');
    for (guint i = 0; i < list->len; i++) {
        json_out_line(&out);
        json_out_begin(&out, '{');
        json_out_member_number(&out, names.time, g_array_index(list, double, i));
        json_out_member_number(&out, names.first, answers->first[i]); /* NOLINT(clang-analyzer-core.NullDereference): there are as many answers as times */
        json_out_member_number(&out, names.second, answers->second[i]);
        json_out_member_string(&out, "status", tdsp_status_name(answers->statuses[i]));
        json_out_end(&out, '}');
    }
    json_out_end(&out, ']');
    json_out_end(&out, '}');
    return json_out_print(&out, error);
}

int cmd_query(const CliCommand *command, int argc, char **argv, GError **error)
{
    g_auto(Asked) asked = {0};
    g_auto(FileIn) file = {0};
    g_auto(Answers) answers = {0};
    if (!parse(command, &asked, argc, argv, error) || !file_in_load_any(asked.table, &file, error) ||
        !answer(&file, &asked, &answers, error))
        return CLI_FAILED;
    if (!(asked.json ? print_json(&asked, &answers, error) : print_text(&asked, &answers, error))) return CLI_FAILED;
    for (gsize i = 0; i < answers.count; i++)
        if (answers.statuses[i] == TDSP_OK) return CLI_DONE;
    return CLI_NO;
}
