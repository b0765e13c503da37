/* The demo's parts, read from a text file. Each line is a statement of words separated by blanks; a
   TEXT extends to the end of the line. Lines that begin with # are remarks.

     part SECONDS KIND             begins a part; KIND: a name of enum part_kind
     title TEXT                    the first status line
     says TEXT                     the second status line, before the figures; several panes have theirs alone
     scene FILE                    in the script's directory
     pane X Y FORM ACCURACY PERSPECTIVE DEAREST TEXT       a place where the scene is drawn, and
                                   how: addx or swap, steps of settings.h or `own`; the frame of
                                   the scene that takes longest, for panes that take turns; a
                                   caption. All panes together are the picture
     step FIRST FRAMES FIELDS PERSPECTIVE TEXT     a choice of the governor, the best first: frames
                                   of the scene, fields of the display for each picture, a name */
#ifndef SCRIPT_H
#define SCRIPT_H

#include "show/governor.h"
#include "polygon/polygon.h"
#include "scene/settings.h"

enum script_constants {
    PARTS_MAX = 16,
    PANES_MAX = 5,
    FIELDS_MAX = 10             /* for a picture; the governor's products fit 32 bits */
};

enum part_kind {
    PART_TOGETHER,              /* all panes in each frame; the governor keeps the step's rate */
    PART_RACE,                  /* each pane gets the same time and draws all the pictures it can */
    PART_FAIR,                  /* the same, but all pictures follow the clock */
    PART_FREE,                  /* as many frames as possible; steps have equal times */
    PART_KINDS
};

struct pane {
    int32 x, y;                 /* of its top left corner, pixels; x a multiple of 8 */
    uint32 form;                /* enum form */
    struct settings settings;
    int32 worst;              /* the scene's frame that takes longest */
    const char *caption;
};

struct step {
    int32 first, frames;        /* of the scene */
    int32 fields;               /* from one picture to the next; in PART_FREE at least */
    int32 perspective;          /* for panes with `own` */
    const char *name;
};

struct part {
    int32 seconds;
    uint32 kind;                /* enum part_kind */
    const char *title, *says, *scene;
    int32 panes, steps;         /* 1 or more each */
    struct pane pane[PANES_MAX];
    struct step step[GOVERNOR_STEPS];
};

struct script {
    int32 parts;
    struct part part[PARTS_MAX];
};

/* Prints a line and returns 0 if the file cannot be read or a line of it is wrong. */
int32 script_load(struct script *script, const char *name);

#endif
