/* Files that are read piece by piece, with a checksum. */
#ifndef INPUT_H
#define INPUT_H

#include "compiler.h"

/* A file that is being read from its start to its end. */
struct file_input {
    const char *name;
    int32 file;                 /* its handle */
    uint32 left;                /* bytes that are not read yet */
    uint32 sum;                 /* CRC-32 of those that are, since it was last set to 0 */
};

/* Opens a file; prints a line and returns 0 if it cannot. */
int32 file_input_open(struct file_input *input, const char *name);

/* Reads the next bytes; prints a line and returns 0 if it cannot. */
int32 file_input_read(struct file_input *input, void *to, uint32 bytes);

/* Reads the rest of the file and returns 1 if its sum is `checksum`, 0 if not, or if it cannot be
   read. */
int32 file_input_sound(struct file_input *input, uint32 checksum);

#endif
