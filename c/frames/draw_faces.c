/* Draws faces of instances whose points are placed: in batches of triangles where routines for those
   can, else one by one, clipped if they cross a border. */
#include "frames/draw_meshes.h"

#include "drawing/fan.h"
#include "frames/draw_touched.h"
#include "mesh/near.h"
#include "polygon/setup.h"
#include "triangle/polygon.h"

/* A face is a plane in space, but on the screen its affine texels need not be on a plane; nor depths, which fog
   follows. */
static inline void set_polygon(struct polygon *polygon, const struct vertex *vertices, int32 count,
                               const struct mesh_placed *placed)
{
    polygon_set(polygon, vertices, count, PLANAR_ALL - PLANAR_TEXELS);
    if (placed->flags & MESH_FOG)
        polygon->planar = mesh_fade_planar(vertices, count);
}

/* Draws a polygon; with GRADIENTS_POLYGON as a fan of triangles, because clipping adds corners. */
static inline enum polygon_result draw_polygon(struct renderer *renderer, const struct polygon *polygon,
                                               const struct material *material, polygon_routine *draw)
{
    if (polygon->count == 3 || material->mapper == MAPPER_FLAT
        || material->gradients != GRADIENTS_POLYGON)
        return draw(renderer, polygon, material);
    return polygon_fan(draw, renderer, polygon, material);
}

/* Cuts a polygon in the camera's space that has points outside of borders; sets *count to the number of corners, below 3
   if nothing is left. */
static struct vertex *clipped(const struct scene *scene, struct vertex *vertices, int32 *count, uint32 outside)
{
    const struct scene_header *header = scene->header;
    struct near_frame frame;

    vertices = mesh_clip(scene->scratch->cut, vertices, count, header->near_plane, outside);
    if (*count >= 3) {
        frame.width = header->width;
        frame.height = header->height;
        frame.guard = header->guard;
        mesh_project(vertices, *count, &frame);
        if (scene->touched)
            touched_vertices(scene->touched, vertices, *count);
    }
    return vertices;
}

/* The same of a face whose vertices are on the screen. */
static struct vertex *cut_face(const struct scene *scene, const struct mesh_face *face,
                               struct vertex *vertices, int32 *count)
{
    const struct mesh_placed *placed = face->placed;
    const struct scene_corner *corner = &placed->corners[face->face->corner];
    uint32 outside = 0;

    for (int32 i = 0; i < *count; i++, corner++) {
        const struct mesh_point *p = &placed->points[corner->point];

        if (placed->view16)
            mesh_place_wide(scene, placed, corner->point, 1);
        vertices[i].x = p->x;
        vertices[i].y = p->y;
        vertices[i].w = p->w;
        outside |= p->outside;
    }
    return clipped(scene, vertices, count, outside);
}

/* Sets a vertex's x, y and w; returns the borders that it is outside of. */
static uint32 set_place(struct vertex *v, const struct mesh_placed *placed, uint32 point)
{
    const struct mesh_place *place = &placed->places[point];

    if (!placed->view16 || place->place < 0) {
        const struct mesh_point *p = &placed->points[point];

        v->x = p->screen_x;
        v->y = p->screen_y;
        v->w = p->w;
        return p->outside;
    }
    v->x = ((place->place >> 16) - SNAPPED_ONE) << (16 - SNAPPED_BITS);
    v->y = ((int16)place->place - (SNAPPED_ONE - 1)) << (16 - SNAPPED_BITS);
    v->w = place->depth << placed->view16->depth_shift;
    return 0;
}

/* Sets a vertex's s, t and shade. */
static void set_values(struct vertex *v, const struct scene *scene, const struct mesh_placed *placed,
                       const struct scene_corner *corner)
{
    const struct mesh_attributes *attributes = &placed->attributes[corner->normal];
    struct mesh_attributes made;

    v->s = corner->s;
    v->t = corner->t;
    v->shade = 0;
    if (placed->flags & MESH_LINKED) {
        v->shade = (placed->places[corner->point].u >> 4) - SNAPPED_RAISED;
        if (placed->flags & MESH_ENVIRONMENT) {     /* the place has texels, of any scale */
            mesh_make_texels(&made, &scene->normals[placed->mesh->normal + corner->normal], 1, placed->view);
            v->s = made.s;
            v->t = made.t;
        }
        return;
    }
    if (placed->flags & MESH_ENVIRONMENT) {
        v->s = attributes->s;
        v->t = attributes->t;
    }
    if (placed->flags & MESH_LIT)
        v->shade = attributes->shade;
}

/* Returns a face's corners on the screen from points that were transformed with 32-bit operands, and their number, below
   3 if nothing is left. */
