/* Spans of lines with perspective, of which a program may leave some out: drawing/parts/parts.h. */
#include "perspective/perspective.h"

perspective_routine *const perspective_pieces[3] = {
    span_perspective_pieces, span_perspective_pieces_16, span_perspective_pieces_32};
perspective_routine *const perspective_curves[3] = {
    span_perspective_curves, span_perspective_curves_16, span_perspective_curves_32};
span_routine *const perspective_scanlines[2][3] = {
    {span_affine_scanline, span_affine_16_scanline, span_affine_32_scanline},
    {span_affine_level, span_affine_16_level, span_affine_32_level}};
