/* Which pixels of a frame may differ from its background: so much of it is cleared again, and brought to the screen.

   Bands of some lines each, from their leftmost to their rightmost such pixel, in steps of TOUCHED_STEP. */
#ifndef TOUCHED_H
#define TOUCHED_H

#include "polygon/edges.h"
#include "polygon/polygon.h"

enum touched_constants {
    TOUCHED_BANDS = 32,
    TOUCHED_ROWS_LOG = 3,       /* log2 of the fewest lines in a band */
    TOUCHED_STEP = 32,          /* pixels */
    TOUCHED_REST = 16,          /* frames */
    TOUCHED_BEYOND = 2          /* pixels: no setting draws farther outside of the vertices' box */
};

/* Pixels of a band; right is excluded: those of an empty one are 0. */
struct touched_band {
    int16 left, right;
};

struct touched {
    int32 rows_log;             /* log2 of a band's lines */
    int32 rest;                 /* touched_ask's: the calls until it asks again */
    int32 width, height;        /* of the frame, pixels */
    struct touched_band bands[TOUCHED_BANDS];
};

/* Sets the size of frames; no pixel of them differs. */
void touched_begin(struct touched *touched, int32 width, int32 height);

/* No pixel differs; all may. */
void touched_clear(struct touched *touched);
void touched_fill(struct touched *touched);

/* Called once a frame. Returns `touched`, or 0 for TOUCHED_REST frames after one that was touched all over: those are
   drawn whole, as keeping count costs time then and saves none. */
struct touched *touched_ask(struct touched *touched);

/* Adds the pixels in a box, which may be partly or wholly outside of the frame, and TOUCHED_BEYOND around it. */
void touched_add(struct touched *touched, const struct rectangle *box);

/* Sets it to, or adds, the pixels of another, of frames of the same size. */
void touched_copy(struct touched *touched, const struct touched *other);
void touched_join(struct touched *touched, const struct touched *other);

/* Sets *box to the next run of bands with the same pixels, from line `from` on, and returns it; its bottom is the next
   call's `from`. A box without lines: there are no more. */
struct rectangle *touched_next(const struct touched *touched, int32 from, struct rectangle *box);

/* Sets a box around all of them; one without lines if there are none. */
void touched_box(const struct touched *touched, struct rectangle *box);

#endif
