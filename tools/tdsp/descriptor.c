/* SPDX-License-Identifier: MIT */
/* Whole reads and writes. */
#include "descriptor.h"

#include <errno.h>
#include <fcntl.h>
#include <unistd.h>

gssize descriptor_read(int file, void *block, gsize room)
{
    gssize got;
    do got = read(file, block, room);
    while (got < 0 && errno == EINTR);
    return got;
}

int descriptor_write_all(int file, const void *bytes, gsize length)
{
    const char *rest = bytes;
    while (length > 0) {
        gssize written = write(file, rest, length);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return written < 0 ? errno : EIO;
        rest += written;
        length -= (gsize)written;
    }
    return 0;
}

int descriptor_open(const char *path, int flags)
{
    int file;
    do file = open(path, flags);
    while (file < 0 && errno == EINTR);
    return file;
}

void descriptor_guard_standard(void)
{
    const int unlike[] = {O_WRONLY, O_RDONLY, O_RDONLY};
    for (int i = 0; i <= STDERR_FILENO; i++)
        if (fcntl(i, F_GETFD) < 0 && open("/dev/null", unlike[i]) != i) _exit(4);
}
