/* Materials with mip maps. */
#include "scene/load.h"

void scene_make_levels(struct scene *scene)
{
    const struct scene_material *from = scene->materials;
    struct material *to = scene->drawn;

    for (uint32 i = 0; i < scene->header->materials; i++, from++, to++) {
        if (!from->levels)
            continue;
        to->levels = (uint8)from->levels;
        to->level_at = (uint16)(from->level - i);
        to->draw = polygon_draw_mipmapped;
        for (uint32 level = from->levels; level; level--)
            scene->drawn[from->level + level - 1].number = (uint16)i;
    }
}
