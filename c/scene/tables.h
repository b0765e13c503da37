/* The tables that perspective is drawn by. */
#ifndef SCENE_TABLES_H
#define SCENE_TABLES_H

#include "scene/scene.h"

/* Makes the tables that the scene's materials need as they are set now, each once: 109 KB of
   reciprocals, 673 KB of logarithms and powers. SCENE_RECIPROCALS or SCENE_LOGARITHMS: memory is,
   or was, short for one. */
enum scene_memory scene_make_tables(struct scene *scene);

#endif
