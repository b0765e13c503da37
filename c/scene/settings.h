/* Steps of accuracy for the materials of a loaded scene, on two axes, each from cheap to exact.

   `accuracy` is edges, gradients and start together, `perspective` is enum perspective. A step sets
   the fields of every material with these exceptions:
   - perspective: set only if the scene's material has one. Glide's units take it as
     glide_subdivision: 16 pixels (none, every16), 8, else at each pixel;
   - gradients and start: not set if perspective is drawn, nor with MAPPER_LIT_GOURAUD,
     MAPPER_DITHERED or texture units;
   - gradients: not set if one of the material's polygons or faces has more than three corners;
   - edges: subpixel instead of integer and snapped with texture units;
   - tolerance: the scene's, but 0 with PERSPECTIVE_FINE;
   - where `only_cheaper` says so: nothing of a material that would cost more: perspective if the scene's is less exact,
     accuracy if the scene's edges are whole pixels or snapped.
   Fields that are not set have the scene's values. */
#ifndef SETTINGS_H
#define SETTINGS_H

#include "scene/scene.h"

enum settings_steps {
    SETTINGS_OWN = -1,          /* the scene's */
    ACCURACY_STEPS = 6
};

struct settings {
    int32 accuracy;             /* SETTINGS_OWN, or 0 to ACCURACY_STEPS - 1 */
    int32 perspective;          /* SETTINGS_OWN, or 0 to PERSPECTIVE_KINDS - 1 */
    int32 only_cheaper;         /* 1: steps are the most that a material may cost */
};

/* Sets all materials, and makes their tables (scene/tables.h) when a step first needs them. Returns
   0 if memory was short for a table: its lines are then divided exactly, which is within the same
   bounds, but slower, and pixels differ. */
int32 settings_set(struct scene *scene, const struct settings *settings);

/* Sets the steps of the exact picture: the best of both, and fine perspective of materials that have none too, where the
   mapper may and meshes alone have them. */
void settings_set_exact(struct scene *scene);

/* Return a step's name, such as "exact, plane, subtexel" or "every16"; for SETTINGS_OWN "settings
   of the scene" and "of the scene". */
const char *settings_accuracy(int32 step);
const char *settings_perspective(int32 step);

#endif
