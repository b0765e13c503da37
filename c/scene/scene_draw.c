#include "scene/scene.h"

#include "polygon/plane.h"
#include "span/scanline.h"

/* The background is a span of the whole width on every line. */
static void clear(const struct frame *frame, uint32 colour)
{
    static struct scanline lines[SCENE_SIDE_MAX];
    struct span_plan plan;

    for (int32 i = 0; i < frame->height; i++) {
        lines[i].left = EDGE_BIAS;
        lines[i].count = (int16)frame->width;
    }
    plan.lines = lines;
    plan.count = frame->height;
    plan.row = frame->pixels - EDGE_BIAS;
    plan.pitch = frame->pitch;
    plan.colour = colour;
    span_fill(&plan);
}

static void place(struct vertex *to, const struct scene_vertex *from, uint32 count,
                  const struct scene_pose *pose)
{
    for (; count; count--, from++, to++) {
        to->x = mul_fix(pose->xx, from->x) + mul_fix(pose->xy, from->y) + pose->x0;
        to->y = mul_fix(pose->yx, from->x) + mul_fix(pose->yy, from->y) + pose->y0;
        to->s = from->s;
        to->t = from->t;
        to->shade = 0;
    }
}

void scene_draw(const struct scene *scene, const struct frame *frame, int32 number,
                enum form form, struct draw_counts *counts)
{
    const struct scene_object *object = scene->objects;
    struct vertex vertices[POLYGON_VERTICES_MAX];

    clear(frame, scene->header->background);
    for (uint32 i = 0; i < scene->header->objects; i++, object++) {
        const struct scene_material *from = &scene->materials[object->material];
        uint32 age = (uint32)number - object->first_frame;
        struct material material;
        struct map map;

        if ((uint32)number < object->first_frame || age >= object->poses)
            continue;
        map.texels = scene->maps + (uint32)from->texture * MAP_BYTES;
        map.width = map.height = MAP_PAGE_SIDE;
        map.scale = 65536;
        material.map = from->texture == NO_TEXTURE ? 0 : &map;
        material.mapper = material.map ? MAPPER_AFFINE : MAPPER_FLAT;
        material.colour = from->colour;
        material.edges = EDGES_SUBPIXEL;
        material.gradients = GRADIENTS_PLANE;
        material.start = START_SUBTEXEL;
        material.clip = CLIP_SCISSOR;
        place(vertices, &scene->vertices[object->vertex], object->vertices,
              &scene->poses[object->pose + age]);
        polygon_draw(frame, vertices, (int32)object->vertices, &material, form, counts);
    }
}
