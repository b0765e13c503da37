/* Draws faces with TREE_Z: which of their pixels are seen is decided pixel by pixel. */
#include "frames/draw_meshes.h"

void mesh_depths_begin(const struct scene *scene, const struct mesh_face *face)
{
    depths_begin(scene->depths);
    for (; face; face = face->next) {
        int32 count;
        const struct vertex *vertices = mesh_face_vertices(scene, face, &count);

        if (count >= 3)
            depths_include(scene->depths, vertices, count);
    }
    depths_clear(scene->depths);
}

void mesh_depths_fill(struct renderer *renderer, const struct scene *scene, const struct mesh_face *face)
{
    for (; face; face = face->next) {
        int32 count;
        const struct vertex *vertices = mesh_face_vertices(scene, face, &count);

        if (count >= 3)
            depths_fill(renderer, scene->depths, vertices, count, face->placed->material);
    }
}

enum polygon_result mesh_depths_draw(struct renderer *renderer, const struct scene *scene,
                                     const struct mesh_face *face)
{
    enum polygon_result refused = POLYGON_DRAWN;
    const struct frame *const frame = renderer->frame;

    for (; face; face = face->next) {
        const struct material *const material = face->placed->material;
        int32 count;
        const struct vertex *vertices = mesh_face_vertices(scene, face, &count);
        enum polygon_result result;

        if (count < 3)
            continue;
        if (material->mapper == MAPPER_KEYED)
            depths_blank(renderer, scene->depths, vertices, count, material);
        renderer->frame = &scene->depths->aside;
        result = mesh_draw_polygon(renderer, vertices, count, face->placed);
        renderer->frame = frame;
        if (result == POLYGON_DRAWN)
            depths_copy(renderer, scene->depths, vertices, count, material);
        else if (result != POLYGON_EMPTY)
            refused = result;
    }
    return refused;
}
