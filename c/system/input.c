#include "system/input.h"

#include "system/file.h"
#include "system/outcome.h"
#include "system/system.h"
#include "system/text.h"

int32 file_input_open(struct file_input *input, const char *name)
{
    int32 size;

    input->name = name;
    input->sum = 0;
    input->file = file_open(name, FILE_OLD);
    if (!input->file)
        return text_refuse(name, "cannot be opened");
    size = file_size(input->file);
    if (size <= 0) {
        file_close(input->file);
        return text_refuse(name, "is empty");
    }
    input->left = (uint32)size;
    return 1;
}

int32 file_input_read(struct file_input *input, void *to, uint32 bytes)
{
    if (file_read(input->file, to, (int32)bytes) != (int32)bytes)
        return text_refuse(input->name, "cannot be read to its end");
    input->left -= bytes;
    input->sum = crc32(input->sum, to, bytes);
    return 1;
}

int32 file_input_sound(struct file_input *input, uint32 checksum)
{
    uint8 rest[1024];

    while (input->left) {
        uint32 bytes = input->left < sizeof rest ? input->left : (uint32)sizeof rest;

        if (file_read(input->file, rest, (int32)bytes) != (int32)bytes)
            return 0;
        input->left -= bytes;
        input->sum = crc32(input->sum, rest, bytes);
    }
    return input->sum == checksum;
}
