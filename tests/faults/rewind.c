/* SPDX-License-Identifier: MIT */
/*
 * Pieces of memory are copied one behind the other, and back in the same order; by words, for memcpy() would be checked, and frames have red zones.
 * Copying back overwrites the frames of whoever does it, so it is done on a stack of its own.
 */
#include "faults/rewind.h"

#include <errno.h>
#include <pthread.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <ucontext.h>

#include "faults/blocks.h"
#include "faults/rewind_bounds.h"

#define RAW __attribute__((no_sanitize("address", "undefined"), noinline))

/* There only with AddressSanitizer, and with GLib. */
#pragma weak __asan_get_shadow_mapping
#pragma weak __asan_get_current_fake_stack
#pragma weak __asan_poison_memory_region
#pragma weak __asan_unpoison_memory_region
#pragma weak g_malloc
void __asan_get_shadow_mapping(size_t *scale, size_t *offset);
void *__asan_get_current_fake_stack(void);
void __asan_poison_memory_region(const volatile void *at, size_t size);
void __asan_unpoison_memory_region(const volatile void *at, size_t size);
void *g_malloc(size_t size);

void __real_free(void *block);
void __wrap_free(void *block);
void *__real_realloc(void *block, size_t size);
void *__wrap_realloc(void *block, size_t size);
FILE *__real_fopen(const char *name, const char *mode);
FILE *__wrap_fopen(const char *name, const char *mode);
int __real_pthread_create(pthread_t *thread, const pthread_attr_t *how, void *(*function)(void *), void *argument);
int __wrap_pthread_create(pthread_t *thread, const pthread_attr_t *how, void *(*function)(void *), void *argument);

enum { ROOM = 1 << 22, OTHER_STACK = 1 << 18 };

typedef struct piece {
    uintptr_t at;
    size_t words;
} piece;

static struct {
    char *room; /* pieces, each followed by its words */
    size_t used;
    int under_way;
    volatile int result;
    int error; /* errno */
    ucontext_t *back, *away; /* away from LeakSanitizer's eyes, like the rest */
    char *other_stack;
} saved;

