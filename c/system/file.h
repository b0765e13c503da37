/* Whole files. */
#ifndef FILE_H
#define FILE_H

#include "compiler.h"

/* Reads a file into new memory; prints a line and returns 0 if it cannot. */
int32 file_load(const char *name, uint8 **data, uint32 *bytes);

/* Writes a file; prints a line, leaves no file and returns 0 if it cannot. */
int32 file_save(const char *name, const void *data, uint32 bytes);

/* CRC-32 as zlib, PNG and Ethernet have it (polynomial $edb88320, reflected). `crc`: that of the data
   before these, 0 if there are none. */
uint32 crc32(uint32 crc, const uint8 *data, uint32 bytes);

/* Returns 1 if a table of `count` entries of `size` bytes at offset `at` fits in a file of `bytes`
   bytes and `at` is a multiple of 4. */
int32 table_inside(uint32 at, uint32 count, uint32 size, uint32 bytes);

#endif
