/* SPDX-License-Identifier: MIT */
/*
 * Victims without a fork: what a test can change is saved before an allocation fails and put back when it has been seen what came of it, which takes
 * some microseconds where a fork under AddressSanitizer takes two milliseconds.
 *
 * Saved are the frames of the test, the blocks of the heap, and the variables of the test, its support and the library, which are linked between
 * rewind_begin.c and rewind_end.c. What the victim frees is only poisoned, so that the sanitizer still sees it being used, and whatever it allocates is
 * freed when it is over. What cannot be put back, and whatever looks wrong, is left to a fork: only a victim with nothing to object to ends here.
 */
#ifndef FAULTS_REWIND_H
#define FAULTS_REWIND_H

/* Can this program be rewound? Not where GLib keeps blocks of its own, nor where the sanitizer has frames on its heap. */
int rewind_is_possible(void);

/* Where a victim is. */
enum { REWIND_SAVED, REWIND_UNSURE, REWIND_DONE };

/*
 * REWIND_SAVED when all is saved, and then, from the same call, what rewind_back() was given. REWIND_UNSURE also when there is too much to be saved.
 * The test's frames are below `stack_top`.
 */
int rewind_save(const void *stack_top);

/* Is something saved, to which the process can go back? */
int rewind_is_under_way(void);

/* `result` is more than REWIND_SAVED, and never less than what has been found out on the way. */
void rewind_back(int result);

#endif
