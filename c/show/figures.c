#include "show/figures.h"

#include "polygon/counts.h"
#include "system/text.h"

#define SUM_LIMIT 0x10000000u   /* CYCLES times this, and a frame more, fit 32 bits */
#define CYCLES 4                /* CPU cycles in a tick */
#define CLOCK_TICKS 3546895     /* a second */

void rate_begin(struct rate *rate, uint32 field)
{
    rate->since = field;
    rate->frames = rate->spent = rate->ticks = rate->tenths = 0;
}

void rate_count(struct rate *rate, uint32 field, uint32 ticks)
{
    const uint32 fields = field - rate->since - rate->spent;

    rate->frames++;
    rate->ticks += ticks;
    if (fields < FIELDS)
        return;
    rate->tenths = rate->frames * FIELDS * 10 / fields;
    rate->drawn = rate->frames * 10 * (CLOCK_TICKS / 16) / (rate->ticks / 16 + 1);
    rate->since = field;
    rate->frames = rate->spent = rate->ticks = 0;
}

void measured_clear(struct measured *measured)
{
    measured->pixels = measured->ticks = measured->different = measured->compared = 0;
}

int32 measured_has_room(const struct measured *measured)
{
    return measured->pixels < SUM_LIMIT && measured->ticks < SUM_LIMIT
        && measured->compared < SUM_LIMIT;
}

void measured_add(struct measured *measured, const struct scene_counts *counts, uint32 ticks)
{
    for (uint32 i = 0; i < counts->materials; i++)
        measured->pixels += counts_drawn(&counts->frame[i]);
    measured->ticks += ticks;
}

/* Returns how many pixels of a longword differ; differs: the XOR of two frames' longwords. */
static uint32 pixels_in(uint32 differs, int32 pixel_bytes)
{
    const uint32 bits = 8 * (uint32)pixel_bytes, mask = 0xffffffffu >> (32 - bits);
    uint32 pixels = 0;

    for (uint32 at = 0; at < 32; at += bits)
        pixels += (differs >> at & mask) != 0;
    return pixels;
}

/* Returns how many pixels of two frames of the same size differ. */
static uint32 differing(const struct frame *frame, const struct frame *exact)
{
    const uint32 *one = (const uint32 *)frame->pixels, *other = (const uint32 *)exact->pixels;
    uint32 different = 0;

    for (int32 i = frame->pitch * frame->height / 4; i > 0; i--) {
        const uint32 differs = *one++ ^ *other++;

        if (differs)
            different += pixels_in(differs, frame->pixel_bytes);
    }
    return different;
}

/* Returns how many pixels of an exact frame's row differ from half as many, each of which covers two. */
static uint32 differing_twice(const uint8 *row, const uint8 *exact, int32 width, int32 bytes)
{
    uint32 different = 0;

    for (; width > 0; width--, row += bytes)
        for (int32 twice = 0; twice < 2; twice++, exact += bytes) {
            int32 at = 0;

            while (at < bytes && row[at] == exact[at])
                at++;
            different += at < bytes;
        }
    return different;
}

void measured_compare(struct measured *measured, const struct frame *frame,
                      const struct frame *exact)
{
    if (frame->width == exact->width)
        measured->different += differing(frame, exact);
    else
        for (int32 y = 0; y < exact->height; y++)
            measured->different += differing_twice(frame->pixels + (y >> 1) * frame->pitch,
                                                   exact->pixels + y * exact->pitch, frame->width, frame->pixel_bytes);
    measured->compared += (uint32)(exact->width * exact->height);
}

/* Returns part / whole * scale, rounded down. whole is below 2^28.7, scale a power of ten. */
static uint32 ratio(uint32 part, uint32 whole, uint32 scale)
{
    uint32 result = part / whole;

    for (part %= whole; scale > 1; scale /= 10) {
        part *= 10;
        result = result * 10 + part / whole;
        part %= whole;
    }
    return result;
}

/* Adds value / power with its decimals; power: 10 or 100. */
static void add_decimal(uint32 value, uint32 power)
{
    text_number((int32)(value / power));
    text_add(".");
    for (power /= 10; power; power /= 10)
        text_number((int32)(value / power % 10));
}

void figures_rate(const struct rate *rate)
{
    if (rate->tenths)
        add_decimal(rate->tenths, 10);
    else
        text_add("...");
    text_add(" fps");
    if (rate->tenths) {
        text_add(", ");
        add_decimal(rate->drawn, 10);
        text_add(" drawn alone");
    }
}

void figures_cost(const struct measured *measured)
{
    if (!measured->pixels)
        return;
    add_decimal(ratio(measured->ticks * CYCLES, measured->pixels, 10), 10);
    text_add(" cycles/pixel");
}

void figures_error(const struct measured *measured)
{
    if (!measured->compared)
        return;
    add_decimal(ratio(measured->different, measured->compared, 10000), 100);
    text_add(" % of pixels off");
}
