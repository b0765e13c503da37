"""Random input of the passes for Glide's texture unit, and what must come out of each.

The expected output is worked out pixel by pixel from the unit's rules, in whatever way is
plainest: neither the C nor the assembly is asked. The bench measures one example of each pass,
the tests call many.
"""

from collections.abc import Callable

from tmap.bench.examples import (glide_combine as combine, glide_depth as depth,
                                 glide_sample as sample, glide_tiles as tiles)
from tmap.bench.examples.example import Example

#: Pass to the maker of its examples.
MAKERS: dict[str, Callable[..., Example]] = {
    "glide_walk": sample.walk, "glide_walk_small": sample.walk_small,
    "glide_walk_clamp": sample.walk_clamp, "glide_walk_inside": sample.walk_inside,
    "glide_point": sample.point, "glide_bilinear": sample.bilinear,
    "glide_bilinear_8": sample.bilinear_8, "glide_quads_8": sample.quads_8,
    "glide_bilinear_565": sample.bilinear_565, "glide_store_565": sample.store_565,
    "glide_widen_565": sample.widen_565,
    "glide_divide": depth.divide, "glide_divide_clamp": depth.divide_clamp,
    "glide_divide_each": depth.divide_each,
    "glide_pieces": depth.pieces_8, "glide_pieces_16": depth.pieces_16,
    "glide_pieces_clamp": depth.pieces_clamp, "glide_pieces_small": depth.pieces_small,
    "glide_lod": depth.lod, "glide_logarithms": depth.logarithm_table,
    "glide_details": depth.details, "glide_interleave": sample.interleave,
    "glide_lerp": combine.lerp, "glide_scale": combine.scale, "glide_modulate": combine.modulate,
    "glide_modulate_rgb": combine.modulate_rgb, "glide_add": combine.add, "glide_alpha": combine.alpha,
    "glide_combiner": combine.combine, "glide_combine_line": combine.combine_line,
    "glide_quads": sample.quads,
} | tiles.MAKERS
#: Tables, and what chooses passes: C alone.
IN_C_ALONE = ("glide_quads", "glide_quads_8", "glide_logarithms", "glide_combine_line")
#: Other input of a pass, and the pass.
FORMS = {"glide_walk_small": "glide_walk", "glide_walk_inside": "glide_walk_clamp",
         "glide_divide_clamp": "glide_divide", "glide_divide_each": "glide_divide",
         "glide_pieces_16": "glide_pieces", "glide_pieces_clamp": "glide_pieces",
         "glide_pieces_small": "glide_pieces"} | tiles.FORMS
