/* SPDX-License-Identifier: MIT */
/*
 * Oracles that break one rule each: a sound toy of three pieces with jumps between, in which one member is spoilt.
 */
#ifndef SUPPORT_MUTANT_ORACLES_H
#define SUPPORT_MUTANT_ORACLES_H

#include "support/toy_oracles.h"
#include "tdsp/oracle_check.h"

typedef struct mutant {
    toy toy;
    tdsp_oracle sound; /* the toy's own */
    uint64_t calls;    /* of spoilt callbacks */
    double now;        /* of the clock */
    tdsp_leg legs[2];  /* of the last path */
    uint64_t bytes;
} mutant;

/* What a mutant breaks. */
typedef struct mutation {
    const char *name;
    tdsp_oracle_rule rule;
    tdsp_oracle_callback callback;
} mutation;

void mutant_make(mutant *m);

/* The sound oracle over it, with every callback. It borrows the mutant. */
tdsp_oracle mutant_sound(mutant *m);

/* Spoil that oracle in the way numbered `which`, from 0; returns 0 when there are no more. Its paths are bytes then, unless they are what is spoilt. */
int mutant_spoil(int which, tdsp_oracle *oracle, mutation *out);

/* A clock that stands still but for the mutant that is slow; its context is the mutant. */
double mutant_clock(void *ctx);

#endif
