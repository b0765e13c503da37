#include "depths/depths.h"

#include "drawing/material.h"
#include "drawing/outline.h"
#include "perspective/perspective.h"
#include "polygon/kind.h"

/* From here on, in 2^16 units a pixel, a plane of q is too steep: the face is narrower than a pixel. */
#define TOO_STEEP 65536

void depths_begin(struct depths *depths)
{
    const struct frame *frame = &depths->aside;
    struct scanline *line = depths->bounds;

    for (int32 i = frame->height; i > 0; i--, line++) {
        line->left = (uint16)(EDGE_BIAS + frame->width);
        line->last = EDGE_BIAS - 1;
    }
    depths->box.left = frame->width;
    depths->box.top = frame->height;
    depths->box.right = depths->box.bottom = 0;
}

void depths_include(struct depths *depths, const struct vertex *vertices, int32 count)
{
    const struct frame *frame = &depths->aside;
    fix16 x_low = vertices->x, x_high = x_low, y_low = vertices->y, y_high = y_low;
    int32 left, right, top, bottom;

    for (; count > 0; count--, vertices++) {
        x_low = outline_least(x_low, vertices->x);
        x_high = outline_most(x_high, vertices->x);
        y_low = outline_least(y_low, vertices->y);
        y_high = outline_most(y_high, vertices->y);
    }
    left = outline_most((x_low >> 16) - 1, 0);
    right = outline_least((x_high >> 16) + 2, frame->width);
    top = outline_most((y_low >> 16) - 1, 0);
    bottom = outline_least((y_high >> 16) + 2, frame->height);
    if (left >= right || top >= bottom)
        return;
    depths->box.left = outline_least(depths->box.left, left);
    depths->box.top = outline_least(depths->box.top, top);
    depths->box.right = outline_most(depths->box.right, right);
    depths->box.bottom = outline_most(depths->box.bottom, bottom);
    for (; top < bottom; top++) {
        struct scanline *line = &depths->bounds[top];

        line->left = (uint16)outline_least(line->left, EDGE_BIAS + left);
        line->last = (int16)outline_most(line->last, EDGE_BIAS + right - 1);
    }
}

static int32 pitch_of(const struct depths *depths)
{
    return depths->aside.width * (int32)sizeof *depths->z;
}

void depths_clear(const struct depths *depths)
{
    struct span_plan plan;

    plan.lines = depths->bounds;
    plan.count = depths->aside.height;
    plan.row = (uint8 *)depths->z - EDGE_BIAS * (int32)sizeof *depths->z;
    plan.pitch = pitch_of(depths);
    plan.colour = (uint32)DEPTH_FAR;
    span_fill_32(&plan);
}

static void shift_left_16(struct number64 *to, const struct number64 *from)
{
    to->hi = from->hi << 16 | from->lo >> 16;
    to->lo = from->lo << 16;
}

/* Returns the units that a plane may be off after so many pixels: its gradient, in 48.16, is off by 2^-31 of
   itself and 3 / 2^16. */
static int32 error_part(int32 steep, int32 pixels)
{
    return (steep * pixels >> 15) + (pixels >> 14);
}

/* Sets the plane of q, with w of the setup's vertices. */
static void set_plane(struct depth_plan *plan, const struct setup *s, fix16 near_plane)
{
    const struct sides *sides = &s->sides;
    const struct rectangle *box = &s->box;
    struct plane_corners corners;
    struct corner_source source;
    struct screen_plane q;
    int32 low, range, right, down, steep_x, steep_y;

    source.first = sides->top;
    source.a = sides->middle_right ? sides->middle : sides->bottom;
    source.b = sides->middle_right ? sides->bottom : sides->middle;
    source.u = source.v = 0;
    source.nearest = near_plane >> 1;
    source.scale = 31;
    corners_find(&corners, &source);
    corners.x = (box->left << 16) - corners.first.x;
    corners.y = (box->top << 16) - corners.first.y;
    corners.area = sides->area;
    depth_plane_find(&q, &corners);
    low = outline_least(0, outline_least(corners.a.q, corners.b.q));
    range = outline_most(0, outline_most(corners.a.q, corners.b.q)) - low;
    right = (int32)(fix_magnitude(corners.x) >> 16) + box->right - box->left + 1;
    down = (int32)(fix_magnitude(corners.y) >> 16) + box->bottom - box->top + 1;
    steep_x = perspective_steepness(&q.dx);
    steep_y = perspective_steepness(&q.dy);
    if (steep_x >= TOO_STEEP || steep_y >= TOO_STEEP
        || DEPTH_OFF_LEAST + error_part(steep_x, right) + error_part(steep_y, down) > range) {
        plan->at.hi = (uint32)(corners.first.q + low + (range >> 1));
        plan->at.lo = plan->dx.hi = plan->dx.lo = plan->dy.hi = plan->dy.lo = 0;
    } else {
        shift_left_16(&plan->at, &q.at);
        shift_left_16(&plan->dx, &q.dx);
        shift_left_16(&plan->dy, &q.dy);
    }
    plan->step = (int32)(plan->dx.hi + (plan->dx.lo >> 31));
}

