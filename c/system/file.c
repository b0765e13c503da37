#include "system/file.h"

#include "system/outcome.h"
#include "system/system.h"
#include "system/text.h"

int32 file_load(const char *name, uint8 **data, uint32 *bytes)
{
    int32 file = file_open(name, FILE_OLD), size, got;

    if (!file)
        return text_refuse(name, "cannot be opened");
    size = file_size(file);
    if (size <= 0) {
        file_close(file);
        return text_refuse(name, "is empty");
    }
    if (!mem_alloc(data, size, MEMORY_ANY)) {
        file_close(file);
        return outcome_lack_memory(name, "the file");
    }
    got = file_read(file, *data, size);
    file_close(file);
    if (got != size)
        return text_refuse(name, "cannot be read to its end");
    *bytes = (uint32)size;
    return 1;
}

int32 file_save(const char *name, const void *data, uint32 bytes)
{
    int32 file = file_open(name, FILE_NEW), put;

    if (!file)
        return text_refuse(name, "cannot be created");
    put = file_write(file, data, (int32)bytes);
    file_close(file);
    if (put == (int32)bytes)
        return 1;
    file_delete(name);
    return text_refuse(name, "cannot be written");
}

uint32 crc32(uint32 crc, const uint8 *data, uint32 bytes)
{
    static uint32 table[256];

    crc = ~crc;
    if (!table[1])
        for (uint32 i = 0; i < 256; i++) {
            uint32 rest = i;

            for (int32 bit = 0; bit < 8; bit++)
                rest = (rest >> 1) ^ (0xedb88320 & (0 - (rest & 1)));
            table[i] = rest;
        }
    while (bytes--)
        crc = (crc >> 8) ^ table[(crc ^ *data++) & 0xff];
    return ~crc;
}

int32 table_inside(uint32 at, uint32 count, uint32 size, uint32 bytes)
{
    return !(at & 3) && at <= bytes && count <= (bytes - at) / size;
}
