#include "screen/copper.h"

/* Registers by their offsets from $dff000. */
enum custom_register {
    DIWSTRT = 0x08e, DIWSTOP = 0x090, DDFSTRT = 0x092, DDFSTOP = 0x094, DMACON = 0x096,
    BPL1PTH = 0x0e0, BPLCON0 = 0x100, BPLCON1 = 0x102, BPLCON2 = 0x104, BPLCON3 = 0x106,
    BPL1MOD = 0x108, BPL2MOD = 0x10a, BPLCON4 = 0x10c, SPR0CTL = 0x142, COLOR00 = 0x180,
    DIWHIGH = 0x1e4, FMODE = 0x1fc
};

enum register_bits {
    DMA_SPRITES = 0x0020,               /* written without bit 15: switched off */
    /* BPLCON0 */
    HIRES = 0x8000, ONE_PLANE = 0x1000, HAM = 0x0800, COLOUR = 0x0200, SHRES = 0x0040,
    EIGHT_PLANES = 0x0010, ECS_ENABLED = 0x0001,
    /* BPLCON3 */
    BANK_SHIFT = 13, LOW_NIBBLES = 0x0200, RESET = 0x0c00, BORDER_BLANK = 0x0020,
    SPRITE_COLOURS = 0x0011,            /* BPLCON4, as after a reset */
    /* FMODE */
    WIDEST = 0x0003, ROWS_TWICE = 0x4000
};

#define STATUS_GROUND 0x000
#define STATUS_LETTERS 0xccc

static uint16 *move_to(uint16 *at, uint32 reg, uint32 value)
{
    *at++ = (uint16)reg;
    *at++ = (uint16)value;
    return at;
}

/* Waits for the start of a line. */
static uint16 *wait_for(uint16 *at, int32 line)
{
    if (line > 255)
        at = move_to(at, 0xffdf, 0xfffe);       /* the last position with an 8-bit line number */
    return move_to(at, (uint32)(line & 255) << 8 | 1, 0xfffe);
}

static uint16 *pointer(uint16 *at, uint32 plane, const uint8 *to)
{
    const uint32 address = (uint32)to, reg = BPL1PTH + 4 * plane;

    return move_to(move_to(at, reg, address >> 16), reg + 2, address & 0xffff);
}

/* Sets the display window, in pixels of low resolution from the screen's corner. */
static uint16 *window(uint16 *at, int32 left, int32 top, int32 width, int32 height)
{
    const uint32 x = (uint32)(SCREEN_LEFT + left), right = x + (uint32)width;
    const uint32 y = (uint32)top, bottom = y + (uint32)height;

    at = move_to(at, DIWSTRT, (y & 255) << 8 | (x & 255));
    at = move_to(at, DIWSTOP, (bottom & 255) << 8 | (right & 255));
    return move_to(at, DIWHIGH, (right >> 8) << 13 | (bottom >> 8) << 8 | (x >> 8) << 5 | y >> 8);
}

/* Sets the data fetch of a row. It starts at a multiple of 64 dots; a delay moves the picture right
   by the remainder. */
static uint16 *fetch(uint16 *at, int32 left, int32 shift, int32 row_bytes)
{
    const int32 unit = FETCH_DOTS >> shift;     /* low-resolution pixels, two a colour clock */
    const uint32 start = (uint32)(SCREEN_FETCH + (left / unit) * (unit / 2));
    const uint32 rest = (uint32)(left % unit);
    const uint32 delay = (rest & 15) | (rest >> 4) << 10;

    at = move_to(at, DDFSTRT, start);
    at = move_to(at, DDFSTOP, start + (uint32)((row_bytes / (FETCH_DOTS / 8) - 1) * (unit / 2)));
    return move_to(at, BPLCON1, delay | delay << 4);
}

static uint16 *sprites_off(uint16 *at)
{
    at = move_to(at, DMACON, DMA_SPRITES);
    for (uint32 sprite = 0; sprite < 8; sprite++)
        at = move_to(at, SPR0CTL + 8 * sprite, 0);
    return at;
}

