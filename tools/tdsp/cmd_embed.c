/* SPDX-License-Identifier: MIT */
/* tdsp embed: a table as C source, for firmware that reads it from flash. */
#include <string.h>

#include "commands.h"
#include "file_in.h"
#include "file_out.h"
#include "json_out.h"

#define BYTES_A_LINE 20

/* Words that no C or C++ compiler takes for a name. */
static const char *const keywords[] = {
    "auto",     "bool",     "break",    "case",      "catch",    "char",     "class",    "const",   "continue",  "default",
    "delete",   "do",       "double",   "else",      "enum",     "export",   "extern",   "false",   "float",     "for",
    "friend",   "goto",     "if",       "inline",    "int",      "long",     "main",     "mutable", "namespace", "new",
    "nullptr",  "operator", "private",  "protected", "public",   "register", "restrict", "return",  "short",     "signed",
    "sizeof",   "static",   "struct",   "switch",    "template", "this",     "throw",    "true",    "try",       "typedef",
    "typename", "union",    "unsigned", "using",     "virtual",  "void",     "volatile", "while",   NULL};

static gboolean is_identifier(const char *name)
{
    if (!g_ascii_isalpha(*name)) return FALSE;
    for (; *name; name++)
        if (!g_ascii_isalnum(*name) && *name != '_') return FALSE;
    return TRUE;
}

/* The name of the file up to its first dot, with anything that no identifier holds replaced. */
static char *name_from(const char *path)
{
    g_autofree char *base = g_path_get_basename(path);
    base[strcspn(base, ".")] = '\0';
    for (char *at = base; *at; at++)
        if (!g_ascii_isalnum(*at)) *at = '_';
    gboolean usable = g_ascii_isalpha(*base) && !g_strv_contains(keywords, base);
    return usable ? g_strdup(base) : g_strdup_printf("table_%s", base);
}

static void append_bytes(GString *text, const FileIn *file)
{
    const unsigned char *bytes = (const unsigned char *)file->text;
    for (gsize i = 0; i < file->length; i++) {
        g_string_append(text, i % BYTES_A_LINE == 0 ? "\n    " : " ");
        g_string_append_printf(text, "%u,", bytes[i]);
    }
}

/* Aligned, so that a reader may use wide loads; the table itself is read at any alignment. */
static GString *source_of(const FileIn *file, const char *name)
{
    g_autofree char *base = g_path_get_basename(file->path);
    GString *text = g_string_sized_new(file->length * 5 + 1024);
    g_string_append_printf(text, "/* Made by tdsp embed of \"%s\": a table of libtdsp. Open it with\n", base);
    g_string_append_printf(text, " *     tdsp_table_open(&table, %s, %s_length);\n */\n#include <stddef.h>\n\n", name, name);
    g_string_append_printf(text, "extern const size_t %s_length;\nextern const unsigned char %s[];\n\n", name, name);
    g_string_append_printf(text, "const size_t %s_length = %" G_GSIZE_FORMAT ";\n\n", name, file->length);
    g_string_append(text, "#if defined(__GNUC__) || defined(__ICCARM__)\n__attribute__((aligned(8)))\n#elif "
                          "defined(_MSC_VER)\n__declspec(align(8))\n#endif\n");
    g_string_append_printf(text, "const unsigned char %s[%" G_GSIZE_FORMAT "] = {", name, file->length);
    append_bytes(text, file);
    g_string_append(text, "\n};\n");
    return text;
}

static gboolean print(gboolean json, const char *output, const char *name, gsize bytes, GError **error)
{
    g_auto(JsonOut) out = json_out_new();
    if (!json) return TRUE;
    json_out_begin(&out, '{');
    json_out_member_string(&out, "file", output);
    json_out_member_string(&out, "name", name);
    json_out_member_whole(&out, "bytes", bytes);
    json_out_end(&out, '}');
    return json_out_print(&out, error);
}

static gboolean embed(const char *path, const char *output, const char *name, gboolean json, GError **error)
{
    const char *const inputs[] = {path, NULL};
    g_auto(FileIn) file = {0};
    if (!file_out_check(output, inputs, error) || !file_in_load_table(path, &file, error)) return FALSE;
    g_autoptr(GString) source = source_of(&file, name);
    return file_out_write(output, source->str, source->len, error) && print(json, output, name, file.length, error);
}

int cmd_embed(const CliCommand *command, int argc, char **argv, GError **error)
{
    gboolean json = FALSE;
    g_autofree char *output = NULL;
    g_autofree char *name = NULL;
    const GOptionEntry entries[] = {
        {"output", 'o', 0, G_OPTION_ARG_FILENAME, &output, "Write the C source to FILE.c", "FILE.c"},
        {"name", 0, 0, G_OPTION_ARG_STRING, &name, "Name of the array (default: of the file's name)", "NAME"},
        G_OPTION_ENTRY_NULL,
    };
    if (!cli_parse(command, entries, &json, &argc, &argv, error) || !cli_positional(command, argc, 1, 1, error))
        return CLI_FAILED;
    if (!output) {
        cli_fail(error, CLI_USAGE, "-o FILE.c is missing: where to write the source");
        return CLI_FAILED;
    }
    if (name && (!is_identifier(name) || g_strv_contains(keywords, name))) {
        cli_fail(error, CLI_USAGE, "--name \"%s\": not a C identifier that begins with a letter", name);
        return CLI_FAILED;
    }
    if (!name) name = name_from(output);
    return embed(argv[1], output, name, json, error) ? CLI_DONE : CLI_FAILED;
}
