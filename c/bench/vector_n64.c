/* Operations of the N64's texture engine. */
#include "bench/vector_engines.h"

#include "bench/vector_answers.h"
#include "bench/vector_file.h"
#include "bench/vector_n64_calls.h"
#include "n64/passes.h"
#include "n64/pixel.h"
#include "n64/polygons/decode.h"

static struct n64 n64;
static struct n64_kept kept[N64_TILES];
static struct n64_colours colours;
static struct n64_decode_scratch scratch;
static uint8 *dram;

static void answer_colour(const struct n64_colour *colour)
{
    vector_answer(colour->r);
    vector_answer(colour->g);
    vector_answer(colour->b);
    vector_answer(colour->a);
}

static void fill_tlut(uint32 seed)
{
    uint8 *at = n64.tmem + N64_TMEM_BYTES / 2;

    while (at < n64.tmem + N64_TMEM_BYTES) {
        const uint32 entry = vector_random(&seed) >> 16;

        for (int32 copy = 0; copy < 4; copy++) {
            *at++ = (uint8)(entry >> 8);
            *at++ = (uint8)entry;
        }
    }
}

static void reset(void)
{
    uint32 *at = (uint32 *)dram;

    for (uint32 longs = VECTOR_DRAM_BYTES / 4; longs; longs--)
        *at++ = 0;
    n64_init(&n64, dram, VECTOR_DRAM_BYTES);
    n64.checked = 0;
}

void vector_n64_open(uint8 *memory)
{
    dram = memory;
    reset();
}

static void poke(uint8 *to, const int32 *bytes, uint32 count)
{
    while (count--)
        *to++ = (uint8)*bytes++;
}

static void set_axis(struct n64_axis *axis, const int32 *flags, int32 low, int32 high)
{
    axis->clamp = (uint8)flags[0];
    axis->mirror = (uint8)flags[1];
    axis->mask = (uint8)flags[2];
    axis->shift = (uint8)flags[3];
    axis->low = (uint16)low;
    axis->high = (uint16)high;
}

/* n fmt siz line tmem pal cs ms masks shs ct mt maskt sht sl tl sh th */
static void set_tile(const int32 *values)
{
    struct n64_tile *tile = &n64.tiles[values[0] & 7];

    tile->format = (uint8)values[1];
    tile->size = (uint8)values[2];
    tile->line = (uint16)values[3];
    tile->tmem = (uint16)values[4];
    tile->palette = (uint8)values[5];
    set_axis(&tile->s, &values[6], values[14], values[16]);
    set_axis(&tile->t, &values[10], values[15], values[17]);
    n64.tile_generation[values[0] & 7]++;
}

static void set_mode(uint32 byte, int32 value)
{
    ((uint8 *)&n64.modes)[byte] = (uint8)value;
    n64_find_inputs(&n64);
    n64.mode_generation++;
}

static uint32 hash(void)
{
    uint32 value = 2166136261u;

    for (int32 i = 0; i < N64_TMEM_BYTES; i++)
        value = (value ^ n64.tmem[i]) * 16777619u;
    return value;
}

static void fetch(const int32 *at)
{
    struct n64_colour texel;

    n64_fetch(&n64, &n64.tiles[at[0] & 7], at[1], at[2], 0, &texel);
    answer_colour(&texel);
}

static void sample(const int32 *at)
{
    static const struct n64_colour none;
    struct n64_colour colour;

    n64_sample(&n64, at[0], at[1], at[2], at[3], &none, &colour);
    answer_colour(&colour);
}

static void sample_both(const int32 *at)
{
    struct n64_colour first, second;

    n64_sample(&n64, at[0], at[2], at[3], 0, 0, &first);
    n64_sample(&n64, at[1], at[2], at[3], 1, &first, &second);
    answer_colour(&first);
    answer_colour(&second);
}

static void divide(const int32 *at)
{
    struct n64_divided out;

    n64_quotients(at[0], at[1], at[2], &out);
    vector_answer(out.raw_s);
    vector_answer(out.raw_t);
    vector_answer(out.s);
    vector_answer(out.t);
}

