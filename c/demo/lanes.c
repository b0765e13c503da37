#include "demo/picture.h"
#include "demo/player.h"

#include "frames/frames.h"
#include "polygon/counts.h"
#include "system/system.h"

static void clear_counts(struct draw_counts *counts, uint32 materials)
{
    uint32 *to = (uint32 *)counts;

    for (uint32 i = materials * (sizeof *counts / sizeof *to); i > 0; i--)
        *to++ = 0;
}

static uint32 sum_pixels(const struct draw_counts *counts, uint32 materials)
{
    uint32 sum = 0;

    for (; materials; materials--, counts++)
        sum += counts_drawn(counts);
    return sum;
}

/* Returns the scene's frame for a lane's next picture. */
static int32 scene_frame(const struct player *player, const struct lane *lane)
{
    const struct step *step = &player->part->step[player->governor.step];
    uint32 age = lane->pictures;

    if (player->part->kind == PART_TOGETHER || player->part->kind == PART_FAIR)
        age = (screen_fields(player->screen) - player->began) / CLOCK_FIELDS;
    return step->first + (int32)(age % (uint32)step->frames);
}

static void set_settings(struct player *player, int32 number)
{
    const struct pane *pane = &player->part->pane[number];
    const struct step *step = &player->part->step[player->governor.step];
    const int32 set = number * GOVERNOR_STEPS + player->governor.step;
    struct settings settings;

    if (player->set == set)
        return;
    player->set = set;
    settings.accuracy = pane->settings.accuracy;
    settings.perspective = pane->settings.perspective;
    settings.only_cheaper = 0;
    if (settings.perspective == SETTINGS_OWN)
        settings.perspective = step->perspective;
    settings_set(player->scene, &settings);
}

static void draw(struct player *player, int32 number, int32 frame)
{
    struct lane *lane = &player->lane[number];
    const uint32 materials = player->scene->header->materials;
    const int32 counted = player->part->panes > 1 && lane->pictures % COUNT_EVERY == 0;
    struct renderer *renderer = &player->renderer;

    renderer->frame = &lane->frame;
    renderer->form = (enum form)player->part->pane[number].form;
    renderer->counts = counted ? player->counts : 0;
    set_settings(player, number);
    if (counted)
        clear_counts(player->counts, materials);
    /* The system's tasks have work ten times a second: it is none of the picture's. */
    tasks_forbid();
    player_lap(player);
    scene_draw(renderer, player->scene, frame);
    lane->last = player_lap(player);
    tasks_permit();
    if (counted) {
        lane->pixels += sum_pixels(player->counts, materials);
        lane->counted += lane->last;
    } else
        lane->sum += lane->last;
    lane->used += lane->last;
    lane->pictures++;
    if (player->part->panes > 1 && lane->frame.pixel_bytes == 1)
        picture_caption(&lane->frame, player->part->pane[number].caption, player->screen->font, player->ink,
                        player->ground);
}

void lane_draw(struct player *player, int32 number)
{
    draw(player, number, scene_frame(player, &player->lane[number]));
}

static int32 takes_turns(const struct player *player)
{
    return player->part->kind == PART_RACE || player->part->kind == PART_FAIR;
}

void lanes_probe(struct player *player)
{
    for (int32 i = 0; takes_turns(player) && i < player->part->panes; i++) {
        struct lane *lane = &player->lane[i];

        draw(player, i, player->part->pane[i].worst);
        lane->worst = lane->last + lane->last / 8;
        lane_draw(player, i);
    }
}

/* Returns the pane that has used the least time. */
static int32 poorest(const struct player *player)
{
    int32 best = 0;

    for (int32 i = 1; i < player->part->panes; i++)
        if (player->lane[i].used < player->lane[best].used)
            best = i;
    return best;
}

/* Draws pictures in turn until the next one might make this frame late; at least one. The conversion
   begins when the frame before is shown, and is in that frame's age when the next one is drawn. */
static void draw_fairly(struct player *player)
{
    const uint32 fields = (uint32)player->part->step[player->governor.step].fields;
    int32 next;

    player_lap(player);
    do {
        lane_draw(player, poorest(player));
        next = poorest(player);
    } while (screen_waits(player->screen)
             && display_age() * LINE_TICKS + player->lane[next].worst <= fields * TURNS_BUDGET);
}

void lanes_draw(struct player *player)
{
    if (takes_turns(player)) {
        draw_fairly(player);
        return;
    }
    for (int32 i = 0; i < player->part->panes; i++)
        lane_draw(player, i);
}
