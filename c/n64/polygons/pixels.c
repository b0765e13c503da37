#include "n64/polygons/pixels.h"

uint32 n64_pixel_of(uint32 colour, int32 pixel_bytes)
{
    if (pixel_bytes == 4)
        return colour;
    return (colour >> 16 & 0xf800) | (colour >> 13 & 0x7c0) | (colour >> 10 & 0x3e)
        | (colour >> 7 & 1);
}

void n64_pixel_write(uint8 *row, int32 x, int32 pixel_bytes, uint32 pixel)
{
    if (pixel_bytes == 4)
        ((uint32 *)row)[x] = pixel;
    else
        ((uint16 *)row)[x] = (uint16)pixel;
}
