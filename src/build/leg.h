/* What a leg must be to be written: docs/format.md, section 5. */
#ifndef BUILD_LEG_H
#define BUILD_LEG_H

#include "tdsp/types.h"

/* Are its numbers finite and in their range, its times in order, and all members zero that its kind does not have? */
int leg_is_good(const tdsp_leg *leg);

#endif
