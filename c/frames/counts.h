/* Counts of polygons, rules and pixels by material, and their output. */
#ifndef FRAMES_COUNTS_H
#define FRAMES_COUNTS_H

#include "frames/frames.h"

struct scene_counts {
    uint32 materials;           /* 0: nothing is counted */
    struct draw_counts *frame, *totals;         /* of the last frame and of all; one a material */
};

/* Allocates a scene's counts and sets them to 0; returns 0 if memory is short. */
int32 counts_make(struct scene_counts *counts, uint32 materials);

/* Counts the frame that was drawn last. */
void counts_frame(struct scene_counts *counts, struct renderer *renderer, struct scene *scene,
                  int32 number);

/* Adds the last frame's counts to the line of output: " polygons n", pixels of each kind of
   span. */
void counts_add(const struct scene_counts *counts);

/* Prints a line for each material, of all frames: polygons, polygons to which each rule applied,
   pixels of each kind of span. */
void counts_print(const struct scene_counts *counts);

/* Returns a bit for each rule in a list of names separated by commas, or "all"; 0 if a name is
   unknown. */
uint32 rules_named(const char *names);

#endif
