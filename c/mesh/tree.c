#include "mesh/mesh.h"

void mesh_fill(struct mesh_face **slots, const struct scene_slot *slot, const struct scene_face *face,
               struct mesh_face *seen, int32 count)
{
    for (; count > 0; face++, slot++)
        if (face == seen->face) {
            slots[slot->slot] = seen++;
            count--;
        }
}
