/* SPDX-License-Identifier: MIT */
/* Memory: the C library's, with the blocks that are held counted. The module has one thread. */
#include <stdlib.h>

#include "page.h"

static uint32_t held;

static void *resize(void *ctx, void *block, size_t old_size, size_t new_size)
{
    (void)ctx;
    (void)old_size;
    if (new_size == 0) {
        page_release(block);
        return NULL;
    }
    return block ? realloc(block, new_size) : page_allocate(new_size);
}

const tdsp_allocator page_allocator = {NULL, resize};

PAGE_EXPORT(allocate) void *page_allocate(size_t size)
{
    void *block = malloc(size > 0 ? size : 1);
    if (block) held++;
    return block;
}

PAGE_EXPORT(release) void page_release(void *block)
{
    if (!block) return;
    held--;
    free(block);
}

/* Blocks that were allocated and not released: what is left when everything was freed is lost. */
PAGE_EXPORT(blocks_held) uint32_t page_blocks_held(void)
{
    return held;
}

tdsp_status page_numbers(size_t count, PageNumbers *out)
{
    double *at = count <= SIZE_MAX / sizeof *at ? page_allocate(count * sizeof *at) : NULL;
    if (!at) return TDSP_NO_MEMORY;
    *out = (PageNumbers){at, count};
    return TDSP_OK;
}
