/* SPDX-License-Identifier: MIT */
#include "support/refusals.h"
#include "support/tight.h"

#include "support/cmocka_all.h"

size_t refuse_each(refusable ask, void *ctx, tdsp_status expected)
{
    for (size_t refuse = 1;; refuse += 1 + refuse / 128) {
        tight_heap heap = {.refuse = refuse};
        const tdsp_allocator memory = tight_allocator(&heap);
        const tdsp_status status = ask(&memory, ctx);
        assert_int_equal(heap.blocks, 0);
        assert_int_equal(heap.held, 0);
        if (heap.calls < refuse) {
            if (status != expected) fail_msg("nothing refused: %s", tdsp_status_name(status));
            return heap.calls;
        }
        if (status != TDSP_NO_MEMORY) fail_msg("call %d refused: %s", (int)refuse, tdsp_status_name(status));
    }
}
