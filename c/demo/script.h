/* The demo's parts, read from a text file. Each line is a statement of words separated by blanks; a
   TEXT extends to the end of the line. Lines that begin with # are remarks.

     screen WIDTH HEIGHT           of chunky parts, in low resolution; before the first part
     part SECONDS KIND             begins a part; KIND: a name of enum part_kind
     picture WIDTH HEIGHT          size of the screen for a scene that is not chunky; default: the
                                   scene's size
     title TEXT                    the first status line
     says TEXT                     the second status line, before the figures
     scene FILE                    in the script's directory
     text X Y SCALE COLOUR TEXT    on the picture, X from its left, or `middle`; COLOUR as ff8000
     fill X Y WIDTH HEIGHT COLOUR  a rectangle; later statements cover it, and panes cover all
     pane X Y FORM ACCURACY PERSPECTIVE DEAREST TEXT       a place where the scene is drawn, and
                                   how: addx or swap, steps of settings.h or `own`; the frame of
                                   the scene that takes longest, for panes that take turns; a
                                   caption
     step FIRST FRAMES TOP ROWS PERSPECTIVE TEXT   a choice of the governor, the best first:
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
    PART_RACE,                  /* each pane gets the same time and draws all the pictures it can */
    PART_FAIR,                  /* the same, but all pictures follow the clock */
    PART_FREE,                  /* as many frames as possible; steps have equal times */
    PART_KINDS
};

struct pane {
    int32 x, y;                 /* of its top left corner, pixels; x a multiple of 32 */
    uint32 form;                /* enum form */
    struct settings settings;
    int32 worst;              /* the scene's frame that takes longest */
    const char *caption;
};

struct step {
    int32 first, frames;        /* of the scene */
    int32 top, rows;            /* the rows of the frame that may change */
    int32 perspective;          /* for panes with `own` */
    const char *name;
};

/* A text or a rectangle that does not change. */
struct mark {
    int32 x, y;                 /* pixels; x of a text may be MIDDLE */
    int32 scale;                /* of a text's letters; 0: a rectangle */
    int32 width, height;        /* of a rectangle */
    uint32 colour;              /* 0x00rrggbb */
    const char *text;
};

struct part {
    int32 seconds;
    uint32 kind;                /* enum part_kind */
    const char *title, *says, *scene;
    int32 width, height;        /* of a picture that is not chunky, or 0 */
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

/* Prints a line and returns 0 if the file cannot be read or a line of it is wrong. */
int32 script_load(struct script *script, const char *name);

#endif
