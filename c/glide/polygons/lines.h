/* What lines are drawn by: the renderer's scratch room, and where all of a polygon have the same passes,
   these (lines.c). */
#ifndef GLIDE_LINES_H
#define GLIDE_LINES_H

#include "glide/glide.h"
#include "glide/passes.h"
#include "limits.h"
#include "span/scanline.h"

/* A texel is its bytes' entries, exclusive-ored: no bit of its colour comes from both. */
struct glide_bytes {
    uint32 low[256], high[256];
};

struct glide_line_scratch {
    /* Between the passes of a line. */
    uint32 coordinates[FRAME_SIDE_MAX];
    uint32 texels[FRAME_SIDE_MAX], other[FRAME_SIDE_MAX], colours[FRAME_SIDE_MAX];
    /* Where pixels' LODs are needed. */
    uint16 lods[FRAME_SIDE_MAX];
    uint8 details[FRAME_SIDE_MAX];
    uint32 quarters[4][FRAME_SIDE_MAX / 4];     /* of a line: each fourth pixel */
    /* While a level is decoded, in the middle of a line. */
    struct glide_bytes bytes;
    /* The pixels of a line that is only counted; of lines that are drawn together, before they are in the frame. */
    uint32 unseen[FRAME_SIDE_MAX];
};

enum {
    GLIDE_STAGES = 24,          /* passes of a line; two units have 19 at most */
    GLIDE_STAGE_LONGS = 160,    /* of what they read besides */
    GLIDE_ACROSS = 3, GLIDE_DOWN = 6,   /* longs from an iterator's start to its steps */
    GLIDE_TOGETHER = 32,        /* pixels of the longest lines that are drawn together */
    GLIDE_PIXEL_PLACES = 4      /* addresses below this are bytes from the line's first pixel on */
};

/* What a unit iterates. */
struct glide_points {
    struct glide_iterators start;   /* the line's, at pixel -EDGE_BIAS */
    struct glide_iterators across, down;
    struct glide_iterators at;      /* the line's first pixel's; w is set if it is the same in all */
    int32 deep;                     /* 0: it is */
};

/* One pass: a routine of src68k/glide, none in C. */
struct glide_stage {
    const void *in;
    void *out;
    const void *constants;
    glide_pass *pass;
};

/* What a polygon's lines are drawn by, if all have the same passes. */
struct glide_lines {
    const struct scanline *lines;
    int32 count;                /* of lines, 1 or more */
    uint8 *pixels;              /* the first line's pixel -EDGE_BIAS */
    int32 pitch, bits;          /* bytes from line to line; a pixel has 2^bits */
    uint16 last_points, last_stage;     /* numbers of the last ones that are used */
    struct glide_points points[2];      /* at GLIDE_S, at GLIDE_OWN */
    struct glide_stage stages[GLIDE_STAGES];
    uint32 constants[GLIDE_STAGE_LONGS];
    uint32 longs;               /* of them that are used */
    int32 is_full;              /* there was no room for a pass */
    uint16 lods[2];   /* of all pixels; so are the details */
    uint16 details[2];    /* a byte is used */
    struct glide_steps steps[GLIDE_UNITS];  /* what passes to coordinates read */
    int32 firsts[GLIDE_UNITS];  /* their planes */
    int32 steps_used;
    int32 joins;                /* passes behind the first one may draw all lines at once */
    int32 is_kept;              /* passes are those of every polygon with the same `bits` and these: */
    int32 is_plain;             /* polygons of one depth may be drawn from a page instead */
    uint32 own;
    const struct scratch *scratch;
    int32 divided[GLIDE_UNITS];
    uint32 states[GLIDE_UNITS];
};

#endif
