/* The tables that perspective is drawn by. */
#ifndef SCENE_TABLES_H
#define SCENE_TABLES_H

#include "scene/scene.h"

/* Each makes its table, 109 KB of reciprocals and 673 KB of logarithms and powers, and scene's
   pointer to it; 0 where memory is short: the pointer is left alone. */
int32 scene_make_reciprocals(struct scene *scene);
int32 scene_make_logarithms(struct scene *scene);

#endif
