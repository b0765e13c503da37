/* The demo's parts, read from a text file: a line each statement, words parted by blanks, what is
   called a text up to the line's end; lines that begin with # are remarks.

     screen WIDTH HEIGHT           of chunky parts; before the first one
     part SECONDS KIND             begins a part: enum part_kind's names
     picture WIDTH HEIGHT          of the screen, where the scene is not chunky; without: the scene's
     title TEXT                    its first line of status
     says TEXT                     its second one, before what is measured
     scene FILE                    beside the script
     text X Y SCALE COLOUR TEXT    on the picture, X from its left, or `middle`; COLOUR as ff8000
     fill X Y WIDTH HEIGHT COLOUR  a rectangle; later statements lie on top, and panes on all
     pane X Y FORM ACCURACY PERSPECTIVE DEAREST TEXT       where the scene's frame is drawn, and
                                   how: addx or swap, steps of settings.h, `own`; the frame of the
                                   scene that takes longest, where panes take turns; a caption
     step FIRST FRAMES TOP ROWS PERSPECTIVE TEXT   what the governor chooses from, the best first:
                                   frames of the scene, rows of a pane that change, a name */
#ifndef SCRIPT_H
#define SCRIPT_H

#include "demo/governor.h"
#include "polygon/polygon.h"
#include "scene/settings.h"

enum script_constants {
    PARTS_MAX = 16,
    PANES_MAX = 5,
    MARKS_MAX = 20,
    MIDDLE = -1
};

enum part_kind {
    PART_TOGETHER,              /* all panes in each frame; the governor keeps 25 a second */
    PART_RACE,                  /* each pane has the same time, and as many pictures as it can */
    PART_FAIR,                  /* the same, but all move by the clock */
    PART_FREE,                  /* as many frames as there can be; steps have equal times */
    PART_KINDS
};

struct pane {
    int32 x, y;                 /* of the frame's corner, pixels; x a multiple of 32 */
    uint32 form;                /* enum form */
    struct settings settings;
    int32 dearest;              /* the scene's frame that takes longest */
    const char *caption;
};

struct step {
    int32 first, frames;        /* of the scene */
    int32 top, rows;            /* of the frame: what there may change */
    int32 perspective;          /* where a pane says `own` */
    const char *name;
};

/* What does not change: a text or a rectangle. */
struct mark {
    int32 x, y;                 /* pixels; x of a text may be MIDDLE */
    int32 scale;                /* of a text's letters; 0: a rectangle, */
    int32 width, height;        /* so large */
    uint32 colour;              /* 0x00rrggbb */
    const char *text;
};

struct part {
    int32 seconds;
    uint32 kind;                /* enum part_kind */
    const char *title, *says, *scene;
    int32 width, height;        /* of the picture where it is not chunky, or 0 */
    int32 panes, steps;         /* 1 or more each */
    int32 marks;
    struct mark mark[MARKS_MAX];
    struct pane pane[PANES_MAX];
    struct step step[GOVERNOR_STEPS];
};

struct script {
    int32 width, height;        /* of chunky parts' screen */
    int32 parts;
    struct part part[PARTS_MAX];
};

/* Prints a line and returns 0 where the file cannot be read, or naming the line that is wrong. */
int32 script_load(struct script *script, const char *name);

#endif
