/* SPDX-License-Identifier: MIT */
/*
 * Blocks of the heap that nothing points to any more, looked for where they must be found if all is well.
 *
 * LeakSanitizer stops the process and searches all of its memory, which takes longer than the fork of a victim and what the victim does. Here the live
 * blocks are known from the sanitizer's hooks, and are followed from the stack, the registers and a few variables: a part of what LeakSanitizer looks at.
 * So blocks that are all reached here are no leaks there, and only when one is not is LeakSanitizer asked.
 */
#ifndef FAULTS_BLOCKS_H
#define FAULTS_BLOCKS_H

#include <stddef.h>
#include <stdint.h>

typedef struct block {
    uintptr_t at; /* 0: an empty place of the table */
    size_t size;
    int saved; /* it was there when the process was saved (rewind.h) ... */
    int freed; /* ... and has been freed since, but for its memory */
} block;

/* From here on blocks are counted; those that there are already are nobody's leak. One thread runs. */
void blocks_begin(void);

/* The blocks in the order of the table, from NULL to NULL, while none comes or goes. */
block *blocks_next(block *after);
block *blocks_find(const void *at);

/* Are all of them known, and has no saved one been freed with its memory? */
int blocks_are_known(void);

/* More memory that may point to blocks. */
void blocks_root(uintptr_t from, uintptr_t end);

/* What CMocka keeps for the thread. */
void blocks_cmocka(uintptr_t *from, uintptr_t *end);

/* Is every block since then that was not freed reached from frames below `stack_top`? The answer 0 may also mean that it cannot be said. */
int blocks_are_reached(const void *stack_top);

#endif
