/* The scene file, as tools/tmap/scene_file/scene_file.py writes it and scene_load checks it.
   Big-endian; every field is aligned to its size; offsets count bytes from the
   file's start and are multiples of 4. This header is the only definition of the layout: the
   host reads it from the compiler's debug information. */
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
    SCENE_VERSION = 17,
    SCENE_FRAMES_MAX = 1000,    /* dumps are numbered with three digits */
    SCENE_COUNT_MAX = 65536,    /* entries of any one table */
    NO_TEXTURE = -1,
    NO_UNIT = -1,
    NO_VIEW16 = -1,
    NO_TREE = -1,
    TREE_Z = -2,
    NO_POSE = -1,
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
    int32 pixel_width, pixel_height;    /* of a pixel on the screen, in pixels of low resolution: 1 or 2 */
    int32 frames;
    uint32 format;              /* enum pixel_format */
    uint32 background;          /* pixel */
    uint32 cleared;             /* 1: frames begin with the background; 0: pixels that no polygon covers keep
                                   what the frame's memory had */
    uint32 once;                /* 1: meshes' pixels are drawn once, front to back; 0: all of them, back to front */
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

/* A map, width x height texels in the order of its layout; MAP_PAGE and MAP_MARGINS row by row
   without repetitions. c/texture/map.h has the sizes of each layout. */
struct scene_texture {
    int32 width, height;        /* texels */
    uint32 layout;              /* enum map_layout */
    uint32 texel_bytes;         /* of the frame's format */
    uint32 at;                  /* of its texels */
};

/* Mappers with 2 bytes a pixel: flat, affine, dithered, columns, for PIXEL_RGB565 glide, for
   PIXEL_RGBA5551 n64; with 4: flat, affine, dithered, glide, n64. */
struct scene_material {
    uint32 mapper, edges, gradients, start, clip, perspective;  /* c/polygon/polygon.h */
    int32 texture;              /* index, in the mapper's layout; NO_TEXTURE: flat, Gouraud */
    uint32 colour;              /* pixel of a flat material */
    int32 light;                /* index of a MAP_LIGHT: lit; else NO_TEXTURE */
    fix16 tolerance;            /* texels, 0 to TOLERANCE_MAX; 0 without perspective */
    int32 unit;                 /* index: MAPPER_N64: of a unit, MAPPER_GLIDE: of a pipe; else
                                   NO_UNIT */
    uint32 primitive;           /* enum unit_primitive; 0 without a unit */
    uint32 levels;              /* MIPMAP_LEVELS_MAX at most: materials from `level` on that are drawn instead of it
                                   where texels are smaller than pixels. They have none themselves; each has a texture
                                   of half the sides of the one before, and all else of this */
    uint32 level;               /* 0 without levels */
};

/* The type of all objects of a unit's material; a mesh's material has UNIT_POLYGONS. */
enum unit_primitive {
    UNIT_POLYGONS,              /* shade is an opaque grey */
    UNIT_COLOURED,              /* polygons; shade is the vertex's R G B A, a byte each */
    UNIT_RECTANGLES,            /* two vertices in whole pixels: left and top, right and bottom; s
                                   and t of the first are s10.5, at the upper left pixel, of the
                                   second the steps, s5.10: n64/rectangle.h */
    UNIT_FLIPPED,               /* the same, but s downwards and t to the right */
    UNIT_PRIMITIVES
};

/* A texture engine and its display lists. The first list is run when the scene is loaded; if there
   are more, there is one for each frame, run before it. All engines load from the file's dram. */
struct scene_unit {
    uint32 list, lists;         /* first, how many: 1 or 1 + frames */
};

/* A display list: struct n64_word in the table of words. */
struct scene_list {
    uint32 word, words;         /* first, how many */
};

/* A Glide texture unit: its registers (glide/glide.h) and its part of the file's glide_memory.
   glide_memory has its tables too. */
