/* A rectangle is a polygon of four vertices whose plane is exact: its gradients are whole
   multiples of 1/65536 texel. Copy mode steps four pixels at a time, which is the same where
   four pixels are four texels. */
#include "tx/rectangle.h"

#define FOUR_TEXELS (4 * 1024)

/* s or t at a corner, 16.16 texels, from s10.5 and a step of s5.10. */
static fix16 corner(int32 start, int32 step, int32 pixels)
{
    return start * 2048 + step * pixels * 64;
}

static void find_corners(struct vertex *v, const struct tx_rectangle *r, int32 dsdx)
{
    for (int32 i = 0; i < 4; i++, v++) {
        int32 right = i == 1 || i == 2 ? r->right - r->left : 0;
        int32 down = i >= 2 ? r->bottom - r->top : 0;

        v->x = (r->left + right) * 65536;
        v->y = (r->top + down) * 65536;
        v->s = corner(r->s, dsdx, r->flip ? down : right);
        v->t = corner(r->t, r->dtdy, r->flip ? right : down);
        v->shade = 0;
        v->w = 65536;
    }
}

/* Four pixels of a line, as many of them as the frame has. */
static void copy_four(const struct frame *frame, int32 x, int32 y, int32 end,
                      const uint32 *texels)
{
    uint16 *row = (uint16 *)(frame->pixels + y * frame->pitch);

    for (int32 i = 0; i < 4 && x + i < end; i++)
        if (x + i >= 0)
            row[x + i] = (uint16)(i & 1 ? texels[i >> 1] : texels[i >> 1] >> 16);
}

static void copy_line(const struct frame *frame, const struct tx_rectangle *r, int32 y,
                      const struct tx *tx)
{
    int32 end = r->right < frame->width ? r->right : frame->width;
    int32 t = r->t + ((y - r->top) * r->dtdy >> 5);

    for (int32 x = r->left, s = r->s * 32; x < end; x += 4, s += r->dsdx) {
        uint32 texels[2];

        if (x <= -4)
            continue;
        tx_copy_texels(tx, tx->primitive_tile, s >> 5, t, texels);
        copy_four(frame, x, y, end, texels);
    }
}

static void copy_lines(const struct frame *frame, const struct tx_rectangle *r,
                       const struct tx *tx)
{
    int32 end = r->bottom < frame->height ? r->bottom : frame->height;

    for (int32 y = r->top < 0 ? 0 : r->top; y < end; y++)
        copy_line(frame, r, y, tx);
}

static enum polygon_result draw_polygon(const struct frame *frame,
                                        const struct tx_rectangle *r, int32 dsdx,
                                        const struct material *material,
                                        const struct drawing *drawing)
{
    struct vertex corners[4];

    find_corners(corners, r, dsdx);
    return tx_polygon_draw(frame, corners, 4, material, drawing);
}

/* By the plain mappers where they do: only then is a polygon drawn in copy mode. */
static enum polygon_result draw_copy(const struct frame *frame, const struct tx_rectangle *r,
                                     const struct material *material,
                                     const struct drawing *drawing)
{
    struct tx_unit *unit = material->unit;
    enum polygon_result result = POLYGON_REFUSED;

    if (frame->pixel_bytes != 2)
        return POLYGON_WRONG_MAP;
    unit->result = TX_CYCLE_TYPE;
    if (r->flip)
        return POLYGON_REFUSED;
    if (r->dsdx == FOUR_TEXELS)
        result = draw_polygon(frame, r, r->dsdx / 4, material, drawing);
    if (result != POLYGON_REFUSED || unit->result != TX_CYCLE_TYPE)
        return result;
    unit->result = tx_check_drawing(&unit->tx);
    if (unit->result != TX_DONE)
        return POLYGON_REFUSED;
    copy_lines(frame, r, &unit->tx);
    tx_drawn(&unit->tx);
    return POLYGON_DRAWN;
}

enum polygon_result tx_rectangle_draw(const struct frame *frame, const struct tx_rectangle *r,
                                      const struct material *material,
                                      const struct drawing *drawing)
{
    if (r->left >= r->right || r->top >= r->bottom)
        return POLYGON_EMPTY;
    if (material->unit->tx.modes.cycle == TX_COPY)
        return draw_copy(frame, r, material, drawing);
    return draw_polygon(frame, r, r->dsdx, material, drawing);
}
