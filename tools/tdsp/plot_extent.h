/* SPDX-License-Identifier: MIT */
/* Which part of the plane the picture of a scene shows. */
#ifndef PLOT_EXTENT_H
#define PLOT_EXTENT_H

#include "plot_frame.h"
#include "plot_scene.h"

/* A frame with its corner at (left, top) of the canvas and one scale in both directions, for the journeys and what is near them. */
Frame plot_extent_frame(const ScenePicture *picture, double left, double top);

#endif
