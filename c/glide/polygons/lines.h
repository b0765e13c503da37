/* Polygons whose lines all have the same passes. */
#ifndef GLIDE_LINES_H
#define GLIDE_LINES_H

#include "glide/passes.h"
#include "span/scanline.h"

enum {
    GLIDE_STAGES = 24,          /* passes of a line; two units have 19 at most */
    GLIDE_STAGE_LONGS = 160,    /* of what they read besides */
    GLIDE_PIXEL_PLACES = 4      /* addresses below this are bytes from the line's first pixel on */
};

/* What a unit iterates. */
struct glide_points {
    struct glide_iterators start;   /* the line's, at pixel -EDGE_BIAS */
    struct glide_iterators across, down;
    struct glide_iterators at;      /* the line's first pixel's */
};

/* One pass: a routine of src68k/glide, none in C. */
struct glide_stage {
    const void *in;
    void *out;
    const void *constants;
    glide_pass *pass;
};

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
};

/* src68k/glide/lines.s: draws the lines. */
void glide_lines(struct glide_lines *lines);

/* lines.c. Adds a pass whose data is `bytes` long. */
void glide_lines_add(struct glide_lines *lines, glide_pass *pass, const void *in, void *out,
                     const void *constants, uint32 bytes);

/* Adds a pass whose data stays where it is. */
void glide_lines_stage(struct glide_lines *lines, glide_pass *pass, const void *in, void *out,
                       const void *constants);

#endif
