/* The report of the program measure: lines to the console, and to a file at the end. */
#ifndef REPORT_H
#define REPORT_H

#include "compiler.h"

/* A cell of the table: a title and three figures, under the heads of report_heads; a missing figure
   is blank. Two cells are a line of 75 columns on the console. It has 77, but a line of all 77 is
   followed by an empty one. */
struct report_cell {
    char text[37];
};

enum report_column { REPORT_HERE = 23, REPORT_EMULATED = 30, REPORT_RATIO = 36 };

void report_cell_clear(struct report_cell *cell, const char *title);

/* Write a number of thousandths, rounded to so many decimals (0 to 3), or a text, so that it ends
   before a column. */
void report_cell_number(struct report_cell *cell, int32 column, uint32 thousandths, int32 decimals);
void report_cell_text(struct report_cell *cell, int32 column, const char *text);

/* Writes the line that text_add collected to both. */
void report_line(void);

/* Writes the heads of a table to both. */
void report_heads(void);

/* Writes a cell: two a line on the console, one a line in the file, followed by what text_add
   collected. Returns 1 if the console's line needs another cell. */
int32 report_row(const struct report_cell *cell);

/* Ends the console's line if it has only one cell. */
void report_end_rows(void);

/* Writes the file; prints the reason, leaves no file and returns 0 if it cannot. */
int32 report_save(const char *name);

#endif
