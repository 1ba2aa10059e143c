/* SPDX-License-Identifier: MIT */
/* The command `tdsp`: picks the command and reports its error. The texts of all commands stand in one table here. */
#include <glib.h>
#include <locale.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli.h"
#include "commands.h"
#include "describe.h"
#include "descriptor.h"
#include "suggest.h"
#include "tdsp/types.h"

#define SUGGESTED_DISTANCE 2 /* edits from a mistyped command to the one that was meant */

static const CliCommand commands[] = {
    {"arrive", "SCENE T...", "exact earliest arrivals for departures",
     "Print the earliest arrival at the destination for each departure T, exactly. With --within,\n"
     "for a part of the work, an arrival whose travel time is at most 1 + DELTA times the least,\n"
     "and a lower bound that nothing arrives before. SCENE may be - for standard input.\n\n"
     "Examples:\n  tdsp arrive examples/scenes/two-discs.json 0 5 9.8496 9.8497\n"
     "  tdsp arrive examples/scenes/fire-oregon-c.json 0 50 --within 0.01",
     cmd_arrive},
    {"depart", "SCENE A...", "exact latest departures for arrivals",
     "Print for each arrival A the latest departure that still arrives at A or before, exactly.\n\n"
     "Example:\n  tdsp depart examples/scenes/two-discs.json 30.35 33",
     cmd_depart},
    {"margin", "SCENE T...", "what a departure has to spare, in time and in growth",
     "Print for each departure T: how much earlier than the deadline it arrives, how much later one may\n"
     "leave, how far all growth rates may rise (as a factor, and as an added rate) before nobody who leaves\n"
     "at T can arrive in time, how far before this very path is blocked, and what limits it. --path takes\n"
     "the path from the output of `tdsp path --json`, or from a table. Exit status 1 when no T is in time.\n\n"
     "Examples:\n  tdsp margin examples/scenes/two-discs.json 0 5 9.8 --deadline 30\n"
     "  tdsp margin examples/scenes/two-discs.json 5 --path two-discs.tdsp",
     cmd_margin},
    {"path", "SCENE|TABLE T", "the path of one departure, leg by leg",
     "Print the path for departure T as legs: of a scene the fastest one, of a table the path\n"
     "of the row that answers T, moved earlier. With --at only the robot's position at that time;\n"
     "with --within, of a scene a path that takes at most 1 + DELTA times the least.\n\n"
     "Example:\n  tdsp path examples/scenes/two-discs.json 5 --at 12.5",
     cmd_path},
    {"jumps", "SCENE", "where the earliest arrival jumps",
     "Print the departures after which the travel time jumps, by how much, and the two discs that close in\n"
     "on the path there, with time and place. No jump larger than --least is missed.\n\n"
     "Example:\n  tdsp jumps examples/scenes/two-discs.json",
     cmd_jumps},
    {"envelope", "SCENE", "the pieces of the earliest arrival",
     "Print the sequence of combinatorial forms of the fastest paths, the discs that they ride and how: one\n"
     "line for each piece of departures, with the travel times at its ends and what ends it (a jump, a touch\n"
     "of a disc, a switch to another way), and at last their number F.\n\n"
     "Example:\n  tdsp envelope examples/scenes/two-discs.json",
     cmd_envelope},
    {"build", "SCENE -o TABLE", "a table of certified arrivals, from a scene",
     "Sample the exact arrivals of a scene into a table that answers every departure with a\n"
     "certified interval and a path. The guarantee: travel times within 1 + E (travel), arrival\n"
     "times within 1 + E (arrival), or arrivals within D (absolute).\n\n"
     "Example:\n  tdsp build examples/scenes/two-discs.json -o two-discs.tdsp --epsilon 0.01",
     cmd_build},
    {"matrix", "SCENE -o MATRIX", "tables between many places, in one file",
     "Build the tables between all places of two lists, of sources and of destinations, into one file.\n"
     "A list has one place a line: x,y or x y, with a name behind it where wanted; # begins a comment.\n\n"
     "Example:\n  tdsp matrix examples/scenes/two-discs.json --sources from.csv --destinations to.csv -o matrix.tdspm",
     cmd_matrix},
    {"query", "TABLE|MATRIX T...", "certified arrival intervals, from a table",
     "Print for each departure T an interval that holds the earliest arrival for certain. With\n"
     "--arrive-by, for each arrival A a departure that arrives by A for certain, and one after\n"
     "which nothing can. Of a matrix, --from and --to say between which places, by number or name.\n\n"
     "Examples:\n  tdsp query two-discs.tdsp 0 2.5 5\n  tdsp query two-discs.tdsp --arrive-by 30.35 33\n"
     "  tdsp query two-discs.tdsp --times departures.txt",
     cmd_query},
    {"info", "TABLE|MATRIX", "what a table or a matrix holds",
     "Print the facts of a table: size, guarantee, ends of the departures, jumps.\n\n"
     "Example:\n  tdsp info two-discs.tdsp",
     cmd_info},
    {"verify", "SCENE TABLE|MATRIX|PATH", "check a table or a path against its scene",
     "Check a table, or the output of `tdsp path --json`, against its scene by means that share no\n"
     "code with the search. Exit status 1 when anything is wrong. --deep N also solves N departures again.\n\n"
     "Example:\n  tdsp verify examples/scenes/two-discs.json two-discs.tdsp --deep 20",
     cmd_verify},
    {"plot", "SCENE|TABLE -o FILE", "a picture, SVG or PNG",
     "Draw a scene with its fastest path, or the travel times of a table. The ending of FILE\n"
     "decides: .svg or .png. With --animate the discs of a scene grow and the robot rides its path,\n"
     "in an SVG that browsers play, over and over; --beside shows what leaving later would cost.\n\n"
     "Examples:\n  tdsp plot examples/scenes/two-discs.json -o scene.svg --depart 5\n"
     "  tdsp plot examples/scenes/two-discs.json -o moving.svg --depart 9.8 --beside 9.9 --jumps --animate\n"
     "  tdsp plot two-discs.tdsp -o travel-times.png",
     cmd_plot},
    {"view", "SCENE|TABLE", "a page to look at it in the browser",
     "Write the page that shows discs, path and travel times, and lets one move them, with a scene or\n"
     "a table inside: to FILE, or to a file in the user's cache. Then open it in the browser, where\n"
     "there is a desktop. The page needs no network and no server; it may be sent to others.\n\n"
     "Examples:\n  tdsp view examples/scenes/two-discs.json\n"
     "  tdsp view two-discs.tdsp -o two-discs.html --no-open",
     cmd_view},
    {"embed", "TABLE -o FILE.c", "a table as a C array, for firmware",
     "Write a table as C source: a const array in flash, to be opened in place.\n\n"
     "Example:\n  tdsp embed two-discs.tdsp -o two_discs.c",
     cmd_embed},
    {"convert", "FILE", "scenes and paths from and to CSV, GeoJSON, GPX",
     "Convert a scene (CSV, GeoJSON or a scene file, told by what is in it) to a scene file, CSV or GeoJSON;\n"
     "or a path (of tdsp path --json) to CSV, GeoJSON or GPX. CSV has a line a disc under named columns:\n"
     "x, y (or lon, lat), radius, growth, role. GeoJSON has points with such properties, which are projected\n"
     "to metres about an origin. FILE may be - for standard input.\n\n"
     "Examples:\n  tdsp convert fires.geojson --speed 6 --from=-120.1,44.3 --to=-119.6,44.6 --growth 0.3 -o fires.json\n"
     "  tdsp convert examples/scenes/two-discs.json --format csv\n"
     "  tdsp convert path.json --scene fires.json --epoch 2026-06-01T12:00:00Z -o path.gpx",
     cmd_convert},
    {"generate", "KIND", "a made-up scene",
     "Print a scene of a KIND: random (discs of all sizes), crowd (equal discs), wall (columns of\n"
     "touching discs with gaps), mixed (three growth rates), columns (gaps that close one after the\n"
     "other), nsquared (N gaps and a chain of N discs, whose arrival has over N^2 pieces).\n\n"
     "Example:\n  tdsp generate crowd --n 300 --seed 7 > crowd.json",
     cmd_generate},
};

