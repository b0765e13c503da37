#include "polygon/texturing.h"

uint32 texturing_middle(const struct texturing *t, const struct rectangle *box)
{
    const int32 x = ((box->left + box->right) >> 1) - t->i;
    const int32 y = ((box->top + box->bottom) >> 1) - t->j;

    return t->v + (uint32)x * (uint32)t->dvdx + (uint32)y * (uint32)t->dvdy;
}
