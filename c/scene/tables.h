/* The tables for drawing perspective. */
#ifndef SCENE_TABLES_H
#define SCENE_TABLES_H

#include "scene/load.h"

/* Makes the tables that the scene's materials need with their present settings, each once: 82 KB
   of reciprocals, and those of triangles. Returns SCENE_RECIPROCALS if memory is, or was, short for one. */
enum scene_memory scene_make_tables(struct scene *scene);

#endif
