"""Random input of the passes for Glide's texture unit, and what must come out of each.

The expected output is worked out from the unit's rules, pixel by pixel or by its model: neither
the C nor the assembly is asked. The bench measures one example of each pass, the tests call many.
"""

from collections.abc import Callable
from functools import partial

from tmap.bench.examples import (glide_combine as combine, glide_depth as depth, glide_mips as mips,
                                 glide_sample as sample, glide_tiles as tiles)
from tmap.bench.examples.example import Example

#: Pass to the maker of its examples.
MAKERS: dict[str, Callable[..., Example]] = {f"glide_{name}": make for name, make in {
    "walk": sample.walk, "walk_small": partial(sample.walk, levels=(3, 9)),
    "walk_clamp": sample.walk_clamp, "walk_inside": sample.walk_inside, "point": sample.point,
    "bilinear": sample.bilinear, "bilinear_8": partial(sample.bilinear, bits=8),
    "quads_8": partial(sample.quads, to_bytes=sample.quad_8_bytes),
    "bilinear_times": combine.times, "bilinear_times_565": combine.times_565,
    "products": combine.products, "bilinear_565": sample.bilinear_565, "store_565": sample.store_565,
    "widen_565": sample.widen_565, "divide": depth.divide, "divide_clamp": depth.divide_clamp,
    "divide_each": depth.divide_each, "pieces": depth.pieces,
    "pieces_16": partial(depth.priced, bits=4),
    "pieces_clamp": partial(depth.priced, bits=3, last=255 * 16),
    "pieces_small": partial(depth.priced, bits=3, shift=17), "lod": depth.lod,
    "logarithms": depth.logarithms, "details": depth.details,
    "flips": depth.flips, "point_mips": mips.point, "bilinear_mips": mips.bilinear, "interleave": sample.interleave,
    **combine.MIXES, "alpha": combine.alpha, "combiner": combine.combiner,
    "combine_line": combine.combine_line,
    "quads": partial(sample.quads, to_bytes=sample.quad_bytes)}.items()} | tiles.MAKERS
#: Tables, and what chooses passes: C alone.
IN_C_ALONE = ("glide_quads", "glide_quads_8", "glide_logarithms", "glide_products", "glide_combine_line")
#: Other input of a pass, and the pass.
FORMS = {"glide_walk_small": "glide_walk", "glide_walk_inside": "glide_walk_clamp",
         "glide_divide_clamp": "glide_divide", "glide_divide_each": "glide_divide",
         "glide_pieces_16": "glide_pieces", "glide_pieces_clamp": "glide_pieces",
         "glide_pieces_small": "glide_pieces"} | tiles.FORMS
