#include "demo/log.h"

#include "system/text.h"

static void field(const char *name, uint32 value)
{
    text_add(name);
    text_number((int32)value);
}

void log_part(const struct player *player, int32 number, int32 full)
{
    field("part ", (uint32)number + 1);
    field(" frames ", player->frames);
    field(" fields ", player->shown - player->began);
    field(" late ", player->late);
    field(" step ", (uint32)player->governor.step + 1);
    field(" waited ", player->waited);
    field(" black ", player->black);
    text_add(" ");
    text_add(player->part->title);
    text_print();
    if (!full)
        return;
    for (int32 i = 0; i < player->part->panes; i++) {
        const struct lane *lane = &player->lane[i];

        field("pane ", (uint32)i + 1);
        field(" pictures ", lane->pictures);
        field(" ticks ", lane->sum);
        field(" used ", lane->used);
        text_print();
    }
    for (uint32 i = 0; player->worked && i < player->frames; i++) {
        const struct worked *worked = &player->worked[i];

        field("frame ", i);
        field(" step ", worked->step + 1);
        field(" fields ", worked->fields);
        field(" work ", worked->work);
        field(" lines ", worked->lines);
        text_print();
    }
}
