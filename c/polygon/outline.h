/* What a polygon covers: its sides, the box around it, its edges and table of lines. */
#ifndef OUTLINE_H
#define OUTLINE_H

#include "polygon/setup.h"

/* Fills in sides, box, outline and edges from frame, material, vertices and count. */
enum polygon_result outline_find(struct setup *s);

/* Makes the table by a stepper of edges, and cuts it to the frame's columns. */
void outline_lines(struct setup *s, void (*edges)(const struct edge_plan *plan),
                   void (*scissor)(const struct scissor_plan *plan));

#endif
