/* bench - calls kernels as a plan says, times them and writes what they did.

   bench PLAN RESULTS
   prints a line before each case that is timed, and before every REPORTED-th. */
#include "bench/kernels.h"
#include "bench/plan_file.h"
#include "screen/plain.h"
#include "span/logarithm.h"
#include "span/scanline.h"
#include "system/file.h"
#include "system/outcome.h"
#include "system/system.h"
#include "system/text.h"
#include "texture/map.h"
#include "tmu/plain.h"
#include "tx/plain.h"

#define REPORTED 32

/* column_layout_make as a kernel: its arguments are in a plan, the result in count. */
static void make_columns(struct span_plan *plan)
{
    plan->count = column_layout_make((struct column_layout *)plan->columns, plan->map_width,
                                     plan->map_height);
}

/* logarithms_make as a kernel: the tables name the memory. */
static void make_logarithms(struct logarithm_tables *tables)
{
    logarithms_make(tables, (int16 *)tables->logs, (uint16 *)tables->powers);
}

static void nothing(void)
{
}

#define PASS(name) {#name, (void (*)(void))name}

/* Beside the assembly: what is written in C, and what costs nothing. */
static const struct kernel c_kernels[] = {
    {"span_affine_c", (void (*)(void))span_affine_c},
    {"column_layout_make", (void (*)(void))make_columns},
    {"logarithms_make", (void (*)(void))make_logarithms},
    {"nothing", nothing},
    PASS(tx_walk_c), PASS(tx_threepoint_c), PASS(tx_average_c),
    PASS(tx_point_c), PASS(tx_store_16_c),
    PASS(tx_divide_c), PASS(tx_tile_c), PASS(tx_lerp_c),
    PASS(tx_quads_c), PASS(tx_reciprocals_c),
    PASS(tx_modulate_c), PASS(tx_map_c), PASS(tx_widen_c),
    PASS(tx_combiner_c), PASS(tx_narrow_c), PASS(tx_lod_c), PASS(tx_levels_c),
    PASS(tx_threepoint_16_c), PASS(tx_shade_c), PASS(tx_chroma_c),
    PASS(tx_convert_c), PASS(tx_convert_wide_c), PASS(tx_matrix_c),
    PASS(tmu_walk_c), PASS(tmu_walk_clamp_c), PASS(tmu_point_c), PASS(tmu_bilinear_c),
    PASS(tmu_bilinear_565_c), PASS(tmu_store_565_c), PASS(tmu_quads_c),
    PASS(tmu_widen_565_c),
    PASS(tmu_lerp_c), PASS(tmu_scale_c), PASS(tmu_modulate_c), PASS(tmu_add_c),
    PASS(tmu_combiner_c), PASS(tmu_divide_c), PASS(tmu_lod_c), PASS(tmu_logarithms_c),
    PASS(tmu_alpha_c), PASS(tmu_bilinear_8_c),
    PASS(tmu_quads_8_c), PASS(tmu_modulate_rgb_c), PASS(tmu_combine_line_c),
    PASS(tmu_details_c), PASS(tmu_interleave_c), PASS(tmu_pieces_c),
    PASS(c2p_8_c), PASS(c2p_ham8_16_c), PASS(c2p_ham8_32_c), PASS(ham8_control),
    PASS(tmu_tile_16_c), PASS(tmu_tile_32_c),
    {0, 0}
};

static void (*find(const struct kernel *kernel, const char *name))(void)
{
    while (kernel->name && !text_same(kernel->name, name))
        kernel++;
    return kernel->routine;
}

/* As plan_header.checksum says: twice the sum of all sums, less the last. */
static uint32 checksum(const uint32 *from, uint32 longs)
{
    uint32 sum = 0, sums = 0;

    for (; longs; longs--) {
        sum += *from++;
        sums += sum;
    }
    return 2 * sums - sum;
}

