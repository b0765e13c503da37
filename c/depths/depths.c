#include "depths/depths.h"

#include "drawing/fan.h"
#include "drawing/material.h"
#include "drawing/outline.h"
#include "perspective/perspective.h"
#include "polygon/kind.h"

/* From here on, in 2^16 units a pixel, a plane of q is too steep: the face is narrower than a pixel. */
#define TOO_STEEP 65536

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
    face->plan.pitch = depths_pitch(depths);
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

   They have the same if edges are exact and the face turns to one side only: then the triangles of the fan do not
   overlap,
   fill the face, and a pixel on an edge that two of them share belongs to one of them. Rounding may turn a corner
   inwards,
   though, by a sixteenth of a pixel or 1/65536: a triangle beside that corner is then seen from the back or lies
   outside,
   so that pixels in the sliver between differ. So a fan is filled, and copied, by its triangles: what is drawn of a
   face,
   what sets z and what is copied of it are always the same pixels, and a pixel that hides another face's has set z. */
static int32 is_odd_fan(struct depth_face *face, const struct polygon *polygon, const struct material *material)
{
    return polygon_may_be_fan(face->renderer, polygon, material)
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

/* The parts that a polygon is filled in. */
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

/* Leaves parts out whose faces are all before a plane. */
static void leave_out(struct filled *filled, const struct depths *depths, const struct depth_plan *plan)
{
    int32 kept = 0;

    for (int32 i = 0; i < filled->count; i++)
        if (!depths_are_before(depths, filled->parts[i], plan))
            filled->parts[kept++] = filled->parts[i];
    filled->count = kept;
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
    if (!depth_part_set(&own, &depths->aside, polygon->vertices, polygon->count))
        return;
    for (int32 left = depths->count; left > 0; left--, part++) {
        if (!depth_parts_meet(&own.box, &part->box))
            continue;
        if (part->near <= own.far)
            is_before = 0;
        if (!is_ordered || part->far >= own.near)
            filled.parts[filled.count++] = part;
    }
    if (!filled.count || !begin(&face, renderer, depths, polygon, material))
        return;
    if (is_before) {
        set_everywhere(&face.plan, DEPTH_NEAREST);
    } else {
        set_plane(&face.plan, &face.setup, depths->near_plane);
        if (is_ordered)
            leave_out(&filled, depths, &face.plan);
    }
    face.origin = face.plan.at;
    if (filled.count)
        do_lines(&face, polygon, material, fill_lines, &filled);
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
