#include "triangle/polygon.h"

enum span_kind triangle_kind(const struct frame *frame, const struct material *material)
{
    if (frame->pixel_bytes > 1)
        return material->mapper == MAPPER_FLAT
             ? frame->pixel_bytes == 2 ? SPAN_FILL_16 : SPAN_FILL_32
             : frame->pixel_bytes == 2 ? SPAN_AFFINE_16 : SPAN_AFFINE_32;
    return material->mapper == MAPPER_FLAT ? SPAN_TRIANGLES_FLAT
         : material->mapper == MAPPER_GOURAUD ? SPAN_TRIANGLES_GOURAUD
         : material->mapper == MAPPER_LIT ? SPAN_LIT
         : material->mapper == MAPPER_LIT_GOURAUD ? SPAN_LIT_GOURAUD : SPAN_TRIANGLES_AFFINE;
}
