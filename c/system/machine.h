/* The machine that a program runs on. */
#ifndef MACHINE_H
#define MACHINE_H

#include "compiler.h"

struct machine {
    uint32 exec_version, exec_revision;
    uint32 attention;           /* enum processor */
    uint32 e_clock;             /* Hz: a twentieth of an A1200's processor clock */
    uint32 chip, fast;          /* total bytes of RAM; fast: RAM that exec prefers to chip RAM */
    uint32 agnus;               /* bits 14 to 8 of VPOSR: bit 4 is NTSC, bit 1 AGA's Alice */
};

enum processor { CPU_68020 = 2, CPU_68030 = 4, CPU_68040 = 8, CPU_68060 = 128 };
enum agnus { AGNUS_ALICE = 2, AGNUS_NTSC = 16 };

/* src68k/amiga/machine.s: contracts there. */
void machine_read(struct machine *machine);
int32 memory_is_chip(const void *address);
void dos_fault(char *text, int32 bytes);
int32 dos_requests(int32 window);

#endif
