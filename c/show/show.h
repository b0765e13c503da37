/* The scene that `show` plays: its frames, what they cost and how far they are off. */
#ifndef SHOW_H
#define SHOW_H

#include "frames/frames.h"
#include "polygon/scratch.h"
#include "scene/settings.h"
#include "screen/screen.h"
#include "show/figures.h"
#include "show/ladder.h"
#include "show/times.h"

struct show {
    struct scene scene;
    struct frame frame, exact;  /* exact.pixels is 0 if memory is short; that one is never coarse */
    struct touched touched;     /* of frame, where that begins with the background */
    struct touched *asked;      /* that, or 0 if it is drawn whole */
    struct screen screen;
    struct screen_form form;
    struct settings settings;
    struct ladder ladder;
    struct governor governor;   /* of the ladder's rungs, while a rate is held */
    int32 fields;               /* of the rate that is held: of each frame, at least; 0: none is */
    uint32 shown;               /* the field since which the last frame is shown, while a rate is held */
    struct renderer renderer;
    struct scratch scratch;
    struct scene_counts counts;
    struct measured measured;
    struct rate rate;
    uint32 next_measuring;      /* field */
    int32 number, paused;
    int32 is_plain;             /* 1: without status lines, and nothing is measured */
    int32 count;                /* of frames to show; 0: until a key ends it */
    int32 is_broken;            /* by Ctrl-C */
    int32 has_tables;           /* 0: no memory for tables of perspective */
    uint32 ticks;               /* of the last frame */
    struct frame_time *times;   /* of each frame counted; 0: they are not asked for */
    uint32 refused;             /* enum polygon_result: the last one refused, or POLYGON_DRAWN */
};

/* Makes the frames, the counts, the clock and the screen. Prints a line and returns 0 if something necessary is lacking. */
int32 show_make(struct show *show, int32 has_times);

/* Sets the materials as show->settings say; what was measured before no longer counts. */
void show_set(struct show *show);

/* Draws the current frame. */
void show_draw(struct show *show);

/* Measures the frame that was just drawn: its pixels, and, if memory allows, how many are not the exact picture's. */
void show_measure(struct show *show);

/* Writes the two status lines. */
void show_describe(struct show *show);

/* Draws the current frame, with status lines unless show->is_plain, and shows it at the next field. Returns 0 if the screen cannot be opened for its pixels. */
int32 show_present(struct show *show);

/* The same without status lines, and sets `time` but for the field; show->shown is since when the frame before is shown. */
int32 show_timed(struct show *show, struct frame_time *time);

/* Holds a rate from now on: begins with the scene's settings. fields: of a frame; 0: no rate, the scene's settings. */
void show_hold(struct show *show, int32 fields);

/* Draws the current frame and posts it for when the one before, since show->shown on the screen, has had its fields;
   chooses the next frame's rung. Sets `time` but for the field. Returns 0 as show_present. */
int32 show_held(struct show *show, struct frame_time *time);

#endif
