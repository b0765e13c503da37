/* The N64's texture engine: its state and the words that change it.

   A texture engine is a value: a program may have as many as it likes, each with its own
   TMEM. Words are the one way into the state (calls.h writes them); pixel.h draws from it.
   Formats: 10.2 is unsigned with 2 fraction bits; s10.5 signed, 16 bits, 5 of them fraction;
   TMEM words have 64 bits. Memory is big-endian throughout. */
#ifndef TX_H
#define TX_H

#include "compiler.h"

enum tx_format { TX_RGBA, TX_YUV, TX_CI, TX_IA, TX_I };     /* 5-7 act as TX_I */
enum tx_size { TX_4, TX_8, TX_16, TX_32 };                  /* bits a texel */
enum tx_cycle { TX_ONE_CYCLE, TX_TWO_CYCLES, TX_COPY, TX_FILL };

enum tx_constants {
    TX_TMEM_BYTES = 4096,
    TX_TMEM_WORDS = 512,
    TX_HALF_WORDS = 256,        /* the high half holds TLUTs, and the low parts' other halves */
    TX_TILES = 8,
    TX_LOAD_TILE = 7,           /* the calls of calls.h load through it */
    TX_BLOCK_TEXELS = 2048,     /* of one load block */
    TX_COLUMNS_MAX = 1024,      /* of a tile, in texels */
    TX_ROWS_MAX = 256
};

/* Operations: bits 29:24 of a pair's upper word. The upper two bits are not looked at.
   TX_OP_TEXTURE and TX_OP_MODES are no words of the drawing processor: they are what is left
   of the manual's words for the geometry processor, with the fields it gives them. */
enum tx_operation {
    TX_OP_NOTHING = 0x00,
    TX_OP_TEXTURE = 0x17,       /* hi: max_level 13:11, first tile 10:8 */
    TX_OP_MODES = 0x23,         /* hi: 32 - shift - bits 15:8, bits - 1 7:0; lo: the bits */
    TX_OP_LOAD_SYNC = 0x26,
    TX_OP_PIPE_SYNC = 0x27,
    TX_OP_TILE_SYNC = 0x28,
    TX_OP_FULL_SYNC = 0x29,
    TX_OP_CONVERT = 0x2c,
    TX_OP_OTHER_MODES = 0x2f,
    TX_OP_LOAD_TLUT = 0x30,
    TX_OP_TILE_SIZE = 0x32,
    TX_OP_LOAD_BLOCK = 0x33,
    TX_OP_LOAD_TILE = 0x34,
    TX_OP_TILE = 0x35,
    TX_OP_PRIMITIVE = 0x3a,
    TX_OP_ENVIRONMENT = 0x3b,
    TX_OP_COMBINE = 0x3c,
    TX_OP_IMAGE = 0x3d
};

/* What came of a command or a check. All but TX_DONE: nothing was changed. */
enum tx_result {
    TX_DONE,
    TX_UNKNOWN_COMMAND,
    TX_ILLEGAL_PAIR,            /* no such format of this size */
    TX_IMAGE_MISALIGNED,        /* its address is no multiple of 8 */
    TX_IMAGE_4_BIT,             /* in a load: it would hang the hardware */
    TX_OUTSIDE_DRAM,            /* a load reads beyond the memory given */
    TX_LOAD_BACKWARDS,          /* the last texel comes before the first */
    TX_BLOCK_TOO_LARGE,         /* more than TX_BLOCK_TEXELS */
    TX_LOAD_TOO_LARGE,          /* it goes beyond TMEM */
    TX_TLUT_IMAGE,              /* a TLUT's image must have 16 bits, */
    TX_TLUT_TILE,               /* the tile it is loaded through 4 */
    TX_TLUT_ROWS,               /* more than one: it would hang the hardware */
    TX_TLUT_ENTRIES,            /* more than 256, or beyond the end of TMEM */
    TX_TLUT_LOW,                /* it begins in the low half */
    TX_INDEX_HIGH,              /* CI texels in the high half */
    TX_SPLIT_HIGH,              /* low part of RGBA 32 or YUV in the high half */
    TX_TLUT_MODE,               /* a CI tile while TLUT is off, or another while it is on */
    TX_TILE_TOO_LARGE,          /* more than 1024 columns or 256 rows */
    TX_TILE_OUTSIDE,            /* the tile shows texels beyond TMEM */
    TX_TILE_EDGES,              /* sh < sl or th < tl where the tile clamps */
    TX_COMBINE_INPUT,           /* a code that is not supported: noise, chroma key */
    TX_CYCLE_TYPE,              /* not one the texture engine can draw this with */
    TX_COORDINATE_RANGE,        /* not -1024.0 to 1023.96875 texels */
    TX_NO_LOAD_SYNC,            /* strict: a load after drawing without its sync, */
    TX_NO_TILE_SYNC,            /* a change of a tile that was drawn from, */
    TX_NO_PIPE_SYNC,            /* a change of modes */
    TX_LIST_FULL,               /* calls.h: no room for the words */
    TX_NO_MEMORY,               /* decode.h */
    TX_DECODE_TOO_LARGE,        /* its limit: TX_DECODE_BITS */
    TX_RECTANGLE_MODES,         /* a rectangle in perspective or with shade: it has neither */
    TX_RESULTS
};

/* A tile in s or t. */
struct tx_axis {
    uint8 clamp, mirror;        /* 0 or 1 */
    uint8 mask;                 /* 0: none (clamps); n: n low bits of the index, above 10 as 10 */
    uint8 shift;                /* 0-10 right, 11-15 left by 16 - shift */
    uint16 low, high;           /* 10.2: edges, both inside */
};

