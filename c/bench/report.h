/* What an owner reads: lines to the console, and to a file at the end. */
#ifndef REPORT_H
#define REPORT_H

#include "compiler.h"

/* A table's cell: a title, and three figures under the heads that report_heads shows; blank where
   there is none. Two of them are a line of 75 columns on the console: it
   has 77, and behind lines of all 77 it leaves an empty one. */
struct report_cell {
    char text[37];
};

enum report_column { REPORT_HERE = 23, REPORT_EMULATED = 30, REPORT_RATIO = 36 };

void report_cell_clear(struct report_cell *cell, const char *title);

/* The number, in thousandths, with so many decimals (0 to 3), rounded, ends before a column. */
void report_cell_number(struct report_cell *cell, int32 column, uint32 thousandths, int32 decimals);
void report_cell_text(struct report_cell *cell, int32 column, const char *text);

/* What text_add collected becomes a line of both. */
void report_line(void);

/* The heads of a table on both. */
void report_heads(void);

/* A cell on the console, two a line; in the file what text_add collected stands behind it.
   Returns whether the console's line is to have another. */
int32 report_row(const struct report_cell *cell);

/* Ends a line of the console that has one cell. */
void report_end_rows(void);

/* Writes the file; prints a line that says why, leaves none and returns 0 if it cannot. */
int32 report_save(const char *name);

#endif
