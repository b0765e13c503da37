/* What the codes of the combiner's inputs in a set-combine word select. */
#ifndef N64_CODES_H
#define N64_CODES_H

#include "n64/n64.h"

/* Codes that are not supported: A, B and C of R G B. */
enum n64_codes { N64_CODE_NOISE = 7, N64_CODE_KEY_CENTRE = 6, N64_CODE_KEY_SCALE = 6 };

enum n64_source {
    /* colours */
    N64_COMBINED, N64_TEXEL0, N64_TEXEL1, N64_PRIMITIVE, N64_SHADE, N64_ENVIRONMENT,
    N64_ONE, N64_ZERO, N64_FRACTION, N64_PRIMITIVE_FRACTION, N64_K4, N64_K5,
    N64_ALPHA_OF = 16           /* and a colour: its alpha */
};

/* Places in a row of n64->sources: those of R G B; N64_OF_ALPHA and these are alpha's. */
enum n64_which { N64_A, N64_B, N64_C, N64_D, N64_OF_ALPHA };

#endif
