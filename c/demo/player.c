#include "demo/picture.h"
#include "demo/player.h"

#include "system/system.h"

#define FIELDS_SECOND 50
#define GROUND 0x000000         /* colours of the picture and of figures */
#define INK 0xffffff

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
        lane->pictures = lane->seen = lane->pixels = lane->counted = 0;
        lane->stale = lane->unlabelled = lane->sum = lane->cost = 0;
    }
}

/* The first picture of all panes and what does not change, in both sets of planes. */
static void begin(struct player *player)
{
    const struct scene_header *header = player->scene->header;
    const uint8 *palette;

    make_lanes(player);
    governor_start(&player->governor, player->part->steps, FRAME_BUDGET);
    player->set = -1;
    player->frames = player->late = player->figured_frames = 0;
    player->whole = 0;
    player->aside = 0;
    player->began = screen_fields(player->screen);
    palette = (const uint8 *)header + header->palette_at;
    player->ground = picture_pixel(header->format, palette, GROUND);
    player->ink = picture_pixel(header->format, palette, INK);
    picture_fill(&player->frame, 0, 0, player->frame.width, player->frame.height,
                 player->ground);
    figures_first(player);
    for (int32 i = 0; i < player->part->panes; i++) {
        lane_draw(player, i);
        lane_draw(player, i);           /* the first one makes and counts */
    }
    lanes_probe(player);
    for (int32 i = 0; i < player->part->panes; i++)
        lane_draw(player, i);
    for (int32 set = 0; set < 2; set++) {
        screen_convert(player->screen, &player->frame);
        if (!set)
            screen_palette(player->screen, palette);
        screen_swap(player->screen);
        lanes_convert(player);          /* times it */
    }
    screen_swap(player->screen);        /* from a field's begin on */
    player->began = player->shown = player->figured = screen_fields(player->screen);
    for (int32 i = 0; i < player->part->panes; i++) {
        struct lane *lane = &player->lane[i];

        lane->used = lane->pictures = lane->counted = lane->pixels = lane->sum = 0;
        lane->figured = player->began;
    }
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

/* Frames are shown in the second field after the one before, or as soon as they can be. Returns how
   many fields later that is. */
static uint32 show(struct player *player)
{
    uint32 fields;

    if (player->part->kind != PART_FREE)
        while (screen_fields(player->screen) - player->shown < FRAME_FIELDS - 1)
            ;
    screen_swap(player->screen);
    fields = screen_fields(player->screen) - player->shown;
    player->late += fields > FRAME_FIELDS;
    player->shown += fields;
    return fields;
}

/* What a step leaves out of the picture stays as the step before left it: all is shown anew. */
static void govern(struct player *player)
{
    const int32 before = player->governor.step;

    if (governor_next(&player->governor, player->work) != before)
        player->whole = 2;
}

static void note(struct player *player, int32 step, uint32 fields)
{
    uint32 *to = player->works + player->frames;

    if (player->works)
        *to = (uint32)step << WORK_STEP | (fields < 15 ? fields : 15) << WORK_FIELDS | player->work;
}

/* Frames of PART_FREE count as long as they should take. */
static int32 is_over(const struct player *player, uint32 frames)
{
    const uint32 fields = player->shown - player->began;

    if (!frames)
        return fields >= (uint32)player->part->seconds * FIELDS_SECOND;
    return player->frames >= frames
        || (player->part->kind == PART_FREE && fields >= frames * FRAME_FIELDS);
}

enum player_end player_play(struct player *player, uint32 frames)
{
    enum player_end end = PLAYED;

    begin(player);
    while (end == PLAYED && !is_over(player, frames)) {
        const int32 step = player->governor.step;

        player->work = 0;
        lanes_draw(player);
        lanes_convert(player);
        govern(player);
        note(player, step, show(player));
        player->frames++;
        figures_make(player);
        end = asked();
    }
    return end;
}
