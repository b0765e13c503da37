#include "n64/n64.h"

const char *n64_result_text(enum n64_result result)
{
    static const char *const texts[] = {
        "done",
        "unknown command",
        "no such format of this size",
        "image address is no multiple of 8",
        "4-bit image in a load",
        "load reads outside the memory given",
        "last texel of the load comes before the first",
        "load block of more than 2048 texels",
        "load goes beyond TMEM",
        "TLUT image is not of 16 bits",
        "TLUT load through a tile that is not of 4 bits",
        "TLUT load over more than one row",
        "TLUT of more than 256 entries or beyond TMEM",
        "TLUT in the low half of TMEM",
        "CI texels in the high half of TMEM",
        "low part of RGBA 32 or YUV texels in the high half of TMEM",
        "CI tile without TLUT, or another tile with it",
        "tile of more than 1024 x 256 texels",
        "tile shows texels beyond TMEM",
        "clamped tile ends before it begins",
        "combiner input is not supported",
        "cycle type does not draw this",
        "texture coordinate is not within -1024 to 1023.96875",
        "no load sync",
        "no tile sync",
        "no pipe sync",
        "no room in the list",
        "not enough memory",
        "tile is too large to be decoded",
        "texture rectangle in perspective or with shade"
    };

    return (uint32)result < N64_RESULTS ? texts[result] : "unknown result";
}
