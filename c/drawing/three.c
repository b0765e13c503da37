#include "drawing/three.h"

#include "drawing/clamp.h"
#include "drawing/lower.h"
#include "drawing/material.h"
#include "drawing/outline.h"

/* Returns non-zero if all rules are on, nothing is counted and the first vertex is inside the frame. */
static int32 is_usual(const struct renderer *renderer, const struct vertex *first)
{
    return !renderer->counts && !renderer->off && renderer->form == FORM_ADDX
        && (uint32)first->x < (uint32)renderer->frame->width << 16
        && (uint32)first->y < (uint32)renderer->frame->height << 16;
}

/* Returns non-zero if the mapper can draw the material's map to the frame. */
static int32 has_map(const struct material *material, const struct frame *frame)
{
    const struct map *map = material->map;

    return material->mapper == MAPPER_AFFINE
         ? map && map->layout == MAP_PAGE && map->texel_bytes == frame->pixel_bytes
         : material->mapper == MAPPER_FLAT || frame->pixel_bytes == 1;
}

/* Returns what polygon_find needs to know of the plane, and sets the texturing's cuts. */
static int32 chain_of(struct texturing *t, const struct material *material)
{
    t->u_cut = t->v_cut = 0;
    if (material->gradients != GRADIENTS_PLANE)
        return OUTLINE_ALONE;
    if (material->mapper == MAPPER_GOURAUD)
        return CHAIN_SHADES;
    return material->start == START_SUBTEXEL ? CHAIN_PLANE : CHAIN_ANYWHERE;
}

/* Finds steps, and the starts on left edges, where the plane alone does not give them. */
static void set_other_starts(struct setup *s, const struct material *material)
{
    struct texturing *t = &s->texturing;

    if (material->gradients == GRADIENTS_PLANE) {
        texturing_crossings(t, s->edges.left, s->edges.lefts);
        return;
    }
    texturing_longest(t, &s->sides, &s->box,
                      material->mapper == MAPPER_GOURAUD ? CHAIN_NONE : CHAIN_ANYWHERE);
    (material->start == START_SUBTEXEL ? texturing_pixels : texturing_edges)(
        t, s->edges.left, s->edges.lefts, s->box.right - s->box.left);
}

static void set_steps(struct setup *s, const struct material *material)
{
    int32 at_pixels = material->start == START_SUBTEXEL;

    if (!at_pixels || material->gradients != GRADIENTS_PLANE)
        set_other_starts(s, material);
    s->span.dudx = s->texturing.dudx;
    s->span.dvdx = s->texturing.dvdx;
    s->edges.dudx = at_pixels ? s->span.dudx : 0;
    s->edges.dvdx = at_pixels ? s->span.dvdx : 0;
}

enum polygon_result polygon_draw_three(struct renderer *renderer, const struct polygon *polygon,
                                       const struct material *material)
{
    const struct frame *frame = renderer->frame;
    const int32 exact = EDGES_ARE_EXACT(material->edges);
    const struct line_routines *routines;
    enum polygon_result result;
    struct setup s;

    if (!is_usual(renderer, polygon->vertices))
        return polygon_draw_any(renderer, polygon, material);
    s.scratch = renderer->scratch;
    s.frame = frame;
    s.material = material;
    s.off = s.applied = 0;
    s.count = 3;
    s.given = polygon->vertices;
    s.kind = (enum span_kind)mappers[material->mapper].kind[frame->pixel_bytes >> 1];
    s.vertices = material_vertices(s.scratch->vertices, s.given, 3, material);
    if (s.kind == SPAN_GOURAUD)
        lower_by_vertices(&s);
    result = polygon_find(&s, exact, s.kind <= SPAN_FILL_32 ? OUTLINE_ALONE
                                                            : chain_of(&s.texturing, material));
    if (result != POLYGON_DRAWN)
        return result;
    if (!has_map(material, frame))
        return POLYGON_WRONG_MAP;
    s.span.lines = s.edges.lines;
    s.span.count = s.box.bottom - s.box.top;
    s.span.row = frame->pixels + s.box.top * frame->pitch - EDGE_BIAS * frame->pixel_bytes;
    s.span.pitch = frame->pitch;
    if (s.kind > SPAN_FILL_32) {
        s.span.map = material->map ? material->map->texels : 0;
        set_steps(&s, material);
        lower_by_steps(&s);
    } else {
        s.span.colour = material->mapper == MAPPER_FLAT ? material->colour
                                                        : (uint32)s.given->shade >> 16;
    }
    routines = &line_routines[kind_lines[s.kind]];
    outline_lines(&s, exact ? routines->exact_edges : routines->edges, routines->scissor);
    if (material->mapper == MAPPER_GOURAUD && s.kind > SPAN_FILL_32)
        clamp_lines(&s);
    kind_spans[s.kind](&s.span);
    return POLYGON_DRAWN;
}
