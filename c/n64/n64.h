/* The N64's texture engine: its state and the words that change it.

   A program may have any number of texture engines, each with its own TMEM. Command words
   (written by calls.h) are the only way to change the state; pixel.h draws from it.
   Formats: 10.2 is unsigned with 2 fraction bits; s10.5 signed, 16 bits, 5 of them fraction;
   TMEM words have 64 bits. Memory is big-endian throughout. */
#ifndef N64_H
#define N64_H

#include "compiler.h"

enum n64_format { N64_RGBA, N64_YUV, N64_CI, N64_IA, N64_I };  /* 5-7 act as N64_I */
enum n64_size { N64_4, N64_8, N64_16, N64_32 };             /* bits a texel */
enum n64_cycle { N64_ONE_CYCLE, N64_TWO_CYCLES, N64_COPY, N64_FILL };

enum n64_constants {
    N64_TMEM_BYTES = 4096,
    N64_TMEM_WORDS = 512,
    N64_HALF_WORDS = 256,       /* the high half holds TLUTs, and the low parts' other halves */
    N64_TILES = 8,
    N64_LOAD_TILE = 7,          /* the calls of calls.h load through it */
    N64_BLOCK_TEXELS = 2048,    /* of one load block */
    N64_COLUMNS_MAX = 1024,     /* of a tile, in texels */
    N64_ROWS_MAX = 256
};

/* Operations: bits 29:24 of a pair's upper word, whose bits 31:30 are ignored. N64_OP_TEXTURE
   and N64_OP_MODES are words of the geometry processor, not of the drawing processor. They have
   the fields that the manual gives them. */
enum n64_operation {
    N64_OP_NOTHING = 0x00,
    N64_OP_TEXTURE = 0x17,      /* hi: max_level 13:11, first tile 10:8 */
    N64_OP_MODES = 0x23,        /* hi: 32 - shift - bits 15:8, bits - 1 7:0; lo: the bits */
    N64_OP_LOAD_SYNC = 0x26, N64_OP_PIPE_SYNC, N64_OP_TILE_SYNC, N64_OP_FULL_SYNC,
    N64_OP_CONVERT = 0x2c, N64_OP_OTHER_MODES = 0x2f,
    N64_OP_LOAD_TLUT = 0x30,
    N64_OP_TILE_SIZE = 0x32, N64_OP_LOAD_BLOCK, N64_OP_LOAD_TILE, N64_OP_TILE,
    N64_OP_PRIMITIVE = 0x3a, N64_OP_ENVIRONMENT, N64_OP_COMBINE, N64_OP_IMAGE
};

/* Results of a command or a check, and their texts. Unless it is N64_DONE, nothing was changed. */
#define N64_RESULT_LIST(RESULT) \
    RESULT(DONE, "done") \
    RESULT(UNKNOWN_COMMAND, "unknown command") \
    RESULT(ILLEGAL_PAIR, "no such format of this size") \
    RESULT(IMAGE_MISALIGNED, "image address is no multiple of 8") \
    RESULT(IMAGE_4_BIT, "4-bit image in a load")  /* it would hang the hardware */ \
    RESULT(OUTSIDE_DRAM, "load reads outside the memory given") \
    RESULT(LOAD_BACKWARDS, "last texel of the load comes before the first") \
    RESULT(BLOCK_TOO_LARGE, "load block of more than 2048 texels")  /* N64_BLOCK_TEXELS */ \
    RESULT(LOAD_TOO_LARGE, "load goes beyond TMEM") \
    RESULT(TLUT_IMAGE, "TLUT image is not of 16 bits") \
    RESULT(TLUT_TILE, "TLUT load through a tile that is not of 4 bits") \
    RESULT(TLUT_ROWS, "TLUT load over more than one row")  /* it would hang the hardware */ \
    RESULT(TLUT_ENTRIES, "TLUT of more than 256 entries or beyond TMEM") \
    RESULT(TLUT_LOW, "TLUT in the low half of TMEM") \
    RESULT(INDEX_HIGH, "CI texels in the high half of TMEM") \
    RESULT(SPLIT_HIGH, "low part of RGBA 32 or YUV texels in the high half of TMEM") \
    RESULT(TLUT_MODE, "CI tile without TLUT, or another tile with it") \
    RESULT(TILE_TOO_LARGE, "tile of more than 1024 x 256 texels") \
    RESULT(TILE_OUTSIDE, "tile shows texels beyond TMEM") \
    RESULT(TILE_EDGES, "clamped tile ends before it begins") \
    RESULT(COMBINE_INPUT, "combiner input is not supported")  /* noise, chroma key */ \
    RESULT(CYCLE_TYPE, "cycle type does not draw this") \
    RESULT(COORDINATE_RANGE, "texture coordinate is not within -1024 to 1023.96875") \
    RESULT(NO_LOAD_SYNC, "no load sync")  /* strict: a load after drawing without it */ \
    RESULT(NO_TILE_SYNC, "no tile sync")  /* a change of a tile that was drawn from */ \
    RESULT(NO_PIPE_SYNC, "no pipe sync")  /* a change of modes */ \
    RESULT(LIST_FULL, "no room in the list")  /* calls.h */ \
    RESULT(NO_MEMORY, "not enough memory")  /* decode.h */ \
    RESULT(DECODE_TOO_LARGE, "tile is too large to be decoded")  /* N64_DECODE_BITS */ \
    RESULT(RECTANGLE_MODES, "texture rectangle in perspective or with shade")

