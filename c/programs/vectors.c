/* vectors - asks the texture engines what a file says, and writes their answers.

   vectors QUESTIONS ANSWERS
   Prints a line before every REPORTED-th operation. */
#include "bench/vector_answers.h"
#include "bench/vector_check.h"
#include "bench/vector_file.h"
#include "bench/vector_run.h"
#include "system/file.h"
#include "system/outcome.h"
#include "system/system.h"
#include "system/text.h"

#define REPORTED 16

/* Returns 1 if an operation is valid; longs: how many follow it in the file. */
static int32 usable_operation(const struct vector_operation *operation, uint32 longs)
{
    return operation->longs <= longs
        && vector_usable(operation->code, (const int32 *)(operation + 1), operation->longs);
}

static int32 usable(const uint8 *data, uint32 bytes, const char *name)
{
    const struct vector_header *h = (const struct vector_header *)data;
    const uint32 summed = (uint32)((const uint8 *)&h->operations_at - data);
    uint32 at;

    if (bytes < sizeof *h || h->size != bytes || bytes & 3)
        return text_refuse(name, "not a usable file of questions: size");
    if (h->magic != VECTOR_MAGIC)
        return text_refuse(name, "not a usable file of questions: magic");
    if (h->version != VECTOR_VERSION)
        return text_refuse(name, "not a usable file of questions: version");
    if (h->checksum != crc32(0, data + summed, bytes - summed))
        return text_refuse(name, "not a usable file of questions: checksum");
    at = h->operations_at;
    if (at & 3 || at > bytes)
        return text_refuse(name, "not a usable file of questions: operations_at");
    for (uint32 i = 0; i < h->operations; i++) {
        const struct vector_operation *operation = (const struct vector_operation *)(data + at);

        if (at >= bytes || !usable_operation(operation, (bytes - at) / 4 - 1)) {
            text_add(name);
            text_add(": not a usable file of questions: operation ");
            text_number((int32)i);
            text_print();
            return 0;
        }
        at += 4 + 4u * operation->longs;
    }
    return 1;
}

static int32 run_all(const uint8 *data)
{
    const struct vector_header *h = (const struct vector_header *)data;
    const struct vector_operation *operation =
        (const struct vector_operation *)(data + h->operations_at);

    for (uint32 i = 0; i < h->operations; i++) {
        const int32 *values = (const int32 *)(operation + 1);

        if (i % REPORTED == 0) {
            text_add("operation ");
            text_number((int32)i);
            text_print();
        }
        vectors_run(operation->code, values, operation->longs);
        if (outcome_break())
            return 0;
        operation = (const struct vector_operation *)(values + operation->longs);
    }
    return vector_answers_flush();
}

int main(void)
{
    enum { QUESTIONS, ANSWERS, ITEMS };
    int32 args[ITEMS] = {0};
    const char *name;
    uint8 *data;
    uint32 bytes;
    int32 results, done;

    if (!args_read("QUESTIONS/A,ANSWERS/A", args)) {
        print("vectors: usage: vectors QUESTIONS ANSWERS\n");
        return RETURN_ERROR;
    }
    name = (const char *)args[QUESTIONS];
    if (!file_load(name, &data, &bytes) || !usable(data, bytes, name))
        return outcome_code(0);
    results = outcome_create((const char *)args[ANSWERS]);
    vector_answers_open(results);
    done = results && vectors_open() && run_all(data);
    if (done)
        outcome_keep();
    return outcome_code(done);
}
