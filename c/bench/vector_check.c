#include "bench/vector_check.h"

#include "bench/vector_file.h"
#include "glide/glide.h"
#include "n64/polygons/decode.h"

#define ANY 0xffff              /* any number of longs */

/* The number of longs of each operation. */
static const uint16 longs_of[VECTOR_CODES] = {
    0, 1, 1, 1, ANY, ANY, 2, 18, 6, ANY, 1, 1, 0, 0, 3, 4, 4, 3, 12, 3, ANY, 1, 0, 2, 1, 10, ANY,
    2, 1, 3,
    1, 1, 1, 1, 1, 4, 4, 6, 10, ANY, 0, 2, 1, 2, 2, 4, 1
};

/* The bits of a tile's fields, in the order of a line `tile`. */
static const uint8 tile_bits[] = {3, 3, 2, 9, 9, 4, 1, 1, 4, 4, 1, 1, 4, 4, 12, 12, 12, 12};

static int32 is_tile(const uint32 *values)
{
    for (uint32 i = 0; i < sizeof tile_bits; i++)
        if (values[i] >> tile_bits[i])
            return 0;
    return 1;
}

/* Returns 1 if `bytes` bytes from an address on are within `room`. */
static int32 in_memory(uint32 at, uint32 bytes, uint32 room)
{
    return at <= room && bytes <= room - at;
}

int32 vector_usable(uint32 code, const int32 *values, uint32 longs)
{
    const uint32 *const a = (const uint32 *)values;

    if (code >= VECTOR_CODES || (longs_of[code] != ANY && longs != longs_of[code]))
        return 0;
    switch (code) {
    case VECTOR_TMEM: return longs && in_memory(a[0], longs - 1, N64_TMEM_BYTES);
    case VECTOR_DRAM: return longs && in_memory(a[0], longs - 1, VECTOR_DRAM_BYTES);
    case VECTOR_MODE:
        return a[0] < sizeof(struct n64_modes) && a[1] <= (a[0] ? 1u : (uint32)N64_FILL);
    case VECTOR_TILE: return is_tile(a);
    case VECTOR_CALL: return longs >= 2;
    case VECTOR_DECODE: return a[1] <= N64_QUADS_CHROMA;
    case VECTOR_GLIDE_CALL: return longs >= 1;
    case VECTOR_GLIDE_BYTES_OF: return a[1] <= VECTOR_GLIDE_BYTES / 4;
    case VECTOR_GLIDE_SUM: return a[0] <= GLIDE_LEVEL_LAST;
    case VECTOR_GLIDE_LOGARITHM: return a[0] || a[1];   /* 0 has none */
    default: return 1;
    }
}
