/* The figures of a part, in the second status line. */
#include "demo/player.h"

#include "system/system.h"
#include "system/text.h"

#define CYCLES 4                /* CPU cycles in a colour clock */
#define TEXT 160                /* bytes: the status line has 80 */

/* Adds a number of tenths, with a decimal point. */
static void text_tenths(uint32 tenths)
{
    text_number((int32)(tenths / 10));
    text_add(".");
    text_number((int32)(tenths % 10));
}

/* Returns a rate from events in so many fields, in tenths a second, to the nearest. */
static uint32 rate(uint32 events, uint32 fields)
{
    return fields ? (events * 500 + fields / 2) / fields : 0;
}

/* Updates a lane's cycles a pixel from the pictures counted since the last call. */
static void find_cost(struct lane *lane)
{
    if (lane->pixels)
        lane->cost = (lane->counted * CYCLES + lane->pixels / 2) / lane->pixels;
    lane->counted = lane->pixels = 0;
}

/* Writes what each pane is and what its pictures cost, in columns of equal widths. */
static void make_columns(struct player *player, uint32 fields)
{
    const int32 panes = player->part->panes;
    char text[TEXT], line[STATUS_COLUMNS + 1];
    int32 at = 0;

    for (int32 i = 0; i < panes; i++) {
        struct lane *lane = &player->lane[i];
        const int32 end = STATUS_COLUMNS * (i + 1) / panes;
        int32 letter = 0;

        text_add(player->part->pane[i].caption);
        if (fields) {
            find_cost(lane);
            text_add(" ");
            text_number((int32)lane->cost);
            text_add("/px ");
            text_tenths(rate(lane->pictures - lane->seen, fields));
            text_add("/s");
            lane->seen = lane->pictures;
        }
        text_take(text);
        while (at < end)
            line[at++] = text[letter] ? text[letter++] : ' ';
    }
    line[at] = 0;
    screen_text(player->screen, 1, line);
}

static void make_status(const struct player *player, uint32 frames, uint32 fields)
{
    char text[TEXT];
    const struct part *part = player->part;

    text_add(part->says);
    if (frames) {
        text_add("  ");
        text_tenths(rate(frames, fields));
        text_add(" frames/s");
    }
    if (part->steps > 1) {
        text_add("  step ");
        text_number(player->governor.step + 1);
        text_add(" of ");
        text_number(part->steps);
        text_add(": ");
        text_add(part->step[player->governor.step].name);
    }
    text_take(text);
    screen_text(player->screen, 1, text);
}

static void make(struct player *player, uint32 frames, uint32 fields)
{
    if (player->part->panes > 1)
        make_columns(player, fields);
    else
        make_status(player, frames, fields);
}

void figures_first(struct player *player)
{
    screen_text(player->screen, 0, player->part->title);
    make(player, 0, 0);
}

/* A step's first picture is not counted: it also makes the data it needs. */
void figures_again(struct player *player)
{
    for (int32 i = 0; i < player->part->panes; i++) {
        struct lane *lane = &player->lane[i];

        lane->seen = lane->pictures;
        lane->counted = lane->pixels = lane->cost = 0;
    }
    player->figured_frames = player->frames;
    player->figured = player->shown;
    make(player, 0, 0);
}

void figures_make(struct player *player)
{
    if (player->due - player->figured < FIGURES_FIELDS)
        return;
    make(player, player->frames - player->figured_frames, player->due - player->figured);
    player->figured_frames = player->frames;
    player->figured = player->due;
}
