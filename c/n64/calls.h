/* Calls that append command words to a list, as the N64 manual's macros do: the same
   parameters in the same order, the same words, the same syncs within the loads. A call
   without room for all of its words appends none and returns N64_LIST_FULL. Parameters are cut
   to their fields. Images are addresses within the texture engine's DRAM. */
#ifndef N64_CALLS_H
#define N64_CALLS_H

#include "n64/n64.h"

struct n64_list {
    struct n64_word *words;
    uint32 room, count;         /* pairs */
};

/* One axis of a tile, as in the manual's parameters. */
enum n64_wrap { N64_WRAP = 0, N64_MIRROR = 1, N64_CLAMP = 2 };  /* the last two may be combined */

struct n64_addressing {
    uint32 wrap, mask, shift;   /* enum n64_wrap; 0-15; 0-15 */
};

enum n64_detail { N64_DETAIL_CLAMP, N64_DETAIL_SHARPEN, N64_DETAIL_DETAIL };
enum n64_filter { N64_FILTER_POINT = 0, N64_FILTER_BILINEAR = 2, N64_FILTER_AVERAGE = 3 };
enum n64_lut { N64_LUT_NONE = 0, N64_LUT_RGBA16 = 2, N64_LUT_IA16 = 3 };
enum n64_conversion { N64_CONVERSION_CONVERT = 0, N64_CONVERSION_FILTER_CONVERT = 5,
                     N64_CONVERSION_FILTER = 6 };

/* A texture in DRAM and the render tile it becomes. `tmem` and `tile` are 0 in the manual's plain
   forms; its `multi` forms name both. */
struct n64_texture {
    uint32 image;               /* multiple of 8 */
    uint32 format, size;        /* the 4-bit calls ignore size */
    uint32 width;               /* texels of the image's rows, */
    uint32 height;              /* and their number; only blocks use it */
    uint32 sl, tl, sh, th;      /* the part to load, in texels; blocks ignore it */
    uint32 palette;             /* of CI 4 */
    struct n64_addressing s, t;
    uint32 tmem, tile;
};

/* Load a whole texture as one block: of 8 bits a texel or more, and of 4 bits. */
enum n64_result n64_load_texture_block(struct n64_list *list, const struct n64_texture *texture);
enum n64_result n64_load_texture_block_4b(struct n64_list *list, const struct n64_texture *texture);

/* Load a part of a texture, row by row. */
enum n64_result n64_load_texture_tile(struct n64_list *list, const struct n64_texture *texture);
enum n64_result n64_load_texture_tile_4b(struct n64_list *list, const struct n64_texture *texture);

/* Load 16 colours into one of the 16 palettes, or all 256. */
enum n64_result n64_load_tlut_16(struct n64_list *list, uint32 palette, uint32 image);
enum n64_result n64_load_tlut_256(struct n64_list *list, uint32 image);

/* Single words. Edges are 10.2, but in a block whole texels; dxt is 1.11. */
enum n64_result n64_set_texture_image(struct n64_list *list, uint32 format, uint32 size,
                                      uint32 width, uint32 image);
enum n64_result n64_set_tile(struct n64_list *list, uint32 format, uint32 size, uint32 line,
                             uint32 tmem, uint32 tile, uint32 palette,
                             const struct n64_addressing *t, const struct n64_addressing *s);
enum n64_result n64_set_tile_size(struct n64_list *list, uint32 tile, uint32 sl, uint32 tl,
                                  uint32 sh, uint32 th);
enum n64_result n64_load_block(struct n64_list *list, uint32 tile, uint32 sl, uint32 tl, uint32 sh,
                               uint32 dxt);
enum n64_result n64_load_tile(struct n64_list *list, uint32 tile, uint32 sl, uint32 tl, uint32 sh,
                              uint32 th);
enum n64_result n64_load_tlut(struct n64_list *list, uint32 tile, uint32 last);  /* entries - 1 */

/* A word of the geometry processor: the number of mipmap levels above the first, and the tile of
   the first one. */
enum n64_result n64_texture(struct n64_list *list, uint32 max_level, uint32 tile);

/* Modes; each call changes only its own. */
typedef enum n64_result n64_mode_call(struct n64_list *list, uint32 value);

n64_mode_call n64_cycle_type, n64_texture_perspective, n64_texture_detail, n64_texture_lod;
n64_mode_call n64_texture_lut, n64_texture_filter, n64_texture_convert;

enum n64_result n64_set_convert(struct n64_list *list, const int16 *k);  /* K0-K5 */
enum n64_result n64_combine_mode(struct n64_list *list, const struct n64_combine *combine);

/* Colours: R G B A from the highest byte on. */
enum n64_result n64_prim_colour(struct n64_list *list, uint32 min_level, uint32 fraction,
                                uint32 colour);
enum n64_result n64_env_colour(struct n64_list *list, uint32 colour);

typedef enum n64_result n64_sync_call(struct n64_list *list);

n64_sync_call n64_load_sync, n64_tile_sync, n64_pipe_sync, n64_full_sync;

#endif
