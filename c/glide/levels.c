#include "glide/pixel.h"

/* Returns how many texels a level has; sets the sides of *to if to is not null. */
static uint32 measure(const struct glide_modes *modes, uint32 level, struct glide_level *to)
{
    const uint32 longer = 256u >> level, other = longer >> modes->aspect;
    const uint32 shorter = other ? other : 1;

    if (to) {
        to->columns = modes->wide ? longer : shorter;
        to->rows = modes->wide ? shorter : longer;
    }
    return longer * shorter;
}

int32 glide_holds(const struct glide_modes *modes, uint32 level)
{
    return !modes->split || (level & 1) == modes->odd;
}

uint32 glide_level_offset(const struct glide_modes *modes, uint32 level)
{
    uint32 offset = 0;

    for (uint32 n = 0; n < level; n++) {
        const uint32 texels = measure(modes, n, 0);

        if (glide_holds(modes, n))
            offset += texels > GLIDE_LEVEL_TEXELS ? texels : GLIDE_LEVEL_TEXELS;
    }
    return modes->format < GLIDE_ARGB8332 ? offset : offset << 1;
}

void glide_find_level(const struct glide_modes *modes, uint32 level, struct glide_level *to)
{
    to->address = modes->base + glide_level_offset(modes, level);
    measure(modes, level, to);
}
