/* SPDX-License-Identifier: MIT */
#include "support/tight.h"

#include <stdlib.h>

#include "support/cmocka_all.h"

/* In front of each block: its size, in as many bytes as keep the block aligned for anything. */
enum { HEAD = 16 };

static size_t *head_of(void *block) { return block ? (size_t *)((char *)block - HEAD) : NULL; }

void *tight_resize(void *heap, void *block, size_t old_size, size_t new_size)
{
    tight_heap *h = heap;
    size_t *head = head_of(block);
    assert_int_equal(head ? *head : 0, old_size);
    if (new_size == 0) {
        h->blocks -= block ? 1 : 0;
        h->held -= old_size;
        free(head);
        return NULL;
    }
    ++h->calls;
    if (h->refuse && (h->calls == h->refuse || (h->and_after && h->calls > h->refuse))) return NULL;
    head = realloc(head, HEAD + new_size);
    assert_non_null(head);
    *head = new_size;
    h->blocks += block ? 0 : 1;
    h->held += new_size - old_size;
    return (char *)head + HEAD;
}

tdsp_allocator tight_allocator(tight_heap *heap) { return (tdsp_allocator){heap, tight_resize}; }
