#include "tx/forms.h"

#include "limits.h"
#include "tx/codes.h"

#define ZERO_C 16               /* from this code on C of R G B is 0 */

/* Whether a cycle's result is one of its inputs, as it is. */
static int32 is_input(const struct tx_combine *combine, int32 cycle, uint32 code)
{
    const struct tx_input *rgb = &combine->rgb[cycle], *alpha = &combine->alpha[cycle];

    return (rgb->a == rgb->b || rgb->c >= ZERO_C) && rgb->d == code
        && (alpha->a == alpha->b || alpha->c == TX_CODE_ZERO) && alpha->d == code;
}

/* Of A and B of R G B; COMBINED is 0 in the first cycle. */
static int32 is_zero(const struct tx *tx, uint32 code)
{
    return code > TX_CODE_ZERO
        || (code == TX_CODE_COMBINED && tx->modes.cycle == TX_ONE_CYCLE);
}

static int32 is_product(const struct tx *tx, int32 cycle, uint32 code)
{
    const struct tx_input *rgb = &tx->combine.rgb[cycle], *alpha = &tx->combine.alpha[cycle];

    return rgb->a == code && is_zero(tx, rgb->b) && rgb->c == TX_CODE_SHADE
        && rgb->d == TX_CODE_ZERO && alpha->a == code && alpha->b == TX_CODE_ZERO
        && alpha->c == TX_CODE_SHADE && alpha->d == TX_CODE_ZERO;
}

/* A constant, or the one input that is known. */
static int32 allowed(uint32 code, uint32 known)
{
    return code == known || (code != TX_CODE_COMBINED && code != TX_CODE_TEXEL0
                             && code != TX_CODE_TEXEL1 && code != TX_CODE_SHADE);
}

/* Whether each channel depends on its own of one input alone. */
static int32 has_tables(const struct tx *tx, int32 cycle, uint32 code)
{
    const struct tx_input *rgb = &tx->combine.rgb[cycle], *alpha = &tx->combine.alpha[cycle];
    const uint32 c = rgb->c;

    if (c >= TX_CODE_COMBINED_ALPHA && c <= TX_CODE_FRACTION && c != TX_CODE_PRIMITIVE_ALPHA
        && c != TX_CODE_ENVIRONMENT_ALPHA)
        return 0;
    return allowed(rgb->a, code) && allowed(rgb->b, code) && allowed(rgb->d, code)
        && (c > TX_CODE_ENVIRONMENT || allowed(c, code)) && allowed(alpha->a, code)
        && allowed(alpha->b, code) && allowed(alpha->d, code)
        && alpha->c != TX_CODE_ALPHA_FRACTION && allowed(alpha->c, code);
}

/* What a cycle makes of one input. */
static void find_second(struct tx_form *form, const struct tx *tx, int32 cycle, uint32 code)
{
    form->cycle = (uint8)cycle;
    if (is_input(&tx->combine, cycle, code))
        form->second = TX_SECOND_NOTHING;
    else if (is_product(tx, cycle, code))
        form->second = TX_SECOND_MODULATE;
    else if (has_tables(tx, cycle, code))
        form->second = TX_SECOND_TABLES;
    else
        form->any = 1;
}

/* The constant a blend goes by; -1: the level's fraction, -2: neither. */
static int32 blend_fraction(const struct tx *tx, const struct tx_input *rgb,
                            const struct tx_input *alpha)
{
    if (rgb->c == TX_CODE_FRACTION && alpha->c == TX_CODE_ALPHA_FRACTION)
        return -1;
    if (rgb->c == TX_CODE_PRIMITIVE_FRACTION && alpha->c == TX_CODE_ALPHA_PRIMITIVE_FRACTION)
        return tx->primitive_fraction;
    if (rgb->c == TX_CODE_PRIMITIVE_ALPHA && alpha->c == TX_CODE_PRIMITIVE)
        return tx->primitive[3];
    if (rgb->c == TX_CODE_ENVIRONMENT_ALPHA && alpha->c == TX_CODE_ENVIRONMENT)
        return tx->environment[3];
    return -2;
}