static int32 usable(const uint8 *plan, uint32 bytes, const char *name)
{
    const struct plan_header *h = (const struct plan_header *)plan;
    const uint32 summed = (uint32)((const uint8 *)&h->cases - plan);

    if (bytes < sizeof *h)
        return text_refuse(name, "not a usable plan file: size");
    if (h->magic != PLAN_MAGIC)
        return text_refuse(name, "not a usable plan file: magic");
    if (h->version != PLAN_VERSION)
        return text_refuse(name, "not a usable plan file: version");
    if (h->size != bytes || bytes & 3)
        return text_refuse(name, "not a usable plan file: size");
    if (h->checksum != checksum((const uint32 *)(plan + summed), (bytes - summed) / 4))
        return text_refuse(name, "not a usable plan file: checksum");
    if (!table_inside(h->cases_at, h->cases, sizeof(struct plan_case), bytes))
        return text_refuse(name, "not a usable plan file: cases_at");
    return 1;
}

/* The memory of all cases: one piece for every use, as large as its largest image. */
struct arenas {
    uint8 *near, *any, *chip;
};

static int32 make_arena(uint8 **arena, uint32 bytes, int32 kind)
{
    *arena = 0;
    if (!bytes)
        return 1;
    if (!mem_alloc(arena, (int32)(bytes + ARENA_ALIGN), kind))
        return 0;
    *arena += (0 - (uint32)*arena) & (ARENA_ALIGN - 1);
    return 1;
}

static int32 make_arenas(struct arenas *arenas, const struct plan_case *cases, uint32 count)
{
    uint32 near = 0, any = 0, chip = 0;

    for (; count; count--, cases++) {
        uint32 *far = cases->far_memory == MEMORY_CHIP ? &chip : &any;

        if (cases->near > near)
            near = cases->near;
        if (cases->far > *far)
            *far = cases->far;
    }
    return make_arena(&arenas->near, near, MEMORY_ANY)
        && make_arena(&arenas->any, any, MEMORY_ANY)
        && make_arena(&arenas->chip, chip, MEMORY_CHIP);
}

/* Unrolled: most of the time of many short calls is the copying of their images. */
static void copy(uint8 *to, const uint8 *from, uint32 bytes)
{
    uint32 *to_long = (uint32 *)to;
    const uint32 *from_long = (const uint32 *)from;

    for (; bytes >= 32; bytes -= 32) {
        *to_long++ = *from_long++;
        *to_long++ = *from_long++;
        *to_long++ = *from_long++;
        *to_long++ = *from_long++;
        *to_long++ = *from_long++;
        *to_long++ = *from_long++;
        *to_long++ = *from_long++;
        *to_long++ = *from_long++;
    }
    for (; bytes; bytes -= 4)
        *to_long++ = *from_long++;
}

static void relocate(uint8 *near, const uint8 *offsets, uint32 count, const uint8 *base)
{
    const uint32 *offset = (const uint32 *)offsets;

    for (; count; count--, offset++)
        *(uint32 *)(near + *offset) += (uint32)base;
}

static void prepare(const struct plan_case *c, const uint8 *plan, uint8 *near, uint8 *far,
                    uint32 *registers)
{
    copy(near, plan + c->near_at, c->near);
    copy(far, plan + c->far_at, c->far);
    relocate(near, plan + c->near_offsets_at, c->near_offsets, near);
    relocate(near, plan + c->far_offsets_at, c->far_offsets, far);
    for (int32 i = 0; i < PLAN_REGISTERS; i++) {
        registers[i] = c->registers[i];
        if (c->near_registers >> i & 1)
            registers[i] += (uint32)near;
        if (c->far_registers >> i & 1)
            registers[i] += (uint32)far;
    }
}

/* Results on their way to the file: a write takes AmigaDOS milliseconds, however short. */
static uint8 kept[32768];
static uint32 kept_bytes;

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
    copy(kept + kept_bytes, from, bytes);
    kept_bytes += bytes;
    return 1;
}

