/* SPDX-License-Identifier: MIT */
/* What all formats need to know of a point on a path. */
#include "convert.h"

const char *convert_instant(char buffer[INSTANT_ROOM], const ConvertPath *path, const PathPoint *point)
{
    return instant_format(buffer, &path->epoch, point->time);
}

const tdsp_leg *convert_leg(const ConvertPath *path, const PathPoint *point)
{
    return &g_array_index(path->path->legs, tdsp_leg, point->leg);
}
