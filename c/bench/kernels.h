/* The kernels that a plan can call by name. */
#ifndef KERNELS_H
#define KERNELS_H

#include "compiler.h"

struct kernel {
    const char *name;           /* 0 ends the table */
    void (*routine)(void);
};

/* Every routine of src68k's math, mesh, polygon, edge, span, n64, glide and screen, generated from
   their contract blocks. */
extern const struct kernel kernel_table[];

/* Finds a kernel in that table or among those in C; returns 0 if none has this name. */
void (*kernel_find(const char *name))(void);

/* src68k/amiga/call.s: contracts there. */
void call_kernel(uint32 *registers, void (*routine)(void));
void call_place(void (*routine)(void));
void call_repeat(const uint32 *registers, uint32 times);

/* src68k/amiga/planes_fetch.s. */
void planes_fetch(uint32 display);

#endif