static const CliCommand *find_command(const char *name)
{
    for (gsize i = 0; i < G_N_ELEMENTS(commands); i++)
        if (strcmp(commands[i].name, name) == 0) return &commands[i];
    return NULL;
}

static const char *nearest_command(const char *name)
{
    const char *nearest = NULL;
    guint least = SUGGESTED_DISTANCE + 1;
    for (gsize i = 0; i < G_N_ELEMENTS(commands); i++) {
        guint distance = suggest_distance(name, commands[i].name);
        if (distance >= least) continue;
        least = distance;
        nearest = commands[i].name;
    }
    return nearest;
}

static void append_usage(GString *text)
{
    g_string_append(text, "usage: tdsp COMMAND ARGUMENTS [OPTIONS]\n\n"
                          "Earliest arrivals among growing discs, and tables of them.\n\n");
    for (gsize i = 0; i < G_N_ELEMENTS(commands); i++)
        g_string_append_printf(text, "  %-9s %-23s %s\n", commands[i].name, commands[i].arguments, commands[i].summary);
    g_string_append(text, "\n  tdsp COMMAND --help tells more; every command takes --json; tdsp --version\n"
                          "  Exit status: 0 done, 1 the answer is no, 2 usage, 3 invalid input, 4 the system failed\n");
}

