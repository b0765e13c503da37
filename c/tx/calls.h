/* Calls that append command words to a list, as the N64 manual's macros do: the same
   parameters in the same order, the same words, the same syncs within the loads. A call that
   finds no room for all of its words appends none and returns TX_LIST_FULL; parameters are cut
   to their fields. Images are addresses within the texture engine's DRAM. */
#ifndef TX_CALLS_H
#define TX_CALLS_H

#include "tx/tx.h"

struct tx_list {
    struct tx_word *words;
    uint32 room, count;         /* pairs */
};

/* One axis of a tile as the manual's parameters have it. */
enum tx_wrap { TX_WRAP = 0, TX_MIRROR = 1, TX_CLAMP = 2 };     /* the last two may be added */

struct tx_addressing {
    uint32 wrap, mask, shift;   /* enum tx_wrap; 0-15; 0-15 */
};

enum tx_detail { TX_DETAIL_CLAMP, TX_DETAIL_SHARPEN, TX_DETAIL_DETAIL };
enum tx_filter { TX_FILTER_POINT = 0, TX_FILTER_BILINEAR = 2, TX_FILTER_AVERAGE = 3 };
enum tx_lut { TX_LUT_NONE = 0, TX_LUT_RGBA16 = 2, TX_LUT_IA16 = 3 };
enum tx_conversion { TX_CONVERSION_CONVERT = 0, TX_CONVERSION_FILTER_CONVERT = 5,
                     TX_CONVERSION_FILTER = 6 };

/* A texture in DRAM and the render tile it becomes. The manual's plain forms have `tmem` 0
   and `tile` 0; its `multi` forms name both. */
struct tx_texture {
    uint32 image;               /* multiple of 8 */
    uint32 format, size;        /* the 4-bit calls do not look at size */
    uint32 width;               /* texels of the image's rows, */
    uint32 height;              /* and how many; only blocks look at it */
    uint32 sl, tl, sh, th;      /* of the part to be loaded, texels; blocks do not look at it */
    uint32 palette;             /* of CI 4 */
    struct tx_addressing s, t;
    uint32 tmem, tile;
};

/* Whole textures as one block, of 8 bits or more, and of 4. */
enum tx_result tx_load_texture_block(struct tx_list *list, const struct tx_texture *texture);
enum tx_result tx_load_texture_block_4b(struct tx_list *list, const struct tx_texture *texture);

/* Parts of textures, row by row. */
enum tx_result tx_load_texture_tile(struct tx_list *list, const struct tx_texture *texture);
enum tx_result tx_load_texture_tile_4b(struct tx_list *list, const struct tx_texture *texture);

/* 16 colours into one of the 16 palettes, or all 256. */
enum tx_result tx_load_tlut_16(struct tx_list *list, uint32 palette, uint32 image);
enum tx_result tx_load_tlut_256(struct tx_list *list, uint32 image);

/* The words themselves. Edges are 10.2 but in a block: whole texels, dxt 1.11. */
enum tx_result tx_set_texture_image(struct tx_list *list, uint32 format, uint32 size,
                                    uint32 width, uint32 image);
enum tx_result tx_set_tile(struct tx_list *list, uint32 format, uint32 size, uint32 line,
                           uint32 tmem, uint32 tile, uint32 palette,
                           const struct tx_addressing *t, const struct tx_addressing *s);
enum tx_result tx_set_tile_size(struct tx_list *list, uint32 tile, uint32 sl, uint32 tl,
                                uint32 sh, uint32 th);
enum tx_result tx_load_block(struct tx_list *list, uint32 tile, uint32 sl, uint32 tl, uint32 sh,
                             uint32 dxt);
enum tx_result tx_load_tile(struct tx_list *list, uint32 tile, uint32 sl, uint32 tl, uint32 sh,
                            uint32 th);
enum tx_result tx_load_tlut(struct tx_list *list, uint32 tile, uint32 last);    /* entries - 1 */

/* The geometry processor's: the mipmap's levels above the first, and its first tile. */
enum tx_result tx_texture(struct tx_list *list, uint32 max_level, uint32 tile);

/* Modes; each leaves the others as they are. */
enum tx_result tx_cycle_type(struct tx_list *list, uint32 cycle);
enum tx_result tx_texture_perspective(struct tx_list *list, uint32 on);
enum tx_result tx_texture_detail(struct tx_list *list, uint32 detail);
enum tx_result tx_texture_lod(struct tx_list *list, uint32 on);
enum tx_result tx_texture_lut(struct tx_list *list, uint32 lut);
enum tx_result tx_texture_filter(struct tx_list *list, uint32 filter);
enum tx_result tx_texture_convert(struct tx_list *list, uint32 conversion);

enum tx_result tx_set_convert(struct tx_list *list, const int16 *k);    /* K0-K5 */
enum tx_result tx_combine_mode(struct tx_list *list, const struct tx_combine *combine);

/* Colours: R G B A from the highest byte on. */
enum tx_result tx_prim_colour(struct tx_list *list, uint32 min_level, uint32 fraction,
                              uint32 colour);
enum tx_result tx_env_colour(struct tx_list *list, uint32 colour);

enum tx_result tx_load_sync(struct tx_list *list);
enum tx_result tx_tile_sync(struct tx_list *list);
enum tx_result tx_pipe_sync(struct tx_list *list);
enum tx_result tx_full_sync(struct tx_list *list);

#endif
