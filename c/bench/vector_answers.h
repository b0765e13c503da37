/* Shared by the engines' operations: answers written to a file, and random numbers. */
#ifndef VECTOR_ANSWERS_H
#define VECTOR_ANSWERS_H

#include "compiler.h"

/* Sets the open file for answers. */
void vector_answers_open(int32 file);

void vector_answer(int32 value);

/* Answers with VECTOR_TEXT_BYTES longs, a character each, then zeros. */
void vector_answer_text(const char *text);

/* Writes the buffered answers; returns 0 if any write failed, and prints a line the first time. */
int32 vector_answers_flush(void);

/* xorshift32: the next number. */
uint32 vector_random(uint32 *state);

/* Fills memory with the longs that follow a seed. */
void vector_fill(uint8 *to, uint32 bytes, uint32 seed);

#endif
