#include "polygon/kind.h"

span_routine *const kind_spans[SPAN_KINDS] = {
#define SPAN(kind, name, lines) span_##name,
#define OTHER(kind, name) 0,
    SPAN_LIST(SPAN, OTHER)
#undef SPAN
#undef OTHER
};

const uint8 kind_lines[SPAN_KINDS] = {
#define SPAN(kind, name, lines) LINES_##lines,
#define OTHER(kind, name) 0,
    SPAN_LIST(SPAN, OTHER)
#undef SPAN
#undef OTHER
};

const struct mapper_traits mappers[MAPPER_KINDS] = {
#define MAPPER(kind, name, layout, bytes, is, span, span_16, span_32) \
    {layout, bytes, is, {span, span_16, span_32}, {0, 0}},
    MAPPER_LIST(MAPPER)
#undef MAPPER
};

const struct line_routines line_routines[LINE_FORMS] = {
    [LINES_FLAT] = {edge_flat, edge_flat_exact, {lines_flat, lines_flat_exact}, scissor_flat},
    [LINES_ADDX] = {edge_addx, edge_addx_exact, {lines_addx, lines_addx_exact}, scissor_addx},
    [LINES_SWAP] = {edge_swap, edge_plain_exact, {0, 0}, scissor_plain},
    [LINES_PLAIN] = {edge_plain, edge_plain_exact, {lines_plain, lines_plain_exact}, scissor_plain}
};