/* The first cycle as a blend of both texels; 0: it is none. */
static int32 find_blend(struct tx_form *form, const struct tx *tx)
{
    const struct tx_input *rgb = tx->combine.rgb, *alpha = tx->combine.alpha;
    const int32 fraction = blend_fraction(tx, rgb, alpha);
    const int32 swapped = rgb->a == TX_CODE_TEXEL0;

    if (rgb->a != (swapped ? TX_CODE_TEXEL0 : TX_CODE_TEXEL1)
        || rgb->b != (swapped ? TX_CODE_TEXEL1 : TX_CODE_TEXEL0) || rgb->d != rgb->b
        || alpha->a != rgb->a || alpha->b != rgb->b || alpha->d != rgb->b || fraction < -1)
        return 0;
    form->swapped = (uint8)swapped;
    form->fraction = (int16)fraction;
    form->first = TX_FIRST_BLEND;
    return 1;
}

void tx_form_find(struct tx_form *form, const struct tx *tx)
{
    form->any = form->swapped = 0;
    form->first = TX_FIRST_TEXEL;
    form->second = TX_SECOND_NOTHING;
    form->fraction = 0;
    form->cycle = 1;
    if (tx->modes.cycle == TX_ONE_CYCLE) {
        find_second(form, tx, 1, TX_CODE_TEXEL0);
    } else if (is_input(&tx->combine, 1, TX_CODE_COMBINED)) {
        if (!find_blend(form, tx))
            find_second(form, tx, 0, TX_CODE_TEXEL0);
    } else if (is_input(&tx->combine, 0, TX_CODE_TEXEL0)
               || (find_blend(form, tx) && !tx->modes.sharpen)) {
        /* A sharpened blend may leave 0 to 255 between the cycles. */
        find_second(form, tx, 1, TX_CODE_COMBINED);
    } else {
        form->first = TX_FIRST_TEXEL;
        find_second(form, tx, 1, TX_CODE_TEXEL0);
        form->swapped = !form->any;
    }
}

/* The constants that codes may stand for. */
static struct tx_wide primitive, environment, one, zero;
static int16 primitive_fraction, k4, k5;

/* As A, B and D take 9 bits. */
static int16 extended(int32 value)
{
    value &= 0x1ff;
    return (int16)((value & 0x180) == 0x180 ? value - 512 : value);
}

static void set_constants(const struct tx *tx)
{
    for (int32 i = 0; i < 4; i++) {
        primitive.channels[i] = tx->primitive[i];
        environment.channels[i] = tx->environment[i];
        one.channels[i] = 0x100;
        zero.channels[i] = 0;
    }
    primitive_fraction = tx->primitive_fraction;
    k4 = extended(tx->k[4]);
    k5 = tx->k[5];
}

/* Where a cycle's input lies, and bytes from pixel to pixel. */
struct place {
    const int16 *at;
    int32 step;
};

static struct place constant(const int16 *at)
{
    struct place place;

    place.at = at;
    place.step = 0;
    return place;
}

/* A code up to ONE; texel 0 and 1 change places in the second of two cycles. */
static struct place colour(const struct tx *tx, const struct tx_places *from, int32 cycle,
                           uint32 code, int32 channel)
{
    const int32 second = cycle && tx->modes.cycle == TX_TWO_CYCLES;
    struct place place;

    place.step = sizeof(struct tx_wide);
    switch (code) {
    case TX_CODE_COMBINED:
        if (!second)
            return constant(zero.channels);
        place.at = &from->combined->channels[channel];
        return place;
    case TX_CODE_TEXEL0:
    case TX_CODE_TEXEL1:
        place.at = (code == TX_CODE_TEXEL0) != second ? &from->texel0->channels[channel]
                                                      : &from->texel1->channels[channel];
        return place;
    case TX_CODE_SHADE:
        place.at = &from->shade->channels[channel];
        place.step = from->shade_step;
        return place;
    case TX_CODE_PRIMITIVE:
        return constant(&primitive.channels[channel]);
    case TX_CODE_ENVIRONMENT:
        return constant(&environment.channels[channel]);
    case TX_CODE_ONE:
        return constant(one.channels);
    default:
        return constant(zero.channels);
    }
}