struct scene_glide_unit {
    uint32 mode, lod, detail, base;
    uint32 memory, bytes;       /* offset, a multiple of 4; size: a power of two, 8 or more */
    int32 palette;              /* offset of GLIDE_ENTRIES longs 00RRGGBB, or NO_TABLE */
    int32 ncc;                  /* offset of two tables' registers, or NO_TABLE */
    uint32 fraction_bits;       /* of filter weights: 4 or 8 */
    uint32 dithered;            /* 1: point samples may replace the bilinear filter; or 0 */
    uint32 subdivision;         /* pixels: 0, 8 or 16 */
};

/* A chain of units; the first is nearest the frame. */
struct scene_pipe {
    uint32 glide, glide_units;  /* first, how many: 1 or 2 */
    uint32 own;                 /* 2: the second unit has separate s, t and w. An object then has
                                   twice as many vertices as corners; s, t and w (not 0) of the
                                   second half are the second unit's. Not for meshes. Else 0 */
    uint32 prefilter;           /* bytes: glide_pipe_prefilter */
    uint32 adds;                /* 1: glide_pipe_adds; or 0 */
};

/* One convex polygon, or a rectangle. In frame f it is drawn with pose
   pose + (f - first_frame), as long as f - first_frame is 0 to poses - 1. Objects are drawn in the
   order of the file. Vertices have x and y before the pose, and for MAPPER_ARBITRARY s and t inside
   the map. Poses only move a rectangle, by whole pixels. */
struct scene_object {
    uint32 material;            /* index */
    uint32 vertex, vertices;    /* first vertex, number: 3 if the gradients require it, 2 for a
                                   rectangle */
    int32 pose;                 /* the first, or NO_POSE: it never moves */
    uint32 poses;               /* number of frames with the object */
    uint32 first_frame;
    uint32 planar;              /* enum planar_values that are on planes; others are checked when
                                   it is drawn */
};

/* screen x = xx * x + xy * y + x0; screen y = yx * x + yy * y + y0, each product
   rounded down to 1/65536 by itself. All 16.16. */
struct scene_pose {
    fix16 xx, xy, yx, yy, x0, y0;
};

/* A moving mesh; views work as poses of an object. It is drawn before the object whose
   number is `before`, or at the end; instances are in this order. Those with the same number that
   follow each other in one tree, or in none, are drawn together: by the tree, or the farthest faces
   first. */
struct scene_instance {
    uint32 mesh, material, before;
    uint32 view, views;
    uint32 first_frame;
    uint32 flags;
    fix16 dark, bright;         /* range of shades with MESH_LIT or MESH_FOG */
    int32 view16;               /* first of as many as views, or NO_VIEW16 */
    int32 tree;                 /* the first node of a tree, NO_TREE, or TREE_Z: its pixels are tested against all
                                   faces that are drawn with it. Those are the first with the same number, have
                                   exact edges, no texture unit and no transparent texels, and the frame has 1 byte
                                   a pixel. Trees are in the order of their
                                   instances, from node 0 on. All instances of a tree have views from
                                   the same space */
    uint32 slot;                /* with a tree: first of as many slots as the mesh has faces */
    fix16 fog_near, fog_far;    /* with MESH_FOG: depths from 0 to W_MAX up to which shades are bright and from which
                                   on they are dark, the first below the second. The material has a light table or
                                   is Gouraud's */
};

/* One frame in the file that `render ... DIGEST name` writes instead of dumps. sum: of its
   longwords; a single different longword always changes it. hash: of all longwords that differ from
   the one before (the first: from 0) and of their places. For each of them the halves of the hash
   are exchanged, the longword is exclusive-ored, the result is multiplied by FRAME_HASH, and the
   number of longwords from this one (included) to the frame's end is added. */
enum {
    FRAME_HASH = 0x2c9277b5     /* 8 n + 5: odd, its bits mixed */
};

struct frame_digest {
    uint32 sum, hash;
    uint32 ticks;               /* colour clocks */
    uint32 result;              /* enum polygon_result: why a polygon was refused, or 0 */
};

#endif
