/* SPDX-License-Identifier: MIT */
/* Scenes of the soak as scene files. */
#ifndef SOAK_SCENE_JSON_H
#define SOAK_SCENE_JSON_H

#include <stdio.h>

#include "soak/scene.h"

/* Write a scene file. A law by callback, which a file cannot hold, is described in its place. */
void soak_write(FILE *out, const soak_scene *scene, const char *name);

/* Read one again. 0 where it cannot be read, with a message on standard error. */
int soak_read(const char *path, soak_scene *scene);

#endif
