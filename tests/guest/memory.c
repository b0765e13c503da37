/* memory - lists the free pieces of memory, in exec's order: the attributes of their kind, first address and
   bytes. */
#include "system/system.h"
#include "system/text.h"

struct piece {
    const struct piece *next;
    uint32 bytes;
};

/* A header of exec's list. */
struct header {
    const struct header *next, *before;
    uint16 type, name[2], attributes;
    const struct piece *first;
};

int main(void)
{
    const struct header *header = (const struct header *)mem_lists();

    for (; header->next; header = header->next)
        for (const struct piece *piece = header->first; piece; piece = piece->next) {
            text_number(header->attributes);
            text_add(" ");
            text_number((int32)piece);
            text_add(" ");
            text_number((int32)piece->bytes);
            text_print();
        }
    return RETURN_OK;
}
