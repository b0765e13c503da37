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

void mesh_depths_fill(struct renderer *renderer, const struct scene *scene, const struct mesh_face *face,
                      int32 is_ordered)
{
    const struct depths *const depths = scene->depths;
    struct polygon polygon;

    for (; face && depths->count; face = face->next)
        if (!(is_ordered && is_beyond(face, depths->far)) && mesh_face_polygon(&polygon, scene, face))
            depths_fill(renderer, depths, &polygon, face->placed->material, is_ordered);
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

        if (!mesh_face_polygon(&polygon, scene, face))
            continue;
        if (material->mapper == MAPPER_KEYED)
            depths_blank(renderer, scene->depths, &polygon, material);
        renderer->frame = &scene->depths->aside;
        result = mesh_draw_polygon(renderer, &polygon, face->placed);
        renderer->frame = frame;
        if (result == POLYGON_DRAWN)
            depths_copy(renderer, scene->depths, &polygon, material);
        else if (result != POLYGON_EMPTY)
            refused = result;
    }
    return refused;
}
