#include "bench/report.h"

#include "system/machine.h"
#include "system/system.h"
#include "system/text.h"

#define ROOM 8192
#define LINE 514                /* the longest of text_take */
#define FAULT 82                /* the longest of dos_fault */

static char lines[ROOM + 1];
static int32 length;
static int32 left_full;         /* 1: the console's line has a cell already */

void report_cell_text(struct report_cell *cell, int32 column, const char *text)
{
    int32 size = 0;

    while (text[size])
        size++;
    for (int32 i = 0; i < size; i++)
        cell->text[column - size + i] = text[i];
}

void report_cell_clear(struct report_cell *cell, const char *title)
{
    int32 i = 0;

    for (; title[i] && i < (int32)sizeof cell->text - 1; i++)
        cell->text[i] = title[i];
    for (; i < (int32)sizeof cell->text - 1; i++)
        cell->text[i] = ' ';
    cell->text[i] = 0;
}

void report_cell_number(struct report_cell *cell, int32 column, uint32 thousandths, int32 decimals)
{
    uint32 unit = 1, rest;
    int32 at = column;

    for (int32 i = decimals; i < 3; i++)
        unit *= 10;
    rest = (thousandths + unit / 2) / unit;
    for (int32 i = 0; i < decimals; i++, rest /= 10)
        cell->text[--at] = (char)('0' + rest % 10);
    if (decimals)
        cell->text[--at] = '.';
    do
        cell->text[--at] = (char)('0' + rest % 10);
    while ((rest /= 10) && at);
}

static void keep(const char *text)
{
    while (*text && length < ROOM)
        lines[length++] = *text++;
}

void report_line(void)
{
    char line[LINE];

    text_take(line);
    keep(line);
    keep("\n");
    text_add(line);
    text_print();
}

/* Prints a cell on the console. */
static void show(const char *cell)
{
    text_add(left_full ? " | " : "");
    text_add(cell);
    if (left_full) {
        text_print();
    } else {
        char line[LINE];

        text_take(line);
        print(line);
    }
    left_full = !left_full;
}

int32 report_row(const struct report_cell *cell)
{
    char more[LINE];

    text_take(more);
    keep(cell->text);
    keep(more);
    keep("\n");
    show(cell->text);
    return left_full;
}

void report_heads(void)
{
    struct report_cell cell;

    report_cell_clear(&cell, "");
    report_cell_text(&cell, REPORT_HERE, "here");
    report_cell_text(&cell, REPORT_EMULATED, "emul.");
    report_cell_text(&cell, REPORT_RATIO, "ratio");
    report_row(&cell);
    show(cell.text);
}

void report_end_rows(void)
{
    if (left_full)
        print("\n");
    left_full = 0;
}

int32 report_save(const char *name)
{
    const int32 window = dos_requests(-1);      /* no requester: the line below has the reason */
    const int32 file = file_open(name, FILE_NEW);
    int32 put = -1;
    char fault[FAULT];

    if (file)
        put = file_write(file, lines, length);
    dos_fault(fault, FAULT);
    if (file) {
        file_close(file);
        if (put != length)
            file_delete(name);
    }
    dos_requests(window);
    if (put == length)
        return 1;
    text_add(name);
    text_add(file ? " cannot be written" : " cannot be created");
    return text_refuse("", fault);
}
