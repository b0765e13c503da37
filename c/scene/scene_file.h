/* The scene file, as tools/tmap/scene_file/scene_file.py writes it and scene_load checks it.
   Big-endian; every field is aligned to its size; offsets count bytes from the
   file's start and are multiples of 4. This header is the only definition: the
   host reads the layout from the compiler's debug information. */
#ifndef SCENE_FILE_H
#define SCENE_FILE_H

#include "compiler.h"
#include "glide/glide.h"
#include "limits.h"
#include "mesh/records.h"
#include "n64/n64.h"
#include "polygon/vertex.h"
#include "scene/table_list.h"

enum scene_constants {
    SCENE_MAGIC = 0x544d4150,   /* "TMAP" */
    SCENE_VERSION = 11,
    SCENE_FRAMES_MAX = 1000,    /* dumps are numbered with three digits */
    SCENE_COUNT_MAX = 65536,    /* entries of any one table */
    NO_TEXTURE = -1,
    NO_UNIT = -1,
    NO_TABLE = -1,
    GUARD_MIN = 6,
    GUARD_MAX = 13              /* 8,192 pixels */
};

struct scene_header {
    uint32 magic;
    uint32 version;
    uint32 size;                /* of the whole file, bytes */
    uint32 checksum;            /* CRC-32 of the file from `width` on */
    int32 width, height;        /* of the frame, pixels; width a multiple of 4 */
    int32 frames;
    uint32 format;              /* enum pixel_format */
    uint32 background;          /* pixel */
    fix16 near_plane;           /* depth, from W_MIN on; counts where instances are */
    uint32 guard;               /* log2 of how far right and down of the frame's middle
                                   camera x and y of the size of the depth lie, pixels */
    /* Entries of each table, bytes of each block. */
#define TABLE(name, type) uint32 name;
#define BLOCK(name) uint32 name;
    TABLE_LIST(TABLE, BLOCK)
#undef TABLE
#undef BLOCK
    uint32 palette_at;          /* 256 entries of 4 bytes: 0, red, green, blue */
#define TABLE(name, type) uint32 name##_at;
#define BLOCK(name) uint32 name##_at;
    TABLE_LIST(TABLE, BLOCK)
#undef TABLE
#undef BLOCK
};

/* A map, width x height texels in the order of its layout; MAP_PAGE and MAP_MARGINS
   without what they repeat, row by row. What each layout takes: c/texture/map.h. */
struct scene_texture {
    int32 width, height;        /* texels */
    uint32 layout;              /* enum map_layout */
    uint32 texel_bytes;         /* of the frame's format */
    uint32 at;                  /* of its texels */
};

/* With 2 bytes a pixel: flat, affine, dithered, columns, for PIXEL_RGB565 glide, for PIXEL_RGBA5551
   unit; with 4 flat, affine, dithered, glide or unit; none of these with a perspective. */
struct scene_material {
    uint32 mapper, edges, gradients, start, clip, perspective;  /* c/polygon/polygon.h */
    int32 texture;              /* index, in the mapper's layout; NO_TEXTURE: flat, Gouraud */
    uint32 colour;              /* pixel of a flat material */
    int32 light;                /* index of a MAP_LIGHT: lit; else NO_TEXTURE */
    fix16 tolerance;            /* texels, 0 to TOLERANCE_MAX; 0 without a perspective */
    int32 unit;                 /* index: of a unit where MAPPER_N64, of a pipe where
                                   MAPPER_GLIDE; else NO_UNIT */
    uint32 primitive;           /* enum unit_primitive; 0 without a unit */
};

/* What all objects of a unit's material are; of a mesh, UNIT_POLYGONS. */
enum unit_primitive {
    UNIT_POLYGONS,              /* shade is an opaque grey */
    UNIT_COLOURED,              /* polygons; shade is the vertex's R G B A, a byte each */
    UNIT_RECTANGLES,            /* two vertices in whole pixels: left and top, right and bottom; s
                                   and t of the first are s10.5, at the upper left pixel, of the
                                   second the steps, s5.10: n64/rectangle.h */
    UNIT_FLIPPED,               /* the same, s downwards and t to the right */
    UNIT_PRIMITIVES
};

