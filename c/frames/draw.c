#include "frames/frames.h"

#include "frames/draw_meshes.h"
#include "frames/draw_touched.h"
#include "math/math.h"
#include "polygon/kind.h"
#include "polygon/scratch.h"
#include "scene/load.h"
#include "span/box.h"

/* Fills a box, whose sides are at multiples of 4 pixels, with the background. */
static void clear_box(const struct frame *frame, const struct rectangle *box, uint32 colour)
{
    const int32 bytes = frame->pixel_bytes;
    struct box_plan plan;

    plan.first = (uint32 *)(frame->pixels + box->top * frame->pitch + box->left * bytes);
    plan.longwords = (box->right - box->left) * bytes >> 2;
    plan.rows = box->bottom - box->top;
    plan.pitch = frame->pitch;
    if (plan.longwords * 4 == plan.pitch) {     /* rows that follow each other are one */
        plan.longwords *= plan.rows;
        plan.rows = 1;
    }
    plan.pixels = bytes == 4 ? colour : bytes == 2 ? colour * 0x10001u : colour * 0x1010101u;
    box_fill(&plan);
}

/* Clears the pixels that may differ from the background; touched 0: all. */
static void clear(const struct frame *frame, const struct touched *touched, uint32 colour)
{
    struct rectangle box;

    if (!touched) {
        box.left = box.top = 0;
        box.right = frame->width;
        box.bottom = frame->height;
        clear_box(frame, &box, colour);
        return;
    }
    for (touched_next(touched, 0, &box); box.top < box.bottom; touched_next(touched, box.bottom, &box))
        clear_box(frame, &box, colour);
}

/* Moves vertices by a pose. */
static void place(struct vertex *to, const struct vertex *from, uint32 count,
                  const struct scene_pose *pose)
{
    const int32 upright = pose->xx == 65536 && pose->yy == 65536 && !pose->xy && !pose->yx;

    for (; count; count--, from++, to++) {
        to->x = from->x + pose->x0;
        to->y = from->y + pose->y0;
        if (!upright) {
            to->x = mul_fix(pose->xx, from->x) + mul_fix(pose->xy, from->y) + pose->x0;
            to->y = mul_fix(pose->yx, from->x) + mul_fix(pose->yy, from->y) + pose->y0;
        }
        to->s = from->s;
        to->t = from->t;
        to->shade = from->shade;
        to->w = from->w;
    }
}

/* Draws polygons of a material; returns `refused`, or why one of them was. */
static enum polygon_result draw_run(struct renderer *renderer, const struct scene *scene, const struct polygon *end,
                                    const struct material *material, enum polygon_result refused)
{
    const struct polygon *const run = scene->scratch->run;
    enum polygon_result result;

    if (scene->touched)
        for (const struct polygon *polygon = run; polygon < end; polygon++)
            touched_vertices(scene->touched, polygon->vertices, polygon->count);
    result = end == run + 1
        ? material->draw(renderer, run, material)
        : polygons_draw(renderer, run, (int32)(end - run), material);

    return result > POLYGON_EMPTY ? result : refused;
}

/* Draws objects first to end (excluded). Those that polygon_draw draws and that have the same material
   are drawn together if no other is between them. */
static enum polygon_result draw_objects(struct renderer *renderer, const struct scene *scene,
                                        int32 number, uint32 first, uint32 end)
{
    enum polygon_result refused = POLYGON_DRAWN;
    const struct scene_object *object = &scene->objects[first];
    const struct scene_object *const objects_end = &scene->objects[end];
    struct polygon *const run = scene->scratch->run;
    struct polygon *last = run, *full = run;
    struct vertex *room = scene->scratch->placed;
    uint32 left = 0;            /* places in the room */
    const struct material *material = scene->drawn;
    uint32 of_run = 0;

    for (; object < objects_end; object++) {
        uint32 age = (uint32)number - object->first_frame;      /* huge before the first */
        const struct vertex *vertices;

        if (age >= object->poses)
            continue;
        if (object->material != of_run || last == full || object->vertices > left) {
            if (last != run)
                refused = draw_run(renderer, scene, last, material, refused);
            material = &scene->drawn[object->material];
            last = run;
            room = scene->scratch->placed;
            left = RUN_VERTICES;
            of_run = object->material;
            full = &run[material->draw == polygon_draw ? RUN_POLYGONS : 1];
        }
        vertices = &scene->vertices[object->vertex];
        if (object->pose != NO_POSE) {
            place(room, vertices, object->vertices, &scene->poses[(uint32)object->pose + age]);
            vertices = room;
            room += object->vertices;
            left -= object->vertices;
        }
        polygon_set(last++, vertices, (int32)object->vertices, object->planar);
    }
    return last == run ? refused : draw_run(renderer, scene, last, material, refused);
}

/* Draws all objects and instances. */
static enum polygon_result draw_all(struct renderer *renderer, const struct scene *scene,
                                    int32 number)
{
    const struct scene_header *header = scene->header;
    enum polygon_result refused = POLYGON_DRAWN, result;
    uint32 object = 0, instance = 0;

    renderer->reciprocals = scene->reciprocals;
    renderer->triangles = scene->triangles;
    while (instance < header->instances) {      /* those with the same `before` together */
        uint32 before = scene->instances[instance].before, first = instance;

        result = draw_objects(renderer, scene, number, object, before);
        refused = result == POLYGON_DRAWN ? refused : result;
        while (instance < header->instances && scene->instances[instance].before == before)
            instance++;
        result = mesh_draw(renderer, scene, number, first, instance);
        refused = result == POLYGON_DRAWN ? refused : result;
        object = before;
    }
    result = draw_objects(renderer, scene, number, object, header->objects);
    return result == POLYGON_DRAWN ? refused : result;
}

enum polygon_result scene_draw_over(struct renderer *renderer, struct scene *scene, int32 number,
                                    struct touched *touched)
{
    const struct scene_header *header = scene->header;
    enum polygon_result result;

    if (header->units)
        scene_start_units(scene, number);
    if (header->cleared)
        clear(renderer->frame, touched, header->background);
    if (touched)
        touched_clear(touched);
    scene->touched = touched;
    result = draw_all(renderer, scene, number);
    scene->touched = 0;
    return result;
}

enum polygon_result scene_draw(struct renderer *renderer, struct scene *scene, int32 number)
{
    return scene_draw_over(renderer, scene, number, 0);
}

void scene_count(struct renderer *renderer, struct scene *scene, int32 number,
                 struct draw_counts *counts)
{
    renderer->counts = counts;
    renderer->only_counts = 1;
    draw_all(renderer, scene, number);
    renderer->counts = 0;
    renderer->only_counts = 0;
}
