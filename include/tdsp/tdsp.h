/* SPDX-License-Identifier: MIT */
/* libtdsp: time-dependent shortest paths among growing discs. Everything at once. */
#ifndef TDSP_TDSP_H
#define TDSP_TDSP_H

#include "tdsp/build.h"
#include "tdsp/growth.h"
#include "tdsp/margin.h"
#include "tdsp/matrix.h"
#include "tdsp/oracle.h"
#include "tdsp/oracle_check.h"
#include "tdsp/path.h"
#include "tdsp/scene.h"
#include "tdsp/search.h"
#include "tdsp/shape.h"
#include "tdsp/solver.h"
#include "tdsp/status.h"
#include "tdsp/table.h"
#include "tdsp/types.h"
#include "tdsp/verify.h"

#endif
