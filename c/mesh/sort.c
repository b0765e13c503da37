#include "mesh/mesh.h"

/* Merges two lists; of the same order those of the first list come first. */
static struct mesh_face *merged(struct mesh_face *a, struct mesh_face *b)
{
    struct mesh_face *first, **to = &first;

    while (a && b)
        if (a->order <= b->order) {
            *to = a;
            to = &a->next;
            a = a->next;
        } else {
            *to = b;
            to = &b->next;
            b = b->next;
        }
    *to = a ? a : b;
    return first;
}

/* Sorts the first faces of an array; there is at least one. */
static struct mesh_face *sorted(struct mesh_face *faces, int32 count)
{
    if (count == 1) {
        faces->next = 0;
        return faces;
    }
    return merged(sorted(faces, count >> 1), sorted(faces + (count >> 1), count - (count >> 1)));
}

struct mesh_face *mesh_sort(struct mesh_face *faces, int32 count, struct mesh_face **at)
{
    struct mesh_face *first;

    if (!count)
        return 0;
    first = mesh_spread(faces, count, at);
    return first ? first : sorted(faces, count);
}
