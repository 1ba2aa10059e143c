/* SPDX-License-Identifier: MIT */
#include "support/brink.h"

#include "support/cmocka_all.h"

#include <stdlib.h>
#include <sys/mman.h>
#include <unistd.h>

brink brink_of(const unsigned char *bytes, size_t length)
{
    brink b = {.page = (size_t)sysconf(_SC_PAGESIZE)};
    assert_true(length <= b.page);
    assert_int_equal(posix_memalign(&b.pages, b.page, 2 * b.page), 0);
    b.bytes = (unsigned char *)b.pages + b.page - length;
    memcpy(b.bytes, bytes, length);
    assert_int_equal(mprotect((unsigned char *)b.pages + b.page, b.page, PROT_NONE), 0);
    return b;
}

void brink_free(brink b)
{
    assert_int_equal(mprotect((unsigned char *)b.pages + b.page, b.page, PROT_READ | PROT_WRITE), 0);
    free(b.pages);
}
