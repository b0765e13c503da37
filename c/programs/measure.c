/* measure - how fast this Amiga runs the loops, beside the emulated A1200.

   measure [TO FILE] [PLAN FILE]
   Times a plan's cases. Shows their cycles a pixel or step, those of the emulated machine with the
   same kind of RAM, and the ratio; saves the table as TO. Cycles are an A1200's: a colour clock,
   the unit of measurement, is four of them, whatever the processor's clock is. */
#include "bench/plan.h"
#include "bench/plan_call.h"
#include "bench/report.h"
#include "system/machine.h"
#include "system/outcome.h"
#include "system/system.h"
#include "system/text.h"

#define CYCLES 4                /* in a colour clock */
#define CLOCK 20                /* cycles in an E-clock */
#define NTSC_E_CLOCK 712644     /* Hz, half-way from PAL's 709,379 to 715,909: above it is NTSC */
#define FRACTION 8              /* fraction bits of a call's cycles */

/* The RAM of program and data, which selects the emulated machine's figures. */
enum memory { IN_CHIP, IN_FAST, IN_BOTH };

struct measured {
    enum memory memory;
    uint32 calling;             /* cycles of an empty call, with FRACTION */
    int32 wrong;                /* rows whose pixels differ from the emulated machine's */
};

int main(void);

static enum memory memory_of(const struct plan_arenas *arenas)
{
    const int32 chip = memory_is_chip((const void *)(uint32)main) + memory_is_chip(arenas->near)
                       + memory_is_chip(arenas->any);

    return chip == 3 ? IN_CHIP : chip ? IN_BOTH : IN_FAST;
}

/* Returns the cycles of a call, with FRACTION. */
static uint32 call_cycles(uint32 ticks, uint32 repeats)
{
    const uint32 cycles = CYCLES * ticks;

    return (cycles / repeats << FRACTION) + (cycles % repeats << FRACTION) / repeats;
}

/* Returns the thousandths of a cycle for each of so many units, rounded. */
static uint32 unit_cycles(uint32 call, uint32 units)
{
    return (call / units * 1000 + call % units * 1000 / units + (1 << (FRACTION - 1))) >> FRACTION;
}

static const char *processor(uint32 attention)
{
    return attention & CPU_68060 ? "68060" : attention & CPU_68040 ? "68040"
         : attention & CPU_68030 ? "68030" : "68020";
}

/* Rounds to the nearest: exec's own list takes some bytes of each memory. */
static void add_kilobytes(const char *before, uint32 bytes, const char *after)
{
    text_add(before);
    text_number((int32)((bytes + 512) >> 10));
    text_add(after);
}

static void show_machine(const struct plan_arenas *arenas, struct measured *measured,
                         const char *origin)
{
    struct machine machine;

    machine_read(&machine);
    measured->memory = memory_of(arenas);
    text_add("tmap020: cycles of a pixel or a step, here and on the emulated A1200");
    report_line();
    text_add("Here: exec ");
    text_number((int32)machine.exec_version);
    text_add(".");
    text_number((int32)machine.exec_revision);
    text_add(", ");
    text_add(processor(machine.attention));
    text_add(machine.agnus & AGNUS_ALICE ? ", AGA" : ", no AGA");
    text_add(machine.e_clock > NTSC_E_CLOCK ? ", NTSC, " : ", PAL, ");
    text_number((int32)(machine.e_clock * CLOCK));
    text_add(" Hz");
    add_kilobytes(", ", machine.chip, " KB chip");
    add_kilobytes(", ", machine.fast, " KB fast");
    report_line();
    text_add("Emulated: ");
    text_add(origin);
    text_add(measured->memory == IN_CHIP ? ", chip RAM" : ", fast RAM");
    report_line();
    if (measured->memory == IN_BOTH) {
        text_add("Not compared: the program and its data here lie in both kinds of RAM.");
        report_line();
    }
    report_heads();
}

