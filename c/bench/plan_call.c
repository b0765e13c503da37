#include "bench/plan_call.h"

#include "bench/kernels.h"
#include "bench/plan.h"
#include "system/system.h"
#include "system/text.h"

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

int32 plan_arenas_make(struct plan_arenas *arenas, const uint8 *plan)
{
    const struct plan_case *cases = plan_cases(plan);
    uint32 near = 0, any = 0, chip = 0;

    for (uint32 count = ((const struct plan_header *)plan)->cases; count; count--, cases++) {
        uint32 *far = cases->far_memory == MEMORY_CHIP ? &chip : &any;

        if (cases->near > near)
            near = cases->near;
        if (cases->far > *far)
            *far = cases->far;
    }
    for (int32 i = 0; i < PLAN_HELD; i++)
        arenas->any_held[i] = arenas->chip_held[i] = PLAN_WRITTEN;
    arenas->changed = 0;
    return make_arena(&arenas->near, near, MEMORY_ANY)
        && make_arena(&arenas->any, any, MEMORY_ANY)
        && make_arena(&arenas->chip, chip, MEMORY_CHIP);
}

/* Unrolled: with many short calls most of the time goes into copying their images. */
void plan_copy(uint8 *to, const uint8 *from, uint32 bytes)
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

static const uint8 *content(const uint8 *plan, uint32 piece)
{
    static const uint8 zeros[PLAN_PIECE];

    return piece > PLAN_WRITTEN ? plan + (piece & ~(uint32)PLAN_WRITTEN) : zeros;
}

static void place_piece(uint8 *to, const uint8 *plan, uint32 piece, uint32 bytes)
{
    plan_copy(to, content(plan, piece), bytes);
}

/* Returns 1 if a whole piece that no call may write is not the plan's. */
static uint32 is_changed(const uint8 *at, const uint8 *plan, uint32 held)
{
    const uint32 *found = (const uint32 *)at;
    const uint32 *right = (const uint32 *)content(plan, held);
    uint32 changed = 0;

    if (held & PLAN_WRITTEN)
        return 0;
    for (int32 i = PLAN_PIECE / 16; i > 0; i--) {
        changed |= *found++ ^ *right++;
        changed |= *found++ ^ *right++;
        changed |= *found++ ^ *right++;
        changed |= *found++ ^ *right++;
    }
    return changed != 0;
}

static void place(uint8 *to, const uint8 *plan, uint32 at, uint32 bytes)
{
    const uint32 *piece = (const uint32 *)(plan + at);

    for (; bytes > PLAN_PIECE; bytes -= PLAN_PIECE, to += PLAN_PIECE)
        place_piece(to, plan, *piece++, PLAN_PIECE);
    if (bytes)
        place_piece(to, plan, *piece, bytes);
}

/* The same but for whole pieces that are there. Returns how many of the others were changed. */
static uint32 place_far(uint8 *to, uint32 *held, const uint8 *plan, uint32 at, uint32 bytes)
{
    uint32 changed = 0;
    const uint32 *piece = (const uint32 *)(plan + at);
    const uint32 *const end = held + PLAN_HELD;

    for (; bytes > PLAN_PIECE && held < end; bytes -= PLAN_PIECE, to += PLAN_PIECE) {
        if (*held != (*piece & ~(uint32)PLAN_WRITTEN)) {
            changed += is_changed(to, plan, *held);
            place_piece(to, plan, *piece, PLAN_PIECE);
        }
        *held++ = *piece++;
    }
    if (held < end && bytes) {
        changed += is_changed(to, plan, *held);
        *held = PLAN_WRITTEN;
    }
    place(to, plan, (uint32)((const uint8 *)piece - plan), bytes);
    return changed;
}

static uint32 changed_of(const uint8 *arena, const uint32 *held, const uint8 *plan)
{
    uint32 changed = 0;

    for (int32 i = 0; i < PLAN_HELD; i++, arena += PLAN_PIECE)
        changed += is_changed(arena, plan, held[i]);
    return changed;
}

uint32 plan_changed(const struct plan_arenas *arenas, const uint8 *plan)
{
    return arenas->changed + changed_of(arenas->any, arenas->any_held, plan)
        + changed_of(arenas->chip, arenas->chip_held, plan);
}

static void relocate(uint8 *near, const uint8 *offsets, uint32 count, const uint8 *base)
{
    const uint32 *offset = (const uint32 *)offsets;

    for (; count; count--, offset++)
        *(uint32 *)(near + *offset) += (uint32)base;
}

static void prepare(struct plan_call *call, const struct plan_case *c, const uint8 *plan)
{
    place(call->near, plan, c->near_at, c->near);
    *call->changed += place_far(call->far, call->held, plan, c->far_at, c->far);
    relocate(call->near, plan + c->near_offsets_at, c->near_offsets, call->near);
    relocate(call->near, plan + c->far_offsets_at, c->far_offsets, call->far);
    for (int32 i = 0; i < PLAN_REGISTERS; i++) {
        call->registers[i] = c->registers[i];
        if (c->near_registers >> i & 1)
            call->registers[i] += (uint32)call->near;
        if (c->far_registers >> i & 1)
            call->registers[i] += (uint32)call->far;
    }
}

int32 plan_call(struct plan_call *call, const struct plan_case *c, const uint8 *plan,
                struct plan_arenas *arenas)
{
    const char *name = (const char *)(plan + c->name_at);

    call->routine = kernel_find(name);
    if (!call->routine)
        return text_refuse(name, "no such kernel");
    call->near = arenas->near;
    call->far = c->far_memory == MEMORY_CHIP ? arenas->chip : arenas->any;
    call->held = c->far_memory == MEMORY_CHIP ? arenas->chip_held : arenas->any_held;
    call->changed = &arenas->changed;
    prepare(call, c, plan);
    quiet_enter();
    clock_start((int32)c->limit);
    call_kernel(call->registers, call->routine);
    clock_stop();
    quiet_leave();
    return 1;
}

uint32 plan_time(struct plan_call *call, const struct plan_case *c, const uint8 *plan)
{
    uint32 ticks;

    prepare(call, c, plan);
    call_place(call->routine);
    quiet_enter();
    if (c->display) {
        planes_fetch(c->display);
        clock_wait();           /* with a display the position in the field matters */
    }
    clock_start((int32)c->limit);
    call_repeat(call->registers, c->repeats);
    ticks = clock_stop();
    if (c->display)
        planes_fetch(DISPLAY_OFF);
    quiet_leave();
    return ticks;
}
