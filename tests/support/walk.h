/* SPDX-License-Identifier: MIT */
/* Every read that a table offers, and what must hold between the answers of one that was opened. */
#ifndef SUPPORT_WALK_H
#define SUPPORT_WALK_H

#include "tdsp/table.h"

/*
 * Ask everything at every row, between rows and far outside. Returns NULL, or a sentence that says which answer contradicts
 * another. The answers mean nothing when the bytes were changed after opening; no read may leave the bytes even then.
 */
const char *walk_table(const tdsp_table *table);

#endif
