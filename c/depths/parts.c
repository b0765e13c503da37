/* Where tested faces are on the screen, and how near. */
#include "depths/depths.h"

#include "drawing/outline.h"
#include "math/math.h"

void depths_begin(struct depths *depths)
{
    depths->count = 0;
    depths->far = 0;
    depths->corners_count = 0;
}

int32 depth_part_place(struct depth_part *part, const struct frame *frame, fix16 x_low, fix16 x_high, fix16 y_low,
                       fix16 y_high)
{
    struct rectangle *box = &part->box;

    box->left = outline_most((x_low >> 16) - 1, 0);
    box->right = outline_least((x_high >> 16) + 2, frame->width);
    box->top = outline_most((y_low >> 16) - 1, 0);
    box->bottom = outline_least((y_high >> 16) + 2, frame->height);
    return box->left < box->right && box->top < box->bottom;
}

int32 depth_part_set(struct depth_part *part, const struct frame *frame, const struct vertex *v, int32 count)
{
    fix16 x_low = v->x, x_high = x_low, y_low = v->y, y_high = y_low;

    part->near = part->far = v->w;
    part->lacks = 0;
    for (count--, v++; count > 0; count--, v++) {
        if (v->x < x_low)
            x_low = v->x;
        else if (v->x > x_high)
            x_high = v->x;
        if (v->y < y_low)
            y_low = v->y;
        else if (v->y > y_high)
            y_high = v->y;
        if (v->w < part->near)
            part->near = v->w;
        else if (v->w > part->far)
            part->far = v->w;
    }
    return depth_part_place(part, frame, x_low, x_high, y_low, y_high);
}

int32 depths_meet(const struct depths *depths, const struct depth_part *own, int32 is_ordered)
{
    const struct depth_part *part = depths->parts;

    for (int32 left = depths->count; left > 0; left--, part++)
        if (depth_parts_meet(&own->box, &part->box) && (!is_ordered || part->far >= own->near))
            return 1;
    return 0;
}

static void join(struct depth_part *to, const struct depth_part *part)
{
    to->box.left = outline_least(to->box.left, part->box.left);
    to->box.top = outline_least(to->box.top, part->box.top);
    to->box.right = outline_most(to->box.right, part->box.right);
    to->box.bottom = outline_most(to->box.bottom, part->box.bottom);
    to->near = outline_least(to->near, part->near);
    to->far = outline_most(to->far, part->far);
}

/* Keeps a polygon's corners. */
static void keep_corners(struct depths *depths, struct depth_part *part, const struct vertex *v, int32 count)
{
    struct depth_corner *to = &depths->corners[depths->corners_count];
    const int32 width = depths->aside.width, height = depths->aside.height;

    if (count > DEPTH_CORNERS - depths->corners_count) {
        part->lacks = 1;
        return;
    }
    depths->corners_count += count;
    for (; count > 0; count--, v++, to++) {
        to->x = v->x >> 16;
        to->y = v->y >> 16;
        to->q = mul_div(depths->near_plane >> 1, 1 << 30, v->w);
        to->part = part;
        if (to->x < -width || to->x >= 2 * width || to->y < -height || to->y >= 2 * height)
            part->lacks = 1;
    }
}

void depths_include(struct depths *depths, const struct vertex *vertices, int32 count)
{
    struct depth_part part, *to = depths->parts;
    int32 left = depths->count;

    if (!depth_part_set(&part, &depths->aside, vertices, count))
        return;
    depths->far = outline_most(depths->far, part.far);
    for (; left > 0 && !depth_parts_meet(&to->box, &part.box); left--)
        to++;
    if (!left && depths->count < DEPTH_PARTS) {
        to = &depths->parts[depths->count++];
        *to = part;
    } else {
        to -= !left;
        join(to, &part);
    }
    keep_corners(depths, to, vertices, count);
}

/* q of a plane is 0 to 2^29 at a pixel of its face, and a corner is up to two frames away from it: with gradients that
   pass the test q fits 32 bits there. The gradients' fractions, below a unit, are left out: what they may add is added,
   and the growth to the far side of the corner's pixel. */
int32 depths_are_before(const struct depths *depths, const struct depth_part *part, const struct depth_plan *plan)
{
    const struct depth_corner *corner = depths->corners;
    const int32 dx = (int32)plan->dx.hi, dy = (int32)plan->dy.hi;
    const int32 width = depths->aside.width, height = depths->aside.height;
    const uint32 steep = (fix_magnitude(dx) >> 5) * (uint32)width + (fix_magnitude(dy) >> 5) * (uint32)height;
    uint32 at = plan->at.hi + EDGE_BIAS * (uint32)dx;

    if (!(plan->dx.hi | plan->dx.lo | plan->dy.hi | plan->dy.lo))
        return 0;               /* no plane, but the middle of its corners' q */
    if (part->lacks || ((fix_magnitude(dx) | fix_magnitude(dy)) >> 20) || steep >= 1 << 24)
        return 0;
    at += (uint32)(EDGE_BIAS + 2 * (width + height) + 2);
    if (dx >= 0)
        at += (uint32)dx + 1;
    if (dy >= 0)
        at += (uint32)dy + 1;
    for (int32 left = depths->corners_count; left > 0; left--, corner++)
        if (corner->part == part
            && (int32)(at + (uint32)dx * (uint32)corner->x + (uint32)dy * (uint32)corner->y) >= corner->q)
            return 0;
    return 1;
}

void depths_clear(const struct depths *depths)
{
    const struct depth_part *part = depths->parts;
    struct span_plan plan;

    plan.lines = depths->bounds;
    plan.pitch = depths_pitch(depths);
    plan.colour = (uint32)DEPTH_FAR;
    for (int32 left = depths->count; left > 0; left--, part++) {
        const struct rectangle *const box = &part->box;
        struct scanline *line = depths->bounds;

        plan.count = box->bottom - box->top;
        plan.row = (uint8 *)depths->z + box->top * plan.pitch - EDGE_BIAS * (int32)sizeof *depths->z;
        for (int32 i = plan.count; i > 0; i--, line++) {
            line->left = (uint16)(EDGE_BIAS + box->left);
            line->last = (int16)(EDGE_BIAS + box->right - 1);
        }
        span_fill_32(&plan);
    }
}

/* q of a pixel is above the greatest of the corners by its plane's error at most, which is less than what these differ
   by, or all pixels have one q between them; by as much again where rounded corners are off the plane; and by half a
   unit for each further pixel of a line. */
int32 depths_hide(const struct depths *depths, const struct vertex *v, int32 count)
{
    struct depth_part part;
    const struct rectangle *const box = &part.box;
    const int32 width = depths->aside.width, half = depths->near_plane >> 1;
    const int32 *row;
    int32 most, columns;

    if (!depth_part_set(&part, &depths->aside, v, count))
        return 1;
    most = mul_div(half, 1 << 30, part.near);
    most += 2 * (most - mul_div(half, 1 << 30, part.far)) + DEPTH_OFF_LEAST + width;
    columns = box->right - box->left;
    row = &depths->z[box->top * width + box->left];
    for (int32 lines = box->bottom - box->top; lines > 0; lines--, row += width) {
        const int32 *z = row;

        for (int32 left = columns; left > 0; left--)
            if (*z++ <= most)
                return 0;
    }
    return 1;
}
