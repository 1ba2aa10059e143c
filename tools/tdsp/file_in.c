/* SPDX-License-Identifier: MIT */
/* Reading input files and telling their kinds apart. */
#include "file_in.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <unistd.h>

#include "cli.h"
#include "descriptor.h"

static gboolean fail_read(GError **error, const char *path, const char *reason)
{
    return cli_fail(error, CLI_SYSTEM, "cannot read %s: %s", cli_file_name(path), reason);
}

/* Text is not read any further, so that a stream without end cannot fill the memory. A scene of a million discs has 70 MB. */
#define MOST_TEXT ((guint64)1 << 30)

/* Where a table or matrix says how long it is; nothing behind that is needed to refuse it. */
#define BINARY 0x89
#define BINARY_LENGTH_AT 16
#define BINARY_BEGIN (BINARY_LENGTH_AT + 8)

#define BLOCK 65536

/* Bytes read so far, in room for one more, a zero behind them. */
typedef struct Content {
    char *bytes;
    gsize length, room;
} Content;

/* How many bytes to read of a file that begins so. */
static guint64 most_of(const Content *begun)
{
    guint64 length;
    if (begun->length < BINARY_BEGIN || (unsigned char)begun->bytes[0] != BINARY) return MOST_TEXT;
    memcpy(&length, begun->bytes + BINARY_LENGTH_AT, sizeof length);
    return GUINT64_FROM_LE(length);
}

/* Room for another block? */
static gboolean make_room(Content *content)
{
    if (content->room - content->length > BLOCK) return TRUE;
    gsize room = content->room < G_MAXSIZE / 2 ? 2 * content->room + 2 * BLOCK : 0;
    char *bytes = room > 0 ? g_try_realloc(content->bytes, room) : NULL;
    if (!bytes) return FALSE;
    content->bytes = bytes;
    content->room = room;
    return TRUE;
}

/* All bytes, or a block more than there may be: 0, or errno. */
static int read_whole(int file, Content *into)
{
    gssize got = 1;
    while (got > 0 && (into->length == 0 || into->length <= most_of(into))) {
        if (!make_room(into)) return ENOMEM;
        got = descriptor_read(file, into->bytes + into->length, BLOCK);
        if (got < 0) return errno;
        into->length += (gsize)got;
    }
    into->bytes[into->length] = 0;
    return 0;
}

gboolean file_in_read(const char *path, char **text, gsize *length, GError **error)
{
    gboolean standard = strcmp(path, "-") == 0;
    int file = standard ? STDIN_FILENO : descriptor_open(path, O_RDONLY);
    if (file < 0) return fail_read(error, path, g_strerror(errno));
    Content content = {0};
    int code = read_whole(file, &content);
    if (!standard) close(file);
    if (code != 0) {
        g_free(content.bytes);
        return fail_read(error, path, g_strerror(code));
    }
    if (content.length > MOST_TEXT && most_of(&content) == MOST_TEXT) {
        g_free(content.bytes);
        return cli_fail(error, CLI_INPUT, "%s: longer than 1 GiB", cli_file_name(path));
    }
    *length = content.length;
    *text = content.bytes;
    return TRUE;
}

/* JSON begins with a bracket after white space; a byte order mark is let pass. */
static gboolean looks_like_json(const char *text)
{
    if (strncmp(text, "\xef\xbb\xbf", 3) == 0) text += 3; /* NOLINT(clang-analyzer-core.NonNullParamChecker): what is read ends with a 0, be it nothing */
    text += strspn(text, " \t\r\n");
    return *text == '{' || *text == '[';
}

gboolean file_in_load_any(const char *path, FileIn *file, GError **error)
{
    FileIn loaded = {.path = path};
    if (!file_in_read(path, &loaded.text, &loaded.length, error)) return FALSE;
    tdsp_status status = TDSP_BAD_MAGIC;
    if (looks_like_json(loaded.text)) {
        loaded.kind = FILE_JSON;
    } else if ((status = tdsp_table_open(&loaded.table, loaded.text, loaded.length)) == TDSP_OK) {
        loaded.kind = FILE_TABLE;
    } else if (status == TDSP_BAD_MAGIC && (status = tdsp_matrix_open(&loaded.matrix, loaded.text, loaded.length)) == TDSP_OK) {
        loaded.kind = FILE_MATRIX;
    } else {
        file_in_clear(&loaded);
        if (status == TDSP_BAD_MAGIC) return cli_fail(error, CLI_INPUT, "%s: neither JSON nor a table", cli_file_name(path));
        return cli_fail_status(error, cli_file_name(path), status);
    }
    *file = loaded;
    return TRUE;
}

gboolean file_in_load(const char *path, FileIn *file, GError **error)
{
    FileIn loaded = {.path = path};
    if (!file_in_load_any(path, &loaded, error)) return FALSE;
    if (loaded.kind == FILE_MATRIX) {
        file_in_clear(&loaded);
        return cli_fail(error, CLI_INPUT, "%s: a matrix, which query, info and verify read", cli_file_name(path));
    }
    *file = loaded;
    return TRUE;
}

gboolean file_in_need_table(const FileIn *file, GError **error)
{
    if (file->kind == FILE_TABLE) return TRUE;
    return cli_fail(error, CLI_INPUT, "%s: not a table (make one of a scene with tdsp build)", cli_file_name(file->path));
}

gboolean file_in_load_table(const char *path, FileIn *file, GError **error)
{
    FileIn loaded = {.path = path};
    if (!file_in_load(path, &loaded, error)) return FALSE;
    if (!file_in_need_table(&loaded, error)) {
        file_in_clear(&loaded);
        return FALSE;
    }
    *file = loaded;
    return TRUE;
}

void file_in_clear(FileIn *file)
{
    g_clear_pointer(&file->text, g_free);
    file->length = 0;
}
