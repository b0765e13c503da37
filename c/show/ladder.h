/* What `show` gives up, rung by rung, to hold a rate of frames: perspective each 16 pixels at most, then snapped edges,
   then pixels twice as wide and high (scene/coarse.h) with the scene's settings, and the same two again. Rungs that change
   nothing of a scene are left out. Perspective is not given up: texels of near walls are hundreds off without it. */
#ifndef LADDER_H
#define LADDER_H

#include "scene/settings.h"
#include "show/governor.h"

enum ladder_constants {
    HELD_FIELDS_MAX = 10        /* fields a frame: the governor's products fit 32 bits */
};

struct rung {
    struct settings settings;   /* that material settings are at most */
    int32 is_coarse;
};

struct ladder {
    int32 rungs;
    struct rung rung[GOVERNOR_STEPS];
};

void ladder_make(struct ladder *ladder, const struct scene *scene);

/* Adds to the line of text what a rung has. */
void ladder_describe(const struct rung *rung);

#endif
