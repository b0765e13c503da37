/* The plan of a bench or test run: which kernels to call, with which registers and
   memory, how often; and the results. Big-endian, offsets from the file's start.
   This header is the only definition: the host reads the layout from the
   compiler's debug information. */
#ifndef PLAN_FILE_H
#define PLAN_FILE_H

#include "compiler.h"

enum plan_constants {
    PLAN_MAGIC = 0x504c414e,    /* "PLAN" */
    PLAN_VERSION = 4,
    PLAN_REGISTERS = 15,        /* d0-d7/a0-a6 */
    PLAN_PIECE = 1024,          /* bytes of an image that lie together */
    ARENA_ALIGN = 65536         /* arenas begin at a multiple of this */
};

/* What fetches from chip RAM at the same time: nothing, or eight planes of 256 lines, 64 bits at a
   time, as c/screen has them. */
enum plan_display {
    DISPLAY_OFF,
    DISPLAY_LOW, DISPLAY_HIGH, DISPLAY_SUPER,   /* 320, 640, 1280 dots a line */
    DISPLAY_MODES
};

struct plan_header {
    uint32 magic, version;
    uint32 size;                /* of the whole file, bytes */
    uint32 checksum;            /* of the file from `cases` on: the sum of all longwords, the last
                                   one once, the one before thrice, and so on by odd numbers, so
                                   that one longword that differs always shows */
    uint32 cases, cases_at;
};

/* One call. It has two pieces of memory: `near` where a program's own data would be
   (fast RAM first), and `far`, whose kind is chosen. Their images are copied there;
   to the longwords of `near` at the offsets listed, and to the registers marked,
   the address of one piece or the other is added.

   An image is listed: a longword for each PLAN_PIECE of its bytes, of which the last may
   be shorter, says where in the file they are, or 0: zeros. What cases share is there once. */
struct plan_case {
    uint32 name_at;             /* the kernel's name, ended by 0 */
    uint32 near_at, near;       /* where the image's list is; its bytes: multiples of 4 */
    uint32 far_at, far;
    uint32 far_memory;          /* enum memory_kind */
    uint32 near_offsets_at, near_offsets;       /* 4 bytes each */
    uint32 far_offsets_at, far_offsets;
    uint32 near_registers, far_registers;       /* bit n: register n */
    uint32 registers[15];
    uint32 display;             /* enum plan_display, while it is timed */
    uint32 repeats;             /* timed calls after the one whose memory is kept */
    uint32 limit;               /* for the watchdog, 65,536 E-clocks each */

    /* For the program that shows figures; 0 in plans for others. */
    uint32 title_at;            /* ended by 0 */
    uint32 units;               /* pixels, or steps, that a call draws */
    uint32 chip, fast;          /* thousandths of a cycle that the emulated A1200 takes for each,
                                   with chip RAM alone and with fast RAM; 0: not shown there */
    uint32 drawn;               /* checksum of `far` after a call; 0: none */
};

/* What a case leaves, behind near's and far's bytes after the first call. */
struct plan_result {
    uint32 near, far;           /* their addresses */
    uint32 ticks;               /* colour clocks, of all repeats */
    uint32 registers[15];
    int32 stack;                /* by how much sp was off */
};

#endif
