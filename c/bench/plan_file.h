/* The plan of a bench or test run: the kernels to call, their registers and memory, and the number
   of calls; and the results. Big-endian, offsets from the file's start. This header is the only
   definition: the host reads the layout from the compiler's debug information. */
#ifndef PLAN_FILE_H
#define PLAN_FILE_H

#include "compiler.h"

enum plan_constants {
    PLAN_MAGIC = 0x504c414e,    /* "PLAN" */
    PLAN_VERSION = 5,
    PLAN_REGISTERS = 15,        /* d0-d7/a0-a6 */
    PLAN_PIECE = 1024,          /* bytes of an image's piece */
    PLAN_WRITTEN = 1,           /* bit of a piece's offset: the call may write it */
    PLAN_HELD = 1024,           /* pieces of a `far` that may be left as they are */
    ARENA_ALIGN = 65536         /* arenas begin at a multiple of this */
};

/* The display while a case is timed: none, or eight planes of 256 lines fetched from chip RAM, 64
   bits at a time, as in c/screen. */
enum plan_display {
    DISPLAY_OFF,
    DISPLAY_LOW, DISPLAY_HIGH, DISPLAY_SUPER,   /* 320, 640, 1280 dots a line */
    DISPLAY_MODES
};

struct plan_header {
    uint32 magic, version;
    uint32 size;                /* of the whole file, bytes */
    uint32 checksum;            /* of the file from `cases` on: the sum of all longwords, the last
                                   one times 1, the one before times 3, and so on with odd factors:
                                   a single wrong longword is always detected */
    uint32 cases, cases_at;
};

/* One call. It has two pieces of memory: `near`, allocated like a program's own data (fast RAM
   first), and `far`, of the kind chosen. Their images are copied there; then the address of one
   piece or the other is added to the listed longwords of `near` and to the marked registers.

   An image is a list with a longword for each PLAN_PIECE of its bytes, of which the last may be
   shorter: the piece's offset in the file, or 0 for zeros, and PLAN_WRITTEN. Cases share equal pieces.
   A piece of `far` that the last call may not write, and that the next one has at the same place, is
   not copied again: that is most of a map's. Of `far` the last piece, and those from PLAN_HELD on, have
   PLAN_WRITTEN. */
struct plan_case {
    uint32 name_at;             /* the kernel's name, ended by 0 */
    uint32 near_at, near;       /* offset of the image's list; its bytes: multiples of 4 */
    uint32 far_at, far;
    uint32 far_memory;          /* enum memory_type */
    uint32 near_offsets_at, near_offsets;       /* 4 bytes each */
    uint32 far_offsets_at, far_offsets;
    uint32 near_registers, far_registers;       /* bit n: register n */
    uint32 registers[15];
    uint32 display;             /* enum plan_display, while it is timed */
    uint32 repeats;             /* timed calls after the first one, whose memory is the result */
    uint32 limit;               /* for the watchdog, 65,536 E-clocks each */

    /* For the program measure; 0 in other plans. */
    uint32 title_at;            /* ended by 0 */
    uint32 units;               /* pixels, or steps, that a call draws */
    uint32 chip, fast;          /* thousandths of a cycle that the emulated A1200 takes for a unit,
                                   with chip RAM alone and with fast RAM; 0: not shown there */
    uint32 drawn;               /* checksum of `far` after a call; 0: none */
};

/* A case's result, after the bytes as the first call left them: of near, and of far's pieces that have
   PLAN_WRITTEN. The others are compared with the plan before they are replaced, and after the last
   call; a longword at the file's end counts those that a call has changed. */
struct plan_result {
    uint32 near, far;           /* their addresses */
    uint32 ticks;               /* colour clocks, of all repeats */
    uint32 registers[15];
    int32 stack;                /* change of sp during the call */
};

#endif
