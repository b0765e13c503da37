/* Which pixels of a frame are drawn already: polygons are drawn front to back, each pixel once. */
#ifndef COVERAGE_H
#define COVERAGE_H

#include "drawing/deep.h"

enum coverage_constants {
    COVERAGE_GAPS = 8           /* room for gaps, for each line of the frame */
};

/* Pixels of a line that are not drawn yet, x + EDGE_BIAS, both included. */
struct gap {
    int16 left, last;
    struct gap *next;           /* the next one to the right */
};

/* A visible part of a polygon's line that is not visible whole. */
struct visible_part {
    uint16 row;                 /* of the polygon's table */
    uint16 left;
    int16 last;                 /* below left: the line is hidden whole */
};

/* Lines of a table that are drawn after it, in runs: second parts, or further ones. */
struct cut_lines {
    struct scanline *lines;
    struct scanline_step *steps;
    uint16 *rows;               /* of each */
    int32 count;
};

/* How the polygon that is drawn now is drawn. */
enum cover_way {
    COVER_DIRECT,               /* no pixel is hidden */
    COVER_CUT,                  /* its lines are cut, once they are made */
    COVER_ASIDE,                /* into the frame aside; visible parts are then copied */
    COVER_LINES_ASIDE           /* only lines of which the visible parts say so */
};

struct coverage {
    struct gap **rows;          /* of each line of the frame the first gap */
    struct gap *unused;         /* gaps, linked; 0: none, then those from `fresh` on are unused */
    struct gap *fresh;
    struct gap end;             /* behind all gaps of all lines */
    struct gap *gaps;
    struct visible_part *parts;         /* in the order of lines, of the last scan */
    struct visible_part *parts_end;
    int32 room, left;           /* gaps in memory, unused ones */
    int32 open;                 /* lines with gaps */
    int32 overflow;             /* 1: there were not enough gaps: draw all again, back to front */
    int32 seen;                 /* 1: the last scan has found visible pixels */
    int32 shown;                /* 1: a scan has, since it was set to 0 */
    enum cover_way way;
    int32 aside;                /* bytes from the frame to the one aside */
    uint8 *aside_pixels;
    struct cut_lines second, further;
    int32 deep_is_set;          /* in this frame: 1: deep is, 0: not yet, -1: it cannot be */
    struct deep deep;           /* of polygons in perspective; its setup's material: the last one's, or 0 */
};

/* Everything coverage_scan needs. */
struct scan_plan {
    const struct scanline *lines;       /* left and last are read */
    int32 count;                /* lines, 1 or more */
    struct gap **rows;          /* the first line's */
    struct coverage *coverage;
};

/* Begins a frame: no pixel is covered. Until the next one, the renderer and the materials that are drawn stay as they
   are. */
void coverage_begin(struct coverage *coverage, const struct frame *frame);

/* Returns 1 if all pixels of the frame in a box, right and bottom included, are covered. */
int32 coverage_hides_box(const struct coverage *coverage, const struct frame *frame, const struct rectangle *box);

/* Returns the number of pixels of the frame in a box, right and bottom included, that are not covered. */
int32 coverage_open(const struct coverage *coverage, const struct frame *frame, const struct rectangle *box);

/* Draws what of a polygon renderer->coverage does not hide, as polygon_draw would draw it whole, and covers it. */
polygon_routine coverage_draw;

/* The same without a test whether all of its box is hidden. */
polygon_routine coverage_draw_met;

/* Returns 1 if all pixels of the frame that vertices' box has are covered. */
int32 coverage_hides(const struct coverage *coverage, const struct frame *frame,
                     const struct vertex *vertices, int32 count);

/* Finds what of a polygon is visible, as coverage_scan, covers it and draws it by cover_rest. Its vertices are set as
   material_vertices makes them. Returns enum polygon_result or DEEP_CONSTANT. src68k/polygon: contract there. */
int32 cover_draw(struct deep *deep);

/* Draws what the last scan found of a polygon whose edges, table of lines and, if is_sure, depth are made. */
enum polygon_result cover_rest(struct deep *deep, int32 is_sure);

/* src68k/coverage: contract there. */
void coverage_scan(const struct scan_plan *plan);

#endif
