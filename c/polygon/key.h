/* Cache keys: longs from which a cached result was made, compared before it is made again. */
#ifndef KEY_H
#define KEY_H

#include "compiler.h"

/* Copies the longs to those kept; returns non-zero if they differed. */
static inline uint32 key_differs(uint32 *kept, const uint32 *key, int32 count)
{
    uint32 differs = 0;

    for (int32 i = 0; i < count; i++) {
        differs |= key[i] ^ kept[i];
        kept[i] = key[i];
    }
    return differs;
}

#endif
