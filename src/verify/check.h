/* The check of one path, for callers that check many against one scene: the index is built once. */
#ifndef VERIFY_CHECK_H
#define VERIFY_CHECK_H

#include <stddef.h>

#include "tdsp/verify.h"
#include "verify/nearby.h"

/* As tdsp_verify_path(), with good arguments. Takes no memory. */
tdsp_verdict check_path(const tdsp_scene *scene, const nearby_index *index, const tdsp_leg *legs, size_t count,
                        double departure, double arrival);

#endif