/* Returns 1 if the console's line needs another cell. */
static int32 show_case(const struct plan_case *c, const char *title, uint32 ticks, int32 right,
                      struct measured *measured)
{
    const uint32 emulated = measured->memory == IN_CHIP ? c->chip : c->fast;
    const uint32 call = call_cycles(ticks, c->repeats);
    const uint32 net = call < measured->calling ? 0 : call - measured->calling;
    const uint32 here = unit_cycles(net, c->units);
    struct report_cell cell;

    report_cell_clear(&cell, title);
    report_cell_number(&cell, REPORT_HERE, here, 2);
    if (measured->memory != IN_BOTH) {
        report_cell_number(&cell, REPORT_EMULATED, emulated, 2);
        report_cell_number(&cell, REPORT_RATIO, (here * 1000 + emulated / 2) / emulated, 3);
    }
    if (!right) {
        report_cell_text(&cell, REPORT_RATIO, "WRONG");
        measured->wrong++;
    }
    text_add("  ");
    text_number((int32)ticks);
    text_add(" colour clocks, ");
    text_number((int32)c->repeats);
    text_add(" calls");
    return report_row(&cell);
}

/* Returns 1 if all were measured. Returns 0 after a break or an error, for which a line is
   printed. */
static int32 measure(const uint8 *plan, struct plan_arenas *arenas, struct measured *measured)
{
    const struct plan_case *cases = plan_cases(plan);
    const uint32 count = ((const struct plan_header *)plan)->cases;
    int32 half = 0;             /* 1: the console's line has a cell; a break's message waits */

    for (uint32 i = 0; i < count; i++) {
        const struct plan_case *c = &cases[i];
        struct plan_call call;
        uint32 ticks, drawn;

        if (i && !(measured->memory == IN_CHIP ? c->chip : c->fast))
            continue;
        if ((!half && outcome_break()) || !plan_call(&call, c, plan, arenas))
            return 0;
        drawn = c->drawn ? plan_checksum((const uint32 *)call.far, c->far / 4) : 0;
        ticks = plan_time(&call, c, plan);
        if (i)
            half = show_case(c, (const char *)(plan + c->title_at), ticks, drawn == c->drawn,
                             measured);
        else
            measured->calling = call_cycles(ticks, c->repeats);
    }
    report_end_rows();
    return 1;
}

static void show_end(const struct measured *measured)
{
    if (measured->wrong) {
        text_add("WRONG: it drew other pixels than there. Please tell us, with this table.");
        report_line();
    }
    text_add("A ratio below 1: faster here. Please send this file: open an issue of");
    report_line();
    text_add("tmap020, and say which Amiga, which board and which memory. Thank you!");
    report_line();
}

/* 8 KB: twice a shell's stack. */
static struct plan_arenas arenas;

int main(void)
{
    enum { TO, PLAN, ITEMS };
    int32 args[ITEMS] = {0};
    const char *to = "tmap020.txt", *plan_name = "PROGDIR:measure.plan";
    struct measured measured;
    const uint8 *plan;

    if (!args_read("TO,PLAN/K", args)) {
        print("measure: usage: measure [TO FILE] [PLAN FILE]\n");
        return RETURN_ERROR;
    }
    if (args[TO])
        to = (const char *)args[TO];
    if (args[PLAN])
        plan_name = (const char *)args[PLAN];
    if (!plan_load(plan_name, &plan))
        return outcome_code(0);
    if (!((const struct plan_header *)plan)->cases || !plan_cases(plan)->repeats)
        return outcome_code(text_refuse(plan_name, "has nothing to show"));
    if (!plan_arenas_make(&arenas, plan))
        return outcome_code(outcome_lack_memory("measure", "the cases"));
    if (!clock_open())
        return outcome_code(outcome_lack("measure", "another program uses CIA-B's timers"));
    measured.wrong = 0;
    show_machine(&arenas, &measured, (const char *)(plan + plan_cases(plan)->title_at));
    if (!measure(plan, &arenas, &measured)) {
        report_end_rows();
        return outcome_code(0);
    }
    clock_close();
    show_end(&measured);
    if (!report_save(to))
        return outcome_code(0);
    text_add("Saved as ");
    text_add(to);
    text_print();
    return RETURN_OK;
}
