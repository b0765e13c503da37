#include "bench/vector_answers.h"

#include "bench/vector_file.h"
#include "system/file.h"
#include "system/system.h"
#include "system/text.h"

/* Answers not written yet. */
static uint32 answers[8192];
static uint32 answered;
static int32 results;           /* the file */
static int32 failed;            /* 1: a write failed */

void vector_answers_open(int32 file)
{
    results = file;
}

int32 vector_answers_flush(void)
{
    const int32 bytes = (int32)(answered * sizeof *answers);

    if (file_write(results, answers, bytes) != bytes && !failed)
        failed = !text_refuse("vectors", "answers cannot be written");
    answered = 0;
    return !failed;
}

void vector_answer(int32 value)
{
    if (answered == sizeof answers / sizeof *answers)
        vector_answers_flush();
    answers[answered++] = (uint32)value;
}

void vector_answer_text(const char *text)
{
    for (int32 i = 0; i < VECTOR_TEXT_BYTES; i++)
        vector_answer(*text ? *text++ : 0);
}

uint32 vector_random(uint32 *state)
{
    *state ^= *state << 13;
    *state ^= *state >> 17;
    *state ^= *state << 5;
    return *state;
}

void vector_fill(uint8 *to, uint32 bytes, uint32 seed)
{
    for (uint32 *at = (uint32 *)to; bytes; bytes -= 4)
        *at++ = vector_random(&seed);
}
