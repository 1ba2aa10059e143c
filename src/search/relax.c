/* SPDX-License-Identifier: MIT */
/* Relaxation: the argument is in relax.h. */
#include "search/relax.h"

#include <string.h>

/* When a path has met more than this share of the discs, or has been mended this often, the rest is searched at once. */
#define LARGE_SHARE 8u
#define ROUNDS 100

/* How much a relaxation may cost, in chunks of rides followed. */
typedef struct relax_patience {
    uint64_t search; /* one search gives up after so many, */
    uint64_t round;  /* no other round follows when the searches of one took so many each, */
    uint64_t all;    /* or those of all rounds */
} relax_patience;

/* At first, and when the scouts are lost: then the search among all discs may cost a hundred times as much as any round. */
static const relax_patience BRIEF = {128, 96, 512}, LONG = {512, 256, 1024};

tdsp_status relax_create(relaxation *self, const tdsp_scene *scene)
{
    uint32_t count = scene->all.count;
    memset(self, 0, sizeof *self);
    self->scene = scene;
    if (count <= ENGINE_SMALL) return TDSP_OK;
    self->is_member = memory_array(&scene->allocator, count, 1);
    self->members = memory_array(&scene->allocator, count, sizeof *self->members);
    if (!self->is_member || !self->members) return TDSP_NO_MEMORY;
    memset(self->is_member, 0, count);
    return TDSP_OK;
}

void relax_free(relaxation *self)
{
    if (!self->scene) return;
    const tdsp_allocator *memory = &self->scene->allocator;
    uint32_t count = self->scene->all.count;
    set_free(&self->working, memory);
    memory_free(memory, self->is_member, count);
    memory_free(memory, self->members, count * sizeof *self->members);
}

uint64_t relax_bytes(const relaxation *self)
{
    uint64_t lists = self->is_member ? self->scene->all.count * (1 + sizeof *self->members) : 0;
    return lists + set_bytes(&self->working);
}

static int relax_add(void *ctx, uint32_t disc)
{
    relaxation *self = ctx;
    if (!self->is_member[disc]) {
        self->is_member[disc] = 1;
        self->members[self->member_count++] = disc;
    }
    return 1;
}

static void relax_clear(relaxation *self)
{
    while (self->member_count > 0) self->is_member[self->members[--self->member_count]] = 0;
}

static uint32_t working_origin(const disc_engine *engine, uint32_t disc)
{
    return disc < ENGINE_GOAL ? engine->set->origin[disc] : INDEX_NONE;
}

/* Add all discs that the path found runs into; returns how many were new. */
static uint32_t relax_mend(relaxation *self, const disc_engine *engine)
{
    const disc_set *all = &self->scene->all;
    uint32_t before = self->member_count, at = engine->arrived;
    index_view view = {&all->index, engine->question.direction == ENGINE_FORWARD ? all->forward : all->reverse, engine->view.sign};
    while (at != ENGINE_NONE) {
        const engine_leg *leg = &engine->legs[at];
        geom_line line = engine_leg_motion(engine, leg);
        uint32_t from = working_origin(engine, engine_leg_origin(engine, leg));
        index_line_visit(&view, &line, from, working_origin(engine, leg->disc), relax_add, self);
        if (leg->ride == ENGINE_NONE) break;
        const engine_ride *ride = &engine->rides[leg->ride];
        geom_ride motion = engine_ride_motion(engine, ride, ride->start, leg->leave);
        if (motion.end > motion.start) index_ride_visit(&view, &motion, from, relax_add, self);
        at = ride->leg;
    }
    return self->member_count - before;
}

/* Ask among more and more discs. TDSP_NO_ANSWER when that gets nowhere. */
static tdsp_status relax_rounds(relaxation *self, disc_engine *engine, const relax_patience *patience, relax_question ask, void *ctx)
{
    const disc_set *all = &self->scene->all;
    uint64_t before = engine->chunks_followed;
    engine->part_patience = patience->search;
    for (int round = 0; round < ROUNDS && self->member_count * LARGE_SHARE < all->count; ++round) {
        uint64_t round_before = engine->chunks_followed, runs = engine->runs;
        tdsp_status status = set_choose(&self->working, &self->scene->allocator, all, self->members, self->member_count);
        ++self->rounds;
        if (status == TDSP_OK) status = ask(ctx, &self->working);
        if (status != TDSP_OK || engine->arrived == ENGINE_NONE || relax_mend(self, engine) == 0) return status;
        runs = engine->runs - runs;
        if (engine->chunks_followed - round_before > patience->round * runs || engine->chunks_followed - before > patience->all * runs) break;
    }
    return TDSP_NO_ANSWER;
}

tdsp_status relax_run(relaxation *self, disc_engine *engine, relax_question ask, void *ctx)
{
    const disc_set *all = &self->scene->all;
    self->stage = RELAX_LAST;
    if (all->count <= ENGINE_SMALL) return ask(ctx, all);
    relax_clear(self);
    tdsp_status status = relax_rounds(self, engine, &BRIEF, ask, ctx);
    if (status != TDSP_NO_ANSWER) return status;
    self->stage = RELAX_SCOUTED;
    status = ask(ctx, all);
    self->stage = RELAX_LAST;
    if (status == TDSP_NO_ANSWER) status = relax_rounds(self, engine, &LONG, ask, ctx);
    return status == TDSP_NO_ANSWER ? ask(ctx, all) : status;
}

uint32_t relax_given(const relaxation *self, const disc_set *set, uint32_t disc)
{
    const disc_set *all = &self->scene->all;
    return set == all ? all->origin[disc] : all->origin[set->origin[disc]];
}
