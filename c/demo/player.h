/* One part of the demo while it is played.

   A frame is drawn while the one before it waits to be shown, and converted as soon as that one is
   shown; the display then shows it at its field by itself. So drawing may extend into the time of
   the next frame, and the next frames can catch up. */
#ifndef PLAYER_H
#define PLAYER_H

#include "demo/script.h"
#include "polygon/scratch.h"
#include "scene/scene.h"
#include "screen/screen.h"

enum player_constants {
    FRAME_FIELDS = 2,           /* 25 frames a second */
    LINE_TICKS = 227,           /* colour clocks */
    FRAME_TICKS = FRAME_FIELDS * 312 * LINE_TICKS,
    /* All work is timed; a twentieth is left for catching up after long frames. */
    FRAME_BUDGET = FRAME_TICKS * 95 / 100,
    /* Where panes take turns: from the start of one frame on the screen to the end of the next
       one's conversion, less the system's own work of up to 46 lines each tenth of a second. */
    TURNS_BUDGET = 2 * FRAME_TICKS - 2 * 46 * LINE_TICKS,
    FIGURES_EVERY = 25,         /* frames from one update of the figures to the next; */
    FIGURES_APART = 2,          /* from one of their lines to the next, as each takes time */
    COUNT_EVERY = 4,            /* one picture of these has its pixels counted: that takes time */
    CAPTION_GAP = 3, CAPTION_LINES = 3      /* pixels; below a pane: caption, cycles, rate */
};

/* No limit: the watchdog acts in quiet mode only. */
#define CLOCK_LIMIT 65535

enum player_end {
    PLAYED,
    SKIPPED,                    /* space */
    LEFT,                       /* escape */
    BROKEN,                     /* Ctrl-C */
    FAILED                      /* a line was printed */
};

/* The state of a pane. */
struct lane {
    struct frame frame;         /* within the player's */
    uint32 used;                /* colour clocks of drawing: PART_RACE and PART_FAIR go by them */
    uint32 last, converting;    /* of the last picture; the most that turning one into planes took */
    uint32 pictures;            /* drawn; */
    uint32 seen, figured;       /* pictures and field of the last figures */
    uint32 counted, pixels;     /* colour clocks and pixels of the pictures that were counted since */
    uint32 stale;               /* bit n: set n of planes does not have the picture; */
    uint32 unlabelled;          /* nor the line of figures */
    int32 line;                 /* that was written last */
    uint32 worst;             /* colour clocks: no picture takes longer */
    uint32 cost;                /* cycles a pixel, lately */
    uint32 sum;                 /* colour clocks of all other pictures, modulo 2^32 */
};

/* A frame's figures for LOG. */
struct worked {
    uint32 work, excluded;      /* as the player's */
    uint32 lines;               /* raster lines since the previous frame was shown, when ready */
    uint32 step, fields;        /* fields from the previous frame on the screen to this one */
};

struct player {
    struct screen *screen;
    struct scene *scene;
    const struct part *part;
    struct frame frame;         /* the screen's; of 16- and 32-bit scenes the scene's */
    struct renderer renderer;
    struct scratch scratch;
    struct draw_counts *counts; /* one a material */
    struct governor governor;
    struct lane lane[PANES_MAX];
    int32 set;                  /* pane and step whose settings are in effect, or -1 */
    uint32 began, shown;        /* fields: start of the part, of the last frame shown */
    uint32 due;                 /* field of the frame that was posted after it */
    uint32 frames, late;        /* frames, and those that took more than FRAME_FIELDS */
    uint32 figured, figured_frames;     /* field and frames at the last status line */
    int32 whole;                /* frames for which whole panes are converted: the step changed */
    uint32 work;                /* colour clocks of the next frame without waits, */
    uint32 excluded;            /* and those among them that the governor does not count */
    struct worked *worked;      /* one a frame, or 0 */
    uint32 ink, ground;         /* pixels */
};

/* Plays a part for its seconds or, if not 0, for so many frames. The screen must be open. */
enum player_end player_play(struct player *player, uint32 frames);

/* Returns the colour clocks since the last call and adds them to the frame's work. */
uint32 player_lap(struct player *player);

/* figures.c: writes a part's texts to the screen; updates the figures after each frame. */
void figures_first(struct player *player);
void figures_make(struct player *player);

/* Restarts the figures for a new step. */
void figures_again(struct player *player);

/* lanes.c: draws a pane's next picture. */
void lane_draw(struct player *player, int32 number);

/* Times each pane's most expensive picture, if panes take turns. */
void lanes_probe(struct player *player);

/* Draws a picture of each pane; if panes take turns, the pictures that there is time for. */
void lanes_draw(struct player *player);

/* Converts pictures and figures that the hidden planes lack. */
void lanes_convert(struct player *player);

#endif
