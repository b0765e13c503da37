/* Questions to the texture engines and their answers, for the program vectors. Big-endian longs,
   offsets from the file's start. This header is the only definition: the host reads it from the
   compiler's debug information. */
#ifndef VECTOR_FILE_H
#define VECTOR_FILE_H

#include "compiler.h"

enum vector_constants {
    VECTOR_MAGIC = 0x56454354,  /* "VECT" */
    VECTOR_VERSION = 1,
    VECTOR_DRAM_BYTES = 0x100000,       /* Glide: both units' memory and the texels of a call */
    VECTOR_GLIDE_BYTES = 0x40000, /* of each texture unit */
    VECTOR_RANDOM_FROM = 0x1000,        /* the range that VECTOR_DRAM_RANDOM fills */
    VECTOR_RANDOM_END = 0x9000,
    VECTOR_CALL_PAIRS = 8,      /* most pairs of words of one call */
    VECTOR_TEXT_BYTES = 64
};

struct vector_header {
    uint32 magic, version;
    uint32 size;                /* of the whole file, bytes */
    uint32 checksum;            /* CRC-32 of the file from operations_at on */
    uint32 operations_at, operations;
};

/* One operation, followed by its longs. Questions append their answers to the results, a long for
   each number. */
struct vector_operation {
    uint16 code, longs;
};

/* Each operation's longs and, after =, its answers. Colours are 4 longs R G B A. The N64's engine
   and Glide's share memory: reset an engine before using it after the other. */
enum vector_code {
    VECTOR_RESET,               /* a new texture engine, unchecked; DRAM is 0 */
    VECTOR_TMEM_RANDOM,         /* seed */
    VECTOR_TLUT_RANDOM,         /* seed */
    VECTOR_DRAM_RANDOM,         /* seed */
    VECTOR_TMEM,                /* address, bytes: a long each */
    VECTOR_DRAM,                /* address, bytes: a long each */
    VECTOR_MODE,                /* byte of struct n64_modes, value */
    VECTOR_TILE,                /* n, fields in the order of a line `tile` */
    VECTOR_CONVERT,             /* K0-K5 */
    VECTOR_WORDS,               /* pairs: each is run, results are ignored */
    VECTOR_CHECKED,             /* 0 or 1 */
    VECTOR_STRICT,              /* 0 or 1 */
    VECTOR_DRAWN,               /* notes that a primitive was drawn */
    VECTOR_HASH,                /* = FNV-1a of TMEM */
    VECTOR_FETCH,               /* tile, s, t = texel */
    VECTOR_SAMPLE,              /* tile, s, t, cycle = colour */
    VECTOR_SAMPLE_BOTH,         /* tile of cycle 0, of cycle 1, s, t = two colours */
    VECTOR_DIVIDE,              /* s, t, w = raw s, raw t, s, t */
    VECTOR_PIXEL,               /* s, t, w, their 6 gradients, first tile, max_level, min_level
                                   = s, t, tile 0, tile 1, fraction, two colours */
    VECTOR_COPY,                /* tile, s, t = two longs */
    VECTOR_LIST,                /* pairs = enum n64_result, command */
    VECTOR_CHECK_TILE,          /* tile = enum n64_result */
    VECTOR_CHECK_DRAWING,       /* = enum n64_result */
    VECTOR_CHECK_COORDINATES,   /* s, t = enum n64_result */
    VECTOR_GENERATIONS,         /* tile = those of TMEM, the tile, the modes */
    VECTOR_DRAW,                /* s, t, w, their 6 gradients, shade = R G B A in one long */
    VECTOR_CALL,                /* room in pairs, enum vector_call, its arguments
                                   = enum n64_result, pairs, VECTOR_CALL_PAIRS pairs */
    VECTOR_DECODE,              /* tile, with quads = enum n64_result, columns_bits, rows_bits,
                                   1 if made anew, the texels' address */
    VECTOR_RESULT_TEXT,         /* enum n64_result = VECTOR_TEXT_BYTES characters, or 0, each */
    VECTOR_DECODED,             /* tile, s, t (s10.5) = texel, quad's result or 0 */
    /* Glide's texture units. Operations use the chosen unit, if they name none. */
    VECTOR_GLIDE_RESET,         /* bits of weights: new units, unit 0 chosen; memory is 0 */
    VECTOR_GLIDE_CHOOSE,        /* unit */
    VECTOR_GLIDE_RANDOM,        /* seed: memory, each long's lowest byte first */
    VECTOR_GLIDE_PALETTE_RANDOM,  /* seed */
    VECTOR_GLIDE_NCC_RANDOM,    /* seed: the registers of both tables */
    VECTOR_GLIDE_REGISTERS,     /* the four */
    VECTOR_GLIDE_GRADIENTS,     /* of s and t: by x, by y */
    VECTOR_GLIDE_PIXEL,         /* s, t, w, other, x, y = A R G B */
    VECTOR_GLIDE_CHAIN,         /* units, mask of those with their own points, s, t, w of both, x, y
                                   = A R G B */
    VECTOR_GLIDE_CALL,          /* enum vector_glide_call, its arguments
                                   = enum glide_result, the four registers, the call's answer */
    VECTOR_GLIDE_GENERATIONS,   /* = those of memory, tables, modes */
    VECTOR_GLIDE_BYTES_OF,      /* address, bytes / 4 = longs, big-endian */
    VECTOR_GLIDE_SUM,           /* level = sum of its texels, each times 2 * its number + 1 */
    VECTOR_GLIDE_QUOTIENT,      /* s, w = s / w */
    VECTOR_GLIDE_LOGARITHM,     /* upper, lower long = 8.8 */
    VECTOR_GLIDE_LOD,           /* 4 gradients = 8.8 */
    VECTOR_GLIDE_RESULT_TEXT,   /* enum glide_result = VECTOR_TEXT_BYTES characters, or 0, each */
    VECTOR_CODES
};

