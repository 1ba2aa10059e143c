/* SPDX-License-Identifier: MIT */
/* The page that shows scenes and tables in a browser: one file of HTML, into which a scene or a table is put. */
#ifndef PAGE_H
#define PAGE_H

#include <glib.h>

#include "file_in.h"

typedef struct Page {
    char *path; /* where it was found */
    char *text;
    gsize length;
} Page;

/* Find the page and read it. A system error that says where it was looked for when there is none. */
gboolean page_load(Page *page, GError **error);
void page_clear(Page *page);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(Page, page_clear)

/* The page with what `file` holds, a scene or a table, inside. NULL where it is no such page. */
GString *page_with(const Page *page, const FileIn *file, GError **error);

/* Where a page of this file goes when nobody says where: a file in the user's cache, the same one each time for the same input; its folder is made. */
char *page_output(const char *path, GError **error);

#endif
