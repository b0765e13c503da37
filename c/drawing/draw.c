/* From a convex polygon to its scanline table and the call that draws it. With gradients of the plane and sub-
   texel starts, all numbers that decide a pixel are functions of the pixel alone: x of an edge at line j is x0 +
   (j - j0) slope, where j0 is its first line in the frame; u at pixel (i, j) is u_ref + (i - i_ref) dudx + (j -
   j_ref) dudy modulo 2^32, (i_ref, j_ref) being the first pixel right of the left side, or the middle of the box
   if gradients are steep. So it does not matter which vertex comes first, an edge from far above has not drifted
   when it reaches the frame, and polygons that share an edge leave no gap. The model in tools/tmap/model/model.py
   does the same arithmetic. */
#include "drawing/clamp.h"
#include "drawing/columns.h"
#include "drawing/draw.h"
#include "drawing/fan.h"
#include "drawing/generated.h"
#include "drawing/lower.h"
#include "drawing/material.h"
#include "drawing/outline.h"
#include "perspective/afar.h"
#include "perspective/light.h"
#include "perspective/perspective.h"
#include "polygon/clip.h"
#include "polygon/counts.h"
#include "polygon/kind.h"
#include "polygon/ramps.h"
#include "polygon/setup.h"
#include "polygon/shading.h"

/* Uses of the scratch room by polygons without perspective, one at a time. */
union made {
    struct {
        struct ramp left[CLIP_VERTICES_MAX], right[CLIP_VERTICES_MAX];
        struct scanline_step steps[FRAME_SIDE_MAX];
    } ramps;
    uint32 shades[FRAME_SIDE_MAX];
    uint8 code[CODE_BYTES + CACHE_BYTES];
};

SCRATCH_FITS(union made);

static union made *made_of(const struct setup *s)
{
    return (union made *)s->scratch->room;
}

/* Sets the map, light and code of the plan. Returns POLYGON_WRONG_MAP if the mapper cannot draw
   this map or frame, else POLYGON_DRAWN. */
static enum polygon_result set_map(struct setup *s)
{
    struct column_layout *columns = &s->scratch->columns;
    const struct map *map = s->material->map;
    const enum mapper mapper = s->material->mapper;
    const struct mapper_traits *traits = &mappers[mapper];
    uint8 *code;

    if (mapper == MAPPER_FLAT)
        return POLYGON_DRAWN;
    if (mapper == MAPPER_GOURAUD)
        return s->frame->pixel_bytes == 1 ? POLYGON_DRAWN : POLYGON_WRONG_MAP;
    if (!map || map->layout != traits->layout || map->texel_bytes != s->frame->pixel_bytes
        || !(map->texel_bytes & traits->bytes))
        return POLYGON_WRONG_MAP;
    s->span.map = map->texels;
    if (mapper == MAPPER_AFFINE)
        return POLYGON_DRAWN;
    code = made_of(s)->code;
    s->span.map_width = map->width;
    s->span.map_height = map->height;
    s->span.columns = columns;
    s->span.code = code + ((0 - (uint32)code) & (CACHE_BYTES - 1));
    if (traits->is & MAPPER_LIGHTS
        && !shading_light(&s->span, s->material,
                          s->affine == SPAN_LIT_GOURAUD ? 0 : s->given->shade))
        return POLYGON_WRONG_MAP;
    if (mapper == MAPPER_COLUMNS && !column_layout_make(columns, map->width, map->height))
        return POLYGON_WRONG_MAP;
    return POLYGON_DRAWN;
}

/* Returns the pixel of a flat polygon. */
static uint32 colour(const struct setup *s)
{
    return s->material->mapper == MAPPER_FLAT ? s->material->colour
         : s->material->mapper == MAPPER_GOURAUD ? (uint32)s->given->shade >> 16
         : *s->span.light;
}

static int32 is_flat(const struct setup *s)
{
    return s->kind <= SPAN_FILL_32;
}

static enum polygon_result set_span(struct setup *s)
{
    const struct frame *frame = s->frame;
    enum polygon_result result;

