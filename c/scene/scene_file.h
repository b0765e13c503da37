/* The scene file, as tools/scene_file.py writes it and scene_load checks it.
   Big-endian; every field is aligned to its size; offsets count bytes from the
   file's start and are multiples of 4. This header is the only definition: the
   host reads the layout from the compiler's debug information. */
#ifndef SCENE_FILE_H
#define SCENE_FILE_H

#include "compiler.h"

enum scene_constants {
    SCENE_MAGIC = 0x544d4150,   /* "TMAP" */
    SCENE_VERSION = 4,
    SCENE_SIDE_MAX = 1024,      /* pixels, frame width and height */
    SCENE_FRAMES_MAX = 1000,    /* dumps are numbered with three digits */
    SCENE_COUNT_MAX = 65536,    /* entries of any one table */
    POLYGON_VERTICES_MAX = 64,
    NO_TEXTURE = -1
};

struct scene_header {
    uint32 magic;
    uint32 version;
    uint32 size;                /* of the whole file, bytes */
    uint32 checksum;            /* CRC-32 of the file from `width` on */
    int32 width, height;        /* of the frame, pixels; width a multiple of 4 */
    int32 frames;
    uint32 pixel_bytes;         /* 1: palette indices; 2: RGB565, big-endian */
    uint32 background;          /* pixel */
    uint32 textures, materials, objects, vertices, poses;       /* counts */
    uint32 palette_at;          /* 256 entries of 4 bytes: 0, red, green, blue */
    uint32 textures_at, materials_at, objects_at, vertices_at, poses_at;
};

/* A map, width x height texels in the order of its layout; MAP_PAGE and MAP_MARGINS
   without what they repeat, row by row. What each layout takes: c/texture/map.h. */
struct scene_texture {
    int32 width, height;        /* texels */
    uint32 layout;              /* enum map_layout */
    uint32 texel_bytes;         /* as pixel_bytes; 2 in MAP_COLUMNS alone */
    uint32 at;                  /* of its texels */
};

/* With 2 bytes a pixel: flat or columns. */
struct scene_material {
    uint32 mapper, edges, gradients, start, clip, perspective;  /* c/polygon/polygon.h */
    int32 texture;              /* index, in the mapper's layout; NO_TEXTURE: flat, Gouraud */
    uint32 colour;              /* pixel of a flat material */
    int32 light;                /* index of a MAP_LIGHT: lit; else NO_TEXTURE */
};

/* One convex polygon that moves: in frame f it is drawn with pose
   pose + (f - first_frame), as long as that is below poses. Objects are drawn
   in the order of the file. */
struct scene_object {
    uint32 material;            /* index */
    uint32 vertex, vertices;    /* first vertex, how many: 3 where gradients need it */
    uint32 pose, poses;         /* first pose, how many frames it lives */
    uint32 first_frame;
};

/* Before the pose: x, y relative to the object; s, t are the texture's, 0 to 256
   along its longer side and, for MAPPER_ARBITRARY, inside it; y and t downwards.
   shade is a Gouraud material's pixel, 0 to 255, of a lit one 4 times the level; w the depth where the material has
   a perspective. All 16.16. */
struct scene_vertex {
    fix16 x, y, s, t, shade, w;
};

/* screen x = xx * x + xy * y + x0; screen y = yx * x + yy * y + y0, each product
   rounded down to 1/65536 by itself. All 16.16. */
struct scene_pose {
    fix16 xx, xy, yx, yy, x0, y0;
};

/* One frame in the file that `render ... DIGEST name` writes instead of dumps. The sums are
   Fletcher's, modulo 2^32: of the frame's longwords, and of that sum after each of them. */
struct frame_digest {
    uint32 sum, sums;
    uint32 ticks;               /* of the E-clock */
    uint32 result;              /* enum polygon_result: why a polygon was refused, or 0 */
};

#endif
