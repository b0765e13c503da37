#include "mesh/mesh.h"

enum { DIGIT_BITS = 8, DIGITS = MESH_SORT_DIGITS };

/* One pass by one byte; 0 where it is the same in all, and nothing moved. */
static int32 pass(struct mesh_face *to, const struct mesh_face *from, int32 count, uint32 shift,
                  int32 *at)
{
    int32 sum = 0;

    for (int32 i = 0; i < DIGITS; i++)
        at[i] = 0;
    for (int32 i = 0; i < count; i++)
        at[from[i].order >> shift & (DIGITS - 1)]++;
    if (at[from->order >> shift & (DIGITS - 1)] == count)
        return 0;
    for (int32 i = 0; i < DIGITS; i++) {
        int32 here = at[i];

        at[i] = sum;
        sum += here;
    }
    for (; count > 0; count--, from++)
        to[at[from->order >> shift & (DIGITS - 1)]++] = *from;
    return 1;
}

/* Insertion sort, for 16 faces or fewer. */
static void insert(struct mesh_face *faces, int32 count)
{
    for (int32 i = 1; i < count; i++) {
        struct mesh_face face = faces[i];
        int32 at = i;

        for (; at > 0 && faces[at - 1].order > face.order; at--)
            faces[at] = faces[at - 1];
        faces[at] = face;
    }
}

struct mesh_face *mesh_sort(struct mesh_face *faces, struct mesh_face *room, int32 count,
                            int32 *digits)
{
    if (count <= 16) {
        insert(faces, count);
        return faces;
    }
    for (uint32 shift = 0; shift < 32; shift += DIGIT_BITS)
        if (pass(room, faces, count, shift, digits)) {
            struct mesh_face *sorted = room;

            room = faces;
            faces = sorted;
        }
    return faces;
}