static void set_iterators(struct n64_iterators *to, const int32 *from)
{
    to->s = from[0];
    to->t = from[1];
    to->w = from[2];
}

static void set_point(struct n64_point *point, const int32 *values)
{
    set_iterators(&point->at, &values[0]);
    set_iterators(&point->dx, &values[3]);
    set_iterators(&point->dy, &values[6]);
}

/* Always in two-cycle mode. */
static void pixel(const int32 *values)
{
    const uint8 cycle = n64.modes.cycle;
    struct n64_point point;
    struct n64_pixel drawn;

    set_point(&point, values);
    n64.primitive_tile = (uint8)values[9] & 7;
    n64.max_level = (uint8)values[10];
    n64.min_level = (uint8)values[11];
    n64.modes.cycle = N64_TWO_CYCLES;
    n64_sample_pixel(&n64, &point, &drawn);
    n64.modes.cycle = cycle;
    vector_answer(drawn.at.s);
    vector_answer(drawn.at.t);
    vector_answer(drawn.level.tile0);
    vector_answer(drawn.level.tile1);
    vector_answer(drawn.level.fraction);
    answer_colour(&drawn.texel0);
    answer_colour(&drawn.texel1);
}

static void copy(const int32 *at)
{
    uint32 texels[2];

    n64_copy_texels(&n64, at[0], at[1], at[2], texels);
    vector_answer((int32)texels[0]);
    vector_answer((int32)texels[1]);
}

static void draw(const int32 *values)
{
    struct n64_colour shade;
    struct n64_point point;

    set_point(&point, values);
    shade.r = (int16)(values[9] >> 24 & 255);
    shade.g = (int16)(values[9] >> 16 & 255);
    shade.b = (int16)(values[9] >> 8 & 255);
    shade.a = (int16)(values[9] & 255);
    vector_answer((int32)n64_draw_pixel(&n64, &point, &shade));
}

static void run_words(const int32 *words, uint32 pairs)
{
    for (; pairs; pairs--, words += 2)
        n64_command(&n64, (uint32)words[0], (uint32)words[1]);
}

static void generations(int32 n)
{
    vector_answer((int32)n64.tmem_generation);
    vector_answer((int32)n64.tile_generation[n & 7]);
    vector_answer((int32)n64.mode_generation);
}

static void decode(const int32 *values)
{
    struct n64_kept *tile = &kept[values[0] & 7];
    struct n64_decoding decoding;

    decoding.scratch = &scratch;
    decoding.colours = &colours;
    vector_answer(n64_decode(&decoding, &n64, values[0], (enum n64_quads)values[1], tile));
    vector_answer(tile->decoded.columns_bits);
    vector_answer(tile->decoded.rows_bits);
    vector_answer(decoding.made);
    vector_answer((int32)tile->decoded.texels);
}

/* Interpolates in a quad, in plain C: the passes' tables would not fit in memory with the
   questions. */
static uint32 filtered(const struct n64_quad *quad, uint32 st)
{
    const struct n64_triangle *triangle = &quad->lower;
    uint32 fs = st >> 16 & 31, ft = st & 31;

    if (fs + ft >= 32) {
        triangle = &quad->upper;
        fs = 32 - fs;
        ft = 32 - ft;
    }
    return ((triangle->rb + fs * triangle->rb_s + ft * triangle->rb_t) & 0xff00ff00u)
        | ((triangle->ga + fs * triangle->ga_s + ft * triangle->ga_t) >> 8 & 0x00ff00ffu);
}

/* The same, but returns the mean of all four texels in the middle. */
static uint32 averaged(const struct n64_quad *quad, uint32 st)
{
    return (st & 0x001f001f) != 0x00100010 ? filtered(quad, st)
        : (quad->mean_rb & 0xff00ff00u) | (quad->mean_ga >> 8 & 0x00ff00ffu);
}