struct tx_tile {
    uint8 format, size, palette, spare;
    uint16 line, tmem;          /* TMEM words: from row to row (9 bits), of the first */
    struct tx_axis s, t;
};

struct tx_modes {
    uint8 cycle;                /* enum tx_cycle */
    uint8 perspective, detail, sharpen, lod;
    uint8 tlut, tlut_type;      /* type 0: RGBA 16, 1: IA 16 */
    uint8 quad, mid;            /* quad 0: point; 1: filter; mid with it: average */
    uint8 filter0, filter1;     /* in cycle 0 and 1: 1 filter, 0 colour conversion */
    uint8 convert_one;          /* cycle 1 converts cycle 0's result */
};

struct tx_input {
    uint8 a, b, c, d;           /* codes as in the set-combine word */
};

struct tx_combine {
    struct tx_input rgb[2], alpha[2];   /* cycle 0, cycle 1; one-cycle mode uses cycle 1's */
};

struct tx_image {
    uint32 address;             /* into the DRAM given */
    uint8 format, size;
    uint16 width;               /* texels */
};

/* Bits of tx.inputs: what a pixel's colour depends on. */
enum tx_inputs {
    TX_INPUT_TEXEL0 = 1,        /* tile T0's sample, */
    TX_INPUT_TEXEL1 = 2,        /* T1's */
    TX_INPUT_SHADE = 4,
    TX_INPUT_LOD_FRACTION = 8
};

enum tx_pending { TX_PENDING_LOAD = 1, TX_PENDING_TILE = 2, TX_PENDING_PIPE = 4 };

struct tx {
    uint8 tmem[TX_TMEM_BYTES];
    struct tx_tile tiles[TX_TILES];
    struct tx_modes modes;
    struct tx_combine combine;
    struct tx_image image;
    int16 k[6];                 /* K0-K5, signed 9 bits */
    uint8 primitive[4], environment[4];         /* R G B A */
    uint8 primitive_fraction;
    uint8 min_level;            /* 0-31 */
    uint8 max_level;            /* 0-7 */
    uint8 primitive_tile;       /* 0-7: T0, or the first of a mipmap */
    uint32 other_modes;         /* bits 23:0 of the last set other modes */
    uint32 inputs;              /* enum tx_inputs, of this combine mode and cycle type */
    const uint8 *dram;          /* what addresses of images count into, */
    uint32 dram_bytes;          /* multiple of 8 */
    /* Each grows when what it stands for really changes: who keeps something that was made
       from it compares. */
    uint32 tmem_generation, tile_generation[TX_TILES], mode_generation;
    uint8 checked;              /* 1: illegal uses are results of their own; 0: they do what
                                   the hardware does, but those that hang it */
    uint8 strict;               /* 1: a change without its sync is a result of its own */
    uint8 pending;              /* strict: enum tx_pending, set by tx_drawn */
    uint8 pending_tiles;        /* bit n: the primitives that are pending read tile n */
    uint32 command;             /* number in the list of the command being run, from 0 on */
};

struct tx_word {
    uint32 hi, lo;
};

/* Everything 0 but: checked, both cycles filter, the colour is texel 0. dram: may be 0. */
void tx_init(struct tx *tx, const uint8 *dram, uint32 dram_bytes);

/* Runs one pair of words. */
enum tx_result tx_command(struct tx *tx, uint32 hi, uint32 lo);

/* Runs a display list to its end or to the first pair that is refused: tx->command. */
enum tx_result tx_list_run(struct tx *tx, const struct tx_word *words, uint32 count);

/* Drawing calls this after each primitive: syncs are due from now on (strict). Tiles that
   the primitive read: from primitive_tile on, as many as the modes can choose. A pipe sync
   waits for all that a tile sync waits for, so it stands for one too (the manual's load calls
   rely on that). */
void tx_drawn(struct tx *tx);

/* Whether a tile can be drawn from as it is (only where checked). */
enum tx_result tx_check_tile(const struct tx *tx, int32 n);

/* Whether all that a primitive needs is fit for drawing: tiles in use, combine mode. */
enum tx_result tx_check_drawing(const struct tx *tx);

/* Whether a vertex's s and t (s15.16, in texels) can be drawn (only where checked). */
enum tx_result tx_check_coordinates(const struct tx *tx, fix16 s, fix16 t);

/* The tiles a primitive can read: bit n. */
uint32 tx_tiles_used(const struct tx *tx);

/* A line's text for a result, as "no load sync". */
const char *tx_result_text(enum tx_result result);

/* load.c: what the load commands do; the tile is tx->tiles[n], whose edges they also set. */
enum tx_result tx_load_block_words(struct tx *tx, uint32 hi, uint32 lo);
enum tx_result tx_load_tile_words(struct tx *tx, uint32 hi, uint32 lo);
enum tx_result tx_load_tlut_words(struct tx *tx, uint32 hi, uint32 lo);

/* command.c: the edges of a tile as set tile size and the loads give them. */
void tx_set_edges(struct tx *tx, uint32 hi, uint32 lo);

/* check.c: whether a format exists in this size for loads: as for drawing, and views of 16 bits. */
int32 tx_loadable_pair(uint32 format, uint32 size);

/* combine.c: tx->inputs anew; whether all codes that count are supported. */
void tx_find_inputs(struct tx *tx);
enum tx_result tx_check_combine(const struct tx_combine *combine);

#endif
