/* The parts of polygon_draw, triangles_draw and meshes that a program names: it links no others. One C file of the
   program defines the names and includes this header:

       #define WITH_AFFINE
       #define WITH_TRIANGLES
       #include "drawing/parts/parts.h"

   Its object is linked before the library of C objects. It has the tables of span routines, and for each part that
   is not named a routine that refuses, so that the linker has no reason to take the part from the library. Calls
   stay as they are: what is left out costs no cycle. A program without such a file has all parts.

   Outlines, one at least:
       WITH_TRIANGLES       triangles by flat, Gouraud's and affine spans, not clipped to CLIP_VERTICES; alone,
                            polygon_draw and polygons_draw refuse all else
       WITH_POLYGONS        convex polygons, and triangles if WITH_TRIANGLES is not there
       WITH_SNAPPED         triangle_tables_make's routines for EDGES_SNAPPED, of the mappers that are named; and
                            WITH_POLYGONS, for triangles that are not all inside the frame
   Mappers: WITH_FLAT, WITH_GOURAUD, WITH_AFFINE, WITH_ARBITRARY, WITH_TILED, WITH_COLUMNS, WITH_GENERATED, WITH_LIT,
       WITH_LIT_GOURAUD, WITH_DITHERED, WITH_KEYED; a map for another one is refused with POLYGON_WRONG_MAP
   Pixels: of a byte; WITH_16, WITH_32: of two and four; frames of others are refused with POLYGON_WRONG_MAP.
       Snapped triangles do not ask which of the two is named, if one is: material_is_named does
   Cheaper spans with the same picture; others draw instead:
       WITH_ROWS            rows, columns and copies, where u or v stays the same along lines
       WITH_SHORT           unrolled code for short lines
   Settings, beside all edges, GRADIENTS_PLANE and START_SUBTEXEL:
       WITH_STEEP           triangles that gradients of 32 bits are too coarse or too small for: 8 texels a pixel and
                            more, slivers, and those far larger than the frame. Without, they show one texel.
                            A material's `whole` needs it too
       WITH_STARTS          GRADIENTS_POLYGON, START_TRUNCATED
       WITH_SCANLINE        GRADIENTS_SCANLINE
       WITH_CLIPPING        CLIP_VERTICES
       WITH_PERSPECTIVE     PERSPECTIVE_EVERY16 and EVERY8; without: drawn affine
       WITH_RECIPROCALS     their lines by reciprocals; without, reciprocals_make returns 0, and each piece is divided
       WITH_CURVES          PERSPECTIVE_PIXEL and FINE, and WITH_PERSPECTIVE; without: drawn as EVERY8
       WITH_FANS            polygons whose values are on no plane; without, they are taken as if they were
       WITH_COUNTS          counts of snapped polygons
       WITH_FORMS           FORM_SWAP, FORM_C, to measure them
   material_is_named (drawing/parts/named.h) says whether a material asks for no more than that. */
#ifndef DRAWING_PARTS_H
#define DRAWING_PARTS_H

#include "drawing/deep.h"
#include "drawing/dithered.h"
#include "drawing/draw.h"
#include "drawing/fan.h"
#include "drawing/generated.h"
#include "drawing/lower.h"
#include "drawing/material.h"
#include "drawing/outline.h"
#include "drawing/parts/named.h"
#include "drawing/three.h"
#include "drawing/ways.h"
#include "polygon/kind.h"
#include "polygon/shading.h"
#include "triangle/triangles.h"

/* Parts that others fall back on. */
#if defined(WITH_CURVES) || defined(WITH_RECIPROCALS)
#define WITH_PERSPECTIVE
#endif
#ifdef WITH_LIT_GOURAUD
#define WITH_LIT
#endif
#if defined(WITH_LIT) || defined(WITH_GENERATED) || defined(WITH_PERSPECTIVE)
#define WITH_AFFINE
#endif
#if defined(WITH_SNAPPED) || defined(WITH_PERSPECTIVE) || defined(WITH_SCANLINE) || defined(WITH_CLIPPING) \
    || defined(WITH_FANS) || defined(WITH_ARBITRARY) || defined(WITH_TILED) || defined(WITH_COLUMNS) || defined(WITH_GENERATED) \
    || defined(WITH_LIT) || defined(WITH_DITHERED) || defined(WITH_KEYED) || defined(WITH_FORMS)
#define WITH_POLYGONS
#endif

#include "drawing/parts/spans.h"

/* What is left out. Their arguments are not read. */
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"
#endif

#ifndef WITH_POLYGONS
/* Triangles alone. */
enum polygon_result polygon_draw_whole(struct renderer *renderer, const struct polygon *polygon,
                                       const struct material *material)
{
    struct three three;

    if (polygon->count != 3 || !three_set(&three, renderer, material))
        return POLYGON_REFUSED;
    return three_polygon(&three, polygon->vertices);
}

enum polygon_result polygon_draw_inside(struct renderer *renderer, const struct polygon *polygon,
                                        const struct material *material)
{
    return polygon_draw_whole(renderer, polygon, material);
}

enum polygon_result polygon_draw_beyond(struct renderer *renderer, const struct polygon *polygon,
                                        const struct material *material)
{
    return polygon_draw_whole(renderer, polygon, material);
}

enum polygon_result polygon_draw(struct renderer *renderer, const struct polygon *polygon,
                                 const struct material *material)
{
    return polygon_draw_whole(renderer, polygon, material);
}
#endif

#ifndef WITH_TRIANGLES
enum polygon_result polygon_draw_three(struct renderer *renderer, const struct polygon *polygon,
                                       const struct material *material)
{
    return polygon_draw_inside(renderer, polygon, material);
}