static int32 run(const struct plan_case *c, const uint8 *plan, const struct arenas *arenas,
                 int32 file)
{
    const char *name = (const char *)(plan + c->name_at);
    void (*routine)(void) = find(kernel_table, name);
    uint8 *near = arenas->near, *far = c->far_memory == MEMORY_CHIP ? arenas->chip : arenas->any;
    uint32 registers[PLAN_REGISTERS + 1];
    struct plan_result result;

    if (!routine)
        routine = find(c_kernels, name);
    if (!routine)
        return text_refuse(name, "no such kernel");
    prepare(c, plan, near, far, registers);
    quiet_enter();
    clock_start((int32)c->limit);
    call_kernel(registers, routine);
    clock_stop();
    quiet_leave();
    if (!results_add(file, near, c->near) || !results_add(file, far, c->far))
        return 0;
    result.near = (uint32)near;
    result.far = (uint32)far;
    for (int32 i = 0; i < PLAN_REGISTERS; i++)
        result.registers[i] = registers[i];
    result.stack = (int32)registers[PLAN_REGISTERS];
    result.ticks = 0;
    if (c->repeats) {
        prepare(c, plan, near, far, registers);
        call_place(routine);
        quiet_enter();
        clock_start((int32)c->limit);
        call_repeat(registers, c->repeats);
        result.ticks = clock_stop();
        quiet_leave();
    }
    return results_add(file, (const uint8 *)&result, sizeof result);
}

/* Every offset of the list must leave room for a longword in `near`. */
static int32 usable_offsets(const uint8 *plan, uint32 at, uint32 count, uint32 near, uint32 bytes)
{
    if (!table_inside(at, count, 4, bytes))
        return 0;
    for (const uint32 *offset = (const uint32 *)(plan + at); count; count--, offset++)
        if (*offset & 1 || near < 4 || *offset > near - 4)
            return 0;
    return 1;
}

static int32 text_ends(const uint8 *plan, uint32 at, uint32 bytes)
{
    while (at < bytes && plan[at])
        at++;
    return at < bytes;
}

/* The first field of a case that is wrong, or 0. */
static const char *wrong_case(const struct plan_case *c, const uint8 *plan, uint32 bytes)
{
    if (!text_ends(plan, c->name_at, bytes))
        return "name_at";
    if (c->near & 3 || !table_inside(c->near_at, c->near, 1, bytes))
        return "near";
    if (c->far & 3 || !table_inside(c->far_at, c->far, 1, bytes))
        return "far";
    if (c->far_memory != MEMORY_ANY && c->far_memory != MEMORY_CHIP)
        return "far_memory";
    if (!usable_offsets(plan, c->near_offsets_at, c->near_offsets, c->near, bytes))
        return "near_offsets";
    if (!usable_offsets(plan, c->far_offsets_at, c->far_offsets, c->near, bytes))
        return "far_offsets";
    if (c->limit < 1 || c->limit > 65535)
        return "limit";
    return 0;
}

static int32 usable_cases(const struct plan_case *cases, uint32 count, const uint8 *plan,
                          uint32 bytes, const char *name)
{
    for (uint32 i = 0; i < count; i++) {
        const char *wrong = wrong_case(&cases[i], plan, bytes);

        if (wrong) {
            text_add(name);
            text_add(": not a usable plan file: case ");
            text_number((int32)i);
            return text_refuse("", wrong);
        }
    }
    return 1;
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

static int32 run_plan(const uint8 *plan, uint32 bytes, const char *name, int32 results)
{
    const struct plan_header *header = (const struct plan_header *)plan;
    const struct plan_case *cases = (const struct plan_case *)(plan + header->cases_at);
    struct arenas arenas;

    if (!usable_cases(cases, header->cases, plan, bytes, name))
        return 0;
    if (!make_arenas(&arenas, cases, header->cases))
        return outcome_lack_memory(name, "the cases");
    for (uint32 i = 0; i < header->cases; i++) {
        if (cases[i].repeats || i % REPORTED == 0)
            report(i, header->cases, (const char *)(plan + cases[i].name_at));
        if ((i && outcome_break()) || !run(&cases[i], plan, &arenas, results))
            return 0;
    }
    return results_flush(results);
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
        return RETURN_ERROR;
    }
    name = (const char *)args[PLAN];
    if (!file_load(name, &plan, &bytes) || !usable(plan, bytes, name))
        return outcome_code(0);
    if (!clock_open())
        return outcome_code(outcome_lack("bench", "another program uses CIA-B's timers"));
    results = outcome_create((const char *)args[RESULTS]);
    done = results && run_plan(plan, bytes, name, results);
    if (done)
        outcome_keep();
    return outcome_code(done);
}