/* Finds the lines and the plane of a polygon; returns 0 if it has no pixels. */
static int32 find(struct depth_plan *plan, struct setup *s, struct renderer *renderer,
                  const struct depths *depths, const struct vertex *vertices, int32 count,
                  const struct material *material)
{
    struct polygon polygon;
    struct material plain = *material;

    plain.mapper = MAPPER_FLAT;
    plain.map = 0;
    polygon_set(&polygon, vertices, count, PLANAR_ALL);
    setup_begin(s, renderer, &polygon, &plain);
    s->form = renderer->form;
    s->kind = SPAN_FILL;
    s->vertices = material_vertices(s->scratch->vertices, vertices, count, &plain);
    if (outline_find(s, OUTLINE_ALONE) != POLYGON_DRAWN)
        return 0;
    outline_lines(s, EDGES_ARE_EXACT(plain.edges) ? edge_flat_exact : edge_flat, scissor_flat);
    set_plane(plan, s, depths->near_plane);
    plan->lines = s->edges.lines;
    plan->count = s->box.bottom - s->box.top;
    plan->bounds = &depths->bounds[s->box.top];
    plan->pitch = pitch_of(depths);
    plan->row = (uint8 *)depths->z + s->box.top * plan->pitch - EDGE_BIAS * (int32)sizeof *depths->z;
    plan->left = EDGE_BIAS + s->box.left;
    return 1;
}

/* Returns non-zero if a polygon is beside the box of all bounds. */
static int32 is_beside(const struct rectangle *box, const struct vertex *v, int32 count)
{
    const fix16 left = (box->left - 1) << 16, right = (box->right + 1) << 16;
    const fix16 top = (box->top - 1) << 16, bottom = (box->bottom + 1) << 16;
    int32 outside = 15;

    for (; count > 0 && outside; count--, v++)
        outside &= (v->x < left) | (v->x > right) << 1 | (v->y < top) << 2 | (v->y > bottom) << 3;
    return outside;
}

void depths_fill(struct renderer *renderer, const struct depths *depths, const struct vertex *vertices,
                 int32 count, const struct material *material)
{
    struct depth_plan plan;
    struct setup s;

    if (!is_beside(&depths->box, vertices, count)
        && find(&plan, &s, renderer, depths, vertices, count, material))
        depth_fill(&plan);
}

void depths_blank(struct renderer *renderer, const struct depths *depths, const struct vertex *vertices,
                  int32 count, const struct material *material)
{
    const struct frame *frame = &depths->aside;
    struct depth_plan found;
    struct span_plan plan;
    struct setup s;

    if (!find(&found, &s, renderer, depths, vertices, count, material))
        return;
    plan.lines = found.lines;
    plan.count = found.count;
    plan.row = frame->pixels + s.box.top * frame->pitch - EDGE_BIAS;
    plan.pitch = frame->pitch;
    plan.colour = 0;
    span_fill(&plan);
}

void depths_copy(struct renderer *renderer, const struct depths *depths, const struct vertex *vertices,
                 int32 count, const struct material *material)
{
    const struct frame *frame = renderer->frame;
    struct depth_plan plan;
    struct setup s;

    if (!find(&plan, &s, renderer, depths, vertices, count, material))
        return;
    plan.from_pitch = depths->aside.pitch;
    plan.to_pitch = frame->pitch;
    plan.from = depths->aside.pixels + s.box.top * plan.from_pitch - EDGE_BIAS;
    plan.to = frame->pixels + s.box.top * plan.to_pitch - EDGE_BIAS;
    if (material->mapper == MAPPER_KEYED)
        depth_copy_keyed(&plan);
    else
        depth_copy(&plan);
}