enum n64_result {
#define RESULT(name, text) N64_##name,
    N64_RESULT_LIST(RESULT)
#undef RESULT
    N64_RESULTS
};

/* A tile in s or t. */
struct n64_axis {
    uint8 clamp, mirror;        /* 0 or 1 */
    uint8 mask;                 /* 0: none (clamps); n: n low bits of the index, above 10 as 10 */
    uint8 shift;                /* 0-10 right, 11-15 left by 16 - shift */
    uint16 low, high;           /* 10.2: edges, both inside */
};

struct n64_tile {
    uint8 format, size, palette, spare;
    uint16 line, tmem;          /* TMEM words: from row to row (9 bits), of the first */
    struct n64_axis s, t;
};

struct n64_modes {
    uint8 cycle;                /* enum n64_cycle */
    uint8 perspective, detail, sharpen, lod;
    uint8 tlut, tlut_type;      /* type 0: RGBA 16, 1: IA 16 */
    uint8 quad, mid;            /* quad 0: point; 1: filter; mid with it: average */
    uint8 filter0, filter1;     /* in cycle 0 and 1: 1 filter, 0 colour conversion */
    uint8 convert_one;          /* cycle 1 converts cycle 0's result */
};

struct n64_input {
    uint8 a, b, c, d;           /* codes as in the set-combine word */
};

struct n64_combine {
    struct n64_input rgb[2], alpha[2];  /* cycle 0, cycle 1; one-cycle mode uses cycle 1's */
};

struct n64_image {
    uint32 address;             /* into the DRAM given */
    uint8 format, size;
    uint16 width;               /* texels */
};

/* Bits of n64.inputs: the inputs that a pixel's colour depends on. */
enum n64_inputs {
    N64_INPUT_TEXEL0 = 1,       /* tile T0's sample, */
    N64_INPUT_TEXEL1 = 2,       /* T1's */
    N64_INPUT_SHADE = 4,
    N64_INPUT_LOD_FRACTION = 8
};

enum n64_pending { N64_PENDING_LOAD = 1, N64_PENDING_TILE = 2, N64_PENDING_PIPE = 4 };

