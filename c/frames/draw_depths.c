/* Draws faces with TREE_Z: which of their pixels are seen is decided pixel by pixel. */
#include "frames/draw_meshes.h"

void mesh_depths_begin(const struct scene *scene, const struct mesh_face *face)
{
    struct polygon polygon;

    depths_begin(scene->depths);
    for (; face; face = face->next)
        if (mesh_face_polygon(&polygon, scene, face))
            depths_include(scene->depths, polygon.vertices, polygon.count);
    depths_clear(scene->depths);
}

/* Returns 1 if all corners of a face are farther than w; those of its part inside the frame's borders are, too. */
static int32 is_beyond(const struct mesh_face *face, fix16 w)
{
    const struct mesh_placed *placed = face->placed;
    const struct scene_corner *corner = &placed->corners[face->face->corner];

    if (placed->view16)         /* has only points that are off the screen */
        return 0;
    for (int32 left = (int32)face->face->corners; left > 0; left--, corner++)
        if (placed->points[corner->point].w <= w)
            return 0;
    return 1;
}

/* Returns 1 if all corners of a face are inside all borders, and its box meets no part where it may hide a tested one:
   its vertices need not be made. */
static int32 is_beside(const struct mesh_face *face, const struct depths *depths, int32 is_ordered)
{
    const struct mesh_placed *placed = face->placed;
    const struct scene_corner *corner = &placed->corners[face->face->corner];
    const struct mesh_point *p = &placed->points[corner->point];
    fix16 x_low = p->screen_x, x_high = x_low, y_low = p->screen_y, y_high = y_low;
    struct depth_part part;

    if (placed->view16 || p->outside)
        return 0;
    part.near = p->w;
    for (int32 left = (int32)face->face->corners - 1; left > 0; left--) {
        corner++;
        p = &placed->points[corner->point];
        if (p->outside)
            return 0;
        if (p->screen_x < x_low)
            x_low = p->screen_x;
        else if (p->screen_x > x_high)
            x_high = p->screen_x;
        if (p->screen_y < y_low)
            y_low = p->screen_y;
        else if (p->screen_y > y_high)
            y_high = p->screen_y;
        if (p->w < part.near)
            part.near = p->w;
    }
    return !depth_part_place(&part, &depths->aside, x_low, x_high, y_low, y_high)
        || !depths_meet(depths, &part, is_ordered);
}

void mesh_depths_fill(struct renderer *renderer, const struct scene *scene, const struct mesh_face *face,
                      int32 is_ordered, uint32 marks)
{
    const struct depths *const depths = scene->depths;
    struct polygon polygon;

    for (; face && depths->count; face = face->next)
        if (!(marks && !(face->order & marks)) && !(is_ordered && is_beyond(face, depths->far)) && !is_beside(face, depths, is_ordered)
            && mesh_face_polygon(&polygon, scene, face))
            depths_fill(renderer, depths, &polygon, face->placed->material, is_ordered);
}

/* Draws a polygon aside: of keyed materials all texels, as depths_copy leaves those out that are 0. */
static enum polygon_result draw_aside(struct renderer *renderer, const struct polygon *polygon,
                                      const struct material *material)
{
    struct material opaque;
    uint32 *to = (uint32 *)&opaque;
    const uint32 *from = (const uint32 *)material;

    if (material->mapper != MAPPER_KEYED)
        return mesh_draw_polygon(renderer, polygon, material);
    for (uint32 left = sizeof opaque / sizeof *to; left; left--)
        *to++ = *from++;
    opaque.mapper = MAPPER_AFFINE;
    return mesh_draw_polygon(renderer, polygon, &opaque);
}

enum polygon_result mesh_depths_draw(struct renderer *renderer, const struct scene *scene,
                                     const struct mesh_face *face)
{
    enum polygon_result refused = POLYGON_DRAWN;
    const struct frame *const frame = renderer->frame;

    for (; face; face = face->next) {
        const struct material *const material = face->placed->material;
        struct polygon polygon;
        enum polygon_result result;

        if (!mesh_face_polygon(&polygon, scene, face)
            || (!renderer->counts && depths_hide(scene->depths, polygon.vertices, polygon.count)))
            continue;
        renderer->frame = &scene->depths->aside;
        result = draw_aside(renderer, &polygon, material);
        renderer->frame = frame;
        if (result == POLYGON_DRAWN)
            depths_copy(renderer, scene->depths, &polygon, material);
        else if (result != POLYGON_EMPTY)
            refused = result;
    }
    return refused;
}