static int report(const char *command, const GError *error)
{
    g_autofree char *who = g_strconcat("tdsp", command ? " " : "", command, NULL);
    cli_say(who, error->message);
    return error->domain == CLI_ERROR ? error->code : CLI_SYSTEM;
}

static int print_usage(void)
{
    g_autoptr(GString) text = g_string_new(NULL);
    g_autoptr(GError) error = NULL;
    append_usage(text);
    return cli_print(text, &error) ? CLI_DONE : report(NULL, error);
}

static int print_version(void)
{
    g_autoptr(GString) text = g_string_new(NULL);
    g_autoptr(GError) error = NULL;
    g_string_printf(text, "tdsp %s\n", tdsp_version());
    return cli_print(text, &error) ? CLI_DONE : report(NULL, error);
}

static int no_command(void)
{
    g_autoptr(GString) text = g_string_new(NULL);
    append_usage(text);
    fputs(text->str, stderr);
    return CLI_USAGE;
}

static int unknown_command(const char *name)
{
    const char *nearest = nearest_command(name);
    fprintf(stderr, "tdsp: no command \"%s\"", name);
    if (nearest)
        fprintf(stderr, "; did you mean \"%s\"?\n", nearest);
    else
        fprintf(stderr, " (tdsp --help lists them)\n");
    return CLI_USAGE;
}

static int run(const CliCommand *command, int argc, char **argv)
{
    g_autoptr(GError) error = NULL;
    int status = command->run(command, argc, argv, &error);
    return error ? report(command->name, error) : status;
}

static int too_many_for_help(void)
{
    fputs("tdsp help: too many arguments (usage: tdsp help [COMMAND] [--json])\n", stderr);
    return CLI_USAGE;
}

/* `tdsp help --json` tells all commands, `tdsp help COMMAND --json` that one. */
static int print_description(const CliCommand *command)
{
    g_autoptr(GError) error = NULL;
    gboolean told = command ? describe_print(command, 1, &error) : describe_print(commands, G_N_ELEMENTS(commands), &error);
    return told ? CLI_DONE : report("help", error);
}

/* `tdsp help COMMAND` is `tdsp COMMAND --help`. */
static int help(int argc, char **argv)
{
    gboolean json = FALSE;
    const char *name = NULL;
    for (int i = 2; i < argc; i++) {
        if (strcmp(argv[i], "--json") == 0) json = TRUE;
        else if (!name) name = argv[i];
        else return too_many_for_help();
    }
    const CliCommand *command = name ? find_command(name) : NULL;
    if (name && !command) return unknown_command(name);
    if (json) return print_description(command);
    if (!command) return print_usage();
    char option[] = "--help";
    char *arguments[] = {argv[0], option, NULL};
    return run(command, 2, arguments);
}

int main(int argc, char **argv)
{
    descriptor_guard_standard();
    signal(SIGXFSZ, SIG_IGN); /* a file over the limit of sizes is then an error that can be told */
    /* Only how characters are written; numbers look the same everywhere. */
    setlocale(LC_CTYPE, "");
    if (argc < 2) return no_command();
    if (strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0) return print_usage();
    if (strcmp(argv[1], "--version") == 0) return print_version();
    if (strcmp(argv[1], "help") == 0) return help(argc, argv);
    const CliCommand *command = find_command(argv[1]);
    return command ? run(command, argc - 1, argv + 1) : unknown_command(argv[1]);
}