/* A texture engine: display lists that are run one after the other. The first when the scene is
   loaded; if there are more, there is one for each frame, run before it. All engines load from
   the dram of the file. */
struct scene_unit {
    uint32 list, lists;         /* first, how many: 1 or 1 + frames */
};

/* A display list: struct n64_word in the table of words. */
struct scene_list {
    uint32 word, words;         /* first, how many */
};

/* A texture unit of Glide's: its registers (glide/glide.h) and its part of the file's glide_memory, where
   its tables lie too. */
struct scene_glide_unit {
    uint32 mode, lod, detail, base;
    uint32 memory, bytes;       /* offset, a multiple of 4; how many: a power of two, 8 or more */
    int32 palette;              /* offset of GLIDE_ENTRIES longs 00RRGGBB, or NO_TABLE */
    int32 ncc;                  /* offset of two tables' registers, or NO_TABLE */
    uint32 fraction_bits;       /* of filter weights: 4 or 8 */
    uint32 dithered;            /* 1: points may stand in for the bilinear filter; or 0 */
    uint32 subdivision;         /* pixels: 0, 8 or 16 */
};

/* Units in a row, the first nearest the frame. */
struct scene_pipe {
    uint32 glide, glide_units;  /* first, how many: 1 or 2 */
    uint32 own;                 /* 2: the second has s, t and w of its own. An object's vertices are
                                   twice its corners' then: the first half as always, of the second
                                   s, t and w (not 0) count. Not for meshes */
    uint32 prefilter;           /* bytes: glide_pipe_prefilter */
    uint32 adds;                /* 1: glide_pipe_adds; or 0 */
};

/* One convex polygon that moves, or a rectangle: in frame f it is drawn with pose
   pose + (f - first_frame), as long as that is below poses. Objects are drawn
   in the order of the file. Its struct vertex have x and y before the pose, and for
   MAPPER_ARBITRARY s and t inside the map. Poses move a rectangle by whole pixels, nothing else. */
struct scene_object {
    uint32 material;            /* index */
    uint32 vertex, vertices;    /* first vertex, how many: 3 where gradients need it, 2 a
                                   rectangle */
    uint32 pose, poses;         /* first pose, how many frames it lives */
    uint32 first_frame;
    uint32 planar;              /* enum planar_values that lie on planes; others are looked at when
                                   it is drawn */
};

/* screen x = xx * x + xy * y + x0; screen y = yx * x + yy * y + y0, each product
   rounded down to 1/65536 by itself. All 16.16. */
struct scene_pose {
    fix16 xx, xy, yx, yy, x0, y0;
};

/* A mesh that moves: views as poses of an object. It is drawn before the object whose
   number is `before`, or at the end; instances are in this order. Those with one number
   are drawn together, faces far away first. */
struct scene_instance {
    uint32 mesh, material, before;
    uint32 view, views;
    uint32 first_frame;
    uint32 flags;
    fix16 dark, bright;         /* range of shades where MESH_LIT */
};

/* One frame in the file that `render ... DIGEST name` writes instead of dumps: the sum of its
   longwords, which one that differs always changes, and a hash of all that are not equal to the one
   before (to 0, the first) and of their places: such a longword is exclusive-ored to the hash,
   halves exchanged, that is multiplied by FRAME_HASH, and to it is added how many longwords there
   are from it to the frame's end, itself too. */
enum {
    FRAME_HASH = 0x2c9277b5     /* 8 n + 5: odd, its bits mixed */
};

struct frame_digest {
    uint32 sum, hash;
    uint32 ticks;               /* colour clocks */
    uint32 result;              /* enum polygon_result: why a polygon was refused, or 0 */
};

#endif
