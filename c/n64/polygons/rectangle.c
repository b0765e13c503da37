/* Texture rectangles are drawn as polygons of four vertices. Their planes are exact: the gradients
   are whole multiples of 1/65536 texel. Copy mode steps four pixels at a time, which gives the same
   pixels if four pixels are four texels. */
#include "n64/polygons/rectangle.h"

#define FOUR_TEXELS (4 * 1024)

/* Returns s or t at a corner, 16.16 texels, from s10.5 and a step of s5.10. */
static fix16 corner(int32 start, int32 step, int32 pixels)
{
    return start * 2048 + step * pixels * 64;
}

static void find_corners(struct vertex *v, const struct n64_rectangle *r, int32 dsdx)
{
    for (int32 i = 0; i < 4; i++, v++) {
        int32 right = i == 1 || i == 2 ? r->right - r->left : 0;
        int32 down = i >= 2 ? r->bottom - r->top : 0;

        v->x = (r->left + right) * 65536;
        v->y = (r->top + down) * 65536;
        v->s = corner(r->s, dsdx, r->flip ? down : right);
        v->t = corner(r->t, r->dtdy, r->flip ? right : down);
        v->shade = 0;           /* R G B A */
        v->w = 65536;
    }
}

/* Writes four pixels of a line, or those of them that are within the frame. */
static void copy_four(const struct frame *frame, int32 x, int32 y, int32 end,
                      const uint32 *texels)
{
    uint16 *row = (uint16 *)(frame->pixels + y * frame->pitch);

    for (int32 i = 0; i < 4 && x + i < end; i++)
        if (x + i >= 0)
            row[x + i] = (uint16)(i & 1 ? texels[i >> 1] : texels[i >> 1] >> 16);
}

static void copy_line(const struct frame *frame, const struct n64_rectangle *r, int32 y,
                      const struct n64 *n64)
{
    int32 end = r->right < frame->width ? r->right : frame->width;
    int32 t = r->t + ((y - r->top) * r->dtdy >> 5);

    for (int32 x = r->left, s = r->s * 32; x < end; x += 4, s += r->dsdx) {
        uint32 texels[2];

        if (x <= -4)
            continue;
        n64_copy_texels(n64, n64->primitive_tile, s >> 5, t, texels);
        copy_four(frame, x, y, end, texels);
    }
}

static void copy_lines(const struct frame *frame, const struct n64_rectangle *r,
                       const struct n64 *n64)
{
    int32 end = r->bottom < frame->height ? r->bottom : frame->height;

    for (int32 y = r->top < 0 ? 0 : r->top; y < end; y++)
        copy_line(frame, r, y, n64);
}

static enum polygon_result draw_polygon(struct renderer *renderer, const struct n64_rectangle *r,
                                        int32 dsdx, const struct material *material)
{
    int32 copy = material->unit->n64.modes.cycle == N64_COPY;
    polygon_routine *draw = copy ? n64_polygon_copy : n64_polygon_draw_coloured;
    struct vertex corners[4];
    struct polygon polygon;

    find_corners(corners, r, dsdx);
    polygon_set(&polygon, corners, 4, PLANAR_ALL);
    return draw(renderer, &polygon, material);
}

static void count_copied(const struct renderer *renderer, const struct n64_rectangle *r,
                         const struct material *material)
{
    struct draw_counts *counts = &renderer->counts[material->number];
    const struct frame *frame = renderer->frame;
    int32 left = r->left < 0 ? 0 : r->left, top = r->top < 0 ? 0 : r->top;
    int32 right = r->right < frame->width ? r->right : frame->width;
    int32 bottom = r->bottom < frame->height ? r->bottom : frame->height;

    if (left >= right || top >= bottom)
        return;
    counts->polygons++;
    counts->pixels[SPAN_N64_PIXELS] += (uint32)((right - left) * (bottom - top));
}

/* By the plain mappers where they do. */
static enum polygon_result draw_copy(struct renderer *renderer, const struct n64_rectangle *r,
                                     const struct material *material)
{
    struct n64_unit *unit = material->unit;
    enum n64_result before = unit->result, check;

    if (renderer->frame->pixel_bytes != 2 || r->flip)
        return n64_refused(unit, N64_CYCLE_TYPE);
    if (r->dsdx == FOUR_TEXELS) {
        enum polygon_result result = draw_polygon(renderer, r, r->dsdx / 4, material);

        if (result != POLYGON_REFUSED || unit->result != N64_CYCLE_TYPE)
            return result;
        unit->result = before;
    }
    check = n64_check_drawing(&unit->n64);
    if (check != N64_DONE)
        return n64_refused(unit, check);
    if (renderer->counts)
        count_copied(renderer, r, material);
    if (!renderer->only_counts)
        copy_lines(renderer->frame, r, &unit->n64);
    n64_drawn(&unit->n64);
    return POLYGON_DRAWN;
}

/* Its command names no level: the greatest is 0. What was made of the modes is made again then. */
static enum polygon_result draw_first_level(struct renderer *renderer,
                                            const struct n64_rectangle *r,
                                            const struct material *material)
{
    struct n64 *n64 = &material->unit->n64;
    enum polygon_result result;
    uint8 max_level = n64->max_level;

    if (!max_level || !(n64->modes.lod || n64->inputs & N64_INPUT_LOD_FRACTION))
        return draw_polygon(renderer, r, r->dsdx, material);
    n64->max_level = 0;
    n64->mode_generation++;
    result = draw_polygon(renderer, r, r->dsdx, material);
    n64->max_level = max_level;
    n64->mode_generation++;
    return result;
}

static int32 is_far(int32 pixels)
{
    return pixels < -POLYGON_FAR || pixels >= POLYGON_FAR;
}

/* Returns non-zero if a coordinate stays within the range of polygons'. */
static int32 is_in_range(int32 start, int32 step, int32 steps)
{
    const int32 most = 1024 * 1024;             /* texels in s5.10 */
    int32 way = step * steps, end = start * 32;

    if (way <= -most || way >= most)
        return 0;
    end += way;
    return end >= -most && end < most;
}

static int32 coordinates_in_range(const struct n64_rectangle *r, int32 copy)
{
    int32 width = r->right - r->left, height = r->bottom - r->top;
    int32 across = r->flip ? height : copy ? (width + 3) >> 2 : width;

    return is_in_range(r->s, r->dsdx, across)
        && is_in_range(r->t, r->dtdy, r->flip ? width : height);
}

enum polygon_result n64_rectangle_draw(struct renderer *renderer, const struct n64_rectangle *r,
                                       const struct material *material)
{
    struct n64_unit *unit = material->unit;
    const struct n64_modes *modes = &unit->n64.modes;
    int32 copy = modes->cycle == N64_COPY;

    if (r->left >= r->right || r->top >= r->bottom)
        return POLYGON_EMPTY;
    if (is_far(r->left) || is_far(r->top) || is_far(r->right) || is_far(r->bottom))
        return POLYGON_OUTSIDE_RANGE;
    if (unit->n64.checked && (modes->perspective || unit->n64.inputs & N64_INPUT_SHADE))
        return n64_refused(unit, N64_RECTANGLE_MODES);
    if (!coordinates_in_range(r, copy))
        return n64_refused(unit, N64_COORDINATE_RANGE);
    return copy ? draw_copy(renderer, r, material) : draw_first_level(renderer, r, material);
}
