/* What the engines' operations share: answers to a file, and numbers at random. */
#ifndef VECTOR_ANSWERS_H
#define VECTOR_ANSWERS_H

#include "compiler.h"

/* The open file that answers go to. */
void vector_answers_open(int32 file);

void vector_answer(int32 value);

/* As many longs as VECTOR_TEXT_BYTES, a character each, and 0 behind the last. */
void vector_answer_text(const char *text);

/* Writes the answers that are still kept; prints a line and returns 0 if any could not be. */
int32 vector_answers_flush(void);

/* xorshift32: the next number. */
uint32 vector_random(uint32 *state);

/* Fills memory with the longs that follow a seed. */
void vector_fill(uint8 *to, uint32 bytes, uint32 seed);

#endif
