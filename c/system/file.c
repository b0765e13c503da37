#include "system/file.h"

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
        return text_refuse(name, "does not fit into memory");
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
    return put == (int32)bytes ? 1 : text_refuse(name, "cannot be written");
}

/* The remainders of a byte with 0 to 3 bytes behind it. Remainders have their bytes in reverse, so
   that a longword of data is exclusive-ored as it lies in memory. */
static uint32 remainders[4][256];

static void make_remainders(void)
{
    for (uint32 i = 0; i < 256; i++) {
        uint32 rest = i;

        for (int32 bit = 0; bit < 8; bit++)
            rest = (rest >> 1) ^ (0xedb88320 & (0 - (rest & 1)));
        remainders[0][i] = rest << 24 | (rest & 0xff00) << 8 | (rest >> 8 & 0xff00) | rest >> 24;
    }
    for (int32 behind = 1; behind < 4; behind++)
        for (uint32 i = 0; i < 256; i++) {
            uint32 rest = remainders[behind - 1][i];

            remainders[behind][i] = rest << 8 ^ remainders[0][rest >> 24];
        }
}

uint32 crc32(const uint8 *data, uint32 bytes)
{
    uint32 crc = 0xffffffff;

    if (!remainders[0][1])
        make_remainders();
    for (; bytes >= 4; bytes -= 4, data += 4) {
        crc ^= *(const uint32 *)data;
        crc = remainders[3][crc >> 24] ^ remainders[2][(uint8)(crc >> 16)]
            ^ remainders[1][(uint8)(crc >> 8)] ^ remainders[0][(uint8)crc];
    }
    while (bytes--)
        crc = crc << 8 ^ remainders[0][crc >> 24 ^ *data++];
    crc = crc << 24 | (crc & 0xff00) << 8 | (crc >> 8 & 0xff00) | crc >> 24;
    return ~crc;
}

int32 table_inside(uint32 at, uint32 count, uint32 size, uint32 bytes)
{
    return !(at & 3) && at <= bytes && count <= (bytes - at) / size;
}
