#include "demo/picture.h"
#include "demo/player.h"

#include "system/system.h"

#define KEY_ESCAPE 0x45
#define KEY_SPACE 0x40
#define FIELDS_SECOND 50

static void make_lanes(struct player *player)
{
    const struct scene_header *header = player->scene->header;

    for (int32 i = 0; i < player->part->panes; i++) {
        const struct pane *pane = &player->part->pane[i];
        struct lane *lane = &player->lane[i];

        lane->frame.pixel_bytes = player->frame.pixel_bytes;
        lane->frame.pitch = player->frame.pitch;
        lane->frame.width = header->width;
        lane->frame.height = header->height;
        lane->frame.pixels = player->frame.pixels + pane->y * player->frame.pitch
            + pane->x * player->frame.pixel_bytes;
        lane->used = lane->last = lane->converting = 0;
        lane->pictures = lane->seen = lane->pixels = 0;
        lane->stale = lane->unlabelled = lane->sum = 0;
    }
}

/* The first picture of all panes and what does not change, in both sets of planes. */
static void begin(struct player *player)
{
    const struct scene_header *header = player->scene->header;

    make_lanes(player);
    governor_start(&player->governor, player->part->steps, FRAME_BUDGET);
    player->set = -1;
    player->frames = player->late = player->figured_frames = 0;
    player->whole = 0;
    player->began = screen_fields(player->screen);
    if (header->format == PIXEL_CHUNKY) {
        player->ground = (uint8)header->background;
        player->ink = picture_ink((const uint8 *)header + header->palette_at);
        picture_fill(&player->frame, 0, 0, player->frame.width, player->frame.height,
                     player->ground);
    }
    figures_first(player);
    for (int32 i = 0; i < player->part->panes; i++) {
        lane_draw(player, i);
        lane_draw(player, i);           /* the first one makes and counts */
    }
    for (int32 set = 0; set < 2; set++) {
        screen_convert(player->screen, &player->frame);
        if (!set)
            screen_palette(player->screen, (const uint8 *)header + header->palette_at);
        screen_swap(player->screen);
        lanes_convert(player);          /* times it */
    }
    for (int32 i = 0; i < player->part->panes; i++) {
        struct lane *lane = &player->lane[i];

        lane->used = lane->pictures = lane->seen = lane->sum = 0;
    }
    player->began = player->shown = player->figured = screen_fields(player->screen);
}

/* What the user wants; PLAYED: nothing. */
static enum player_end asked(void)
{
    uint32 key;

    if (break_asked())
        return BROKEN;
    while ((key = key_take()) != NO_KEY)
        if (key == KEY_ESCAPE)
            return LEFT;
        else if (key == KEY_SPACE)
            return SKIPPED;
    return PLAYED;
}

/* Frames are shown in the second field after the one before, or as soon as they can be. */
static void show(struct player *player)
{
    uint32 now;

    if (player->part->kind != PART_FREE)
        while (screen_fields(player->screen) - player->shown < FRAME_FIELDS - 1)
            ;
    screen_swap(player->screen);
    now = screen_fields(player->screen);
    player->late += now - player->shown > FRAME_FIELDS;
    player->shown = now;
}

/* What lies beside the rows of a step stays as the step before left it: all is drawn anew. */
static void govern(struct player *player)
{
    const int32 before = player->governor.step;

    if (player->works)
        player->works[player->frames] = (uint32)before << 24 | player->work;
    if (governor_next(&player->governor, player->work) != before)
        player->whole = 2;
}

enum player_end player_play(struct player *player, uint32 frames)
{
    const uint32 fields = (uint32)player->part->seconds * FIELDS_SECOND;
    enum player_end end = PLAYED;

    begin(player);
    while (end == PLAYED && (frames ? player->frames < frames
                                    : player->shown - player->began < fields)) {
        player->work = 0;
        lanes_draw(player);
        lanes_convert(player);
        govern(player);
        player->frames++;
        show(player);
        if (player->frames % FIGURES_EVERY == 0)
            figures_make(player);
        end = asked();
    }
    return end;
}