    s->span.lines = s->edges.lines;
    s->span.count = s->box.bottom - s->box.top;
    s->span.row = frame->pixels + s->box.top * frame->pitch - EDGE_BIAS * frame->pixel_bytes;
    s->span.pitch = frame->pitch;
    result = set_map(s);
    if (result == POLYGON_DRAWN && is_flat(s))
        s->span.colour = colour(s);
    return result;
}

/* Returns how u and v of the polygon's spans share an addx chain. */
static enum chain chain_of(const struct setup *s)
{
    const struct material *m = s->material;

    if (m->mapper == MAPPER_GOURAUD)
        return m->gradients == GRADIENTS_PLANE ? CHAIN_SHADES : CHAIN_NONE;
    if (m->mapper == MAPPER_LIT_GOURAUD)
        return s->kind == SPAN_LIT_GOURAUD ? CHAIN_NONE : CHAIN_WHOLE;
    if (m->mapper != MAPPER_AFFINE && m->mapper != MAPPER_LIT && m->mapper != MAPPER_KEYED
        && (m->mapper != MAPPER_GENERATED || s->kind == SPAN_GENERATED))
        return CHAIN_NONE;
    if (m->gradients != GRADIENTS_PLANE || m->start != START_SUBTEXEL)
        return CHAIN_ANYWHERE;
    return m->whole ? CHAIN_WHOLE : CHAIN_PLANE;
}

/* Sets the number of low bits of u and v that the mapper's spans do not keep. */
static void set_cuts(struct texturing *t, enum mapper mapper)
{
    t->u_cut = mapper == MAPPER_COLUMNS ? CUT_COLUMNS : 0;
    t->v_cut = mapper == MAPPER_TILED ? CUT_TILED_V : t->u_cut;
}

/* Finds the plane of a polygon that has its outline. Materials of texture units have the units' plane,
   to the last bit. */
static void set_plane(struct setup *s)
{
    struct texturing *t = &s->texturing;
    enum chain chain = chain_of(s);

    set_cuts(t, s->material->mapper);
    if (s->material->whole) {
        texturing_plane(t, &s->sides, &s->box, chain);
        texturing_starts(t, s->edges.left, s->edges.lefts);
    } else {
        plane_find(s, (int32)chain);
    }
}

/* Finds the outline and, unless the polygon is flat or has no plane of u and v, the plane. */
static enum polygon_result set_outline(struct setup *s)
{
    const int32 has_plane = !is_flat(s) && s->kind != SPAN_PERSPECTIVE
        && s->material->gradients == GRADIENTS_PLANE;
    enum polygon_result result;

    if (has_plane && !s->material->whole) {
        set_cuts(&s->texturing, s->material->mapper);
        return outline_find(s, (int32)chain_of(s));
    }
    result = outline_find(s, OUTLINE_ALONE);
    if (has_plane && result == POLYGON_DRAWN)
        set_plane(s);
    return result;
}

/* Finds the polygon's steps and the starts on its left edges; a plane is there already. */
static enum polygon_result set_texturing(struct setup *s)
{
    const struct material *m = s->material;
    struct texturing *t = &s->texturing;

    if (m->gradients == GRADIENTS_PLANE) {
        if (m->start == START_TRUNCATED)
            texturing_crossings(t, s->edges.left, s->edges.lefts);
    } else if (s->count == 3) {
        set_cuts(t, m->mapper);
        texturing_longest(t, &s->sides, &s->box, chain_of(s));
        (m->start == START_SUBTEXEL ? texturing_pixels : texturing_edges)(
            t, s->edges.left, s->edges.lefts, s->box.right - s->box.left);
    } else {
        return POLYGON_NO_TRIANGLE;
    }
    s->span.dudx = t->dudx;
    s->span.dvdx = t->dvdx;
    s->edges.dudx = m->start == START_SUBTEXEL ? t->dudx : 0;
    s->edges.dvdx = m->start == START_SUBTEXEL ? t->dvdx : 0;
    return POLYGON_DRAWN;
}