static uint16 *picture(uint16 *at, const struct screen_layout *layout,
                       const struct copper_planes *planes)
{
    static const uint16 resolution[] = {0, HIRES, SHRES};

    at = move_to(at, FMODE, layout->twice ? WIDEST | ROWS_TWICE : WIDEST);
    at = move_to(at, BPLCON0, EIGHT_PLANES | COLOUR | ECS_ENABLED | resolution[layout->shift]
                 | (layout->ham ? HAM : 0u));
    at = move_to(at, BPLCON2, 0);
    at = move_to(at, BPLCON4, SPRITE_COLOURS);
    at = window(at, layout->left, SCREEN_TOP + layout->top, layout->shown_width,
                layout->shown_height);
    at = fetch(at, layout->left, layout->shift, layout->row_bytes);
    /* Rows shown twice: after the first time, on lines of the parity of the window's first line,
       BPL1MOD steps back. */
    at = move_to(at, BPL1MOD, layout->twice ? (uint32)-layout->row_bytes & 0xffff : 0);
    at = move_to(at, BPL2MOD, 0);
    for (uint32 plane = 0; plane < PLANES; plane++)
        at = pointer(at, plane, planes->plane[plane]);
    return at;
}

/* Moves for both nibbles of all colours, black; copper_palette_set fills them in. */
static uint16 *palette(uint16 *at)
{
    for (uint32 bank = 0; bank < 8; bank++)
        for (uint32 half = 0; half < 2; half++) {
            at = move_to(at, BPLCON3, bank << BANK_SHIFT | RESET | BORDER_BLANK
                         | (half ? LOW_NIBBLES : 0u));
            for (uint32 colour = 0; colour < 32; colour++)
                at = move_to(at, COLOR00 + 2 * colour, 0);
        }
    return at;
}

static uint16 *status(uint16 *at, const uint8 *plane)
{
    at = move_to(at, FMODE, WIDEST);
    at = move_to(at, BPLCON0, HIRES | ONE_PLANE | COLOUR | ECS_ENABLED);
    at = window(at, 0, STATUS_TOP, SCREEN_WIDTH, STATUS_ROWS);
    at = fetch(at, 0, 1, STATUS_PITCH);
    at = move_to(at, BPL1MOD, 0);
    at = pointer(at, 0, plane);
    at = move_to(at, BPLCON3, RESET | BORDER_BLANK);
    at = move_to(at, COLOR00, STATUS_GROUND);
    return move_to(at, COLOR00 + 2, STATUS_LETTERS);
}

uint16 *copper_list_make(uint16 *list, const struct screen_layout *layout,
                         const struct copper_planes *planes)
{
    uint16 *colours, *at = list;

    at = picture(at, layout, planes);
    at = sprites_off(at);
    colours = at;
    at = palette(at);
    at = wait_for(at, SCREEN_TOP + SCREEN_HEIGHT);
    at = status(at, planes->status);
    move_to(at, 0xffff, 0xfffe);
    return colours;
}

void copper_blank_make(uint16 *list)
{
    uint16 *at = move_to(list, FMODE, 0);

    at = move_to(at, BPLCON0, COLOUR | ECS_ENABLED);
    at = move_to(at, BPLCON3, RESET | BORDER_BLANK);
    at = move_to(at, DMACON, DMA_SPRITES);
    move_to(at, 0xffff, 0xfffe);
}

void copper_colour_set(uint16 *palette, uint32 number, const uint8 *colour)
{
    const uint32 red = colour[1], green = colour[2], blue = colour[3];
    uint16 *upper = palette + 2 * (1 + (number & 31) + 2 * 33 * (number >> 5)) + 1;

    upper[0] = (uint16)((red & 0xf0) << 4 | (green & 0xf0) | blue >> 4);
    upper[2 * 33] = (uint16)((red & 15) << 8 | (green & 15) << 4 | (blue & 15));
}

void copper_palette_set(uint16 *palette, const uint8 *colours)
{
    for (uint32 number = 0; number < 256; number++)
        copper_colour_set(palette, number, colours + 4 * number);
}
