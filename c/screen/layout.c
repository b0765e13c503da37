#include "screen/layout.h"

#include "limits.h"
#include "screen/planar.h"

/* Returns 1 if the frame fits half the screen's width and height: it is shown twice as large. */
static int32 is_half(int32 width, int32 height)
{
    return width <= SCREEN_WIDTH / 2 && height <= SCREEN_HEIGHT / 2;
}

const char *screen_layout_find(struct screen_layout *layout, int32 width, int32 height,
                               uint32 format)
{
    int32 rows;

    if (width < 8 || width > SCREEN_WIDTH || width & 7)
        return "the frame's width is not 8 to 320 in steps of 8";
    if (height < 1 || height > SCREEN_HEIGHT)
        return "the frame's height is not 1 to 256";
    layout->width = width;
    layout->height = height;
    layout->ham = format != PIXEL_CHUNKY;
    layout->dots = layout->ham ? HAM8_DOTS : 1;
    layout->twice = layout->ham && is_half(width, height);
    layout->shift = !layout->ham ? 0 : layout->twice ? 1 : 2;
    layout->shown_width = width * layout->dots >> layout->shift;
    layout->shown_height = height << layout->twice;
    layout->left = (SCREEN_WIDTH - layout->shown_width) >> 1;
    layout->top = (SCREEN_HEIGHT - layout->shown_height) >> 1;
    rows = (width * layout->dots + FETCH_DOTS - 1) / FETCH_DOTS;
    layout->row_bytes = rows * (FETCH_DOTS / 8);
    layout->plane_bytes = layout->row_bytes * height;
    return 0;
}
