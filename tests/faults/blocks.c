/* SPDX-License-Identifier: MIT */
/* A table of live blocks by their address, at most half full, searched from the hash on; removing moves what follows back, so that no gap is left. */
#define _GNU_SOURCE /* dl_iterate_phdr */
#include "faults/blocks.h"

#include <link.h>
#include <setjmp.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>

/* There only in programs with AddressSanitizer. */
#pragma weak __asan_get_current_fake_stack
#pragma weak __asan_addr_is_in_fake_stack
void *__asan_get_current_fake_stack(void);
void *__asan_addr_is_in_fake_stack(void *fake_stack, void *address, void **begin, void **end);
void __sanitizer_malloc_hook(const volatile void *block, size_t size);
void __sanitizer_free_hook(const volatile void *block);

#define RAW __attribute__((no_sanitize("address", "undefined"), noinline))

enum { FIRST_ROOM = 1 << 10, FRAMES = 1 << 9, STACK = 1 << 24, MODULES = 64 };

typedef struct block {
    uintptr_t at; /* 0: an empty place */
    size_t size;
} block;

static struct {
    block *table;
    size_t room;
    size_t count;
    uintptr_t not_least, not_most; /* no block begins outside; turned round, or LeakSanitizer would take them for pointers */
    int counts;
    int lost; /* a block could not be noted */
    char busy;
} live;

/* What this thread has of its own in each module: CMocka keeps its last message there. */
static struct {
    uintptr_t from, end;
} own[MODULES];
static size_t owned;

/* What was reached and has not been looked into; and the frames of functions that the sanitizer keeps on its heap. */
typedef struct search {
    char *reached; /* by place in the table */
    size_t *waiting;
    size_t waits;
    size_t found;
    void *fake_stack;
    uintptr_t frames[FRAMES];
    size_t frames_met;
} search;

static void lock(void)
{
    while (__atomic_test_and_set(&live.busy, __ATOMIC_ACQUIRE)) continue;
}

static void unlock(void)
{
    __atomic_clear(&live.busy, __ATOMIC_RELEASE);
}

