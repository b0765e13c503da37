/* bench - calls kernels as a plan says, times them and writes what they did.

   bench PLAN RESULTS
   Prints a line before each timed case and before every REPORTED-th case. */
#include "bench/plan.h"
#include "bench/plan_call.h"
#include "system/file.h"
#include "system/outcome.h"
#include "system/system.h"
#include "system/text.h"

#define REPORTED 32

/* Results not written yet: every write takes AmigaDOS milliseconds, however short. */
static uint8 kept[32768];
static uint32 kept_bytes;

/* 8 KB: twice a shell's stack. */
static struct plan_arenas arenas;

static int32 results_write(int32 file, const uint8 *from, uint32 bytes)
{
    return file_write(file, from, (int32)bytes) == (int32)bytes
        || text_refuse("bench", "results cannot be written");
}

static int32 results_flush(int32 file)
{
    uint32 bytes = kept_bytes;

    kept_bytes = 0;
    return results_write(file, kept, bytes);
}

static int32 results_add(int32 file, const uint8 *from, uint32 bytes)
{
    if (bytes > sizeof kept - kept_bytes && !results_flush(file))
        return 0;
    if (bytes > sizeof kept)
        return results_write(file, from, bytes);
    plan_copy(kept + kept_bytes, from, bytes);
    kept_bytes += bytes;
    return 1;
}

/* The pieces of far that the call may write, those side by side at once. */
static int32 add_far(int32 file, const struct plan_case *c, const uint8 *plan, const uint8 *far)
{
    const uint32 *piece = (const uint32 *)(plan + c->far_at);
    const uint8 *first = far, *const end = far + c->far;

    while (far < end) {
        const uint32 is_written = *piece++ & PLAN_WRITTEN;

        if (!is_written && first < far && !results_add(file, first, (uint32)(far - first)))
            return 0;
        far = end - far > PLAN_PIECE ? far + PLAN_PIECE : end;
        if (!is_written)
            first = far;
    }
    return first == end || results_add(file, first, (uint32)(end - first));
}

static int32 run(const struct plan_case *c, const uint8 *plan, struct plan_arenas *arenas,
                 int32 file)
{
    struct plan_call call;
    struct plan_result result;

    if (!plan_call(&call, c, plan, arenas))
        return 0;
    if (!results_add(file, call.near, c->near) || !add_far(file, c, plan, call.far))
        return 0;
    result.near = (uint32)call.near;
    result.far = (uint32)call.far;
    for (int32 i = 0; i < PLAN_REGISTERS; i++)
        result.registers[i] = call.registers[i];
    result.stack = (int32)call.registers[PLAN_REGISTERS];
    result.ticks = c->repeats ? plan_time(&call, c, plan) : 0;
    return results_add(file, (const uint8 *)&result, sizeof result);
}

static void report(uint32 number, uint32 cases, const char *name)
{
    text_add("case ");
    text_number((int32)number);
    text_add(" of ");
    text_number((int32)cases);
    text_add(": ");
    text_add(name);
    text_print();
}

static int32 run_plan(const uint8 *plan, const char *name, int32 results)
{
    const struct plan_case *cases = plan_cases(plan);
    uint32 count = ((const struct plan_header *)plan)->cases;
    uint32 changed;

    if (!plan_arenas_make(&arenas, plan))
        return outcome_lack_memory(name, "the cases");
    for (uint32 i = 0; i < count; i++) {
        if (cases[i].repeats || i % REPORTED == 0)
            report(i, count, (const char *)(plan + cases[i].name_at));
        if ((i && outcome_break()) || !run(&cases[i], plan, &arenas, results))
            return 0;
    }
    changed = plan_changed(&arenas, plan);
    return results_add(results, (const uint8 *)&changed, sizeof changed) && results_flush(results);
}

int main(void)
{
    enum { PLAN, RESULTS, ITEMS };
    int32 args[ITEMS] = {0};
    const uint8 *plan;
    const char *name;
    int32 results, done;

    if (!args_read("PLAN/A,RESULTS/A", args)) {
        print("bench: usage: bench PLAN RESULTS\n");
        return RETURN_ERROR;
    }
    name = (const char *)args[PLAN];
    if (!plan_load(name, &plan))
        return outcome_code(0);
    if (!clock_open())
        return outcome_code(outcome_lack("bench", "another program uses CIA-B's timers"));
    results = outcome_create((const char *)args[RESULTS]);
    done = results && run_plan(plan, name, results);
    if (done)
        outcome_keep();
    return outcome_code(done);
}
