/* Frames of a scene by pixels twice as wide and twice as high as its own, and back.

   What moves is in the camera's space, and the frame's middle and the size of what is at a depth (scene_header.guard)
   alone say where that is in the frame: both are halved, exactly. So these frames are, byte for byte, those of the same
   scene compiled with such pixels. Views of 16 bits are of the scene's own pixels: coarse frames go without. */
#ifndef COARSE_H
#define COARSE_H

#include "scene/scene.h"

/* Returns 1 if a scene has such frames: it is of meshes alone, without texture units (whose lists are in pixels), its
   pixels are 1x1, and half of its frame can be shown. */
int32 scene_has_coarse(const struct scene *scene);

/* Sets the header's width, height, pixels and guard to coarse frames, or back, if they are not so yet. Memory that
   scene_make took for frames serves both. */
void scene_set_coarse(struct scene *scene, int32 is_coarse);

#endif