/* Not by malloc, whose hooks these are. */
static void *pages(size_t bytes)
{
    void *got = mmap(NULL, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    return got == MAP_FAILED ? NULL : got;
}

static size_t home_of(uintptr_t at)
{
    return (size_t)((uint64_t)at * 11400714819323198485u >> 20) & (live.room - 1);
}

/* Where `at` stands, or the empty place where it would. */
static size_t place_of(uintptr_t at)
{
    size_t i = home_of(at);
    while (live.table[i].at != 0 && live.table[i].at != at) i = (i + 1) & (live.room - 1);
    return i;
}

static int grow(void)
{
    const size_t old_room = live.room;
    block *old = live.table, *table = pages(2 * old_room * sizeof *table);
    if (!table) return 0;
    live.table = table;
    live.room = 2 * old_room;
    for (size_t i = 0; i < old_room; i++)
        if (old[i].at) live.table[place_of(old[i].at)] = old[i];
    munmap(old, old_room * sizeof *old);
    return 1;
}

static void note(uintptr_t at, size_t size)
{
    if (2 * live.count >= live.room && !grow()) {
        live.lost = 1;
        return;
    }
    block *b = &live.table[place_of(at)];
    live.count += b->at == 0;
    *b = (block){at, size};
    if (at < ~live.not_least) live.not_least = ~at;
    if (at > ~live.not_most) live.not_most = ~at;
}

static void forget(uintptr_t at)
{
    size_t gap = place_of(at);
    if (live.table[gap].at == 0) return;
    live.count--;
    for (size_t i = (gap + 1) & (live.room - 1); live.table[i].at != 0; i = (i + 1) & (live.room - 1)) {
        const size_t from_home = (i - home_of(live.table[i].at)) & (live.room - 1);
        if (from_home < ((i - gap) & (live.room - 1))) continue;
        live.table[gap] = live.table[i];
        gap = i;
    }
    live.table[gap].at = 0;
}

void __sanitizer_malloc_hook(const volatile void *at, size_t size)
{
    if (!live.counts || !at) return;
    lock();
    note((uintptr_t)at, size);
    unlock();
}

void __sanitizer_free_hook(const volatile void *at)
{
    if (!live.counts || !at) return;
    lock();
    forget((uintptr_t)at);
    unlock();
}

static int note_own(struct dl_phdr_info *module, size_t size, void *unused)
{
    (void)size, (void)unused;
    for (int i = 0; i < module->dlpi_phnum && owned < MODULES; i++) {
        if (module->dlpi_phdr[i].p_type != PT_TLS || !module->dlpi_tls_data) continue;
        own[owned].from = (uintptr_t)module->dlpi_tls_data;
        own[owned].end = own[owned].from + module->dlpi_phdr[i].p_memsz;
        owned++;
    }
    return 0;
}

void blocks_begin(void)
{
    owned = 0;
    dl_iterate_phdr(note_own, NULL);
    if (live.table) munmap(live.table, live.room * sizeof *live.table);
    live.table = pages(FIRST_ROOM * sizeof *live.table);
    if (!live.table) abort();
    live.room = FIRST_ROOM;
    live.count = 0;
    live.not_least = ~UINTPTR_MAX;
    live.not_most = UINTPTR_MAX;
    live.lost = 0;
    live.counts = 1;
}

static void reach(search *s, uintptr_t word)
{
    if (word < ~live.not_least || word > ~live.not_most) return;
    const size_t i = place_of(word);
    if (live.table[i].at == 0 || s->reached[i]) return;
    s->reached[i] = 1;
    s->waiting[s->waits++] = i;
    s->found++;
}

RAW static void look_into(search *s, uintptr_t from, uintptr_t end)
{
    for (uintptr_t at = (from + sizeof at - 1) & ~(sizeof at - 1); at + sizeof at <= end; at += sizeof at) {
        uintptr_t word = *(const uintptr_t *)at;
        reach(s, word);
    }
}

/* Frames that live on the sanitizer's heap are known from the pointers to them. A frame beyond those that can be noted is not looked into. */
static void look_into_frame(search *s, uintptr_t word)
{
    void *begin, *end;
    if (!s->fake_stack || !__asan_addr_is_in_fake_stack(s->fake_stack, (void *)word, &begin, &end)) return;
    for (size_t i = 0; i < s->frames_met; i++)
        if (s->frames[i] == (uintptr_t)begin) return;
    if (s->frames_met == FRAMES) return;
    s->frames[s->frames_met++] = (uintptr_t)begin;
    look_into(s, (uintptr_t)begin, (uintptr_t)end);
}

RAW static void look_into_stack(search *s, uintptr_t from, uintptr_t end)
{
    look_into(s, from, end);
    for (uintptr_t at = from; at + sizeof at <= end; at += sizeof at) look_into_frame(s, *(const uintptr_t *)at);
}

static int follow(search *s, uintptr_t from, uintptr_t end)
{
    look_into_stack(s, from, end);
    for (size_t i = 0; i < owned; i++) look_into(s, own[i].from, own[i].end);
    while (s->waits > 0 && s->found < live.count) {
        const block *b = &live.table[s->waiting[--s->waits]];
        look_into(s, b->at, b->at + b->size);
    }
    return s->found == live.count;
}

RAW int blocks_are_reached(const void *stack_top)
{
    jmp_buf registers; /* here, or saved above when this function was entered */
    const uintptr_t here = (uintptr_t)&registers, top = (uintptr_t)stack_top;
    live.counts = 0;
    if (live.lost || here >= top || top - here > STACK) return 0;
    if (live.count == 0) return 1;
    const size_t bytes = live.room * (sizeof(size_t) + 1);
    size_t *room = pages(bytes);
    if (!room) return 0;
    search s = {.reached = (char *)(room + live.room), .waiting = room};
    if (__asan_get_current_fake_stack) s.fake_stack = __asan_get_current_fake_stack();
    (void)setjmp(registers);
    const int all = follow(&s, here & ~(sizeof here - 1), top);
    munmap(room, bytes);
    return all;
}
