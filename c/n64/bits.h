#ifndef N64_BITS_H
#define N64_BITS_H

#include "compiler.h"

/* Returns bits high to low of a word; never all 32. */
static inline uint32 n64_bits(uint32 word, uint32 high, uint32 low)
{
    return word >> low & ((2u << (high - low)) - 1);
}

/* Return the low 9 or 17 bits as a signed number. */
static inline int32 n64_signed_9(int32 value)
{
    return ((value & 0x1ff) ^ 0x100) - 0x100;
}

static inline int32 n64_signed_17(int32 value)
{
    return ((value & 0x1ffff) ^ 0x10000) - 0x10000;
}

#endif
