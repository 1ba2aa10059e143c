/* SPDX-License-Identifier: MIT */
/*
 * Blocks of the heap that nothing points to any more, looked for where they must be found if all is well.
 *
 * LeakSanitizer stops the process and searches all of its memory, which takes longer than the fork of a victim and what the victim does. Here the live
 * blocks are known from the sanitizer's hooks, and are followed from the stack and the registers alone: a part of what LeakSanitizer looks at.
 * So blocks that are all reached here are no leaks there, and only when one is not is LeakSanitizer asked.
 */
#ifndef FAULTS_BLOCKS_H
#define FAULTS_BLOCKS_H

/* From here on blocks are counted; those that there are already are nobody's leak. One thread runs. */
void blocks_begin(void);

/* Is every block since then that was not freed reached from frames below `stack_top`? The answer 0 may also mean that it cannot be said. */
int blocks_are_reached(const void *stack_top);

#endif
