/* SPDX-License-Identifier: MIT */
/*
 * The page is the same file for everybody. What it is to show stands as JSON in one element of it, which holds `null` as it is made: nothing else of the
 * page is touched. In JSON a "<" can only be in a string, so that written as \u003c nothing there ends the element.
 */
#include "page.h"

#include <string.h>

#include "cli.h"
#include "json_out.h"

#define ELEMENT "<script type=\"application/json\" id=\"given\">"
#define EMPTY "null"
#define BYTE_ORDER_MARK "\xef\xbb\xbf"

/* The directory of the program that runs; NULL where the system does not tell. */
static char *program_directory(void)
{
    g_autofree char *program = g_file_read_link("/proc/self/exe", NULL);
    if (!program) program = g_find_program_in_path("tdsp");
    return program ? g_path_get_dirname(program) : NULL;
}

/* Beside the command where it was built; in the data directory where it was installed. */
static GPtrArray *usual_places(void)
{
    GPtrArray *places = g_ptr_array_new_with_free_func(g_free);
    g_autofree char *directory = program_directory();
    if (!directory) return places;
    g_autofree char *prefix = g_path_get_dirname(directory);
    g_ptr_array_add(places, g_build_filename(directory, "page", "index.html", NULL));
    g_ptr_array_add(places, g_build_filename(prefix, "share", "tdsp", "page.html", NULL));
    return places;
}

/* Where the page is; NULL when it is nowhere. */
static char *find(GError **error)
{
    const char *given = g_getenv("TDSP_PAGE");
    if (given && *given) return g_strdup(given);
    g_autoptr(GPtrArray) places = usual_places();
    g_autoptr(GString) tried = g_string_new(NULL);
    for (guint i = 0; i < places->len; i++) {
        const char *place = g_ptr_array_index(places, i);
        if (g_file_test(place, G_FILE_TEST_EXISTS)) return g_strdup(place);
        g_string_append_printf(tried, "%s%s", i > 0 ? " or " : "", place);
    }
    cli_fail(error, CLI_SYSTEM, "there is no page to show it in (looked for %s): 'make page' builds it, and TDSP_PAGE may name it", tried->str);
    return NULL;
}

gboolean page_load(Page *page, GError **error)
{
    Page loaded = {.path = find(error)};
    if (!loaded.path) return FALSE;
    if (!file_in_read(loaded.path, &loaded.text, &loaded.length, error)) {
        page_clear(&loaded);
        return FALSE;
    }
    *page = loaded;
    return TRUE;
}

void page_clear(Page *page)
{
    g_clear_pointer(&page->path, g_free);
    g_clear_pointer(&page->text, g_free);
}

static void append_json(GString *out, const char *text, gsize length)
{
    for (gsize i = 0; i < length; i++)
        if (text[i] == '<')
            g_string_append(out, "\\u003c");
        else
            g_string_append_c(out, text[i]);
}

/* {"name": ..., "scene": ...} or {"name": ..., "table": ...} */
static void append_given(GString *out, const FileIn *file)
{
    g_autofree char *base = g_path_get_basename(cli_file_name(file->path));
    g_autofree char *name = g_utf8_make_valid(base, -1);
    g_auto(JsonOut) given = json_out_new();
    json_out_begin(&given, '{');
    json_out_member_string(&given, "name", name);
    if (file->kind == FILE_TABLE) {
        g_autofree char *bytes = g_base64_encode((const guchar *)file->text, file->length);
        json_out_member_string(&given, "table", bytes);
        append_json(out, given.text->str, given.text->len);
    } else {
        gsize mark = g_str_has_prefix(file->text, BYTE_ORDER_MARK) ? strlen(BYTE_ORDER_MARK) : 0;
        json_out_key(&given, "scene");
        append_json(out, given.text->str, given.text->len);
        append_json(out, file->text + mark, file->length - mark);
    }
    g_string_append_c(out, '}');
}

/* Where the element's content begins. NULL unless it is empty and the page whole. */
static const char *content_of(const Page *page, GError **error)
{
    const char *element = g_strstr_len(page->text, (gssize)page->length, ELEMENT);
    const char *content = element ? element + strlen(ELEMENT) : NULL;
    if (!content || !g_str_has_prefix(content, EMPTY "</script>")) {
        cli_fail(error, CLI_INPUT, "%s: not the page of this command, for it has no empty element %s", page->path, ELEMENT);
        return NULL;
    }
    if (g_str_has_suffix(content, "</html>\n")) return content;
    cli_fail(error, CLI_INPUT, "%s: cut short, for it does not end with </html>", page->path);
    return NULL;
}

GString *page_with(const Page *page, const FileIn *file, GError **error)
{
    const char *content = content_of(page, error);
    if (!content) return NULL;
    GString *made = g_string_sized_new(page->length + 2 * file->length);
    g_string_append_len(made, page->text, content - page->text);
    append_given(made, file);
    content += strlen(EMPTY);
    g_string_append_len(made, content, (gssize)page->length - (content - page->text));
    return made;
}

/* Of the input's whole name a few digits, and of its own what any system takes in a name. */
static char *name_of(const char *path)
{
    g_autofree char *whole = g_canonicalize_filename(path, NULL);
    g_autofree char *digest = g_compute_checksum_for_string(G_CHECKSUM_SHA256, whole, -1);
    g_autofree char *base = g_path_get_basename(cli_file_name(path));
    g_strcanon(base, G_CSET_A_2_Z G_CSET_a_2_z G_CSET_DIGITS "-_.", '-');
    return g_strdup_printf("%.60s-%.8s.html", base, digest);
}

char *page_output(const char *path, GError **error)
{
    const char *const folders[] = {g_get_user_cache_dir(), g_get_tmp_dir()};
    g_autofree char *name = name_of(path);
    for (gsize i = 0; i < G_N_ELEMENTS(folders); i++) {
        g_autofree char *folder = g_build_filename(folders[i], "tdsp", NULL);
        if (g_mkdir_with_parents(folder, 0700) == 0) return g_build_filename(folder, name, NULL);
    }
    cli_fail(error, CLI_SYSTEM, "no folder for the page in %s nor in %s: say with -o where to write it", folders[0], folders[1]);
    return NULL;
}