int32 three_set(struct three *three, const struct renderer *renderer, const struct material *material)
{
    return 0;
}

enum polygon_result three_polygon(struct three *three, const struct vertex *vertices)
{
    return POLYGON_REFUSED;
}

const struct polygon *three_run(struct three *three, const struct polygon *polygons, const struct polygon *end)
{
    return polygons;
}
#endif

#ifndef WITH_STARTS
enum polygon_result starts_find(struct setup *s)
{
    return POLYGON_REFUSED;
}

void three_starts(struct three *three)
{
}

void three_longest(void)
{
}
#endif

#ifndef WITH_STEEP
void texturing_plane(struct texturing *t, const struct sides *sides, const struct rectangle *box, enum chain chain)
{
    t->u = (uint32)sides->top->s;
    t->v = (uint32)sides->top->t;
    t->dudx = t->dvdx = t->dudy = t->dvdy = 0;
    t->wrap_bit = 0;
    t->wraps = 0;
}

void texturing_starts(const struct texturing *t, struct edge *edges, int32 count)
{
    for (; count > 0; count--, edges++) {
        edges->u = t->u;
        edges->v = t->v;
        edges->du = edges->dv = 0;
    }
}
#endif

#ifndef WITH_SCANLINE
void scanline_make(struct setup *s)
{
}

void scanline_draw(struct setup *s, const struct cover *cover)
{
}
#endif

#ifndef WITH_CLIPPING
enum polygon_result outline_clipped(struct setup *s, int32 chain)
{
    return POLYGON_REFUSED;
}
#endif

#ifndef WITH_FANS
uint32 polygon_planar(struct scratch *scratch, const struct vertex *places, const struct vertex *values,
                      int32 count, uint32 asked)
{
    return asked;
}

int32 polygon_may_be_fan(const struct renderer *renderer, const struct polygon *polygon,
                         const struct material *material)
{
    return 0;
}

int32 polygon_is_fan(const struct renderer *renderer, const struct polygon *polygon,
                     const struct material *material)
{
    return 0;
}

enum polygon_result polygon_fan(polygon_routine *draw, struct renderer *renderer, const struct polygon *polygon,
                                const struct material *material)
{
    return POLYGON_REFUSED;
}
#endif

#include "drawing/parts/perspective.h"

#if !defined(WITH_PERSPECTIVE) && !defined(WITH_GOURAUD) && !defined(WITH_GENERATED) && !defined(WITH_LIT)
void lower_by_vertices(struct setup *s)
{
}
#endif

#if !defined(WITH_GOURAUD) && !defined(WITH_LIT) && !defined(WITH_DITHERED) && !defined(WITH_KEYED) \
    && !defined(WITH_16) && !defined(WITH_32)
void lower_others(struct setup *s)
{
}
#endif

#if !defined(WITH_ROWS) && !defined(WITH_SHORT)
void lower_by_steps(struct setup *s)
{
    if (s->kind != SPAN_AFFINE_ADDX_WRAP)
        lower_others(s);
    else if (!s->texturing.wraps)
        s->kind = SPAN_AFFINE_ADDX;
}
#endif

#ifndef WITH_GOURAUD
enum polygon_result three_shaded(struct three *three, const struct vertex *given, const struct vertex *made)
{
    return POLYGON_REFUSED;
}
#endif

#if !defined(WITH_GOURAUD) && !defined(WITH_ARBITRARY)
void clamp_lines(struct setup *s)
{
}
#endif

#ifndef WITH_GENERATED
int32 generated_may_draw(const struct setup *s)
{
    return 0;
}

void generated_span(struct setup *s)
{
}
#endif

#ifndef WITH_LIT
int32 shading_light(struct span_plan *span, const struct material *material, fix16 shade)
{
    return 0;
}

void shading_lines(struct setup *s, uint32 *shades)
{
}
#endif

#ifndef WITH_COLUMNS
int32 column_layout_make(struct column_layout *layout, int32 width, int32 height)
{
    return 0;
}
#endif

#ifndef WITH_DITHERED
void dithered_span(struct setup *s)
{
}
#endif

#ifndef WITH_KEYED
void outline_opaque(struct setup *s)
{
}
#endif

#ifndef WITH_COUNTS
void polygon_count_snapped(struct renderer *renderer, const struct polygon *polygon,
                           const struct material *material, enum span_kind kind)
{
}
#endif

/* Snapped triangles: what is left out draws none of its list. */
#ifdef WITH_SNAPPED
#ifndef WITH_FLAT
const struct triangle *triangles_flat(struct triangle_plan *plan)
{
    return plan->list;
}
#endif

#ifndef WITH_GOURAUD
const struct triangle *triangles_gouraud(struct triangle_plan *plan)
{
    return plan->list;
}
#endif

#if !defined(WITH_AFFINE) && !defined(WITH_ARBITRARY)
const struct triangle *triangles_affine(struct triangle_plan *plan)
{
    return plan->list;
}
#endif

#if !defined(WITH_16) && !defined(WITH_32)
const struct triangle *triangle_lines_flat(struct triangle_plan *plan)
{
    return plan->list;
}

#ifndef WITH_LIT
const struct triangle *triangle_lines_addx(struct triangle_plan *plan)
{
    return plan->list;
}
#endif
#endif

#ifndef WITH_LIT_GOURAUD
const struct triangle *triangle_lines_levels(struct triangle_plan *plan)
{
    return plan->list;
}
#endif
#endif

#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

#endif
