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

enum n64_which { N64_A, N64_B, N64_C, N64_D };

/* combine.c. By codes below 16: of A and D of R G B and A, B and D of alpha, of B and C of R G B,
   of C of alpha. All higher codes are N64_ZERO. */
extern const uint8 n64_sources[4][16];

/* Returns the enum n64_source of an input's A, B, C or D. */
static inline uint32 n64_source(const struct n64_input *input, int32 is_alpha, int32 which)
{
    const uint32 code = (&input->a)[which];
    const int32 row = which == N64_C ? 2 + is_alpha : which == N64_B && !is_alpha;

    return code < 16 ? n64_sources[row][code] : (uint32)N64_ZERO;
}

#endif
