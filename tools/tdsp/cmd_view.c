/* SPDX-License-Identifier: MIT */
/* tdsp view: a scene or a table in the page, opened in the browser. */
#include "commands.h"
#include "file_in.h"
#include "file_out.h"
#include "json_out.h"
#include "opener.h"
#include "page.h"
#include "scene_file.h"

typedef struct View {
    gboolean json, no_open;
    gboolean opened;
    char *output;
} View;

static void view_clear(View *view)
{
    g_free(view->output);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(View, view_clear)

/* A table was checked when it was loaded. */
static gboolean check_scene(const FileIn *file, GError **error)
{
    g_auto(SceneFile) scene = {0};
    return file->kind == FILE_TABLE || scene_file_parse(cli_file_name(file->path), file->text, file->length, &scene, error);
}

static gboolean write_page(const FileIn *file, const char *output, GError **error)
{
    g_auto(Page) page = {0};
    if (!page_load(&page, error)) return FALSE;
    GString *made = page_with(&page, file, error);
    if (!made) return FALSE;
    gboolean written = file_out_write(output, made->str, made->len, error);
    g_string_free(made, TRUE);
    return written;
}

/* That nobody sees it is no failure: the page is there. */
static void open_page(View *view)
{
    g_autoptr(GError) wrong = NULL;
    if (view->no_open) return;
    if (!opener_has_display())
        cli_warn("there is no display here to open it on: open %s in a browser", view->output);
    else if (opener_open(view->output, &wrong))
        view->opened = TRUE;
    else
        cli_warn("cannot open it (%s): open %s in a browser", wrong->message, view->output);
}

static gboolean print(const View *view, const FileIn *file, GError **error)
{
    if (!view->json) {
        g_autoptr(GString) text = g_string_new(view->output);
        g_string_append_c(text, '\n');
        return cli_print(text, error);
    }
    g_auto(JsonOut) out = json_out_new();
    json_out_begin(&out, '{');
    json_out_member_string(&out, "file", view->output);
    json_out_member_string(&out, "of", file->kind == FILE_TABLE ? "table" : "scene");
    json_out_key(&out, "opened");
    json_out_boolean(&out, view->opened);
    json_out_end(&out, '}');
    return json_out_print(&out, error);
}

int cmd_view(const CliCommand *command, int argc, char **argv, GError **error)
{
    g_auto(View) view = {0};
    g_auto(FileIn) file = {0};
    const GOptionEntry entries[] = {
        {"output", 'o', 0, G_OPTION_ARG_FILENAME, &view.output, "Write the page to FILE (default: a file in the user's cache)", "FILE"},
        {"no-open", 0, 0, G_OPTION_ARG_NONE, &view.no_open, "Do not open it", NULL},
        G_OPTION_ENTRY_NULL,
    };
    if (!cli_parse(command, entries, &view.json, &argc, &argv, error) || !cli_positional(command, argc, 1, 1, error)) return CLI_FAILED;
    const char *const inputs[] = {argv[1], NULL};
    if (!file_in_load(argv[1], &file, error) || !check_scene(&file, error)) return CLI_FAILED;
    if (!view.output) view.output = page_output(argv[1], error);
    if (!view.output || !file_out_check(view.output, inputs, error) || !write_page(&file, view.output, error)) return CLI_FAILED;
    open_page(&view);
    return print(&view, &file, error) ? CLI_DONE : CLI_FAILED;
}
