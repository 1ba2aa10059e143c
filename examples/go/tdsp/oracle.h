/* SPDX-License-Identifier: MIT */
/* A Go oracle seen from C: a number instead of a pointer, which C may keep where Go's memory moves. */
#ifndef ORACLE_H
#define ORACLE_H

#include "tdsp/build.h"

/* An oracle whose callbacks find their Go value by `handle`. */
void go_oracle_init(tdsp_oracle *oracle, uintptr_t handle);

#endif
