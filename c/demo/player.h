/* One part of the demo while it is played. */
#ifndef PLAYER_H
#define PLAYER_H

#include "demo/script.h"
#include "scene/scene.h"
#include "screen/screen.h"

enum player_constants {
    FRAME_FIELDS = 2,           /* 25 frames a second */
    /* Colour clocks: two fields of 312 lines of 227, less a hundredth for what is not timed, keys
       and waits. */
    FRAME_BUDGET = 2 * 312 * 227 * 99 / 100,
    FIGURES_EVERY = 25,         /* frames between two looks at the figures */
    CAPTION_GAP = 2, CAPTION_LINES = 3      /* below a pane: caption, cycles, rate */
};

enum player_end {
    PLAYED,
    SKIPPED,                    /* space */
    LEFT,                       /* escape */
    BROKEN,                     /* Ctrl-C */
    FAILED                      /* a line was printed */
};

/* A pane's picture. */
struct lane {
    struct frame frame;         /* within the player's */
    uint32 used;                /* colour clocks of drawing: PART_RACE and PART_FAIR go by them */
    uint32 last, converting;    /* of the last picture, and of turning it into planes */
    uint32 pictures, seen;      /* drawn, and when figures were last made */
    uint32 pixels;              /* of the polygons of a picture lately */
    uint32 stale;               /* bit n: set n of planes does not have the picture; */
    uint32 unlabelled;          /* nor the figures */
    uint32 sum;                 /* colour clocks of all pictures, modulo 2^32 */
};

struct player {
    struct screen *screen;
    struct scene *scene;
    const struct part *part;
    struct frame frame;         /* the screen's; of 16- and 32-bit scenes the scene's */
    struct draw_counts *counts; /* one a material */
    struct governor governor;
    struct lane lane[PANES_MAX];
    int32 set;                  /* pane and step of the settings that are set, or -1 */
    uint32 began, shown;        /* fields: the part, the last swap */
    uint32 frames, late;        /* frames, and those that took more than FRAME_FIELDS */
    uint32 figured, figured_frames;     /* field and frames of the last look at the figures */
    int32 whole;                /* frames for which panes are shown whole: the step is another */
    uint32 work;                /* colour clocks of this frame */
    uint32 *works;              /* of each frame, and its step in the highest byte; or 0 */
    uint8 ink, ground;
};

/* Plays a part until its time or, where not 0, so many frames are over; the screen is open. */
enum player_end player_play(struct player *player, uint32 frames);

/* figures.c: what is measured, on the screen. */
void figures_make(struct player *player);
void figures_first(struct player *player);

/* lanes.c: draws a pane's next picture. */
void lane_draw(struct player *player, int32 number);

/* Draws what there is time for. */
void lanes_draw(struct player *player);

/* Turns what the hidden planes lack into them. */
void lanes_convert(struct player *player);

#endif
