/* How long a frame may take. */
#ifndef FRAMES_TIME_H
#define FRAMES_TIME_H

/* The longest time for one frame, in units of 92 ms: 60 s, a thousand times that of a polygon. */
enum { FRAME_LIMIT = 650 };

#endif
