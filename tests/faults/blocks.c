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

enum { FIRST_ROOM = 1 << 10, FRAMES = 1 << 9, STACK = 1 << 24, ROOTS = 64, HEAD = 16 };

static struct {
    block *table;
    size_t room;
    size_t count;
    uintptr_t not_least, not_most; /* no block begins outside; turned round, or LeakSanitizer would take them for pointers */
    int counts;
    int lost; /* a block could not be noted, or a saved one is gone */
    char busy;
} live;

/* Where pointers to blocks may be: what this thread has of its own in each module, for CMocka keeps its last message there, and what else is told. */
typedef struct range {
    uintptr_t from, end;
} range;
static range roots[ROOTS];
static size_t root_count;
static range cmocka;

/* What was reached and has not been looked into; and the frames of functions that the sanitizer keeps on its heap. */
typedef struct search {
    char *reached; /* by place in the table */
    size_t *waiting;
    size_t waits;
    size_t found;
    size_t all;
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
    *b = (block){.at = at, .size = size};
    if (at < ~live.not_least) live.not_least = ~at;
    if (at > ~live.not_most) live.not_most = ~at;
}

static void forget(uintptr_t at)
{
    size_t gap = place_of(at);
    if (live.table[gap].at == 0) return;
    live.lost |= live.table[gap].saved;
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

void blocks_root(uintptr_t from, uintptr_t end)
{
    if (root_count < ROOTS) roots[root_count++] = (range){from, end};
}

void blocks_cmocka(uintptr_t *from, uintptr_t *end)
{
    *from = cmocka.from;
    *end = cmocka.end;
}

static int note_own(struct dl_phdr_info *module, size_t size, void *unused)
{
    (void)size, (void)unused;
    for (int i = 0; i < module->dlpi_phnum; i++) {
        const uintptr_t from = (uintptr_t)module->dlpi_tls_data;
        if (module->dlpi_phdr[i].p_type != PT_TLS || from == 0) continue;
        blocks_root(from, from + module->dlpi_phdr[i].p_memsz);
        if (strstr(module->dlpi_name, "cmocka")) cmocka = (range){from, from + module->dlpi_phdr[i].p_memsz};
    }
    return 0;
}

void blocks_begin(void)
{
    root_count = 0;
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

block *blocks_next(block *after)
{
    block *b = after ? after + 1 : live.table;
    while (b < live.table + live.room && b->at == 0) b++;
    return b < live.table + live.room ? b : NULL;
}

block *blocks_find(const void *at)
{
    block *b = live.counts ? &live.table[place_of((uintptr_t)at)] : NULL;
    return b && b->at ? b : NULL;
}

int blocks_are_known(void)
{
    return live.counts && !live.lost;
}

static void reach_at(search *s, uintptr_t word)
{
    const size_t i = place_of(word);
    if (live.table[i].at == 0 || live.table[i].freed || s->reached[i]) return;
    s->reached[i] = 1;
    s->waiting[s->waits++] = i;
    s->found++;
}

/* A pointer to a block, or to what an allocator hands out that keeps a head of its own in front of it. */
static void reach(search *s, uintptr_t word)
{
    if (word < ~live.not_least || word > ~live.not_most + HEAD) return;
    reach_at(s, word);
    reach_at(s, word - HEAD);
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
    for (size_t i = 0; i < root_count; i++) look_into(s, roots[i].from, roots[i].end);
    while (s->waits > 0 && s->found < s->all) {
        const block *b = &live.table[s->waiting[--s->waits]];
        look_into(s, b->at, b->at + b->size);
    }
    return s->found == s->all;
}

/* Room for a search, kept for the next: the table only grows. NULL when there is none. */
static size_t *search_room(void)
{
    static size_t *room, places;
    if (places < live.room) {
        if (room) munmap(room, places * (sizeof *room + 1));
        room = pages(live.room * (sizeof *room + 1));
        places = room ? live.room : 0;
    }
    if (room) memset(room + places, 0, places);
    return room;
}

RAW int blocks_are_reached(const void *stack_top)
{
    jmp_buf registers; /* here, or saved above when this function was entered */
    const uintptr_t here = (uintptr_t)&registers, top = (uintptr_t)stack_top;
    if (!blocks_are_known() || here >= top || top - here > STACK) return 0;
    search s = {.all = 0};
    for (block *b = blocks_next(NULL); b; b = blocks_next(b)) s.all += !b->freed;
    if (s.all == 0) return 1;
    s.waiting = search_room();
    if (!s.waiting) return 0;
    s.reached = (char *)(s.waiting + live.room);
    if (__asan_get_current_fake_stack) s.fake_stack = __asan_get_current_fake_stack();
    memset(&registers, 0, sizeof registers); /* what dead frames left there is no pointer of anybody's */
    (void)setjmp(registers);
    return follow(&s, here & ~(sizeof here - 1), top);
}
