#include "demo/picture.h"
#include "demo/player.h"

#include "system/system.h"

#define FIELDS_SECOND 50
#define GROUND 0x000000         /* colours of the background and of figures */
#define INK 0xffffff

uint32 player_lap(struct player *player)
{
    const uint32 ticks = clock_stop();

    clock_start(CLOCK_LIMIT);
    player->work += ticks;
    return ticks;
}

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

/* Starts a part: draws the first picture of all panes, texts and rectangles, converts them into
   both sets of planes, and resets the figures. */
static void begin(struct player *player)
{
    const struct scene_header *header = player->scene->header;
    const uint8 *palette;

    make_lanes(player);
    governor_start(&player->governor, player->part->steps, FRAME_BUDGET);
    player->set = -1;
    player->frames = player->late = player->figured_frames = 0;
    player->whole = 0;
    clock_start(CLOCK_LIMIT);
    player->began = screen_fields(player->screen);
    palette = (const uint8 *)header + header->palette_at;
    player->ground = picture_pixel(header->format, palette, GROUND);
    player->ink = picture_pixel(header->format, palette, INK);
    picture_fill(&player->frame, 0, 0, player->frame.width, player->frame.height,
                 player->ground);
    figures_first(player);
    for (int32 i = 0; i < player->part->panes; i++)
        lane_draw(player, i);           /* also makes the data it needs */
    lanes_probe(player);
    for (int32 set = 0; set < 2; set++) {
        screen_convert(player->screen, &player->frame);
        if (!set)
            screen_palette(player->screen, palette);
        screen_swap(player->screen);
        lanes_convert(player);          /* times the conversion */
    }
    screen_swap(player->screen);        /* returns at the start of a field */
    clock_start(CLOCK_LIMIT);
    player->work = player->excluded = 0;
    player->began = player->shown = player->figured = screen_wait(player->screen);
    for (int32 i = 0; i < player->part->panes; i++) {
        struct lane *lane = &player->lane[i];

        lane->used = lane->pictures = lane->counted = lane->pixels = lane->sum = 0;
        lane->figured = player->began;
    }
}

/* Returns the user's request, or PLAYED if there is none. */
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

/* Waits until the previous frame is shown. */
static void wait_shown(struct player *player)
{
    uint32 fields;

    player_lap(player);
    fields = screen_wait(player->screen) - player->shown;
    clock_start(CLOCK_LIMIT);
    if (player->frames && player->worked)
        player->worked[player->frames - 1].fields = fields;
    player->late += fields > FRAME_FIELDS;
    player->shown += fields;
}

/* Posts a frame for the second field after the previous one; in PART_FREE for the next field. */
static void post(struct player *player)
{
    player->due = player->part->kind == PART_FREE ? screen_fields(player->screen) + 1
                : player->shown + FRAME_FIELDS;
    screen_post(player->screen, player->due);
    player->work = player->excluded = 0;
    player->frames++;
}

/* Returns the fields that a part takes. A frame counts as FRAME_FIELDS, in PART_FREE too. */
static uint32 fields_of(const struct player *player, uint32 frames)
{
    return frames ? frames * FRAME_FIELDS : (uint32)player->part->seconds * FIELDS_SECOND;
}

/* Chooses the next step. Steps of PART_FREE have equal shares of its time. After a change whole
   panes are converted twice, once for each set of planes: a step may redraw only some rows. */
static void govern(struct player *player, uint32 frames)
{
    const int32 before = player->governor.step, steps = player->part->steps;
    const uint32 fields = player->shown - player->began;
    const uint32 share = fields * (uint32)steps / fields_of(player, frames);

    if (player->part->kind != PART_FREE)
        governor_next(&player->governor, player->work - player->excluded);
    else if (before < (int32)share && before < steps - 1) {
        player->governor.step++;
        figures_again(player);
    }
    if (player->governor.step != before)
        player->whole = 2;
}

/* Records a frame's figures that are known before it is shown. */
static void note(struct player *player)
{
    struct worked *to = player->worked + player->frames;

    if (!player->worked)
        return;
    to->step = (uint32)player->governor.step;
    to->work = player->work;
    to->excluded = player->excluded;
    to->lines = display_age();
}

static int32 is_over(const struct player *player, uint32 frames)
{
    if (frames && player->part->kind != PART_FREE)
        return player->frames >= frames;
    return player->shown - player->began >= fields_of(player, frames);
}

enum player_end player_play(struct player *player, uint32 frames)
{
    enum player_end end = PLAYED;

    begin(player);
    while (end == PLAYED && !is_over(player, frames)) {
        lanes_draw(player);
        wait_shown(player);
        lanes_convert(player);
        player_lap(player);
        note(player);
        govern(player, frames);
        post(player);
        figures_make(player);
        end = asked();
    }
    wait_shown(player);
    return end;
}
