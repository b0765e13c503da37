/* Leaves instances with TREE_Z out that a tree hides, whose faces are drawn from the nearest on. */
#ifndef DRAW_BODIES_H
#define DRAW_BODIES_H

#include "scene/scene.h"

enum { BODIES_TOLD = 31 };      /* bits of marks that have one body; the last bit has all others */

/* The bodies of a frame that are looked for. */
struct bodies {
    const struct scene *scene;
    const struct near_walk *walk;
    struct body *in_frame;      /* those inside its borders */
    int32 waiting;              /* bodies behind all that is drawn at their pixels */
    int32 met;                  /* bodies that were until the face that is drawn now */
    struct rectangle box;       /* pixels that have all of this face's, both ends included */
    uint32 marks;               /* of bodies that it may hide */
};

/* Begins with a walk that has begun; number: of the frame. */
void bodies_begin(struct bodies *bodies, const struct scene *scene, const struct near_walk *walk, int32 number);

/* The face that was found last may be drawn; is_near: it is not all before the near plane. Looks whether bodies are
   hidden that it may not be in front of. */
void bodies_meet(struct bodies *bodies, const struct near_face *face, int32 is_near);

/* It is drawn: bodies wait on if no pixel of it is around them. */
void bodies_pass(struct bodies *bodies);

/* All is drawn. Returns the marks of bodies that may be seen. */
uint32 bodies_end(struct bodies *bodies);

#endif
