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
        lane->used = lane->last = lane->pictures = lane->seen = lane->pixels = lane->counted = 0;
        lane->sum = lane->cost = 0;
    }
}

static void start_governor(struct player *player)
{
    for (int32 i = 0; i < player->part->steps; i++)
        player->governor.budget[i] = (uint32)player->part->step[i].fields * FIELD_BUDGET;
    governor_start(&player->governor, player->part->steps);
}

/* Turns the frame into planes. Without the blitter the frame before must be shown. */
static void convert(struct player *player)
{
    screen_prepare(player->screen, &player->frame, 0);
    player_lap(player);
}

/* Opens the screen and shows the first picture; returns 0 if it cannot. */
static int32 show_first(struct player *player, const uint8 *palette)
{
    const uint32 from = display_fields();

    if (!screen_open(player->screen, &player->form))
        return 0;
    screen_palette(player->screen, palette);
    figures_first(player);
    convert(player);
    screen_post(player->screen, 0);
    player->began = player->shown = player->due = player->figured = screen_wait(player->screen);
    player->black = display_fields() - from;
    player->waited = display_fields() - player->asked;
    return 1;
}

/* Starts a part: draws the first picture of all panes, which also makes the data that they need, while the screen
   still shows what it did, and resets the figures. */
static int32 begin(struct player *player)
{
    const struct scene_header *header = player->scene->header;
    const uint8 *const palette = (const uint8 *)header + header->palette_at;

    make_lanes(player);
    start_governor(player);
    player->set = -1;
    player->frames = player->late = player->figured_frames = 0;
    clock_start(CLOCK_LIMIT);
    player->began = screen_fields(player->screen);
    if (header->format == PIXEL_CHUNKY) {
        player->ground = picture_pixel(palette, GROUND);
        player->ink = picture_pixel(palette, INK);
    }
    for (int32 i = 0; i < player->part->panes; i++)
        lane_draw(player, i);
    lanes_probe(player);
    if (!show_first(player, palette))
        return 0;
    clock_start(CLOCK_LIMIT);
    player->work = 0;
    for (int32 i = 0; i < player->part->panes; i++) {
        struct lane *lane = &player->lane[i];

        lane->used = lane->pictures = lane->counted = lane->pixels = lane->sum = 0;
    }
    return 1;
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

/* Returns the fields for which a frame is shown, at least. */
static uint32 step_fields(const struct player *player)
{
    return (uint32)player->part->step[player->governor.step].fields;
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
    player->late += player->part->kind != PART_FREE && player->frames && fields > player->due - player->shown;
    player->shown += fields;
}

/* Posts a frame for its field. */
static void post(struct player *player)
{
    player->due = player->shown + step_fields(player);
    screen_post(player->screen, player->due);
    player->work = 0;
    player->frames++;
}

/* Returns the fields that a part takes. A frame counts as CLOCK_FIELDS here. */
static uint32 fields_of(const struct player *player, uint32 frames)
{
    return frames ? frames * CLOCK_FIELDS : (uint32)player->part->seconds * FIELDS_SECOND;
}

/* Chooses the next step. Steps of PART_FREE have equal shares of its time. */
static void govern(struct player *player, uint32 frames)
{
    const int32 before = player->governor.step, steps = player->part->steps;
    const uint32 fields = player->shown - player->began;
    const uint32 share = fields * (uint32)steps / fields_of(player, frames);

    if (player->part->kind != PART_FREE)
        governor_next(&player->governor, player->work);
    else if (before < (int32)share && before < steps - 1) {
        player->governor.step++;
        figures_again(player);
    }
}

/* Records a frame's figures that are known before it is shown. */
static void note(struct player *player)
{
    struct worked *to = player->worked + player->frames;

    if (!player->worked)
        return;
    to->step = (uint32)player->governor.step;
    to->work = player->work;
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

    if (!begin(player))
        return FAILED;
    while (end == PLAYED && !is_over(player, frames)) {
        lanes_draw(player);
        if (player->screen->between[0]) {
            convert(player);
            wait_shown(player);
        } else {
            wait_shown(player);
            convert(player);
        }
        note(player);
        govern(player, frames);
        post(player);
        figures_make(player);
        end = asked();
    }
    wait_shown(player);
    screen_finish(player->screen);      /* a line is printed next */
    return end;
}
