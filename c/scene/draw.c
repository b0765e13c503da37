#include "scene/scene.h"

#include "drawing/fan.h"
#include "math/math.h"
#include "scene/draw_meshes.h"
#include "span/scanline.h"

/* The background is a span of the whole width on every line. */
static void clear(const struct frame *frame, uint32 colour)
{
    static struct scanline lines[FRAME_SIDE_MAX];
    struct span_plan plan;

    for (int32 i = 0; i < frame->height; i++) {
        lines[i].left = EDGE_BIAS;
        lines[i].last = (int16)(EDGE_BIAS + frame->width - 1);
    }
    plan.lines = lines;
    plan.count = frame->height;
    plan.row = frame->pixels - EDGE_BIAS * frame->pixel_bytes;
    plan.pitch = frame->pitch;
    plan.colour = colour;
    if (frame->pixel_bytes == 4)
        span_fill_32(&plan);
    else if (frame->pixel_bytes == 2)
        span_fill_16(&plan);
    else
        span_fill(&plan);
}

/* The vertices as a pose has them: in place, or where they stand already. */
static const struct vertex *place(struct vertex *room, const struct vertex *from, uint32 count,
                                  const struct scene_pose *pose)
{
    int32 upright = pose->xx == 65536 && pose->yy == 65536 && !pose->xy && !pose->yx;
    struct vertex *to = room;

    if (upright && !pose->x0 && !pose->y0)
        return from;
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
    return room;
}

/* Objects first to end (excluded). drawing: of those that are planar; most are. */
static enum polygon_result draw_objects(const struct scene *scene, const struct frame *frame,
                                        int32 number, const struct drawing *drawing,
                                        uint32 first, uint32 end)
{
    enum polygon_result refused = POLYGON_DRAWN;
    const struct scene_object *object = &scene->objects[first];
    static struct vertex room[POLYGON_VERTICES_MAX];

    for (; first < end; first++, object++) {
        uint32 age = (uint32)number - object->first_frame;      /* huge before the first */
        const struct material *material;
        const struct vertex *vertices;
        enum polygon_result result;
        struct drawing other;

        if (age >= object->poses)
            continue;
        vertices = place(room, &scene->vertices[object->vertex], object->vertices,
                         &scene->poses[object->pose + age]);
        material = &scene->drawn[object->material];
        result = material->draw(frame, vertices, (int32)object->vertices, material,
                                planar_vouched(&other, drawing, object->planar));
        if (result != POLYGON_DRAWN && result != POLYGON_EMPTY)
            refused = result;
    }
    return refused;
}

enum polygon_result scene_draw(const struct scene *scene, const struct frame *frame,
                               int32 number, const struct drawing *drawing)
{
    const struct scene_header *header = scene->header;
    enum polygon_result refused = POLYGON_DRAWN, result;
    uint32 object = 0, instance = 0;
    struct drawing planar, in_space;
    struct mesh_target target;

    drawing = planar_vouched(&planar, drawing, PLANAR_ALL);
    target.frame = frame;
    target.number = number;
    if (header->units)
        scene_start_units(scene, number);
    clear(frame, header->background);
    while (instance < header->instances) {      /* those before one object are together */
        uint32 before = scene->instances[instance].before, first = instance;

        target.drawing = planar_vouched(&in_space, drawing, PLANAR_ALL - PLANAR_TEXELS);
        result = draw_objects(scene, frame, number, drawing, object, before);
        refused = result == POLYGON_DRAWN ? refused : result;
        while (instance < header->instances && scene->instances[instance].before == before)
            instance++;
        result = mesh_draw(scene, first, instance, &target);
        refused = result == POLYGON_DRAWN ? refused : result;
        object = before;
    }
    result = draw_objects(scene, frame, number, drawing, object, header->objects);
    return result == POLYGON_DRAWN ? refused : result;
}