static void decoded(const int32 *at)
{
    const struct n64_tile *tile = &n64.tiles[at[0] & 7];
    const struct n64_decoded *from = &kept[at[0] & 7].decoded;
    const uint32 s = n64_relative(&tile->s, at[1]), t = n64_relative(&tile->t, at[2]);
    const uint32 place = (t & from->mask_t) >> 5 << from->columns_bits | (s & from->mask_s) >> 5;
    const uint32 coordinates = s << 16 | t;
    uint32 colour = 0;

    if (from->quads && n64.modes.mid)
        colour = averaged(&from->quads[place], coordinates);
    else if (from->quads)
        colour = filtered(&from->quads[place], coordinates);
    vector_answer(from->texels ? (int32)from->texels[place] : 0);
    vector_answer((int32)colour);
}

static void call(const int32 *values, uint32 count)
{
    struct n64_word words[VECTOR_CALL_PAIRS];
    struct n64_list list;

    list.words = words;
    list.room = values[0] < VECTOR_CALL_PAIRS ? (uint32)values[0] : VECTOR_CALL_PAIRS;
    list.count = 0;
    vector_answer(vector_n64_call(&list, (uint32)values[1], &values[2], count - 2));
    vector_answer((int32)list.count);
    for (uint32 i = 0; i < VECTOR_CALL_PAIRS; i++) {
        vector_answer(i < list.count ? (int32)words[i].hi : 0);
        vector_answer(i < list.count ? (int32)words[i].lo : 0);
    }
}

void vector_n64_run(uint32 code, const int32 *values, uint32 count)
{
    switch (code) {
    case VECTOR_RESET: reset(); break;
    case VECTOR_TMEM_RANDOM:
        vector_fill(n64.tmem, N64_TMEM_BYTES, (uint32)values[0]);
        n64.tmem_generation++;
        break;
    case VECTOR_TLUT_RANDOM:
        fill_tlut((uint32)values[0]);
        n64.tmem_generation++;
        break;
    case VECTOR_DRAM_RANDOM:
        vector_fill(dram + VECTOR_RANDOM_FROM, VECTOR_RANDOM_END - VECTOR_RANDOM_FROM,
             (uint32)values[0]);
        break;
    case VECTOR_TMEM:
        poke(n64.tmem + values[0], &values[1], count - 1);
        n64.tmem_generation++;
        break;
    case VECTOR_DRAM: poke(dram + values[0], &values[1], count - 1); break;
    case VECTOR_MODE: set_mode((uint32)values[0], values[1]); break;
    case VECTOR_TILE: set_tile(values); break;
    case VECTOR_CONVERT:
        for (int32 i = 0; i < 6; i++)
            n64.k[i] = (int16)values[i];
        n64.mode_generation++;
        break;
    case VECTOR_WORDS: run_words(values, count / 2); break;
    case VECTOR_CHECKED: n64.checked = (uint8)values[0]; break;
    case VECTOR_STRICT: n64.strict = (uint8)values[0]; break;
    case VECTOR_DRAWN: n64_drawn(&n64); break;
    case VECTOR_HASH: vector_answer((int32)hash()); break;
    case VECTOR_FETCH: fetch(values); break;
    case VECTOR_SAMPLE: sample(values); break;
    case VECTOR_SAMPLE_BOTH: sample_both(values); break;
    case VECTOR_DIVIDE: divide(values); break;
    case VECTOR_PIXEL: pixel(values); break;
    case VECTOR_COPY: copy(values); break;
    case VECTOR_LIST:
        vector_answer(n64_list_run(&n64, (const struct n64_word *)values, count / 2));
        vector_answer((int32)n64.command);
        break;
    case VECTOR_CHECK_TILE: vector_answer(n64_check_tile(&n64, values[0])); break;
    case VECTOR_CHECK_DRAWING: vector_answer(n64_check_drawing(&n64)); break;
    case VECTOR_CHECK_COORDINATES:
        vector_answer(n64_check_coordinates(&n64, values[0], values[1]));
        break;
    case VECTOR_GENERATIONS: generations(values[0]); break;
    case VECTOR_DRAW: draw(values); break;
    case VECTOR_CALL: call(values, count); break;
    case VECTOR_DECODE: decode(values); break;
    case VECTOR_RESULT_TEXT:
        vector_answer_text(n64_result_text((enum n64_result)values[0]));
        break;
    case VECTOR_DECODED: decoded(values); break;
    }
}

