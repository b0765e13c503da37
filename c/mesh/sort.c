#include "mesh/mesh.h"

enum {
    BUCKETS = MESH_SORT_BUCKETS,
    FEW = 16                    /* sorted by insertion */
};

static void insert(struct mesh_face *faces, int32 count)
{
    for (int32 i = 1; i < count; i++) {
        struct mesh_face face;
        int32 at = i;

        if (faces[i - 1].order <= faces[i].order)
            continue;
        face = faces[i];
        for (; at > 0 && faces[at - 1].order > face.order; at--)
            faces[at] = faces[at - 1];
        faces[at] = face;
    }
}

/* Where orders fall into buckets of equal width. */
struct buckets {
    uint32 least, shift;
    int32 is_crowded;           /* one has more than FEW faces, whose orders may differ */
};

static void find_buckets(struct buckets *buckets, const struct mesh_face *faces, int32 count)
{
    uint32 least = faces->order, greatest = least;

    for (; count > 0; count--, faces++) {
        least = faces->order < least ? faces->order : least;
        greatest = faces->order > greatest ? faces->order : greatest;
    }
    buckets->least = least;
    buckets->shift = 0;
    for (greatest -= least; greatest >= BUCKETS; greatest >>= 1)
        buckets->shift++;
}

/* Copies faces bucket by bucket. at: scratch memory. */
static void spread(struct buckets *buckets, struct mesh_face *to, const struct mesh_face *from,
                   int32 count, int32 *at)
{
    const uint32 least = buckets->least, shift = buckets->shift;
    int32 sum = 0, most = 0;

    for (int32 i = 0; i < BUCKETS; i++)
        at[i] = 0;
    for (int32 i = 0; i < count; i++)
        at[(from[i].order - least) >> shift]++;
    for (int32 i = 0; i < BUCKETS; i++) {
        const int32 here = at[i];

        most = here > most ? here : most;
        at[i] = sum;
        sum += here;
    }
    for (; count > 0; count--, from++)
        to[at[(from->order - least) >> shift]++] = *from;
    buckets->is_crowded = shift && most > FEW;
}

/* Sorts the crowded buckets of faces. */
static void sort_crowded(const struct buckets *buckets, struct mesh_face *faces,
                         struct mesh_face *room, int32 count, int32 *at)
{
    const uint32 least = buckets->least, shift = buckets->shift;

    for (int32 first = 0, end; first < count; first = end) {
        const uint32 bucket = (faces[first].order - least) >> shift;
        const struct mesh_face *sorted;

        for (end = first + 1; end < count && (faces[end].order - least) >> shift == bucket; end++)
            ;
        if (end - first <= FEW)
            continue;
        sorted = mesh_sort(&faces[first], &room[first], end - first, at);
        for (int32 i = first; sorted != &faces[first] && i < end; i++)
            faces[i] = room[i];
    }
}

struct mesh_face *mesh_sort(struct mesh_face *faces, struct mesh_face *room, int32 count,
                            int32 *at)
{
    struct buckets buckets;

    if (count <= FEW) {
        insert(faces, count);
        return faces;
    }
    find_buckets(&buckets, faces, count);
    spread(&buckets, room, faces, count, at);
    if (buckets.is_crowded)
        sort_crowded(&buckets, room, faces, count, at);
    insert(room, count);
    return room;
}
