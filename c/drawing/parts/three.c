#include "drawing/three.h"

#include "drawing/draw.h"
#include "drawing/lower.h"
#include "drawing/material.h"
#include "drawing/outline.h"

/* Returns non-zero if triangles of the material are drawn this way with all rules on. */
static int32 is_plain(const struct renderer *renderer, const struct material *material)
{
    return material->edges != EDGES_SNAPPED && material->mapper <= MAPPER_AFFINE
        && material->gradients != GRADIENTS_SCANLINE && !material->perspective
        && material->clip == CLIP_SCISSOR
        && !renderer->counts && !renderer->off && renderer->form == FORM_ADDX
        && renderer->frame->pitch == (int16)renderer->frame->pitch;
}

/* Returns non-zero if the mapper can draw the material's map to the frame. */
static int32 has_map(const struct material *material, const struct frame *frame)
{
    const struct map *map = material->map;

    return (mappers[material->mapper].bytes & frame->pixel_bytes) != 0
        && (material->mapper != MAPPER_AFFINE
            || (map && map->layout == MAP_PAGE && map->texel_bytes == frame->pixel_bytes));
}

/* Returns how the plane is found, if it is. */
static int32 chain_of(const struct material *material)
{
    if (material->mapper == MAPPER_FLAT || material->gradients != GRADIENTS_PLANE || material->whole)
        return OUTLINE_ALONE;
    if (material->mapper == MAPPER_GOURAUD)
        return CHAIN_SHADES;
    return material->start == START_SUBTEXEL ? CHAIN_PLANE : CHAIN_ANYWHERE;
}

static enum three_way way_of(const struct three *three, const struct material *material)
{
    if (material->mapper == MAPPER_FLAT)
        return THREE_FLAT;
    return material->mapper == MAPPER_GOURAUD ? THREE_SHADES
         : three->s.frame->pixel_bytes == 1 ? THREE_TEXELS : THREE_WIDE;
}

static enum three_starts starts_of(const struct material *material)
{
    const int32 at_pixels = material->start == START_SUBTEXEL;

    if (material->whole)
        return THREE_WHOLE;
    return (material->gradients == GRADIENTS_PLANE) == at_pixels
         ? at_pixels ? THREE_PLANE : THREE_LONGEST : THREE_STARTS;
}

static enum three_vertices vertices_of(const struct material *material)
{
    return material_takes_vertices(material) ? THREE_GIVEN
         : material->mapper == MAPPER_GOURAUD ? THREE_SHADED
         : !material->map || material->map->scale == 65536 ? THREE_CUT : THREE_MADE;
}

int32 three_set(struct three *three, const struct renderer *renderer, const struct material *material)
{
    const struct frame *frame = renderer->frame;
    struct setup *s = &three->s;

    if (!is_plain(renderer, material) || !has_map(material, frame))
        return 0;
    s->scratch = renderer->scratch;
    setup_edges_set(s);
    s->frame = frame;
    s->material = material;
    s->off = s->applied = 0;
    s->count = 3;
    s->outline_sides = &s->sides;
    s->kind = (enum span_kind)mappers[material->mapper].kind[frame->pixel_bytes >> 1];
    s->texturing.u_cut = s->texturing.v_cut = 0;
    s->edges.dudx = s->edges.dvdx = 0;  /* THREE_LONGEST; others set them */
    s->span.lines = s->edges.lines;
    s->span.pitch = frame->pitch;
    s->span.map = material->map ? material->map->texels : 0;
    s->span.colour = material->colour;
    three->edges = EDGES_ARE_EXACT(material->edges) ? edge_exact_across : edge_rounded_across;
    three->chain = chain_of(material);
    three->way = way_of(three, material);
    three_set_lines(three);
    three->row = frame->pixels - EDGE_BIAS * frame->pixel_bytes;
    three->right = (uint32)frame->width << 16;
    three->vertices = vertices_of(material);
    three->mask = material->edges == EDGES_INTEGER ? ~0xffffu : ~0u;
    three->starts = starts_of(material);
    three->steep = material_steep(material, frame->height);
    return 1;
}

void three_rest(struct three *three)
{
    struct setup *s = &three->s;
    const struct material *material = s->material;
    const enum span_kind kind = s->kind;
    const struct line_routines *routines;

    if (three->way != THREE_FLAT)
        lower_by_steps(s);
    routines = &line_routines[kind_lines[s->kind]];
    outline_lines(s, EDGES_ARE_EXACT(material->edges) ? routines->exact_edges : routines->edges, routines->scissor);
    if (material->mapper == MAPPER_GOURAUD && three->way != THREE_FLAT)
        clamp_lines(s);
    kind_spans[s->kind](&s->span);
    s->kind = kind;
}

enum polygon_result three_polygon(struct three *three, const struct vertex *vertices)
{
    const struct material *material = three->s.material;
    const struct vertex *made = material_vertices(three->s.scratch->vertices, vertices, 3, material);

    return material->mapper == MAPPER_GOURAUD ? three_shaded(three, vertices, made) : three_draw(three, made);
}
