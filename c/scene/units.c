/* The texture engines of a scene and the display lists that set them up. */
#include "scene/load.h"

#include "n64/polygons/rectangle.h"
#include "system/system.h"
#include "system/text.h"

const char *scene_wrong_unit(const struct scene *scene)
{
    const struct scene_header *h = scene->header;
    const struct scene_list *list = scene->lists;
    const struct scene_unit *unit = scene->units;

    for (uint32 i = 0; i < h->lists; i++, list++)
        if (list->word > h->words || list->words > h->words - list->word)
            return "list.words";
    for (uint32 i = 0; i < h->units; i++, unit++)
        if ((unit->lists != 1 && unit->lists != (uint32)h->frames + 1) || unit->list > h->lists
            || unit->lists > h->lists - unit->list)
            return "unit.lists";
    return 0;
}

static enum n64_result run_list(const struct scene *scene, uint32 unit, uint32 number)
{
    const struct scene_list *list = &scene->lists[scene->units[unit].list + number];

    return n64_list_run(&scene->engines[unit].n64, &scene->words[list->word], list->words);
}

int32 scene_make_units(struct scene *scene, int32 kind)
{
    const struct scene_header *h = scene->header;
    const uint8 *dram = (const uint8 *)h + h->dram_at;

    if (!mem_alloc(&scene->engines, (int32)(h->units * sizeof *scene->engines), MEMORY_ANY))
        return 0;
    scene->n64_reciprocals = 0;
    for (uint32 i = 0; i < h->units; i++) {
        n64_unit_init(&scene->engines[i], dram, h->dram, kind, &scene->n64_reciprocals);
        run_list(scene, i, 0);
    }
    return 1;
}

static enum polygon_result draw_rectangle(struct renderer *renderer, const struct polygon *polygon,
                                          int32 flip, const struct material *material)
{
    const struct vertex *first = polygon->vertices, *last = &first[polygon->count - 1];
    struct n64_rectangle rectangle;

    rectangle.left = first->x >> 16;
    rectangle.top = first->y >> 16;
    rectangle.right = last->x >> 16;
    rectangle.bottom = last->y >> 16;
    rectangle.s = first->s;
    rectangle.t = first->t;
    rectangle.dsdx = last->s;
    rectangle.dtdy = last->t;
    rectangle.flip = flip;
    return n64_rectangle_draw(renderer, &rectangle, material);
}

static enum polygon_result draw_upright(struct renderer *renderer, const struct polygon *polygon,
                                        const struct material *material)
{
    return draw_rectangle(renderer, polygon, 0, material);
}

static enum polygon_result draw_flipped(struct renderer *renderer, const struct polygon *polygon,
                                        const struct material *material)
{
    return draw_rectangle(renderer, polygon, 1, material);
}

polygon_routine *scene_unit_routine(uint32 primitive)
{
    static polygon_routine *const routines[UNIT_PRIMITIVES] = {
        n64_polygon_draw, n64_polygon_draw_coloured, draw_upright, draw_flipped
    };

    return routines[primitive];
}

void scene_start_units(struct scene *scene, int32 number)
{
    for (uint32 i = 0; i < scene->header->units; i++)
        if (scene->units[i].lists > 1)
            run_list(scene, i, (uint32)number + 1);
}

static int32 refuse(const char *name, uint32 unit, uint32 list, uint32 command,
                    enum n64_result result)
{
    text_add(name);
    text_add(": unit ");
    text_number((int32)unit);
    text_add(", list ");
    text_number((int32)list);
    text_add(", command ");
    text_number((int32)command);
    return text_refuse("", n64_result_text(result));
}

int32 scene_try_units(const struct scene *scene, const char *name)
{
    for (uint32 i = 0; i < scene->header->units; i++)
        for (uint32 list = 0; list < scene->units[i].lists; list++) {
            enum n64_result result = run_list(scene, i, list);

            if (result != N64_DONE)
                return refuse(name, i, list, scene->engines[i].n64.command, result);
        }
    return 1;
}

const char *scene_why_refused(const struct scene *scene)
{
    enum n64_result result = N64_DONE;
    const char *pipe = scene_why_pipe_refused(scene);

    if (pipe)
        return pipe;
    for (uint32 i = 0; i < scene->header->units; i++)
        if (scene->engines[i].result != N64_DONE)
            result = scene->engines[i].result;
    return n64_result_text(result);
}