/* The calls of n64/calls.h, with their arguments in order. */
enum vector_call {
    VECTOR_CALL_TEXTURE_BLOCK,
    VECTOR_CALL_TEXTURE_BLOCK_4B,
    VECTOR_CALL_TEXTURE_TILE,
    VECTOR_CALL_TEXTURE_TILE_4B,
    VECTOR_CALL_TLUT_16,
    VECTOR_CALL_TLUT_256,
    VECTOR_CALL_IMAGE,
    VECTOR_CALL_TILE,
    VECTOR_CALL_TILE_SIZE,
    VECTOR_CALL_LOAD_BLOCK,
    VECTOR_CALL_LOAD_TILE,
    VECTOR_CALL_LOAD_TLUT,
    VECTOR_CALL_TEXTURE,
    VECTOR_CALL_CYCLE,
    VECTOR_CALL_PERSPECTIVE,
    VECTOR_CALL_DETAIL,
    VECTOR_CALL_LOD,
    VECTOR_CALL_LUT,
    VECTOR_CALL_FILTER,
    VECTOR_CALL_CONVERSION,
    VECTOR_CALL_CONVERT,
    VECTOR_CALL_COMBINE,
    VECTOR_CALL_PRIMITIVE,
    VECTOR_CALL_ENVIRONMENT,
    VECTOR_CALL_LOAD_SYNC,
    VECTOR_CALL_TILE_SYNC,
    VECTOR_CALL_PIPE_SYNC,
    VECTOR_CALL_FULL_SYNC,
    VECTOR_CALLS
};

/* The calls of glide/glide.h, with their arguments in order. A struct glide_texture is given field
   by field. Texels are given as a seed: they are the random longs that follow it. */
enum vector_glide_call {
    VECTOR_GLIDE_CALL_INIT,             /* bytes; the memory is the unit's */
    VECTOR_GLIDE_CALL_MEMORY_REQUIRED,  /* answer: the bytes */
    VECTOR_GLIDE_CALL_SOURCE,
    VECTOR_GLIDE_CALL_DOWNLOAD,
    VECTOR_GLIDE_CALL_DOWNLOAD_LEVEL,
    VECTOR_GLIDE_CALL_DOWNLOAD_ROWS,
    VECTOR_GLIDE_CALL_PALETTE,          /* first, last, entries; answer: vector_sum of all
                                           entries */
    VECTOR_GLIDE_CALL_NCC,              /* table, Y, I, Q; answer: vector_sum of its values */
    VECTOR_GLIDE_CALL_NCC_REGISTERS,    /* table, registers; the same answer */
    VECTOR_GLIDE_CALL_NCC_SELECT,
    VECTOR_GLIDE_CALL_FILTER,
    VECTOR_GLIDE_CALL_FRACTION_BITS,
    VECTOR_GLIDE_CALL_CLAMP,
    VECTOR_GLIDE_CALL_MIPMAP,
    VECTOR_GLIDE_CALL_BLEND_LEVELS,
    VECTOR_GLIDE_CALL_LOD_BIAS,
    VECTOR_GLIDE_CALL_DETAIL,
    VECTOR_GLIDE_CALL_COMBINE,
    VECTOR_GLIDE_CALL_PERSPECTIVE,
    VECTOR_GLIDE_CALL_REGISTERS,
    VECTOR_GLIDE_CALL_SUBDIVISION,
    VECTOR_GLIDE_CALL_CHAIN,            /* glide_chain_init, glide_chain_hints: units, own */
    VECTOR_GLIDE_CALLS
};

#endif
