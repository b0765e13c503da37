/* One part of the demo while it is played.

   A picture is drawn and converted while the one before it waits to be shown; the blitter ends its conversion, if it
   has a share, while the next one is drawn. The display shows it at its field by itself. */
#ifndef PLAYER_H
#define PLAYER_H

#include "demo/script.h"
#include "polygon/scratch.h"
#include "scene/scene.h"
#include "screen/screen.h"

enum player_constants {
    CLOCK_FIELDS = 2,           /* a frame of a scene that follows the clock: 25 a second */
    TURNS_BUDGET = FIELD_TICKS * 90 / 100,      /* panes that take turns leave another one to spare */
    FIGURES_FIELDS = 50,        /* from one update of the figures to the next */
    COUNT_EVERY = 4             /* where panes are compared, one picture of these is counted: that takes time */
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
    uint32 last;                /* of the last picture */
    uint32 pictures;            /* drawn; */
    uint32 seen;                /* pictures at the last figures */
    uint32 counted, pixels;     /* colour clocks and pixels of the pictures that were counted since */
    uint32 worst;               /* colour clocks: no picture takes longer */
    uint32 cost;                /* cycles a pixel, lately */
    uint32 sum;                 /* colour clocks of all other pictures, modulo 2^32 */
};

/* A frame's figures for LOG. */
struct worked {
    uint32 work;                /* as the player's */
    uint32 lines;               /* raster lines since the previous frame was shown, when ready */
    uint32 step, fields;        /* fields from the previous frame on the screen to this one */
};

struct player {
    struct screen *screen;
    struct scene *scene;
    const struct part *part;
    struct screen_form form;
    struct frame frame;         /* of all panes */
    struct renderer renderer;
    struct scratch scratch;
    struct draw_counts *counts; /* one a material */
    struct governor governor;
    struct lane lane[PANES_MAX];
    int32 set;                  /* pane and step whose settings are in effect, or -1 */
    uint32 began, shown;        /* fields: start of the part, of the last frame shown */
    uint32 due;                 /* field of the frame that was posted after it */
    uint32 asked;               /* display_fields when the part was called for; */
    uint32 waited, black;       /* fields from then to its first picture; those of them with a black screen */
    uint32 frames, late;        /* frames; those that took more than their step's fields, not in PART_FREE */
    uint32 figured, figured_frames;     /* field and frames at the last status line */
    uint32 work;                /* colour clocks of the next frame without waits */
    struct worked *worked;      /* one a frame, or 0 */
    uint32 ink, ground;         /* pixels */
};

/* Opens the screen and plays a part for its seconds or, if not 0, for so many frames. */
enum player_end player_play(struct player *player, uint32 frames);

/* Returns the colour clocks since the last call and adds them to the frame's work. */
uint32 player_lap(struct player *player);

/* figures.c: writes a part's texts to the screen; updates the figures once a second. */
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

#endif