/* Makes the scanline table in the form that a kind of span reads. */
static void make_lines(struct setup *s, enum span_kind kind)
{
    const struct line_routines *routines = &line_routines[kind_lines[kind]];

    outline_lines(s, EDGES_ARE_EXACT(s->material->edges) ? routines->exact_edges : routines->edges,
                  routines->scissor);
}

/* GRADIENTS_SCANLINE: first x of all lines, then u and v by two divides a line. */
static void set_ramps(struct setup *s)
{
    union made *made = made_of(s);
    struct ramp_plan plan;

    make_lines(s, SPAN_FILL);
    ramps_make(made->ramps.left, s->edges.left, s->edges.lefts);
    ramps_make(made->ramps.right, s->edges.right, s->edges.rights);
    plan.lines = s->edges.lines;
    plan.count = s->span.count;
    plan.left = made->ramps.left;
    plan.right = made->ramps.right;
    plan.steps = made->ramps.steps;
    plan.truncated = s->material->start == START_TRUNCATED;
    plan.packed = kind_lines[s->kind] == LINES_ADDX || s->kind == SPAN_AFFINE_SCANLINE;
    edge_ramp(&plan);
    s->span.steps = made->ramps.steps;
}

/* Returns non-zero if the mapper has a range that u and v of every pixel must stay in. */
static int32 has_range(const struct setup *s)
{
    return (s->material->mapper == MAPPER_GOURAUD || s->material->mapper == MAPPER_ARBITRARY)
        && !is_flat(s);
}

/* Rounds u, v and the steps of a line up to the bits that its span keeps. */
static void raise_line(struct scanline *line, struct span_plan *span, const struct texturing *t)
{
    uint32 u = texturing_raised((uint32)line->start1 << 16 | line->start0, t->u_cut);

    line->start1 = (uint16)(u >> 16);
    line->start0 = (uint16)u;
    line->start2 = texturing_raised(line->start2, t->v_cut);
    span->dudx = (fix16)texturing_raised((uint32)span->dudx, t->u_cut);
    span->dvdx = (fix16)texturing_raised((uint32)span->dvdx, t->v_cut);
}

/* Draws the lines of the plan, unless they are only counted. */
static void draw_span(struct setup *s)
{
    if (s->counts && s->renderer->only_counts)
        return;
    if (s->renderer->cover)
        s->renderer->cover->span(s);
    else
        kind_spans[s->kind](&s->span);
}

/* Draws line by line, for mappers whose spans have only one pair of steps. */
static void draw_each_line(struct setup *s)
{
    struct span_plan *line = &s->span;
    int32 count = line->count;

    set_cuts(&s->texturing, s->material->mapper);
    line->count = 1;
    for (int32 i = 0; i < count; i++) {
        line->lines = &s->edges.lines[i];
        line->dudx = line->steps[i].dudx;
        line->dvdx = line->steps[i].dvdx;
        if (line->lines->last >= line->lines->left) {
            raise_line(&s->edges.lines[i], line, &s->texturing);
            if (has_range(s))
                clamp_lines(s);
            draw_span(s);
        }
        line->row += line->pitch;
    }
}

/* Makes the table of lines, unless it is made or nothing reads it but lines from afar whose edges are in the
   frame. Returns 1 if it is made. */
static int32 make_lines_read(struct setup *s, int32 from_afar, int32 is_made)
{
    if (from_afar && !s->counts && !light_kind(s) && !s->renderer->cover && lower_to_no_scissor(s))
        return 0;
    if (!is_made)
        make_lines(s, SPAN_FILL);
    if (s->renderer->cover)
        s->renderer->cover->lines(s);
    s->perspective->lines = s->edges.lines;
    s->perspective->count = s->span.count;
    return 1;
}

/* Draws with perspective. Returns 0 without drawing if the planes are too inexact, too steep or too
   wide: affine spans then draw the polygon. */
