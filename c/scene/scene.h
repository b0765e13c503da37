/* A checked scene in memory, with its textures in the spans' layouts. */
#ifndef SCENE_H
#define SCENE_H

#include "coverage/coverage.h"
#include "depths/depths.h"
#include "glide/polygons/unit.h"
#include "mesh/gather.h"
#include "mesh/bodies.h"
#include "mesh/near.h"
#include "n64/polygons/unit.h"
#include "polygon/polygon.h"
#include "scene/scene_file.h"
#include "system/input.h"

/* Of objects that are drawn together, the most and the room for their vertices. */
enum { RUN_POLYGONS = 42, RUN_VERTICES = 128 };

/* Memory for the vertices of a run of objects, or of one face. */
struct scene_scratch {
    struct polygon run[RUN_POLYGONS];
    struct vertex placed[RUN_VERTICES];
    struct vertex face[MESH_CORNERS_MAX], cut[2 * POLYGON_VERTICES_MAX];
    struct mesh_face *buckets[MESH_SORT_BUCKETS];
    struct mesh_batch batch;
};

/* Of trees that are drawn each pixel once. */
struct scene_near {
    struct mesh_box *boxes;     /* one a node */
    struct near_slot *slots;    /* of all trees */
    struct scene_corner *corners;       /* copies of those of trees' instances, one after the other */
    struct scene_point *points; /* those of each tree, each place once */
    struct scene_bodies *bodies;        /* 0 if no instance has TREE_Z */
    uint32 stamp;               /* of the tree that was drawn last */
    int32 is_still;             /* 1: all instances of a tree are in the same frames, with the same views */
};

struct scene {
    const struct scene_header *header;
#define TABLE(name, type) const struct type *name;
#define BLOCK(name)
    TABLE_LIST(TABLE, BLOCK)
#undef TABLE
#undef BLOCK
    struct mesh_work work;
    struct depths *depths;      /* 0 if no instance has TREE_Z */
    struct mesh_point16 *points16;      /* one a point, if there are views16; of meshes that share points
                                   the last one's */
    uint8 *smooth;              /* one a mesh, 1: all corners have the normal of their point's number */
    struct scene_scratch *scratch;
    struct map *maps;           /* one a texture */
    struct scene_near *near;    /* of a scene with `once` that has trees, else 0 */
    struct coverage *coverage;  /* of a scene with `once` and instances, else 0 */
    struct touched *touched;    /* coverage/touched.h: what is drawn is added to it; 0: it is not asked for */
    struct material *drawn;     /* one a material, with its map */
    const uint16 *reciprocals;  /* if a material needs them, else 0 */
    const struct triangle_tables *triangles;    /* the same */
    uint8 tried_reciprocals, tried_triangles;   /* 1: not made again where memory
                                   was short */
    uint8 is_once;              /* 1: instances are drawn with the coverage */
    uint8 is_coarse;            /* 1: frames are those of scene/coarse.h */
    struct n64_unit *engines;   /* one a unit */
    uint32 *n64_reciprocals;    /* of all units; null until a polygon needs them */
    struct glide *glide;        /* one each of glide_units */
    struct glide_pipe *pipe;    /* one each of pipes */
    struct glide_tile_store *tiles;     /* of all pipes */
};

/* maps.c, for programs that have the scene linked in: copies the textures of a checked scene to memory
   of the kind given, each in its layout; returns 0 if memory is short. Texels are then in memory twice. */
int32 scene_copy_maps(struct scene *scene, int32 kind);

/* maps_read.c, for scene files. Takes memory of the kind given for the textures of a checked scene, in as
   many blocks as it needs: of any kind, fast RAM before chip RAM. Returns 0 if memory is short. */
int32 scene_take_maps(struct scene *scene, int32 kind);

/* Reads the textures, each to its memory and in its layout; prints a line and returns 0 if it cannot. */
int32 scene_read_maps(struct scene *scene, struct file_input *input);

/* Returns the name of the first field of a scene file's start that is wrong, or 0; bytes: of the file. */
const char *scene_wrong_start(const struct scene_header *header, uint32 bytes);

/* The same for the rest of the header. */
const char *scene_wrong_header(const struct scene_header *header);

