/* batch - runs a program with one line of arguments after the other, loading it once.

   batch PROGRAM FIRST
   Takes the lines from FIRST.run and numbers them from FIRST. The program's output goes to N.log,
   its return code to N.code. Before each run the program's data is restored as it was loaded. */
#include "system/file.h"
#include "system/outcome.h"
#include "system/system.h"
#include "system/text.h"

#define HUNKS 4
#define NAME 32             /* bytes of a file's name */

/* A hunk after the code, and a copy of its contents when loaded; `kept` is 0 if they are all
   zeros. */
struct hunk {
    uint32 *at, *kept;
    uint32 longs;
};

/* The data of a program. */
struct data {
    struct hunk hunks[HUNKS];
    int32 count;
};

static int32 keep(struct hunk *hunk, uint32 *link)
{
    uint32 at = 0;

    hunk->at = link + 1;
    hunk->longs = (link[-1] - 8) / 4;
    hunk->kept = 0;
    while (at < hunk->longs && !hunk->at[at])
        at++;
    if (at == hunk->longs)
        return 1;
    if (!mem_alloc(&hunk->kept, (int32)(4 * hunk->longs), MEMORY_ANY))
        return outcome_lack_memory("batch", "a copy of the program's data");
    for (at = 0; at < hunk->longs; at++)
        hunk->kept[at] = hunk->at[at];
    return 1;
}

static int32 keep_all(struct data *data, uint32 program)
{
    uint32 *link = (uint32 *)program;

    for (data->count = 0; *link; data->count++) {
        link = (uint32 *)(*link << 2);
        if (data->count == HUNKS)
            return text_refuse("batch", "the program has too many hunks");
        if (!keep(&data->hunks[data->count], link))
            return 0;
    }
    return 1;
}

static void restore(const struct hunk *hunk)
{
    uint32 *to = hunk->at;
    const uint32 *from = hunk->kept;
    uint32 left = hunk->longs;

    if (from) {
        for (; left; left--)
            *to++ = *from++;
        return;
    }
    for (; left >= 8; left -= 8) {
        *to++ = 0;
        *to++ = 0;
        *to++ = 0;
        *to++ = 0;
        *to++ = 0;
        *to++ = 0;
        *to++ = 0;
        *to++ = 0;
    }
    for (; left; left--)
        *to++ = 0;
}

/* Makes a file's name from a number and an ending. */
static void name_file(char *name, int32 number, const char *ending)
{
    text_number(number);
    text_add(ending);
    text_take(name);
}

static int32 save_code(int32 number, int32 code)
{
    char name[NAME], digits[NAME];

    name_file(name, number, ".code");
    text_number(code);
    return file_save(name, digits, (uint32)text_take(digits));
}

static int32 run_all(uint32 program, const struct data *data, const char *lines, uint32 bytes,
                     int32 number)
{
    for (; bytes; number++) {
        char log[NAME];
        uint32 length = 0;
        int32 code;

        while (length < bytes && lines[length++] != '\n')
            ;
        name_file(log, number, ".log");
        for (int32 i = 0; i < data->count; i++)
            restore(&data->hunks[i]);
        code = program_run(program, lines, (int32)length, log);
        if (code < 0)
            return text_refuse(log, "the program cannot be run");
        if (!save_code(number, code))
            return 0;
        lines += length;
        bytes -= length;
        if (bytes && outcome_break())
            return 0;
    }
    return 1;
}

int main(void)
{
    enum { PROGRAM, FIRST, ITEMS };
    int32 args[ITEMS] = {0};
    struct data data;
    uint32 program, bytes;
    int32 number, done;
    uint8 *lines;
    char name[NAME];

    if (!args_read("PROGRAM/A,FIRST/A/N", args)) {
        print("batch: usage: batch PROGRAM FIRST\n");
        return RETURN_ERROR;
    }
    number = *(const int32 *)args[FIRST];
    name_file(name, number, ".run");
    if (!file_load(name, &lines, &bytes))
        return outcome_code(0);
    program = program_load((const char *)args[PROGRAM]);
    if (!program)
        return outcome_code(text_refuse((const char *)args[PROGRAM], "cannot be loaded"));
    done = keep_all(&data, program)
        && run_all(program, &data, (const char *)lines, bytes, number);
    program_unload(program);
    return outcome_code(done);
}