static void *pages(size_t bytes)
{
    void *got = mmap(NULL, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (got == MAP_FAILED) abort();
    return got;
}

/* The empty statement keeps the compiler from calling memcpy(). */
RAW static void copy_words(uintptr_t *to, const uintptr_t *from, size_t words)
{
    for (size_t i = 0; i < words; i++) {
        to[i] = from[i];
        if (i % 8 == 7) __asm__ volatile("" ::: "memory");
    }
}

static int save_piece(uintptr_t from, uintptr_t end)
{
    const uintptr_t at = from & ~(sizeof at - 1);
    const piece p = {at, (end - at + sizeof at - 1) / sizeof at};
    const size_t size = sizeof p + p.words * sizeof at;
    if (size > ROOM - saved.used) return 0;
    memcpy(saved.room + saved.used, &p, sizeof p);
    copy_words((uintptr_t *)(saved.room + saved.used + sizeof p), (const uintptr_t *)at, p.words);
    saved.used += size;
    return 1;
}

static int save_frames(uintptr_t from, uintptr_t end)
{
    size_t scale, offset;
    __asan_get_shadow_mapping(&scale, &offset);
    return save_piece(from, end) && save_piece((from >> scale) + offset, (end >> scale) + offset);
}

static int save_blocks(void)
{
    for (block *b = blocks_next(NULL); b; b = blocks_next(b)) {
        b->saved = 1;
        if (!save_piece(b->at, b->at + b->size)) return 0;
    }
    return 1;
}

static int save_variables(void)
{
    uintptr_t from, end;
    blocks_cmocka(&from, &end);
    return save_piece((uintptr_t)rewind_data_begin, (uintptr_t)rewind_data_end) && save_piece((uintptr_t)rewind_bss_begin, (uintptr_t)rewind_bss_end) &&
           (from == end || save_piece(from, end));
}

static void forget_saved(void)
{
    for (block *b = blocks_next(NULL); b; b = blocks_next(b)) {
        if (b->freed) __asan_unpoison_memory_region((void *)b->at, b->size);
        b->saved = b->freed = 0;
    }
}

RAW static int save_all(const void *stack_top)
{
    saved.used = 0;
    saved.error = errno;
    saved.under_way = blocks_are_known() && save_blocks() && save_variables() && save_frames((uintptr_t)__builtin_frame_address(0), (uintptr_t)stack_top);
    if (!saved.under_way) forget_saved();
    return saved.under_way;
}

/* Runs on the other stack. */
RAW static void put_back(void)
{
    for (size_t at = 0; at < saved.used;) {
        const piece *p = (const piece *)(saved.room + at);
        copy_words((uintptr_t *)p->at, (const uintptr_t *)(p + 1), p->words);
        at += sizeof *p + p->words * sizeof(uintptr_t);
    }
    setcontext(saved.back);
}

static void prepare(void)
{
    if (saved.room) return;
    saved.room = pages(ROOM);
    saved.other_stack = pages(OTHER_STACK);
    saved.back = pages(sizeof *saved.back);
    saved.away = pages(sizeof *saved.away);
    getcontext(saved.away);
    saved.away->uc_stack.ss_sp = saved.other_stack;
    saved.away->uc_stack.ss_size = OTHER_STACK;
    saved.away->uc_link = NULL;
    makecontext(saved.away, put_back, 0);
}

int rewind_is_possible(void)
{
    if (!__asan_get_shadow_mapping || !__asan_get_current_fake_stack || g_malloc) return 0;
    if (__asan_get_current_fake_stack()) return 0;
    blocks_root((uintptr_t)rewind_data_begin, (uintptr_t)rewind_data_end);
    blocks_root((uintptr_t)rewind_bss_begin, (uintptr_t)rewind_bss_end);
    prepare();
    return 1;
}

int rewind_is_under_way(void)
{
    return saved.under_way;
}

RAW int rewind_save(const void *stack_top)
{
    saved.result = REWIND_SAVED;
    getcontext(saved.back);
    if (saved.result != REWIND_SAVED) {
        errno = saved.error;
        return saved.result;
    }
    return save_all(stack_top) ? REWIND_SAVED : REWIND_UNSURE;
}

/* Freeing moves blocks in the table, so they are picked before. */
static void free_new_blocks(void)
{
    uintptr_t *picked = (uintptr_t *)saved.other_stack;
    for (size_t count = 1; count > 0;) {
        count = 0;
        for (block *b = blocks_next(NULL); b && count < OTHER_STACK / sizeof *picked; b = blocks_next(b))
            if (!b->saved) picked[count++] = b->at;
        for (size_t i = 0; i < count; i++) __real_free((void *)picked[i]);
    }
}

void rewind_back(int result)
{
    saved.under_way = 0;
    free_new_blocks();
    if (!blocks_are_known()) abort(); /* one was freed by a library, for good */
    forget_saved();
    saved.result = result;
    setcontext(saved.away);
}

/* A block that must come back is kept, out of bounds. Freed twice is what the fork is to report. */
void __wrap_free(void *at)
{
    block *b = saved.under_way && at ? blocks_find(at) : NULL;
    if (!b || !b->saved) {
        if (!saved.under_way || b) __real_free(at);
        return;
    }
    if (b->freed) rewind_back(REWIND_UNSURE);
    b->freed = 1;
    __asan_poison_memory_region(at, b->size);
}

void *__wrap_realloc(void *at, size_t size)
{
    block *b = saved.under_way && at ? blocks_find(at) : NULL;
    if (!b || !b->saved) return __real_realloc(at, size);
    if (b->freed) rewind_back(REWIND_UNSURE);
    const size_t old_size = b->size;
    void *moved = malloc(size);
    if (!moved) return NULL;
    memcpy(moved, at, size < old_size ? size : old_size);
    __wrap_free(at);
    return moved;
}

/* What is not in memory is not put back. */
FILE *__wrap_fopen(const char *name, const char *mode)
{
    if (saved.under_way) rewind_back(REWIND_UNSURE);
    return __real_fopen(name, mode);
}

int __wrap_pthread_create(pthread_t *thread, const pthread_attr_t *how, void *(*function)(void *), void *argument)
{
    if (saved.under_way) rewind_back(REWIND_UNSURE);
    return __real_pthread_create(thread, how, function, argument);
}
