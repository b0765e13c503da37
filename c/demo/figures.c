/* The figures of a part: below each pane, or in the second status line. */
#include "demo/picture.h"
#include "demo/player.h"

#include "system/system.h"
#include "system/text.h"

#define CYCLES 4                /* CPU cycles in a colour clock */
#define BOTH 3u
#define FREE_EVERY 4            /* frames between two status lines in PART_FREE: they take long */
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

/* Writes a line below a pane, centred. */
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
    picture_text(&player->frame, pane->x + (frame->width - length * LETTER) / 2, y, 1, text,
                 player->screen->font, player->ink);
}

static void put_cost(struct player *player, int32 number)
{
    char text[TEXT];
    struct lane *lane = &player->lane[number];

    find_cost(lane);
    text_number((int32)lane->cost);
    text_add("/px");
    text_take(text);
    put(player, number, 1, text);
}

static void put_rate(struct player *player, int32 number)
{
    char text[TEXT];
    struct lane *lane = &player->lane[number];

    text_tenths(rate(lane->pictures - lane->seen, player->due - lane->figured));
    text_add("/s");
    text_take(text);
    put(player, number, 2, text);
    lane->seen = lane->pictures;
    lane->figured = player->due;
}

/* Writes line 1 or 2 of a pane's figures. */
static void make_below(struct player *player, int32 number, int32 line)
{
    if (line == 1)
        put_cost(player, number);
    else
        put_rate(player, number);
    player->lane[number].line = line;
    player->lane[number].unlabelled = BOTH;
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
    if (frames && part->panes == 1 && player->lane[0].cost) {
        text_add(", ");
        text_number((int32)player->lane[0].cost);
        text_add(" cycles/pixel");
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

static void put_mark(const struct player *player, const struct mark *mark)
{
    const struct scene_header *header = player->scene->header;
    const uint32 pixel = picture_pixel(header->format,
                                       (const uint8 *)header + header->palette_at, mark->colour);
    int32 x = mark->x, length = 0;

    if (!mark->scale) {
        picture_fill(&player->frame, x, mark->y, mark->width, mark->height, pixel);
        return;
    }
    while (mark->text[length])
        length++;
    if (x == MIDDLE)
        x = (player->frame.width - length * mark->scale * LETTER) / 2;
    picture_text(&player->frame, x, mark->y, mark->scale, mark->text, player->screen->font, pixel);
}

void figures_first(struct player *player)
{
    screen_text(player->screen, 0, player->part->title);
    make_status(player, 0, 0);
    for (int32 i = 0; i < player->part->marks; i++)
        put_mark(player, &player->part->mark[i]);
    for (int32 i = 0; i < player->part->panes; i++)
        if (*player->part->pane[i].caption)
            put(player, i, 0, player->part->pane[i].caption);
}

static void make(struct player *player, uint32 phase)
{
    const uint32 line = phase / FIGURES_APART;          /* from 1 on, two for each pane */

    if (player->part->panes > 1 && phase % FIGURES_APART == 0 && line
        && line <= 2 * (uint32)player->part->panes)
        make_below(player, (int32)(line - 1) / 2, (int32)((line - 1) & 1) + 1);
    if (phase)
        return;
    if (player->part->panes == 1)
        find_cost(&player->lane[0]);
    make_status(player, player->frames - player->figured_frames, player->due - player->figured);
    player->figured_frames = player->frames;
    player->figured = player->due;
}

/* A step's first picture is not counted: it also makes the data it needs. */
void figures_again(struct player *player)
{
    struct lane *lane = &player->lane[0];

    lane->pictures = 1;
    lane->counted = lane->pixels = lane->cost = 0;
    player->figured_frames = player->frames;
    player->figured = player->shown;
    make_status(player, 0, 0);
}

/* The lines are spread over several frames: all at once would make a frame late. */
void figures_make(struct player *player)
{
    const uint32 every = player->part->kind == PART_FREE ? FREE_EVERY : FIGURES_EVERY;

    make(player, player->frames % every);
}
