#include "system/text.h"

#include "system/system.h"

#define LINE 512

static char line[LINE + 2];
static int32 length;

void text_add(const char *text)
{
    while (*text && length < LINE)
        line[length++] = *text++;
}

void text_number(int32 value)
{
    char digits[12];
    int32 at = 11;
    uint32 rest = value < 0 ? 0 - (uint32)value : (uint32)value;

    digits[at] = 0;
    do {
        digits[--at] = (char)('0' + rest % 10);
        rest /= 10;
    } while (rest);
    if (value < 0)
        digits[--at] = '-';
    text_add(digits + at);
}

void text_print(void)
{
    line[length] = '\n';
    line[length + 1] = 0;
    length = 0;
    print(line);
}

int32 text_take(char *to)
{
    int32 taken = length;

    for (int32 i = 0; i < length; i++)
        to[i] = line[i];
    to[length] = 0;
    length = 0;
    return taken;
}

int32 text_refuse(const char *name, const char *why)
{
    text_add(name);
    text_add(": ");
    text_add(why);
    text_print();
    return 0;
}

int32 text_same(const char *a, const char *b)
{
    while (*a && *a == *b)
        a++, b++;
    return *a == *b;
}