static int32 draw_perspective(struct setup *s)
{
    struct perspective_plan plan;
    struct depth depth;
    union afar afar;
    int32 from_afar, has_lines, is_made;

    s->perspective = &plan;
    if (lower_w_is_constant(s)) {       /* rule CONSTANT_W is off: all lines are level */
        set_plane(s);
        if (!perspective_of_texturing(&plan, &s->texturing, &s->box))
            return 0;
        depth.has_texels = 1;
    } else if (!perspective_depth(&plan, &depth, s->vertices, s->count, &s->sides, &s->box)
               || (s->material->tolerance && !perspective_texels(&plan, &depth))) {
        return count_unsure(s);
    }
    lower_by_planes(s);
    perspective_find_level(s);
    if (s->level && !perspective_texels(&plan, &depth))
        return count_unsure(s);
    is_made = s->renderer->cover && s->level != LEVEL_COLUMNS;
    if (s->level == LEVEL_COLUMNS && !columns_draw(s))
        s->level = LEVEL_NOTHING;       /* they bend too much */
    if (s->level == LEVEL_COLUMNS && !light_kind(s))
        return 1;
    from_afar = !s->level && afar_find(&afar, s, &depth);
    if (!from_afar && !perspective_texels(&plan, &depth))
        return count_unsure(s);
    has_lines = make_lines_read(s, from_afar, is_made);
    if (from_afar)
        afar_draw(s, &depth, &afar, has_lines);
    else if (s->level != LEVEL_COLUMNS)
        perspective_draw(s);
    if (light_kind(s))
        light_draw(s, made_of(s)->shades);
    return 1;
}

static void draw_affine(struct setup *s)
{
    int32 scanline = !is_flat(s) && s->material->gradients == GRADIENTS_SCANLINE;

    if (scanline) {
        set_ramps(s);
    } else {
        lower_by_steps(s);
        make_lines(s, s->kind);
        if (has_range(s))
            clamp_lines(s);
        if (s->kind == SPAN_GENERATED)
            generated_span(s);
        else if (s->kind == SPAN_KEYED_ROW)
            outline_opaque(s);
    }
    if (s->kind == SPAN_LIT_GOURAUD)
        shading_lines(s, made_of(s)->shades);
    if (s->counts)
        count_lines(s, s->kind);
    if (scanline && s->kind != SPAN_AFFINE_SCANLINE)
        draw_each_line(s);
    else
        draw_span(s);
}

/* Draws a polygon whose outline and span are set. */
static enum polygon_result draw_inside(struct setup *s)
{
    if (s->kind == SPAN_PERSPECTIVE) {
        if (draw_perspective(s))
            return POLYGON_DRAWN;
        s->kind = s->affine;
        set_plane(s);
    }
    if (!is_flat(s) && s->material->gradients != GRADIENTS_SCANLINE) {
        const enum polygon_result result = set_texturing(s);

        if (result != POLYGON_DRAWN)
            return result;
    }
    draw_affine(s);
    return POLYGON_DRAWN;
}

static enum polygon_result draw(struct setup *s)
{
    const struct material *material = s->material;
    enum polygon_result result;

    s->vertices = material_vertices(s->scratch->vertices, s->given, s->count, material);
    if (lower_asked(s))
        lower_by_vertices(s);
    result = set_outline(s);
    if (result != POLYGON_DRAWN)
        return result;
    result = set_span(s);
    if (result != POLYGON_DRAWN)
        return result;
    return s->renderer->cover ? s->renderer->cover->draw(s, draw_inside) : draw_inside(s);
}

enum polygon_result polygon_draw_whole(struct renderer *renderer, const struct polygon *polygon,
                                       const struct material *material)
{
    struct setup s;

    if (!is_polygon(polygon))
        return POLYGON_FEW;
    if (polygon->count > 3 && polygon->planar != PLANAR_ALL
        && !polygon_is_planar(renderer, polygon, polygon->vertices, planes_asked(material)))
        return polygon_fan(renderer->cover ? polygon_draw_whole : polygon_draw, renderer, polygon, material);
    s.form = renderer->form;
    setup_begin(&s, renderer, polygon, material);
    return count_rules(&s, draw(&s));
}
