/* bench - calls kernels as a plan says, times them and writes what they did.

   bench PLAN RESULTS
   prints a line a case before it starts. */
#include "bench/kernels.h"
#include "bench/plan_file.h"
#include "span/scanline.h"
#include "system/file.h"
#include "system/system.h"
#include "system/text.h"

static void nothing(void)
{
}

/* Beside the assembly: what is written in C, and what costs nothing. */
static const struct kernel c_kernels[] = {
    {"span_affine_c", (void (*)(void))span_affine_c},
    {"nothing", nothing},
    {0, 0}
};

static int32 refuse(const char *name, const char *why)
{
    text_add(name);
    text_add(": ");
    text_add(why);
    text_print();
    return 0;
}

static int32 same_text(const char *a, const char *b)
{
    while (*a && *a == *b)
        a++, b++;
    return *a == *b;
}

static void (*find(const struct kernel *kernel, const char *name))(void)
{
    while (kernel->name && !same_text(kernel->name, name))
        kernel++;
    return kernel->routine;
}

static int32 usable(const uint8 *plan, uint32 bytes, const char *name)
{
    const struct plan_header *h = (const struct plan_header *)plan;
    const uint32 summed = (uint32)((const uint8 *)&h->cases - plan);

    if (bytes < sizeof *h || h->magic != PLAN_MAGIC || h->size != bytes)
        return refuse(name, "not a plan file: size");
    if (h->version != PLAN_VERSION)
        return refuse(name, "not a usable plan file: version");
    if (h->checksum != crc32(plan + summed, bytes - summed))
        return refuse(name, "not a usable plan file: checksum");
    if (!table_inside(h->cases_at, h->cases, sizeof(struct plan_case), bytes))
        return refuse(name, "not a usable plan file: cases_at");
    return 1;
}

/* The arena is allocated once, as large as the largest image. */
static int32 make_arena(uint8 **arena, const struct plan_case *cases, uint32 count, uint32 memory)
{
    uint32 bytes = 0;

    for (; count; count--, cases++)
        if (cases->memory == memory && cases->image > bytes)
            bytes = cases->image;
    if (!bytes)
        return 1;
    if (!mem_alloc(arena, (int32)(bytes + ARENA_ALIGN), (int32)memory))
        return 0;
    *arena += (0 - (uint32)*arena) & (ARENA_ALIGN - 1);
    return 1;
}

static void prepare(const struct plan_case *c, const uint8 *plan, uint8 *arena, uint32 *registers)
{
    const uint32 *from = (const uint32 *)(plan + c->image_at);
    const uint32 *relocation = (const uint32 *)(plan + c->relocations_at);
    uint32 *to = (uint32 *)arena;

    for (uint32 i = 0; i < c->image; i += 4)
        *to++ = *from++;
    for (uint32 i = 0; i < c->relocations; i++, relocation++)
        *(uint32 *)(arena + *relocation) += (uint32)arena;
    for (int32 i = 0; i < PLAN_REGISTERS; i++)
        registers[i] = c->registers[i] + ((c->relocated >> i & 1) ? (uint32)arena : 0);
}

static int32 run(const struct plan_case *c, const uint8 *plan, uint8 *arena, int32 file)
{
    const char *name = (const char *)(plan + c->name_at);
    void (*routine)(void) = find(kernel_table, name);
    uint32 registers[PLAN_REGISTERS + 1];
    struct plan_result result;

    if (!routine)
        routine = find(c_kernels, name);
    if (!routine)
        return refuse(name, "no such kernel");
    prepare(c, plan, arena, registers);
    quiet_enter();
    clock_start((int32)c->limit);
    call_kernel(registers, routine);
    clock_stop();
    quiet_leave();
    if (file_write(file, arena, (int32)c->image) != (int32)c->image)
        return refuse(name, "results cannot be written");
    result.arena = (uint32)arena;
    for (int32 i = 0; i < PLAN_REGISTERS; i++)
        result.registers[i] = registers[i];
    result.stack = (int32)registers[PLAN_REGISTERS];
    result.ticks = 0;
    if (c->repeats) {
        prepare(c, plan, arena, registers);
        quiet_enter();
        clock_start((int32)c->limit);
        call_repeat(registers, routine, c->repeats);
        result.ticks = clock_stop();
        quiet_leave();
    }
    if (file_write(file, &result, sizeof result) != sizeof result)
        return refuse(name, "results cannot be written");
    return 1;
}

/* The plan's tables and each case's must lie inside it. */
static int32 usable_case(const struct plan_case *c, uint32 bytes)
{
    return c->name_at < bytes && !(c->image & 3)
        && table_inside(c->image_at, c->image, 1, bytes)
        && table_inside(c->relocations_at, c->relocations, 4, bytes);
}

static int32 run_plan(const uint8 *plan, uint32 bytes, const char *name, int32 results)
{
    const struct plan_header *header = (const struct plan_header *)plan;
    const struct plan_case *cases = (const struct plan_case *)(plan + header->cases_at);
    uint8 *any, *chip;

    for (uint32 i = 0; i < header->cases; i++)
        if (!usable_case(&cases[i], bytes))
            return refuse(name, "not a usable plan file: case");
    if (!make_arena(&any, cases, header->cases, MEMORY_ANY)
        || !make_arena(&chip, cases, header->cases, MEMORY_CHIP))
        return refuse(name, "not enough memory");
    for (uint32 i = 0; i < header->cases; i++) {
        text_add("case ");
        text_number((int32)i);
        text_add(" of ");
        text_number((int32)header->cases);
        text_add(": ");
        text_add((const char *)(plan + cases[i].name_at));
        text_print();
        if (!run(&cases[i], plan, cases[i].memory == MEMORY_CHIP ? chip : any, results))
            return 0;
    }
    return 1;
}

int main(void)
{
    enum { PLAN, RESULTS, ITEMS };
    static int32 args[ITEMS];
    uint8 *plan;
    uint32 bytes;
    const char *name;
    int32 results, done;

    if (!args_read("PLAN/A,RESULTS/A", args)) {
        print("bench: usage: bench PLAN RESULTS\n");
        return RETURN_FAIL;
    }
    name = (const char *)args[PLAN];
    if (!file_load(name, &plan, &bytes) || !usable(plan, bytes, name))
        return RETURN_FAIL;
    results = file_open((const char *)args[RESULTS], FILE_NEW);
    if (!results || !clock_open()) {
        print("bench: no results file, or another program uses CIA-B's timers\n");
        return RETURN_FAIL;
    }
    done = run_plan(plan, bytes, name, results);
    clock_close();
    file_close(results);
    return done ? RETURN_OK : RETURN_FAIL;
}
