/* What was executed, material by material, and its lines of output. */
#ifndef SCENE_COUNTS_H
#define SCENE_COUNTS_H

#include "scene/scene.h"

struct scene_counts {
    uint32 materials;           /* 0: nothing is counted */
    struct draw_counts *frame, *totals;         /* of the last frame, of all; one a material */
};

/* Memory for a scene's counts, none of them above 0; 0 where it is short. */
int32 counts_make(struct scene_counts *counts, uint32 materials);

/* Counts the frame that was drawn last. */
void counts_frame(struct scene_counts *counts, struct renderer *renderer, struct scene *scene,
                  int32 number);

/* Adds the last frame to a line: " polygons n", pixels of each kind of span. */
void counts_add(const struct scene_counts *counts);

/* Prints a line a material: its polygons, those each rule applied to, pixels of each kind of
   span, of all frames. */
void counts_print(const struct scene_counts *counts);

/* The rules of a list of names by commas, or "all", a bit each; 0: one is unknown. */
uint32 rules_named(const char *names);

#endif
