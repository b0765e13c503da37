#include "plain/screen.h"

/* Stores 32 dots, a byte each, as one longword of each plane from `first` on. */
static void store(uint8 *planes, int32 plane_pitch, const uint8 *dots, int32 first)
{
    planes += first * plane_pitch;
    for (int32 plane = first; plane < 8; plane++) {
        uint32 bits = 0;

        for (int32 dot = 0; dot < 32; dot++)
            bits = bits << 1 | (dots[dot] >> plane & 1u);
        *(uint32 *)planes = bits;
        planes += plane_pitch;
    }
}

void c2p_8_c(const struct planar_plan *plan)
{
    const uint8 *pixels = plan->pixels;
    uint8 *planes = plan->planes;

    for (int32 y = 0; y < plan->rows; y++) {
        for (int32 x = 0; x < plan->width; x += 32)
            store(planes + (x >> 3), plan->plane_pitch, pixels + x, 0);
        pixels += plan->pitch;
        planes += plan->row_pitch;
    }
}

void c2p_8_2x1_c(const struct planar_plan *plan)
{
    const uint8 *pixels = plan->pixels;
    uint8 *planes = plan->planes;
    uint8 dots[32];

    for (int32 y = 0; y < plan->rows; y++) {
        for (int32 x = 0; x < plan->width; x += 16) {
            for (int32 dot = 0; dot < 32; dot++)
                dots[dot] = pixels[x + (dot >> 1)];
            store(planes + (x >> 2), plan->plane_pitch, dots, 0);
        }
        pixels += plan->pitch;
        planes += plan->row_pitch;
    }
}

/* Widens 5 bits to 6, the upper bits of a byte, by repeating the highest bit. */
static inline uint8 six(uint32 five)
{
    return (uint8)(five << 3 | five >> 2);
}

static inline void dots_565(uint8 *dots, uint32 colour)
{
    dots[0] = six(colour >> 11);
    dots[1] = (uint8)(colour >> 3 & 0xfc);
    dots[2] = dots[3] = six(colour & 31);
}

static inline void dots_5551(uint8 *dots, uint32 colour)
{
    dots[0] = six(colour >> 11);
    dots[1] = six(colour >> 6 & 31);
    dots[2] = dots[3] = six(colour >> 1 & 31);
}

static inline void c2p_16(const struct planar_plan *plan, void (*to_dots)(uint8 *dots, uint32 colour))
{
    const uint8 *pixels = plan->pixels;
    uint8 *planes = plan->planes;
    uint8 dots[32];

    for (int32 y = 0; y < plan->rows; y++) {
        const uint16 *pixel = (const uint16 *)pixels;

        for (int32 x = 0; x < plan->width; x += 8) {
            for (int32 dot = 0; dot < 32; dot += HAM8_DOTS)
                to_dots(dots + dot, *pixel++);
            store(planes + (x >> 1), plan->plane_pitch, dots, 2);
        }
        pixels += plan->pitch;
        planes += plan->row_pitch;
    }
}

void c2p_ham8_16_c(const struct planar_plan *plan)
{
    c2p_16(plan, dots_565);
}

void c2p_ham8_5551_c(const struct planar_plan *plan)
{
    c2p_16(plan, dots_5551);
}

void c2p_ham8_32_c(const struct planar_plan *plan)
{
    const uint8 *pixels = plan->pixels;
    uint8 *planes = plan->planes;
    uint8 dots[32];

    for (int32 y = 0; y < plan->rows; y++) {
        const uint8 *from = pixels;

        for (int32 x = 0; x < plan->width; x += 8) {
            for (int32 dot = 0; dot < 32; dot += HAM8_DOTS) {
                dots[dot] = from[0];
                dots[dot + 1] = from[1];
                dots[dot + 2] = from[2];
                dots[dot + 3] = from[2];
                from += 4;
            }
            store(planes + (x >> 1), plan->plane_pitch, dots, 2);
        }
        pixels += plan->pitch;
        planes += plan->row_pitch;
    }
}
