#include "texture/map.h"

fix16 map_scale(int32 width, int32 height)
{
    return (width > height ? width : height) << 8;
}
