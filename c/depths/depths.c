#include "depths/depths.h"

#include "drawing/fan.h"
#include "drawing/material.h"
#include "drawing/outline.h"
#include "perspective/perspective.h"
#include "polygon/kind.h"

/* From here on, in 2^16 units a pixel, a plane of q is too steep: the face is narrower than a pixel. */
#define TOO_STEEP 65536

void depths_begin(struct depths *depths)
{
    depths->count = 0;
    depths->far = 0;
}

/* Sets the part of the frame and the depths of a polygon; returns 0 if none of the frame is in it. */
static int32 set_part(struct depth_part *part, const struct frame *frame, const struct vertex *v, int32 count)
{
    fix16 x_low = v->x, x_high = x_low, y_low = v->y, y_high = y_low;
    struct rectangle *box = &part->box;

    part->near = part->far = v->w;
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
    box->left = outline_most((x_low >> 16) - 1, 0);
    box->right = outline_least((x_high >> 16) + 2, frame->width);
    box->top = outline_most((y_low >> 16) - 1, 0);
    box->bottom = outline_least((y_high >> 16) + 2, frame->height);
    return box->left < box->right && box->top < box->bottom;
}

static inline int32 meet(const struct rectangle *a, const struct rectangle *b)
{
    return a->left < b->right && b->left < a->right && a->top < b->bottom && b->top < a->bottom;
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

void depths_include(struct depths *depths, const struct vertex *vertices, int32 count)
{
    struct depth_part part, *to = depths->parts;
    int32 left = depths->count;

    if (!set_part(&part, &depths->aside, vertices, count))
        return;
    depths->far = outline_most(depths->far, part.far);
    for (; left > 0 && !meet(&to->box, &part.box); left--)
        to++;
    if (!left && depths->count < DEPTH_PARTS)
        depths->parts[depths->count++] = part;
    else
        join(left ? to : to - 1, &part);
}

static int32 pitch_of(const struct depths *depths)
{
    return depths->aside.width * (int32)sizeof *depths->z;
}

void depths_clear(const struct depths *depths)
{
    const struct frame *frame = &depths->aside;
    const struct depth_part *part = depths->parts;
    struct scanline *line = depths->bounds;
    struct span_plan plan;

    if (!depths->count)
        return;
    for (int32 i = frame->height; i > 0; i--, line++) {
        line->left = (uint16)(EDGE_BIAS + frame->width);
        line->last = EDGE_BIAS - 1;
    }
    for (int32 left = depths->count; left > 0; left--, part++)
        for (int32 i = part->box.top; i < part->box.bottom; i++) {
            line = &depths->bounds[i];
            line->left = (uint16)outline_least(line->left, EDGE_BIAS + part->box.left);
            line->last = (int16)outline_most(line->last, EDGE_BIAS + part->box.right - 1);
        }
    plan.lines = depths->bounds;
    plan.count = frame->height;
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

/* Adds so many steps, below 2^16, to a number. */
static void add_steps(struct number64 *to, const struct number64 *step, uint32 count)
{
    const uint32 low = (step->lo & 0xffff) * count, high = (step->lo >> 16) * count + (low >> 16);
    const uint32 sum = to->lo + (high << 16 | (low & 0xffff));

    to->hi += step->hi * count + (high >> 16) + (sum < to->lo);
    to->lo = sum;
}

static void set_everywhere(struct depth_plan *plan, int32 q)
{
    plan->at.hi = (uint32)q;
    plan->at.lo = plan->dx.hi = plan->dx.lo = plan->dy.hi = plan->dy.lo = 0;
    plan->step = 0;
}

/* Moves a plane's origin so many pixels to the left and up. */
static void move_origin(struct depth_plan *plan, int32 x, int32 y)
{
    struct number64 back = {0, 0};

    add_steps(&back, &plan->dx, (uint32)x);
    add_steps(&back, &plan->dy, (uint32)y);
    plan->at.hi -= back.hi + (plan->at.lo < back.lo);
    plan->at.lo -= back.lo;
}

/* Sets the plane of q, with w of the setup's vertices, its origin at pixel -EDGE_BIAS of the frame's first line. */
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
        set_everywhere(plan, corners.first.q + low + (range >> 1));
    } else {
        shift_left_16(&plan->at, &q.at);
        shift_left_16(&plan->dx, &q.dx);
        shift_left_16(&plan->dy, &q.dy);
        plan->step = (int32)(plan->dx.hi + (plan->dx.lo >> 31));
        move_origin(plan, EDGE_BIAS + box->left, box->top);
    }
}

