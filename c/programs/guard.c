/* guard - runs another program as the shell does, and reports its crash.

   guard PROGRAM ARGUMENTS
   The first line of output is "guard: " and where the program's first hunk is, in bytes from guard's own code. A
   crash is reported as a crash of guard's own: with its PC relative to guard's code. The return code is the program's. */
#include "system/outcome.h"
#include "system/system.h"
#include "system/text.h"

enum { LINE = 1024 };       /* bytes of arguments */

/* Copies the arguments and ends them with a line feed; returns their bytes, 0 if there are too many. */
static int32 copy(char *line, const char *from)
{
    int32 length = 0;

    while (from && *from && length < LINE - 1)
        line[length++] = *from++;
    line[length++] = '\n';
    return from && *from ? 0 : length;
}

int main(void)
{
    enum { PROGRAM, ARGUMENTS, ITEMS };
    int32 args[ITEMS] = {0};
    static char line[LINE];
    uint32 program;
    int32 bytes, code;

    if (!args_read("PROGRAM/A,ARGUMENTS/F", args)) {
        print("guard: usage: guard PROGRAM ARGUMENTS\n");
        return RETURN_ERROR;
    }
    bytes = copy(line, (const char *)args[ARGUMENTS]);
    program = program_load((const char *)args[PROGRAM]);
    if (!bytes || !program)
        return outcome_code(text_refuse((const char *)args[PROGRAM], bytes ? "cannot be loaded" : "arguments too long"));
    text_add("guard: ");
    text_number((int32)(program + 4 - program_base()));
    text_print();
    code = program_enter(program, line, bytes);
    program_unload(program);
    return code < 0 ? outcome_code(text_refuse((const char *)args[PROGRAM], "cannot be run")) : code;
}
