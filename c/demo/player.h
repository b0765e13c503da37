/* One part of the demo while it is played.

   A frame is drawn while the one before it waits to be shown, and becomes planes as soon as that
   is; the display then takes it at its field by itself. So a picture may end in the time of the next
   frame, and what one frame takes longer the next ones can take less. */
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
    /* All work is timed; a twentieth is to catch up what some frames take longer. */
    FRAME_BUDGET = FRAME_TICKS * 95 / 100,
    /* From one frame on the screen to the end of the next one's conversion, where panes take turns,
       less what the system may do meanwhile: up to 46 lines each tenth of a second. */
    TURNS_BUDGET = 2 * FRAME_TICKS - 2 * 46 * LINE_TICKS,
    FIGURES_EVERY = 25,         /* frames between two looks at the figures, */
    FIGURES_APART = 2,          /* from one line to the next: each takes time, */
    COUNT_EVERY = 4,            /* pictures between two whose pixels are counted: that too */
    CAPTION_GAP = 3, CAPTION_LINES = 3      /* pixels; below a pane: caption, cycles, rate */
};

/* For ever: the watchdog does not bite outside quiet mode. */
#define CLOCK_LIMIT 65535

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
    uint32 counting;            /* of counting a picture's pixels, at most until now */
    uint32 pictures;            /* drawn; */
    uint32 seen, figured;       /* pictures and field of the last figures */
    uint32 counted, pixels;     /* colour clocks and pixels of the pictures that were counted since */
    uint32 stale;               /* bit n: set n of planes does not have the picture; */
    uint32 unlabelled;          /* nor the line of figures */
    int32 line;                 /* that was written last */
    uint32 dearest;             /* colour clocks: no picture takes longer */
    uint32 cost;                /* cycles a pixel, lately */
    uint32 sum;                 /* colour clocks of drawing all pictures, modulo 2^32 */
};

/* A frame, as LOG tells it. */
struct worked {
    uint32 work, aside;         /* as the player's */
    uint32 lines;               /* after the one before was shown it was ready */
    uint32 step, fields;        /* that it was shown later than the one before */
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
    int32 set;                  /* pane and step of the settings that are set, or -1 */
    uint32 began, shown;        /* fields: the part, the last frame on the screen, */
    uint32 due;                 /* and the one behind it, which waits for it */
    uint32 frames, late;        /* frames, and those that took more than FRAME_FIELDS */
    uint32 figured, figured_frames;     /* field and frames of the last status line */
    int32 whole;                /* frames for which panes are shown whole: the step is another */
    uint32 work;                /* colour clocks of the next frame, all but waits, */
    uint32 aside;               /* and those of it that the governor is not to count */
    struct worked *worked;      /* of each frame, or 0 */
    uint32 ink, ground;         /* pixels */
};

/* Plays a part until its time or, where not 0, so many frames are over; the screen is open. */
enum player_end player_play(struct player *player, uint32 frames);

/* Colour clocks since the last call; they are the frame's work. */
uint32 player_lap(struct player *player);

/* figures.c: what a part is, on the screen; and, after each frame, what is measured. */
void figures_first(struct player *player);
void figures_make(struct player *player);

/* From now on they are another step's. */
void figures_again(struct player *player);

/* lanes.c: draws a pane's next picture. */
void lane_draw(struct player *player, int32 number);

/* Times the dearest picture of each pane where panes take turns. */
void lanes_probe(struct player *player);

/* Draws what there is time for. */
void lanes_draw(struct player *player);

/* Turns what the hidden planes lack into them. */
void lanes_convert(struct player *player);

#endif
