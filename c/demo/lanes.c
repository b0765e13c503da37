#include "demo/picture.h"
#include "demo/player.h"

#include "frames/frames.h"
#include "polygon/counts.h"
#include "system/system.h"

#define BOTH 3u

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
        age = (screen_fields(player->screen) - player->began) / FRAME_FIELDS;
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
    if (settings.perspective == SETTINGS_OWN)
        settings.perspective = step->perspective;
    settings_set(player->scene, &settings);
}

static void draw(struct player *player, int32 number, int32 frame)
{
    struct lane *lane = &player->lane[number];
    const uint32 materials = player->scene->header->materials;
    const int32 counted = lane->pictures % COUNT_EVERY == 0;
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
    lane->stale = BOTH;
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

/* Draws pictures in turn until the previous frame is shown, but none that might make this frame
   late: conversion begins when the previous frame is shown, or after drawing. Draws at least one
   if there is nothing to convert. */
static void draw_fairly(struct player *player)
{
    const uint32 hidden = 1u << player->screen->hidden;
    uint32 converting = 0, drawn = 0;

    for (int32 i = 0; i < player->part->panes; i++) {
        const struct lane *lane = &player->lane[i];

        if (lane->stale & hidden)
            converting += lane->converting;
        if (lane->unlabelled & hidden)
            converting += lane->converting * LETTER / (uint32)lane->frame.height;
    }
    player_lap(player);
    for (;; drawn++) {
        const int32 next = poorest(player);
        const struct lane *lane = &player->lane[next];
        const uint32 more = lane->stale & hidden ? 0 : lane->converting;
        const uint32 age = display_age() * LINE_TICKS;  /* read while the frame before waits */

        if ((drawn || converting)
            && (!screen_waits(player->screen)
                || converting + more > TURNS_BUDGET - FRAME_TICKS
                || age + lane->worst + converting + more > TURNS_BUDGET))
            break;
        converting += more;
        lane_draw(player, next);
    }
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

/* Converts rows of a pane, counted from its frame's top, over its whole width. */
static void convert_rows(const struct player *player, int32 number, int32 top, int32 rows)
{
    const struct pane *pane = &player->part->pane[number];

    screen_convert_box(player->screen, &player->frame, pane->x, pane->y + top,
                       player->lane[number].frame.width, rows);
}

void lanes_convert(struct player *player)
{
    const uint32 hidden = 1u << player->screen->hidden;
    const struct step *step = &player->part->step[player->governor.step];

    for (int32 i = 0; i < player->part->panes; i++) {
        struct lane *lane = &player->lane[i];

        if (lane->stale & hidden) {
            uint32 taken;

            player_lap(player);
            convert_rows(player, i, step->top, step->rows);
            taken = player_lap(player);
            if (lane->converting < taken)
                lane->converting = taken;
            lane->stale &= ~hidden;
            if (player->whole) {
                convert_rows(player, i, 0, lane->frame.height);
                player->excluded += player_lap(player);
            }
        }
        if (lane->unlabelled & hidden) {
            convert_rows(player, i, lane->frame.height + CAPTION_GAP + lane->line * LETTER, LETTER);
            lane->unlabelled &= ~hidden;
        }
    }
    if (player->whole)
        player->whole--;
}
