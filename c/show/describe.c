/* The status lines. */
#include "show/show.h"

#include "system/text.h"

#define KEYS "arrows, S, G, space, Esc" /* at the end of the second one */

/* Puts the keys at the end of a status line, if there is room. */
static void add_keys(char *text)
{
    static const char keys[] = KEYS;
    int32 at = 0, from = STATUS_COLUMNS - (int32)sizeof keys + 1;

    while (text[at])
        at++;
    if (at >= from)
        return;
    while (at < from)
        text[at++] = ' ';
    for (const char *key = keys; (text[at] = *key); key++)
        at++;
}

void show_describe(struct show *s)
{
    char text[2 * STATUS_COLUMNS];

    if (s->paused) {
        text_add("paused, frame ");
        text_number(s->number);
    } else
        figures_rate(&s->rate);
    text_add("   ");
    figures_cost(&s->measured);
    text_add("   ");
    if (s->exact.pixels)
        figures_error(&s->measured);
    else
        text_add("error: no memory");
    text_take(text);
    screen_text(&s->screen, 0, text);
    if (s->fields) {
        text_add("holds ");
        text_number(FIELDS / s->fields);
        text_add(".");
        text_number(10 * FIELDS / s->fields % 10);
        text_add(": ");
        ladder_describe(&s->ladder.rung[s->governor.step]);
    } else {
        text_add(settings_accuracy(s->settings.accuracy));
        text_add("   perspective ");
        text_add(settings_perspective(s->settings.perspective));
    }
    if (!s->has_tables)
        text_add("   (no memory for tables)");
    text_take(text);
    add_keys(text);
    screen_text(&s->screen, 1, text);
}
