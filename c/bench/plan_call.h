/* Calls the cases of a plan, and times them. */
#ifndef PLAN_CALL_H
#define PLAN_CALL_H

#include "bench/plan_file.h"
#include "compiler.h"

/* Memory shared by all cases: a piece for each use, as large as the largest image; and the offsets of the
   pieces that are in the last two, PLAN_WRITTEN where they may have been written. */
struct plan_arenas {
    uint8 *near, *any, *chip;
    uint32 any_held[PLAN_HELD], chip_held[PLAN_HELD];
    uint32 changed;             /* pieces that a call has changed and may not write */
};

/* A call: its memory and its registers. The last longword is the stack pointer's change during the
   call. */
struct plan_call {
    void (*routine)(void);
    uint8 *near, *far;
    uint32 *held, *changed;     /* of far; counts its pieces */
    uint32 registers[PLAN_REGISTERS + 1];
};

/* Allocates the arenas; returns 0 if memory is short. */
int32 plan_arenas_make(struct plan_arenas *arenas, const uint8 *plan);

/* Prepares a case's memory and calls its routine once, in quiet mode; prints a line and returns 0
   if there is no such routine. clock_open must have succeeded. */
int32 plan_call(struct plan_call *call, const struct plan_case *c, const uint8 *plan,
                struct plan_arenas *arenas);

/* Prepares the same memory again and calls the routine `repeats` times; returns the time in colour
   clocks. */
uint32 plan_time(struct plan_call *call, const struct plan_case *c, const uint8 *plan);

/* After the last call: returns how many pieces a call has changed that it may not write. */
uint32 plan_changed(const struct plan_arenas *arenas, const uint8 *plan);

/* Copies longwords: bytes and both addresses are multiples of 4. */
void plan_copy(uint8 *to, const uint8 *from, uint32 bytes);

#endif
