/* SPDX-License-Identifier: MIT */
/* What firmware links: the table reader alone. */
#include <string.h>

#include <tdsp/table.h>

int main(void) {
    unsigned char bytes[400];
    tdsp_table table;
    memset(bytes, 0, sizeof bytes);
    return tdsp_table_open(&table, bytes, sizeof bytes) == TDSP_BAD_MAGIC ? 0 : 1;
}