/* Returns the offset where all tables have ended: that of the first texture's texels. */
uint32 scene_tables_end(const struct scene_header *header);

/* Returns the greatest value of a pixel in the header's format. */
uint32 scene_pixel_max(const struct scene_header *header);

/* Returns the name of the first field of meshes, instances or views that is wrong, or 0. The tables
   must be inside the file, and materials checked. */
const char *scene_wrong_mesh(const struct scene *scene);

/* Returns "s" or "t" if that one is outside a map that is not repeated, else 0. */
const char *scene_wrong_texel(const struct scene *scene, const struct scene_material *material,
                              fix16 s, fix16 t);

/* Returns the bytes of a pixel of an enum pixel_format. */
int32 scene_pixel_bytes(uint32 format);

/* Sets the pointers to the tables of a scene file in memory, at a multiple of 4. */
void scene_place(struct scene *scene, const uint8 *data);

/* Makes the texture engines and runs the first list of each; returns 0 if memory is short. */
int32 scene_make_units(struct scene *scene, int32 kind);

/* Returns the routine that draws an enum unit_primitive. */
polygon_routine *scene_unit_routine(uint32 primitive);

/* Runs the display lists of a frame. */
void scene_start_units(struct scene *scene, int32 number);

/* Returns the name of the first field of units or lists that is wrong, or 0. The tables must be
   inside the file. */
const char *scene_wrong_unit(const struct scene *scene);

/* Runs all lists of all engines. If a command is refused, prints a line with unit, list and command
   and returns 0. */
int32 scene_try_units(const struct scene *scene, const char *name);

/* Returns the reason for an enum polygon_result from POLYGON_FEW on. */
const char *scene_why(const struct scene *scene, uint32 result);

/* Returns the reason why a texture engine refused its last polygon. */
const char *scene_why_refused(const struct scene *scene);

/* glide.c. Returns the name of the first field of glide_units or pipes that is wrong, or 0. The
   tables must be inside the file. */
const char *scene_wrong_pipe(const struct scene *scene);

/* Makes Glide's texture units and their pipes; returns 0 if memory is short. */
int32 scene_make_pipes(struct scene *scene, int32 kind);

/* Returns non-zero if the second half of an object's vertices has the coordinates of the material's
   second unit. Pipes must be checked. */
int32 scene_has_own(const struct scene *scene, const struct scene_material *material);

polygon_routine *scene_pipe_routine(const struct scene *scene,
                                    const struct scene_material *material);

/* Returns the reason why a pipe refused a polygon, or 0 if none did. */
const char *scene_why_pipe_refused(const struct scene *scene);

/* Results of making a scene or its tables: all but SCENE_MADE say what memory is too short for. */
enum scene_memory {
    SCENE_MADE, SCENE_TEXTURES, SCENE_RECIPROCALS, SCENE_MATERIALS, SCENE_MESHES,
    SCENE_UNITS, SCENE_COVERAGE,
    SCENE_CROWDED               /* the last: more than SCENE_COUNT_MAX at once */
};

/* Makes materials and all other data from which a checked scene with its maps is drawn; texture units take
   memory of the kind given. */
enum scene_memory scene_make(struct scene *scene, int32 kind);

/* coverage.c. Returns "once" if pixels are drawn once of meshes that cannot be: they need opaque texels, and exact edges,
   which leave no pixel to two triangles of a face; else 0. */
const char *scene_wrong_once(const struct scene *scene);

/* Makes memory for a scene whose meshes' pixels are drawn once, and sets is_once; returns 0 if memory is
   short. */
int32 scene_make_coverage(struct scene *scene);

/* near.c. Makes the tables by which trees are walked from the nearest face on, if pixels are drawn once; returns 0 if
   memory is short. Trees must be checked. */
int32 scene_make_near(struct scene *scene);

/* levels.c. Sets the materials whose maps have levels; what these draw is counted for them. */
void scene_make_levels(struct scene *scene);

/* Reserves memory for data that texture units make while they draw, if a scene has any. */
void scene_reserve(const struct scene *scene);

/* Loads and checks a scene; textures go to memory of the kind given. On an error prints a line with
   file and field and returns 0. */
int32 scene_load(struct scene *scene, const char *name, int32 kind);

#endif
