#include "coverage/coverage.h"

#include "coverage/cut.h"
#include "drawing/outline.h"
#include "polygon/kind.h"
#include "system/system.h"

int32 coverage_make(struct coverage *c, const struct frame *frame, int32 gaps)
{
    const int32 height = frame->height;
    const int32 room = height * (1 + gaps);

    c->room = room;
    c->cover = coverage_routines;
    return mem_alloc(&c->rows, height * (int32)sizeof *c->rows, MEMORY_ANY)
        && mem_alloc(&c->gaps, room * (int32)sizeof *c->gaps, MEMORY_ANY)
        && mem_alloc(&c->parts, (room + height) * (int32)sizeof *c->parts, MEMORY_ANY)
        && cut_lines_make(&c->second, height)
        && cut_lines_make(&c->further, room)
        && mem_alloc(&c->aside_pixels, frame->pitch * height, MEMORY_ANY);
}

void coverage_begin(struct coverage *c, const struct frame *frame)
{
    struct gap *gap = c->gaps, **row = c->rows;
    const int16 last = (int16)(EDGE_BIAS + frame->width - 1);

    c->end.left = c->end.last = 32767;
    c->end.next = &c->end;
    for (int32 i = frame->height; i > 0; i--, gap++) {
        gap->left = EDGE_BIAS;
        gap->last = last;
        gap->next = &c->end;
        *row++ = gap;
    }
    c->open = frame->height;
    c->left = c->room - frame->height;
    c->unused = gap;
    for (int32 i = c->left; i > 0; i--, gap++)
        gap->next = gap + 1;
    c->overflow = 0;
    c->way = COVER_DIRECT;
    c->aside = (int32)(c->aside_pixels - frame->pixels);
}

/* Returns 1 if no pixel from left to last is in a gap. */
static inline int32 row_hides(const struct gap *gap, int32 left, int32 last)
{
    while (gap->last < left)
        gap = gap->next;
    return gap->left > last;
}

int32 coverage_hides(const struct coverage *c, const struct frame *frame,
                     const struct vertex *v, int32 count)
{
    fix16 x_low = v->x, x_high = v->x, y_low = v->y, y_high = v->y;
    int32 left, last, top, bottom, middle;

    for (count--, v++; count > 0; count--, v++) {
        if (v->x < x_low)
            x_low = v->x;
        else if (v->x > x_high)
            x_high = v->x;
        if (v->y < y_low)
            y_low = v->y;
        else if (v->y > y_high)
            y_high = v->y;
    }
    left = (x_low >> 16) + EDGE_BIAS;
    last = (x_high >> 16) + 1 + EDGE_BIAS;
    top = outline_most(y_low >> 16, 0);
    bottom = outline_least((y_high >> 16) + 1, frame->height - 1);
    middle = (top + bottom) >> 1;
    for (int32 i = middle; i <= bottom; i++)
        if (!row_hides(c->rows[i], left, last))
            return 0;
    for (int32 i = middle - 1; i >= top; i--)
        if (!row_hides(c->rows[i], left, last))
            return 0;
    return 1;
}

/* Takes a gap out of a line's list. */
static inline void drop(struct coverage *c, struct gap **at, struct gap **row)
{
    struct gap *gap = *at;

    *at = gap->next;
    gap->next = c->unused;
    c->unused = gap;
    c->left++;
    if (*row == &c->end)
        c->open--;
}

/* Covers a line whose pixels are all in the gap at `at`. */
static inline void cover_whole(struct coverage *c, struct gap **at, struct gap **row, int16 left,
                               int16 last)
{
    struct gap *gap = *at, *more;

    if (gap->left == left) {
        if (gap->last == last)
            drop(c, at, row);
        else
            gap->left = (int16)(last + 1);
        return;
    }
    if (gap->last != last) {
        more = c->unused;
        c->unused = more->next;
        c->left--;
        more->left = (int16)(last + 1);
        more->last = gap->last;
        more->next = gap->next;
        gap->next = more;
    }
    gap->last = (int16)(left - 1);
}

void coverage_scan(const struct scan_plan *plan)
{
    struct coverage *c = plan->coverage;
    const struct scanline *line = plan->lines;
    struct gap **row = plan->rows;
    struct visible_part *part = c->parts;

    c->seen = 0;
    if (c->left < plan->count) {        /* each line may split a gap */
        c->overflow = 1;
        c->parts_end = part;
        return;
    }
    for (int32 i = 0; i < plan->count; i++, line++, row++) {
        const int16 left = (int16)line->left, last = line->last;
        struct gap **at = row, *gap = *at;

        if (last < left)
            continue;
        while (gap->last < left) {
            at = &gap->next;
            gap = *at;
        }
        if (gap->left <= left && gap->last >= last) {
            c->seen = 1;
            cover_whole(c, at, row, left, last);
            continue;
        }
        part->row = (uint16)i;
        if (gap->left > last) {
            part->left = 1;
            part++->last = 0;
            continue;
        }
        c->seen = 1;
        do {
            part->row = (uint16)i;
            part->left = (uint16)(gap->left > left ? gap->left : left);
            part->last = gap->last < last ? gap->last : last;
            part++;
            if (gap->left < left) {
                gap->last = (int16)(left - 1);
                at = &gap->next;
            } else if (gap->last > last) {
                gap->left = (int16)(last + 1);
                break;
            } else {
                drop(c, at, row);
            }
            gap = *at;
        } while (gap->left <= last);
    }
    c->parts_end = part;
}