static const struct vertex *wide_vertices(const struct scene *scene, const struct mesh_face *face, int32 *number)
{
    struct vertex *vertices = scene->scratch->face;
    const uint32 outside = mesh_vertices(face, vertices);

    *number = (int32)face->face->corners;
    if (outside)
        vertices = clipped(scene, vertices, number, outside);
    if (face->placed->flags & MESH_FOG)
        mesh_fade(vertices, *number, &face->placed->fog);
    return vertices;
}

/* The same from other points. */
static const struct vertex *other_vertices(const struct scene *scene, const struct mesh_face *face, int32 *number)
{
    struct vertex *vertices = scene->scratch->face;
    const struct mesh_placed *placed = face->placed;
    const struct scene_corner *corner = &placed->corners[face->face->corner];
    struct vertex *v = vertices;
    uint32 outside = 0;

    *number = (int32)face->face->corners;
    for (int32 i = *number; i > 0; i--, corner++, v++) {
        outside |= set_place(v, placed, corner->point);
        set_values(v, scene, placed, corner);
    }
    if (outside)
        vertices = cut_face(scene, face, vertices, number);
    if (placed->flags & MESH_FOG)
        mesh_fade(vertices, *number, &placed->fog);
    return vertices;
}

/* Returns a face's corners on the screen, made in scratch memory, and their number, below 3 if nothing is left. */
static inline const struct vertex *vertices_of(const struct scene *scene, const struct mesh_face *face,
                                               int32 *number)
{
    const struct mesh_placed *const placed = face->placed;

    return placed->view16 || placed->flags & MESH_LINKED ? other_vertices(scene, face, number)
                                                          : wide_vertices(scene, face, number);
}

static inline int32 face_polygon(struct polygon *polygon, const struct scene *scene, const struct mesh_face *face)
{
    int32 count;
    const struct vertex *vertices = vertices_of(scene, face, &count);

    if (count < 3)
        return 0;
    set_polygon(polygon, vertices, count, face->placed);
    return 1;
}

int32 mesh_face_polygon(struct polygon *polygon, const struct scene *scene, const struct mesh_face *face)
{
    return face_polygon(polygon, scene, face);
}

enum polygon_result mesh_draw_polygon(struct renderer *renderer, const struct polygon *polygon,
                                      const struct material *material)
{
    return draw_polygon(renderer, polygon, material, material->draw);
}

enum polygon_result mesh_draw_face(struct renderer *renderer, const struct scene *scene,
                                   const struct mesh_face *face, polygon_routine *draw)
{
    struct polygon polygon;

    return face_polygon(&polygon, scene, face)
         ? draw_polygon(renderer, &polygon, face->placed->material, draw) : POLYGON_EMPTY;
}

/* Draws faces of a list in batches, as many as routines for triangles can; returns the first that is
   left. */
static const struct mesh_face *draw_batches(struct mesh_batch *batch,
                                            const struct renderer *renderer,
                                            const struct mesh_face *face)
{
    const struct material *const material = face->placed->material;
    const enum span_kind kind = triangle_batch_kind(renderer, material);
    triangle_drawer *routine;
    const int32 is_shaded = material->mapper == MAPPER_GOURAUD;
    const int32 is_linked = (face->placed->flags & MESH_LINKED) != 0;
    struct triangle_plan plan;
    struct triangle_lines lines;
    struct gather_plan gather;

    if (kind == SPAN_KINDS
        || ((is_shaded || material->light) && !(face->placed->flags & MESH_LIT)))
        return face;
    routine = triangle_plan_set(&plan, kind, &lines, renderer, material);
    gather.vertices = batch->vertices;
    gather.list = batch->list;
    gather.full = &batch->list[BATCH_TRIANGLES - (TRIANGLE_CORNERS_MAX - 2)];
    gather.material = material;
    gather.flags = face->placed->flags;
    gather.values = material->mapper == MAPPER_FLAT ? GATHER_NONE
                  : is_shaded ? GATHER_SHADES
                  : material->light ? GATHER_LIT : GATHER_TEXELS;
    gather.scale = material->map && material->map->scale != 65536 ? material->map->scale : 0;
    do {
        gather.from = face;
        face = is_linked ? mesh_link(&gather) : mesh_gather(&gather);
        plan.list = gather.list;
        plan.end = gather.last;
        routine(&plan);
    } while (gather.last > gather.full && face);
    return face;
}

enum polygon_result mesh_draw_faces(struct renderer *renderer, const struct scene *scene,
                                    const struct mesh_face *face)
{
    enum polygon_result refused = POLYGON_DRAWN;

    while (face) {
        const struct mesh_face *const left = draw_batches(&scene->scratch->batch, renderer, face);
        enum polygon_result result;

        if (left != face) {
            face = left;
            continue;
        }
        result = mesh_draw_face(renderer, scene, face, face->placed->material->draw);
        if (result != POLYGON_DRAWN && result != POLYGON_EMPTY)
            refused = result;
        face = face->next;
    }
    return refused;
}