static struct place level(const struct tx_places *from)
{
    struct place place;

    place.at = from->fraction;
    place.step = from->fraction_step;
    return place;
}

static struct place rgb_b(const struct tx *tx, const struct tx_places *from, int32 cycle,
                          uint32 code, int32 channel)
{
    return code == TX_CODE_K4 ? constant(&k4)
         : colour(tx, from, cycle, code < TX_CODE_ONE ? code : TX_CODE_ZERO, channel);
}

static struct place rgb_c(const struct tx *tx, const struct tx_places *from, int32 cycle,
                          uint32 code, int32 channel)
{
    if (code <= TX_CODE_ENVIRONMENT)
        return colour(tx, from, cycle, code, channel);
    if (code >= TX_CODE_COMBINED_ALPHA && code <= TX_CODE_ENVIRONMENT_ALPHA)
        return colour(tx, from, cycle, code - TX_CODE_COMBINED_ALPHA, 3);
    return code == TX_CODE_FRACTION ? level(from)
         : code == TX_CODE_PRIMITIVE_FRACTION ? constant(&primitive_fraction)
         : code == TX_CODE_K5 ? constant(&k5) : constant(zero.channels);
}

static struct place alpha_c(const struct tx *tx, const struct tx_places *from, int32 cycle,
                            uint32 code)
{
    return code == TX_CODE_ALPHA_FRACTION ? level(from)
         : code == TX_CODE_ALPHA_PRIMITIVE_FRACTION ? constant(&primitive_fraction)
         : colour(tx, from, cycle, code, 3);
}

static void find_inputs(struct tx_combination *to, const struct tx *tx,
                        const struct tx_places *at, int32 cycle, int32 channel)
{
    const struct tx_input *codes = channel < 3 ? &tx->combine.rgb[cycle]
                                               : &tx->combine.alpha[cycle];
    struct place a = colour(tx, at, cycle, codes->a, channel), b, c;
    struct place d = colour(tx, at, cycle, codes->d, channel);

    b = channel < 3 ? rgb_b(tx, at, cycle, codes->b, channel)
                    : colour(tx, at, cycle, codes->b, 3);
    c = channel < 3 ? rgb_c(tx, at, cycle, codes->c, channel) : alpha_c(tx, at, cycle, codes->c);
    to->a = a.at;
    to->a_step = a.step;
    to->b = b.at;
    to->b_step = b.step;
    to->c = c.at;
    to->c_step = c.step;
    to->d = d.at;
    to->d_step = d.step;
}

void tx_combine_cycle(const struct tx *tx, const struct tx_places *at, int32 cycle,
                      struct tx_wide *results, int32 count)
{
    struct tx_combination inputs;

    set_constants(tx);
    for (int32 channel = 0; channel < 4; channel++) {
        find_inputs(&inputs, tx, at, cycle, channel);
        tx_combiner(0, &results->channels[channel], &inputs, count);
    }
}

void tx_combine_line(const struct tx *tx, const struct tx_places *at,
                     struct tx_wide (*results)[TX_LINE_PIXELS], uint32 *colours, int32 count)
{
    struct tx_places places = *at;

    if (tx->modes.cycle == TX_TWO_CYCLES) {
        tx_combine_cycle(tx, &places, 0, results[0], count);
        places.combined = results[0];
    }
    tx_combine_cycle(tx, &places, 1, results[1], count);
    tx_narrow(results[1], colours, 0, count);
}
