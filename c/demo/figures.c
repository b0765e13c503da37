/* The figures of a part: below each pane, or in the second status line. */
#include "demo/picture.h"
#include "demo/player.h"

#include "system/text.h"

#define CYCLES 4                /* of the CPU in a colour clock */
#define BOTH 3u
#define TEXT 160                /* bytes: the status line has 80 */

/* A tenth's value with its point. */
static void text_tenths(uint32 tenths)
{
    text_number((int32)(tenths / 10));
    text_add(".");
    text_number((int32)(tenths % 10));
}

/* Events in so many fields as tenths a second, to the nearest. */
static uint32 rate(uint32 events, uint32 fields)
{
    return fields ? (events * 500 + fields / 2) / fields : 0;
}

static uint32 cycles(const struct lane *lane)
{
    return lane->pixels ? (lane->last * CYCLES + lane->pixels / 2) / lane->pixels : 0;
}

/* One line below a pane, in its middle. */
static void put(const struct player *player, int32 number, int32 line, const char *text)
{
    const struct pane *pane = &player->part->pane[number];
    const struct frame *frame = &player->lane[number].frame;
    const int32 y = pane->y + frame->height + CAPTION_GAP + line * LETTER;
    int32 length = 0;

    while (text[length])
        length++;
    if (y + LETTER > player->frame.height)
        return;
    picture_fill(&player->frame, pane->x, y, frame->width, LETTER, player->ground);
    picture_text(&player->frame, pane->x + (frame->width - length * LETTER) / 2, y, text,
                 player->screen->font, player->ink);
}

static void make_below(struct player *player, uint32 fields)
{
    static char text[TEXT];

    for (int32 i = 0; i < player->part->panes; i++) {
        struct lane *lane = &player->lane[i];

        text_number((int32)cycles(lane));
        text_add(" c/px");
        text_take(text);
        put(player, i, 1, text);
        text_tenths(rate(lane->pictures - lane->seen, fields));
        text_add("/s");
        text_take(text);
        put(player, i, 2, text);
        lane->seen = lane->pictures;
        lane->unlabelled = BOTH;
    }
}

static void make_status(const struct player *player, uint32 frames, uint32 fields)
{
    static char text[TEXT];
    const struct part *part = player->part;

    text_add(part->says);
    if (frames) {
        text_add("  ");
        text_tenths(rate(frames, fields));
        text_add(" frames/s");
    }
    if (frames && part->panes == 1) {
        text_add(", ");
        text_number((int32)cycles(&player->lane[0]));
        text_add(" c/px");
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

void figures_first(struct player *player)
{
    screen_text(player->screen, 0, player->part->title);
    make_status(player, 0, 0);
    if (player->scene->header->format == PIXEL_CHUNKY)
        for (int32 i = 0; i < player->part->panes; i++)
            put(player, i, 0, player->part->pane[i].caption);
}

void figures_make(struct player *player)
{
    const uint32 now = screen_fields(player->screen), fields = now - player->figured;
    if (player->part->panes > 1)
        make_below(player, fields);
    make_status(player, player->frames - player->figured_frames, fields);
    player->figured_frames = player->frames;
    player->figured = now;
}
