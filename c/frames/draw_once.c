/* Draws faces of instances each pixel once: from the nearest to the farthest, what is hidden left out. */
#include "coverage/coverage.h"
#include "frames/draw_meshes.h"

static struct mesh_face *reversed(struct mesh_face *face)
{
    struct mesh_face *before = 0;

    while (face) {
        struct mesh_face *const next = face->next;

        face->next = before;
        before = face;
        face = next;
    }
    return before;
}

enum polygon_result mesh_draw_once(struct renderer *renderer, const struct scene *scene,
                                   struct mesh_face *face)
{
    struct coverage *const coverage = scene->coverage;
    enum polygon_result refused = POLYGON_DRAWN;
    struct mesh_face *const nearest = reversed(face);

    coverage_begin(coverage, renderer->frame);
    renderer->coverage = coverage;
    for (face = nearest; face && (coverage->open || renderer->only_counts); face = face->next) {
        const enum polygon_result result = mesh_draw_face(renderer, scene, face, coverage_draw);

        if (result > POLYGON_EMPTY)
            refused = result;
        if (coverage->overflow && !renderer->only_counts)
            break;
    }
    face = reversed(nearest);
    if (coverage->overflow && !renderer->only_counts)
        return mesh_draw_faces(renderer, scene, face);
    return refused;
}
