#include "glide/glide.h"

const char *glide_result_text(enum glide_result result)
{
    static const char *const texts[] = {
        "done",
        "texture memory is not a power of two of at least 8 bytes",
        "start address is no multiple of 8",
        "map goes beyond texture memory",
        "no such level",
        "smallest level is larger than the largest",
        "levels are not even, odd or both",
        "map has no level of this kind",
        "level is not in this map",
        "rows are not in the level",
        "no such aspect ratio",
        "no such format",
        "entries are not in the palette",
        "no such NCC table",
        "NCC value is not within -256 to 255",
        "no such filter",
        "neither wrap nor clamp",
        "no such mipmap mode",
        "LOD bias is not within -8.0 to 7.75",
        "detail bias is not within -32 to 31",
        "detail scale is not within 0 to 7",
        "greatest detail is not within 0 to 255",
        "no such combine function",
        "no such combine factor",
        "flag is neither 0 nor 1",
        "weights have neither 4 nor 8 bits",
        "pieces have neither 8 nor 16 pixels",
        "register has bits that mean nothing",
        "not one or two units, or hints beyond them",
        "s or t of a vertex is 8,192 or more, or of two so far apart",
        "w of a vertex is 0, or above 16,384",
        "a unit's own coordinates are missing"
    };

    return (uint32)result < GLIDE_RESULTS ? texts[result] : "unknown result";
}
