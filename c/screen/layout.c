#include "screen/layout.h"

#include "limits.h"
#include "screen/planar.h"

/* Returns 1 if the frame fits half the screen's width and height: it is shown twice as large. */
static int32 is_half(int32 width, int32 height)
{
    return width <= SCREEN_WIDTH / 2 && height <= SCREEN_HEIGHT / 2;
}

const char *screen_layout_find(struct screen_layout *layout, const struct screen_form *form)
{
    const uint32 ham = form->format != PIXEL_CHUNKY;
    const int32 wide = form->width * form->pixel_width, high = form->height * form->pixel_height;
    const int32 larger = ham && form->pixel_width == 1 && form->pixel_height == 1 && is_half(wide, high);
    int32 fetches;

    if (wide < 8 || wide > SCREEN_WIDTH || form->width & 7)
        return "the picture's width is not 8 to 320 in steps of 8 pixels";
    if (high < 1 || high > SCREEN_HEIGHT)
        return "the picture's height is not 1 to 256";
    layout->width = form->width;
    layout->height = form->height;
    layout->ham = ham;
    layout->dots = ham ? HAM8_DOTS : form->pixel_width;
    layout->twice = larger || form->pixel_height > 1;
    layout->shift = !ham ? 0 : larger || form->pixel_width > 1 ? 1 : 2;
    layout->shown_width = form->width * layout->dots >> layout->shift;
    layout->shown_height = form->height << layout->twice;
    layout->left = (SCREEN_WIDTH - layout->shown_width) >> 1;
    layout->top = (SCREEN_HEIGHT - layout->shown_height) >> 1;
    fetches = (form->width * layout->dots + FETCH_DOTS - 1) / FETCH_DOTS;
    layout->row_bytes = fetches * (FETCH_DOTS / 8);
    layout->plane_bytes = layout->row_bytes * form->height;
    return 0;
}
