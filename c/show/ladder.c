#include "show/ladder.h"

#include "polygon/kind.h"
#include "scene/coarse.h"
#include "system/text.h"

enum { SNAPPED = 4 };           /* the step of accuracy */

/* Returns 1 if a material or a Glide unit costs less with perspective each 16 pixels. */
static int32 has_perspective(const struct scene *scene)
{
    const struct scene_header *header = scene->header;

    for (uint32 i = 0; i < header->materials; i++)
        if (scene->materials[i].perspective > PERSPECTIVE_EVERY16)
            return 1;
    for (uint32 i = 0; i < header->glide_units; i++)
        if (scene->glide_units[i].subdivision < 16)
            return 1;
    return 0;
}

/* Returns 1 if snapped edges are cheaper for a material: it has no perspective, which needs exact ones, as does what is drawn
   each pixel once, and is not of a texture unit, which has its own. */
static int32 has_edges(const struct scene *scene)
{
    const struct scene_header *header = scene->header;

    for (uint32 i = header->once ? header->materials : 0; i < header->materials; i++) {
        const struct scene_material *m = &scene->materials[i];

        if (!m->perspective && m->edges != EDGES_INTEGER && m->edges != EDGES_SNAPPED
            && !(mappers[m->mapper].is & MAPPER_UNIT))
            return 1;
    }
    return 0;
}

static void add(struct ladder *ladder, int32 accuracy, int32 perspective, int32 is_coarse)
{
    struct rung *rung = &ladder->rung[ladder->rungs++];

    rung->settings.accuracy = accuracy;
    rung->settings.perspective = perspective;
    rung->settings.only_cheaper = 1;
    rung->is_coarse = is_coarse;
}

void ladder_make(struct ladder *ladder, const struct scene *scene)
{
    const int32 has_edge = has_edges(scene), has_coarse = scene_has_coarse(scene);
    const int32 far = has_perspective(scene) ? PERSPECTIVE_EVERY16 : SETTINGS_OWN;

    ladder->rungs = 0;
    for (int32 is_coarse = 0; is_coarse <= has_coarse; is_coarse++) {
        add(ladder, SETTINGS_OWN, SETTINGS_OWN, is_coarse);
        if (far != SETTINGS_OWN)
            add(ladder, SETTINGS_OWN, far, is_coarse);
        if (has_edge)
            add(ladder, SNAPPED, far, is_coarse);
    }
}

void ladder_describe(const struct rung *rung)
{
    text_add(rung->is_coarse ? "pixels of 2x2" : "the scene's pixels");
    if (rung->settings.accuracy != SETTINGS_OWN)
        text_add(", snapped edges");
    if (rung->settings.perspective != SETTINGS_OWN)
        text_add(", every16 at most");
}
