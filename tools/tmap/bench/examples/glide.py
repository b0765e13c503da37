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
    "tmu_walk": sample.walk, "tmu_walk_small": sample.walk_small,
    "tmu_walk_clamp": sample.walk_clamp, "tmu_walk_inside": sample.walk_inside,
    "tmu_point": sample.point, "tmu_bilinear": sample.bilinear,
    "tmu_bilinear_8": sample.bilinear_8, "tmu_quads_8": sample.quads_8,
    "tmu_bilinear_565": sample.bilinear_565, "tmu_store_565": sample.store_565,
    "tmu_widen_565": sample.widen_565,
    "tmu_divide": depth.divide, "tmu_divide_clamp": depth.divide_clamp,
    "tmu_divide_each": depth.divide_each,
    "tmu_pieces": depth.pieces_8, "tmu_pieces_16": depth.pieces_16,
    "tmu_pieces_clamp": depth.pieces_clamp, "tmu_pieces_small": depth.pieces_small,
    "tmu_lod": depth.lod, "tmu_logarithms": depth.logarithm_table,
    "tmu_details": depth.details, "tmu_interleave": sample.interleave,
    "tmu_lerp": combine.lerp, "tmu_scale": combine.scale, "tmu_modulate": combine.modulate,
    "tmu_modulate_rgb": combine.modulate_rgb, "tmu_add": combine.add, "tmu_alpha": combine.alpha,
    "tmu_combiner": combine.combine, "tmu_combine_line": combine.combine_line,
    "tmu_quads": sample.quads,
} | tiles.MAKERS
#: Tables, and what chooses passes: C alone.
IN_C_ALONE = ("tmu_quads", "tmu_quads_8", "tmu_logarithms", "tmu_combine_line")
#: Other input of a pass: beside it there is no C.
FORMS = {"tmu_walk_small": "tmu_walk", "tmu_walk_inside": "tmu_walk_clamp",
         "tmu_divide_clamp": "tmu_divide", "tmu_divide_each": "tmu_divide",
         "tmu_pieces_16": "tmu_pieces", "tmu_pieces_clamp": "tmu_pieces",
         "tmu_pieces_small": "tmu_pieces"} | tiles.FORMS
