#include "frames/draw_bodies.h"

/* Lines. A body of more is hidden so rarely that counting its pixels costs more than it saves. */
#define BODY_LARGE 64

/* Sets the bodies that are outside of the frame; the others wait, if what hides them can be told. */
static void look_at(struct bodies *bodies, struct scene_bodies *all, int32 number, struct body_space *space)
{
    const struct scene *const scene = bodies->scene;
    const struct near_walk *const walk = bodies->walk;
    uint32 mark = 1;

    for (uint32 i = all->first; i < all->end; i++) {
        const struct scene_instance *const o = &scene->instances[i];
        const uint32 age = (uint32)number - o->first_frame;
        const struct scene_view *const view = &scene->views[o->view + age];
        const struct scene_mesh *const mesh = &scene->meshes[o->mesh];
        struct body *const body = &all->each[i];
        fix16 depth;

        if (age >= o->views)
            continue;
        body->is_out = body_is_outside(body, view, &walk->frame, &depth);
        if (body->is_out)
            continue;
        body->state = BODY_PLAIN;
        if (space && body_begin(body, view, walk, space, depth)
            && !body_is_edge_on(&scene->faces[mesh->face], mesh->faces, view, walk->frame.near_plane)) {
            body->state = BODY_WAITING;
            bodies->waiting++;
        }
        body->mark = mark;
        if (mark < 1u << BODIES_TOLD)
            mark <<= 1;
        body->next = bodies->in_frame;
        bodies->in_frame = body;
    }
}

void bodies_begin(struct bodies *bodies, const struct scene *scene, const struct near_walk *walk, int32 number)
{
    struct scene_bodies *const all = scene->near->bodies;
    struct body_space space;

    bodies->scene = scene;
    bodies->walk = walk;
    bodies->in_frame = 0;
    bodies->waiting = bodies->met = 0;
    if (all && all->first < all->end)
        look_at(bodies, all, number, body_set_space(&space, walk) ? &space : 0);
}

static int32 shares_pixels(const struct rectangle *a, const struct rectangle *b)
{
    return a->left <= b->right && a->right >= b->left && a->top <= b->bottom && a->bottom >= b->top;
}

static void set_frame(struct frame *frame, const struct bodies *bodies)
{
    frame->width = bodies->scene->header->width;
    frame->height = bodies->scene->header->height;
}

/* Returns how many pixels that a body and the face share are not covered. */
static int32 open_pixels(const struct bodies *bodies, const struct body *body)
{
    const struct rectangle *const a = &body->pixels, *const b = &bodies->box;
    struct rectangle shared;
    struct frame frame;

    shared.left = a->left > b->left ? a->left : b->left;
    shared.right = a->right < b->right ? a->right : b->right;
    shared.top = a->top > b->top ? a->top : b->top;
    shared.bottom = a->bottom < b->bottom ? a->bottom : b->bottom;
    set_frame(&frame, bodies);
    return coverage_open(bodies->scene->coverage, &frame, &shared);
}

/* Sets whether a body is hidden by what is drawn, all of which is in front of it there. */
static int32 is_hidden(const struct bodies *bodies, struct body *body)
{
    struct frame frame;

    set_frame(&frame, bodies);
    body->is_out = coverage_hides_box(bodies->scene->coverage, &frame, &body->pixels);
    return body->is_out;
}

static void set_box(struct rectangle *to, const struct near_face *face, int32 is_near)
{
    to->left = is_near ? -NEAR_FAR : face->box[0];
    to->right = is_near ? NEAR_FAR : face->box[1];
    to->top = is_near ? -NEAR_FAR : face->box[2];
    to->bottom = is_near ? NEAR_FAR : face->box[3];
}

/* A face that may not be in front of a body which waits: the body is hidden, or met if the face may be seen there. */
static void meet(struct bodies *bodies, struct body *body)
{
    const int32 is_large = body->pixels.bottom - body->pixels.top > BODY_LARGE;

    body->open = is_large ? 1 : open_pixels(bodies, body);
    if (!body->open)
        return;
    bodies->waiting--;
    body->state = BODY_KNOWN;
    if (!is_hidden(bodies, body) && !is_large) {
        body->state = BODY_MET;
        bodies->met++;
    }
}

void bodies_meet(struct bodies *bodies, const struct near_face *face, int32 is_near)
{
    const int32 is_edge_on = face->above < (face->near_plane >> BODY_EDGE_ON) + BODY_ROUNDED;

    bodies->marks = 0;
    set_box(&bodies->box, face, is_near);
    for (struct body *body = bodies->in_frame; body; body = body->next) {
        int32 side = 0;

        if (body->is_out)
            continue;
        if (body->state != BODY_PLAIN) {
            if (!shares_pixels(&body->pixels, &bodies->box))
                continue;
            if (!is_edge_on)
                side = body_side(body, face->slot->face);
            if (body->state == BODY_WAITING && side <= 0)
                meet(bodies, body);
        }
        if (side >= 0)
            bodies->marks |= body->mark;
    }
}

void bodies_pass(struct bodies *bodies)
{
    for (struct body *body = bodies->in_frame; bodies->met; body = body->next)
        if (body->state == BODY_MET) {
            const int32 waits = open_pixels(bodies, body) == body->open;

            bodies->met--;
            bodies->waiting += waits;
            body->state = waits ? BODY_WAITING : BODY_KNOWN;
        }
}

uint32 bodies_end(struct bodies *bodies)
{
    uint32 marks = 0;

    for (struct body *body = bodies->in_frame; body; body = body->next)
        if (!body->is_out && !(body->state == BODY_WAITING && is_hidden(bodies, body)))
            marks |= body->mark;
    return marks;
}