struct n64 {
    uint8 tmem[N64_TMEM_BYTES];
    struct n64_tile tiles[N64_TILES];
    struct n64_modes modes;
    struct n64_combine combine;
    struct n64_image image;
    int16 k[6];                 /* K0-K5, signed 9 bits */
    uint8 primitive[4], environment[4];         /* R G B A */
    uint8 primitive_fraction;
    uint8 min_level;            /* 0-31 */
    uint8 max_level;            /* 0-7 */
    uint8 primitive_tile;       /* 0-7: T0, or the first of a mipmap */
    uint32 other_modes;         /* bits 23:0 of the last set other modes */
    uint32 inputs;              /* enum n64_inputs, of this combine mode and cycle type */
    uint8 sources[2][8];        /* by cycle: enum n64_source of A, B, C, D of R G B, of alpha */
    const uint8 *dram;          /* the memory that image addresses refer to, */
    uint32 dram_bytes;          /* multiple of 8 */
    /* Generation counters for cache invalidation: TMEM's counts loads, the others only real
       changes. */
    uint32 tmem_generation, tile_generation[N64_TILES], mode_generation;
    uint8 checked;              /* 1: illegal uses are refused; 0: they do what the hardware
                                   does, except those that hang it */
    uint8 strict;               /* 1: a change without its sync is refused */
    uint8 pending;              /* strict: enum n64_pending, set by n64_drawn */
    uint8 pending_tiles;        /* bit n: the primitives that are pending read tile n */
    uint32 command;             /* number in the list of the command being run, from 0 on */
};

struct n64_word {
    uint32 hi, lo;
};

/* Sets everything to 0, except: checked is 1, both cycles filter, the colour is texel 0. dram may
   be 0. */
void n64_init(struct n64 *n64, const uint8 *dram, uint32 dram_bytes);

/* Runs one pair of words. */
enum n64_result n64_command(struct n64 *n64, uint32 hi, uint32 lo);

/* Runs a display list to its end, or to the first pair that is refused: its number is then in
   n64->command. */
enum n64_result n64_list_run(struct n64 *n64, const struct n64_word *words, uint32 count);

/* Drawing code calls this after each primitive: from then on syncs are due (strict). The
   primitive is assumed to read all tiles that the modes can choose, from primitive_tile on. A
   pipe sync also counts as a tile sync, because it waits for all that a tile sync waits for (the
   manual's load calls rely on that). */
void n64_drawn(struct n64 *n64);

/* The same; used: n64_tiles_used. */
void n64_drawn_from(struct n64 *n64, uint32 used);

/* Returns N64_DONE if tile n can be drawn from, or if n64->checked is 0. */
enum n64_result n64_check_tile(const struct n64 *n64, int32 n);

/* Returns N64_DONE if a primitive can be drawn with the cycle type, the tiles in use and the
   combine mode, or if n64->checked is 0. */
enum n64_result n64_check_drawing(const struct n64 *n64);

/* Returns N64_DONE if a vertex's s and t (s15.16, in texels) can be drawn, or if n64->checked
   is 0. */
enum n64_result n64_check_coordinates(const struct n64 *n64, fix16 s, fix16 t);

/* Returns the tiles that a primitive can read: bit n for tile n. */
uint32 n64_tiles_used(const struct n64 *n64);

/* Returns a short text for a result, such as "no load sync". */
const char *n64_result_text(enum n64_result result);

/* load.c: the load commands. They load through n64->tiles[n] and also set that tile's edges. */
enum n64_result n64_load_block_words(struct n64 *n64, uint32 hi, uint32 lo);
enum n64_result n64_load_tile_words(struct n64 *n64, uint32 hi, uint32 lo);
enum n64_result n64_load_tlut_words(struct n64 *n64, uint32 hi, uint32 lo);

/* command.c: the fields of a set-combine word, in the order of struct n64_combine. shift: from bit
   0 of the lower word on. */
struct n64_field {
    uint8 shift, bits;
};

extern const struct n64_field n64_combine_fields[16];

/* command.c: sets a tile's edges from the words of set tile size or of a load. */
void n64_set_edges(struct n64 *n64, uint32 hi, uint32 lo);

/* check.c: returns non-zero if a load may use the format in this size: all that can be drawn
   except 4 bits, and every format as 16 bits. */
int32 n64_loadable_pair(uint32 format, uint32 size);

/* check.c: returns non-zero if texels have half of their bytes in each half of TMEM. */
int32 n64_is_split(const struct n64_tile *tile);

/* combine.c: n64_find_inputs recalculates n64->sources and inputs. n64_check_combine returns N64_DONE if all
   codes are supported. */
void n64_find_inputs(struct n64 *n64);
enum n64_result n64_check_combine(const struct n64_combine *combine);

#endif
