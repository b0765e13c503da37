/* The results of a part, as lines of text. */
#ifndef DEMO_LOG_H
#define DEMO_LOG_H

#include "demo/player.h"

/* Prints a line about a part, numbered from 0. In full also a line for each pane and, if frames
   were recorded, a line for each frame:
     part N frames N fields N late N step N waited N black N TITLE
     pane N pictures N ticks N used N       colour clocks of pictures not counted, of all pictures
     frame N step N fields N work N lines N     work: colour clocks */
void log_part(const struct player *player, int32 number, int32 full);

#endif
