#include "demo/picture.h"

#include "screen/display.h"

static int32 square(int32 x)
{
    return x * x;
}

uint32 picture_pixel(const uint8 *palette, uint32 colour)
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

/* A mask of four one-byte pixels for each value of four bits. */
static const uint32 dots_table[16] = {
    0x00000000, 0x000000ff, 0x0000ff00, 0x0000ffff, 0x00ff0000, 0x00ff00ff, 0x00ffff00, 0x00ffffff,
    0xff000000, 0xff0000ff, 0xff00ff00, 0xff00ffff, 0xffff0000, 0xffff00ff, 0xffffff00, 0xffffffff
};

void picture_caption(const struct frame *frame, const char *text, const uint8 *font, uint32 ink, uint32 ground)
{
    uint8 *at = frame->pixels + (frame->height - LETTER) * frame->pitch;

    ink *= 0x01010101u;
    ground *= 0x01010101u;
    for (int32 x = LETTER; *text && x <= frame->width && frame->height >= LETTER; text++, x += LETTER, at += LETTER) {
        const uint32 found = (uint32)(uint8)*text - FONT_FIRST;
        const uint8 *rows = font + (found < FONT_LETTERS ? found : 0) * FONT_ROWS;
        uint8 *to = at;

        for (int32 y = 0; y < FONT_ROWS; y++, to += frame->pitch) {
            const uint32 bits = *rows++;
            uint32 *four = (uint32 *)to;

            four[0] = ground ^ ((ground ^ ink) & dots_table[bits >> 4]);
            four[1] = ground ^ ((ground ^ ink) & dots_table[bits & 15]);
        }
    }
}
