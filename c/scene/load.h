/* How a scene comes into memory: checked, with its textures and what its materials need. */
#ifndef SCENE_LOAD_H
#define SCENE_LOAD_H

#include "scene/scene.h"
#include "system/input.h"

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
