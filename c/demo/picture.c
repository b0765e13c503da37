#include "demo/picture.h"

#include "screen/display.h"

static int32 square(int32 x)
{
    return x * x;
}

static uint32 nearest(const uint8 *palette, uint32 colour)
{
    const int32 red = colour >> 16 & 255, green = colour >> 8 & 255, blue = colour & 255;
    int32 least = 1 << 20;      /* more than any */
    uint32 best = 0;

    for (uint32 i = 0; i < 256; i++, palette += 4) {
        int32 far = square(palette[1] - red) + square(palette[2] - green)
            + square(palette[3] - blue);

        if (far < least) {
            least = far;
            best = i;
        }
    }
    return best;
}

uint32 picture_pixel(uint32 format, const uint8 *palette, uint32 colour)
{
    switch (format) {
    case PIXEL_RGB565:
        return (colour >> 8 & 0xf800) | (colour >> 5 & 0x7e0) | (colour >> 3 & 0x1f);
    case PIXEL_RGBA5551:
        return (colour >> 8 & 0xf800) | (colour >> 5 & 0x7c0) | (colour >> 2 & 0x3e) | 1;
    case PIXEL_RGBA8888:
        return colour << 8 | 255;
    default:
        return nearest(palette, colour);
    }
}

/* For pixels of one byte and a width that is a multiple of 4: used while a part is played. */
static void fill_quickly(uint8 *row, int32 pitch, int32 width, int32 height, uint32 pixel)
{
    const uint32 four = pixel * 0x01010101u;

    for (; height > 0; height--, row += pitch) {
        uint32 *to = (uint32 *)row;

        for (int32 left = width; left > 0; left -= 4)
            *to++ = four;
    }
}

void picture_fill(const struct frame *frame, int32 x, int32 y, int32 width, int32 height,
                  uint32 pixel)
{
    uint8 *row = frame->pixels + y * frame->pitch + x * frame->pixel_bytes;

    if (frame->pixel_bytes == 1 && !(width & 3)) {
        fill_quickly(row, frame->pitch, width, height, pixel);
        return;
    }
    for (; height > 0; height--, row += frame->pitch)
        for (int32 i = 0; i < width; i++)
            if (frame->pixel_bytes == 1)
                row[i] = (uint8)pixel;
            else if (frame->pixel_bytes == 2)
                ((uint16 *)row)[i] = (uint16)pixel;
            else
                ((uint32 *)row)[i] = pixel;
}

/* A mask of four one-byte pixels for each value of four bits. */
static const uint32 dots_table[16] = {
    0x00000000, 0x000000ff, 0x0000ff00, 0x0000ffff, 0x00ff0000, 0x00ff00ff, 0x00ffff00, 0x00ffffff,
    0xff000000, 0xff0000ff, 0xff00ff00, 0xff00ffff, 0xffff0000, 0xffff00ff, 0xffffff00, 0xffffffff
};

static uint32 mixed(uint32 below, uint32 ink, uint32 bits)
{
    return below ^ ((below ^ ink) & dots_table[bits]);
}

/* For pixels of one byte and scale 1: used while a part is played. */
static void put_small(uint8 *to, int32 pitch, const uint8 *rows, uint32 pixel)
{
    const uint32 ink = pixel * 0x01010101u;

    for (int32 y = 0; y < LETTER; y++, to += pitch) {
        uint32 *four = (uint32 *)to;
        const uint32 bits = *rows++;

        four[0] = mixed(four[0], ink, bits >> 4);
        four[1] = mixed(four[1], ink, bits & 15);
    }
}

static void put_letter(const struct frame *frame, int32 x, int32 y, int32 scale,
                       const uint8 *rows, uint32 pixel)
{
    for (int32 line = 0; line < LETTER; line++, y += scale)
        for (int32 dot = 0; dot < LETTER; dot++)
            if (rows[line] & 0x80 >> dot)
                picture_fill(frame, x + dot * scale, y, scale, scale, pixel);
}

void picture_text(const struct frame *frame, int32 x, int32 y, int32 scale, const char *text,
                  const uint8 *font, uint32 pixel)
{
    const int32 size = LETTER * scale;

    if (y < 0 || y + size > frame->height)
        return;
    for (; *text; text++, x += size) {
        const uint32 letter = (uint32)(uint8)*text - FONT_FIRST;
        const uint8 *rows = font + letter * FONT_ROWS;

        if (x < 0 || x + size > frame->width || letter >= FONT_LETTERS)
            continue;
        if (scale == 1 && frame->pixel_bytes == 1)
            put_small(frame->pixels + y * frame->pitch + x, frame->pitch, rows, pixel);
        else
            put_letter(frame, x, y, scale, rows, pixel);
    }
}
