#include "frames/frames.h"

#include "frames/draw_meshes.h"
#include "math/math.h"
#include "polygon/kind.h"
#include "polygon/scratch.h"

enum { CLEAR_MOST = 16384 };    /* pixels of a span, which a scanline can have */

/* Fills the frame with flat spans of the whole width, or of some lines where they are one behind the other. */
static void clear(const struct renderer *renderer, uint32 colour)
{
    const struct frame *frame = renderer->frame;
    struct scanline *lines = renderer->scratch->lines;
    struct span_plan plan;
    int32 width = frame->width, height = frame->height;

    if (frame->pitch == width * frame->pixel_bytes)
        for (; !(height & 1) && width <= CLEAR_MOST / 2; height >>= 1)
            width <<= 1;
    for (int32 i = 0; i < height; i++) {
        lines[i].left = EDGE_BIAS;
        lines[i].last = (int16)(EDGE_BIAS + width - 1);
    }
    plan.lines = lines;
    plan.count = height;
    plan.row = frame->pixels - EDGE_BIAS * frame->pixel_bytes;
    plan.pitch = width == frame->width ? frame->pitch : width * frame->pixel_bytes;
    plan.colour = colour;
    if (frame->pixel_bytes == 4)
        span_fill_32(&plan);
    else if (frame->pixel_bytes == 2)
        span_fill_16(&plan);
    else
        span_fill(&plan);
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
static enum polygon_result draw_run(struct renderer *renderer, const struct polygon *run,
                                    const struct polygon *end, const struct material *material,
                                    enum polygon_result refused)
{
    const enum polygon_result result = end == run + 1
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
                refused = draw_run(renderer, run, last, material, refused);
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
    return last == run ? refused : draw_run(renderer, run, last, material, refused);
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

enum polygon_result scene_draw(struct renderer *renderer, struct scene *scene, int32 number)
{
    if (scene->header->units)
        scene_start_units(scene, number);
    if (scene->header->cleared)
        clear(renderer, scene->header->background);
    return draw_all(renderer, scene, number);
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