/* A face that is filled or copied: its whole outline, then that of what it was drawn as. */
struct depth_face {
    struct setup setup;
    struct material material;           /* of its outline alone */
    struct depth_plan plan;             /* the plane; origin: its q at pixel -EDGE_BIAS of the frame's first line */
    struct number64 origin;
    const struct depths *depths;
    struct renderer *renderer;
};

/* Finds the outline of a polygon; returns 0 if it has no pixels. */
static int32 find_outline(struct depth_face *face, const struct polygon *polygon)
{
    struct setup *s = &face->setup;

    setup_begin(s, face->renderer, polygon, &face->material);
    s->form = face->renderer->form;
    s->kind = SPAN_FILL;
    s->vertices = material_vertices(s->scratch->vertices, polygon->vertices, polygon->count, &face->material);
    return outline_find(s, OUTLINE_ALONE) == POLYGON_DRAWN;
}

/* Begins a face; returns 0 if it has no pixels. */
static int32 begin(struct depth_face *face, struct renderer *renderer, const struct depths *depths,
                   const struct polygon *polygon, const struct material *material)
{
    face->depths = depths;
    face->renderer = renderer;
    face->material = *material;
    face->material.mapper = MAPPER_FLAT;
    face->material.map = 0;
    face->plan.pitch = pitch_of(depths);
    return find_outline(face, polygon);
}

/* Makes the lines of the outline that was found. */
static void make_lines(struct depth_face *face)
{
    outline_lines(&face->setup, EDGES_ARE_EXACT(face->material.edges) ? edge_flat_exact : edge_flat, scissor_flat);
}

/* Sets the lines of a plan to those from top on. */
static void set_lines(struct depth_face *face, int32 top, int32 bottom)
{
    struct depth_plan *plan = &face->plan;

    plan->lines = &face->setup.edges.lines[top - face->setup.box.top];
    plan->count = bottom - top;
    plan->row = (uint8 *)face->depths->z + top * plan->pitch - EDGE_BIAS * (int32)sizeof *face->depths->z;
    plan->at = face->origin;
    add_steps(&plan->at, &plan->dy, (uint32)top);
}

/* Returns 1 if a face was drawn as a fan whose triangles may have other pixels than its outline, which was found.

   They have the same if edges are exact and the face turns to one side only: then the triangles of the fan do not overlap,
   fill the face, and a pixel on an edge that two of them share belongs to one of them. Rounding may turn a corner inwards,
   though, by a sixteenth of a pixel or 1/65536: a triangle beside that corner is then seen from the back or lies outside,
   so that pixels in the sliver between differ. So a fan is filled, and copied, by its triangles: what is drawn of a face,
   what sets z and what is copied of it are always the same pixels, and a pixel that hides another face's has set z. */
static int32 is_odd_fan(struct depth_face *face, const struct polygon *polygon, const struct material *material)
{
    return polygon->count > 3
        && !(EDGES_ARE_EXACT(material->edges) && depth_convex(face->setup.vertices, polygon->count))
        && polygon_is_fan(face->renderer, polygon, material);
}

/* Calls `each` with a face's lines: those of its outline, or of the triangles that it was drawn as. */
static void do_lines(struct depth_face *face, const struct polygon *polygon, const struct material *material,
                     void (*each)(struct depth_face *face, const void *with), const void *with)
{
    struct vertex corners[3];
    struct polygon triangle;

    if (!is_odd_fan(face, polygon, material)) {
        make_lines(face);
        each(face, with);
        return;
    }
    polygon_set(&triangle, corners, 3, PLANAR_ALL);
    for (int32 i = 2; i < polygon->count; i++) {
        planar_triangle(corners, polygon->vertices, i);
        if (find_outline(face, &triangle)) {
            make_lines(face);
            each(face, with);
        }
    }
}

