#include "system/outcome.h"

#include "system/system.h"
#include "system/text.h"

static int32 code = RETURN_ERROR;

/* A file that is not complete yet. */
static int32 piece;
static const char *piece_name;

int32 outcome_break(void)
{
    if (!break_asked())
        return 0;
    code = RETURN_WARN;
    return 1;
}

int32 outcome_lack(const char *name, const char *what)
{
    code = RETURN_FAIL;
    return text_refuse(name, what);
}

int32 outcome_lack_memory(const char *name, const char *purpose)
{
    int32 kind;
    const int32 bytes = mem_asked(&kind);

    text_add(name);
    text_add(": not enough memory for ");
    text_add(purpose);
    text_add(": ");
    text_number(bytes);
    text_add(kind == MEMORY_CHIP ? " bytes of chip RAM" : " bytes");
    text_add("; the largest free piece has ");
    text_number(mem_largest(kind));
    text_print();
    code = RETURN_FAIL;
    return 0;
}

static void drop(void)
{
    if (!piece)
        return;
    file_close(piece);
    file_delete(piece_name);
    piece = 0;
}

int32 outcome_create(const char *name)
{
    static struct end end = {0, drop};

    piece = file_open(name, FILE_NEW);
    if (!piece)
        return text_refuse(name, "cannot be created");
    piece_name = name;
    at_end(&end);
    return piece;
}

void outcome_keep(void)
{
    file_close(piece);
    piece = 0;
}

int32 outcome_code(int32 done)
{
    return done ? RETURN_OK : code;
}
