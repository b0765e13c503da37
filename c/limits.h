/* What every room keeps to: the size of frames and polygons, and what a pixel is. */
#ifndef LIMITS_H
#define LIMITS_H

enum common_limits {
    FRAME_SIDE_MAX = 1024,      /* pixels, width and height */
    POLYGON_VERTICES_MAX = 64
};

/* What a pixel and a texel are; two or four bytes are big-endian. */
enum pixel_format {
    PIXEL_CHUNKY,               /* 8 bits: palette index */
    PIXEL_RGB565,
    PIXEL_RGBA5551,
    PIXEL_RGBA8888,
    PIXEL_FORMATS
};

#endif
