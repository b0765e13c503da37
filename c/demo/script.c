#include "demo/script.h"

#include "system/file.h"
#include "system/text.h"

static const char *const kinds[PART_KINDS] = {"together", "race", "fair", "free"};

/* Returns the next word, ended by 0, or an empty one. */
static char *word(char **at)
{
    char *begin = *at, *end;

    while (*begin == ' ')
        begin++;
    for (end = begin; *end && *end != ' '; end++)
        ;
    *at = *end ? end + 1 : end;
    *end = 0;
    return begin;
}

static const char *text(char **at)
{
    while (**at == ' ')
        (*at)++;
    return *at;
}

/* Returns a number from 0 to 9,999, or -1 if the word is none. */
static int32 value_of(const char *digits)
{
    int32 value = 0, length = 0;

    for (; digits[length]; length++) {
        if (digits[length] < '0' || digits[length] > '9' || length == 4)
            return -1;
        value = 10 * value + digits[length] - '0';
    }
    return length ? value : -1;
}

static int32 number(char **at)
{
    return value_of(word(at));
}

/* Returns the index of the next word in names, or count if it is none of them. */
static uint32 choice(char **at, const char *const *names, uint32 count)
{
    const char *name = word(at);
    uint32 i = 0;

    while (i < count && !text_same(name, names[i]))
        i++;
    return i;
}

/* Reads a step of perspective or `own`; returns PERSPECTIVE_KINDS if the word is neither. */
static int32 perspective(char **at)
{
    const char *name = word(at);
    int32 i = 0;

    if (text_same(name, "own"))
        return SETTINGS_OWN;
    while (i < PERSPECTIVE_KINDS && !text_same(name, settings_perspective(i)))
        i++;
    return i;
}

/* Reads a step of accuracy or `own`; returns -2 if the word is neither. */
static int32 accuracy(char **at)
{
    const char *name = word(at);
    int32 step;

    if (text_same(name, "own"))
        return SETTINGS_OWN;
    step = value_of(name);
    return step >= 0 && step < ACCURACY_STEPS ? step : SETTINGS_OWN - 1;
}

static int32 add_part(struct script *script, char *at)
{
    struct part *part = &script->part[script->parts];

    if (script->parts == PARTS_MAX)
        return 0;
    part->seconds = number(&at);
    part->kind = choice(&at, kinds, PART_KINDS);
    part->title = part->says = part->scene = "";
    part->panes = part->steps = 0;
    script->parts++;
    return part->seconds > 0 && part->kind < PART_KINDS;
}

static int32 add_pane(struct part *part, char *at)
{
    static const char *const forms[] = {"addx", "swap"};        /* as in enum form */
    struct pane *pane = &part->pane[part->panes];

    if (part->panes == PANES_MAX)
        return 0;
    pane->x = number(&at);
    pane->y = number(&at);
    pane->form = choice(&at, forms, 2);
    pane->settings.accuracy = accuracy(&at);
    pane->settings.perspective = perspective(&at);
    pane->worst = number(&at);
    pane->caption = text(&at);
    part->panes++;
    return pane->x >= 0 && !(pane->x & 7) && pane->y >= 0 && pane->form < 2
        && pane->settings.accuracy >= SETTINGS_OWN
        && pane->settings.perspective < PERSPECTIVE_KINDS && pane->worst >= 0;
}

static int32 add_step(struct part *part, char *at)
{
    struct step *step = &part->step[part->steps];

    if (part->steps == GOVERNOR_STEPS)
        return 0;
    step->first = number(&at);
    step->frames = number(&at);
    step->fields = number(&at);
    step->perspective = perspective(&at);
    step->name = text(&at);
    part->steps++;
    return step->first >= 0 && step->frames > 0 && step->fields > 0 && step->fields <= FIELDS_MAX
        && step->perspective < PERSPECTIVE_KINDS;
}

/* Reads a line; returns 0 if it is wrong. */
static int32 read_line(struct script *script, char *at)
{
    struct part *part = &script->part[script->parts - 1];
    const char *what = word(&at);

    if (!*what || *what == '#')
        return 1;
    if (text_same(what, "part"))
        return add_part(script, at);
    if (!script->parts)
        return 0;
    if (text_same(what, "title"))
        part->title = text(&at);
    else if (text_same(what, "says"))
        part->says = text(&at);
    else if (text_same(what, "scene"))
        part->scene = word(&at);
    else if (text_same(what, "pane"))
        return add_pane(part, at);
    else if (text_same(what, "step"))
        return add_step(part, at);
    else
        return 0;
    return 1;
}

static int32 wrong(const char *name, int32 line)
{
    text_add(name);
    text_add(", line ");
    text_number(line);
    return text_refuse("", "is none of a script's");
}

int32 script_load(struct script *script, const char *name)
{
    uint8 *data;
    uint32 bytes;
    char *begin;
    int32 line = 1;

    if (!file_load(name, &data, &bytes))
        return 0;
    script->parts = 0;
    begin = (char *)data;
    for (uint32 i = 0; i < bytes; i++) {
        if (data[i] != '\n')
            continue;
        data[i] = 0;
        if (!read_line(script, begin))
            return wrong(name, line);
        begin = (char *)data + i + 1;
        line++;
    }
    if (begin != (char *)data + bytes)
        return wrong(name, line);
    for (int32 i = 0; i < script->parts; i++)
        if (!script->part[i].panes || !script->part[i].steps || !*script->part[i].scene) {
            text_add(name);
            text_add(", part ");
            text_number(i + 1);
            return text_refuse("", "has no scene, pane or step");
        }
    return 1;
}
