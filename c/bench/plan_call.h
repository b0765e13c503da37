/* Calls the cases of a plan, and times them. */
#ifndef PLAN_CALL_H
#define PLAN_CALL_H

#include "bench/plan_file.h"
#include "compiler.h"

/* The memory of all cases: one piece for every use, as large as its largest image. */
struct plan_arenas {
    uint8 *near, *any, *chip;
};

/* A call that was made: where its memory was, and its registers; the last is by how much the
   stack pointer was off. */
struct plan_call {
    void (*routine)(void);
    uint8 *near, *far;
    uint32 registers[PLAN_REGISTERS + 1];
};

/* 0 where memory is short. */
int32 plan_arenas_make(struct plan_arenas *arenas, const uint8 *plan);

/* Makes a case's memory and calls its routine once, in quiet mode; prints a line and returns 0
   where there is no such routine. clock_open must have succeeded. */
int32 plan_call(struct plan_call *call, const struct plan_case *c, const uint8 *plan,
                const struct plan_arenas *arenas);

/* Makes the same memory anew and calls the routine `repeats` times; returns how long that took, in
   colour clocks. */
uint32 plan_time(struct plan_call *call, const struct plan_case *c, const uint8 *plan);

/* Longwords, by the plan's sizes; both addresses are multiples of 4. */
void plan_copy(uint8 *to, const uint8 *from, uint32 bytes);

#endif
