/* What a part came to, in lines of text. */
#ifndef DEMO_LOG_H
#define DEMO_LOG_H

#include "demo/player.h"

/* A line on the part, counted from 0. In full also a line a pane and, where they were kept, one a
   frame:
     part N frames N fields N late N step N TITLE
     pane N pictures N ticks N cost N      cycles a pixel, lately
     frame N step N fields N work N         colour clocks */
void log_part(const struct player *player, int32 number, int32 full);

#endif
