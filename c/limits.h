/* Limits common to all rooms: the size of frames and polygons, and pixel formats. */
#ifndef LIMITS_H
#define LIMITS_H

enum common_limits {
    FRAME_SIDE_MAX = 1024,      /* pixels, width and height */
    POLYGON_VERTICES_MAX = 64
};

/* Formats of pixels and texels; two or four bytes are big-endian. */
enum pixel_format {
    PIXEL_CHUNKY,               /* 8 bits: palette index */
    PIXEL_RGB565,
    PIXEL_RGBA5551,
    PIXEL_RGBA8888,
    PIXEL_FORMATS
};

#endif
