/* Cache keys: the longs from which a cached result was made. */
#ifndef KEY_H
#define KEY_H

#include "compiler.h"

/* Copies key to kept; returns non-zero if they differed. */
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
