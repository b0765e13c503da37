#include "demo/picture.h"

#include "screen/display.h"

uint8 picture_ink(const uint8 *palette)
{
    int32 best = 0, most = -1;

    for (int32 i = 0; i < 256; i++, palette += 4) {
        int32 light = 2 * palette[1] + 5 * palette[2] + palette[3];

        if (light > most) {
            most = light;
            best = i;
        }
    }
    return (uint8)best;
}

void picture_fill(const struct frame *frame, int32 x, int32 y, int32 width, int32 height,
                  uint8 colour)
{
    const uint32 four = colour * 0x01010101u;
    uint8 *row = frame->pixels + y * frame->pitch + x;

    for (; height > 0; height--, row += frame->pitch) {
        uint32 *to = (uint32 *)row;

        for (int32 left = width; left > 0; left -= 4)
            *to++ = four;
    }
}

static void put_letter(uint8 *to, int32 pitch, const uint8 *rows, uint8 ink)
{
    for (int32 y = 0; y < LETTER; y++, to += pitch)
        for (uint32 bits = *rows++, x = 0; bits; bits = bits << 1 & 0xff, x++)
            if (bits & 0x80)
                to[x] = ink;
}

void picture_text(const struct frame *frame, int32 x, int32 y, const char *text, const uint8 *font,
                  uint8 ink)
{
    if (y < 0 || y + LETTER > frame->height)
        return;
    for (; *text; text++, x += LETTER) {
        const uint32 letter = (uint32)(uint8)*text - FONT_FIRST;

        if (x >= 0 && x + LETTER <= frame->width && letter < FONT_LETTERS)
            put_letter(frame->pixels + y * frame->pitch + x, frame->pitch, font + letter * FONT_ROWS,
                       ink);
    }
}