/* A polygon's part of the frame, and the parts that it is filled in. */
struct filled {
    const struct depth_part *parts[DEPTH_PARTS];
    int32 count;
};

static void fill_lines(struct depth_face *face, const void *with)
{
    const struct filled *filled = with;
    struct depth_plan *plan = &face->plan;

    for (int32 i = 0; i < filled->count; i++) {
        const struct rectangle *box = &filled->parts[i]->box;
        const int32 top = outline_most(face->setup.box.top, box->top);
        const int32 bottom = outline_least(face->setup.box.bottom, box->bottom);

        if (top >= bottom)
            continue;
        set_lines(face, top, bottom);
        plan->left = EDGE_BIAS + box->left;
        plan->last = EDGE_BIAS + box->right - 1;
        depth_fill(plan);
    }
}

void depths_fill(struct renderer *renderer, const struct depths *depths, const struct polygon *polygon,
                 const struct material *material, int32 is_ordered)
{
    const struct depth_part *part = depths->parts;
    struct depth_part own;
    struct filled filled;
    struct depth_face face;
    int32 is_before = 1;

    filled.count = 0;
    if (!set_part(&own, &depths->aside, polygon->vertices, polygon->count))
        return;
    for (int32 left = depths->count; left > 0; left--, part++) {
        if (!meet(&own.box, &part->box))
            continue;
        if (part->near <= own.far)
            is_before = 0;
        if (!is_ordered || part->far >= own.near)
            filled.parts[filled.count++] = part;
    }
    if (!filled.count || !begin(&face, renderer, depths, polygon, material))
        return;
    if (is_before)
        set_everywhere(&face.plan, DEPTH_NEAREST);
    else
        set_plane(&face.plan, &face.setup, depths->near_plane);
    face.origin = face.plan.at;
    do_lines(&face, polygon, material, fill_lines, &filled);
}

static void blank_lines(struct depth_face *face, const void *with)
{
    const struct frame *frame = with;
    struct span_plan plan;

    plan.lines = face->setup.edges.lines;
    plan.count = face->setup.box.bottom - face->setup.box.top;
    plan.row = frame->pixels + face->setup.box.top * frame->pitch - EDGE_BIAS;
    plan.pitch = frame->pitch;
    plan.colour = 0;
    span_fill(&plan);
}

void depths_blank(struct renderer *renderer, const struct depths *depths, const struct polygon *polygon,
                  const struct material *material)
{
    struct depth_face face;

    if (begin(&face, renderer, depths, polygon, material))
        do_lines(&face, polygon, material, blank_lines, &depths->aside);
}

static void copy_lines(struct depth_face *face, const void *with)
{
    const struct material *material = with;
    const struct frame *frame = face->renderer->frame, *aside = &face->depths->aside;
    const struct rectangle *box = &face->setup.box;
    struct depth_plan *plan = &face->plan;

    set_lines(face, box->top, box->bottom);
    plan->from_pitch = aside->pitch;
    plan->to_pitch = frame->pitch;
    plan->from = aside->pixels + box->top * plan->from_pitch - EDGE_BIAS;
    plan->to = frame->pixels + box->top * plan->to_pitch - EDGE_BIAS;
    if (material->mapper == MAPPER_KEYED)
        depth_copy_keyed(plan);
    else
        depth_copy(plan);
}

void depths_copy(struct renderer *renderer, const struct depths *depths, const struct polygon *polygon,
                 const struct material *material)
{
    struct depth_face face;

    if (!begin(&face, renderer, depths, polygon, material))
        return;
    set_plane(&face.plan, &face.setup, depths->near_plane);
    face.origin = face.plan.at;
    do_lines(&face, polygon, material, copy_lines, material);
}
