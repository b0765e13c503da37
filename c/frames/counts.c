#include "frames/counts.h"

#include "system/system.h"
#include "system/text.h"

static const char *const span_names[SPAN_KINDS] = {
#define SPAN(kind, name, lines) #name,
#define OTHER(kind, name) #name,
    SPAN_LIST(SPAN, OTHER)
#undef SPAN
#undef OTHER
};

static const char *const rule_names[RULES] = {
#define RULE(rule, name) #name,
    RULE_LIST(RULE)
#undef RULE
};

static void clear(struct draw_counts *counts, uint32 materials)
{
    uint32 *to = (uint32 *)counts;

    for (uint32 i = materials * (sizeof *counts / sizeof *to); i > 0; i--)
        *to++ = 0;
}

static void sum_up(struct draw_counts *counts, const struct draw_counts *more, uint32 materials)
{
    uint32 *to = (uint32 *)counts;
    const uint32 *from = (const uint32 *)more;

    for (uint32 i = materials * (sizeof *counts / sizeof *to); i > 0; i--)
        *to++ += *from++;
}

int32 counts_make(struct scene_counts *counts, uint32 materials)
{
    int32 bytes = (int32)(materials * sizeof *counts->totals);

    if (!mem_alloc(&counts->frame, bytes, MEMORY_ANY)
        || !mem_alloc(&counts->totals, bytes, MEMORY_ANY))
        return 0;
    counts->materials = materials;
    clear(counts->frame, materials);
    clear(counts->totals, materials);
    return 1;
}

void counts_frame(struct scene_counts *counts, struct renderer *renderer, struct scene *scene,
                  int32 number)
{
    clear(counts->frame, counts->materials);
    scene_count(renderer, scene, number, counts->frame);
    sum_up(counts->totals, counts->frame, counts->materials);
}

/* Adds the names and values of the counts that are not 0. */
static void add_named(const uint32 *counts, const char *const *names, int32 items)
{
    for (; items > 0; items--, counts++, names++)
        if (*counts) {
            text_add(" ");
            text_add(*names);
            text_add(" ");
            text_number((int32)*counts);
        }
}

void counts_add(const struct scene_counts *counts)
{
    struct draw_counts all;

    clear(&all, 1);
    for (uint32 i = 0; i < counts->materials; i++)
        sum_up(&all, &counts->frame[i], 1);
    text_add(" polygons ");
    text_number((int32)all.polygons);
    add_named(all.pixels, span_names, SPAN_KINDS);
}

void counts_print(const struct scene_counts *counts)
{
    const struct draw_counts *of = counts->totals;

    for (uint32 i = 0; i < counts->materials; i++, of++) {
        text_add("material ");
        text_number((int32)i);
        text_add(" polygons ");
        text_number((int32)of->polygons);
        text_add(" unsure ");
        text_number((int32)of->unsure);
        if (of->hidden_pixels) {
            text_add(" hidden ");
            text_number((int32)of->hidden);
            text_add(" pixels ");
            text_number((int32)of->hidden_pixels);
        }
        text_add(" rules");
        add_named(of->rules, rule_names, RULES);
        text_add(" spans");
        add_named(of->pixels, span_names, SPAN_KINDS);
        text_print();
    }
}

/* Returns the rule named by the first `length` characters of name, or RULES if there is none. */
static uint32 rule_named(const char *name, int32 length)
{
    uint32 rule = 0;

    for (; rule < RULES; rule++) {
        const char *other = rule_names[rule];
        int32 i = 0;

        while (i < length && other[i] == name[i])
            i++;
        if (i == length && !other[i])
            break;
    }
    return rule;
}

uint32 rules_named(const char *names)
{
    uint32 off = 0;

    if (text_same(names, "all"))
        return ((uint32)1 << RULES) - 1;
    for (;;) {
        int32 length = 0;
        uint32 rule;

        while (names[length] && names[length] != ',')
            length++;
        rule = rule_named(names, length);
        if (rule == RULES)
            return 0;
        off |= (uint32)1 << rule;
        if (!names[length])
            return off;
        names += length + 1;
    }
}
