/* SPDX-License-Identifier: MIT */
/*
 * The library's requests for memory, cut open: the linker's --wrap puts the functions of memory.c before those of src/scene/allocator.h, through
 * which everything is allocated.
 */
#ifndef FAULTS_MEMORY_H
#define FAULTS_MEMORY_H

/* Is this request refused? Asked once for each that would allocate; the program that links memory.c decides. */
int memory_must_fail(void);

#endif
