/* Steps of accuracy for the materials of a loaded scene, on two axes, each from cheap to exact.

   `accuracy` is edges, gradients and start together, `perspective` is enum perspective. A step sets
   every material as far as it allows:
   - perspective: where the scene asks for one. Texture units of Glide's take it as glide_subdivision:
     16 pixels (none, every16), 8, else at each pixel;
   - gradients and start: not where a perspective is drawn, nor with MAPPER_LIT_GOURAUD,
     MAPPER_DITHERED or texture units;
   - gradients: not where one of the material's polygons or faces has more than three corners;
   - edges: those of texture units are subpixel where the step says integer;
   - tolerance: as the scene says, but 0 with PERSPECTIVE_FINE.
   What is not set is as the scene says. */
#ifndef SETTINGS_H
#define SETTINGS_H

#include "scene/scene.h"

enum settings_steps {
    SETTINGS_OWN = -1,          /* as the scene says */
    ACCURACY_STEPS = 5
};

struct settings {
    int32 accuracy;             /* SETTINGS_OWN, or 0 to ACCURACY_STEPS - 1 */
    int32 perspective;          /* SETTINGS_OWN, or 0 to PERSPECTIVE_KINDS - 1 */
};

/* Sets all materials, and makes the tables they draw by (scene/tables.h) when a step first needs
   them. 0: memory was short for one, and those lines are divided exactly instead: within the same
   bounds, but slower and not the same pixels. */
int32 settings_set(struct scene *scene, const struct settings *settings);

/* A step's name, as "exact, plane, subtexel" or "every16"; "settings of the scene", "of the scene". */
const char *settings_accuracy(int32 step);
const char *settings_perspective(int32 step);

#endif
