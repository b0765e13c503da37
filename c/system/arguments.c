#include "system/arguments.h"

#include "system/text.h"

int32 number_asked(const char *program, int32 argument, int32 least, int32 end, int32 *value,
                   const char *why)
{
    if (argument)
        *value = *(const int32 *)argument;
    return !argument || (*value >= least && *value < end) || text_refuse(program, why);
}
