"""The passes of modes' polygons: names of bench rows, whose cycles add up to what the polygon's pixels cost alone.

Modes that are not listed have no passes: the affine mapper or prefiltered tiles draw them. Where a mode's passes
differ from line to line, those of most are listed.
"""

DIVIDED, LEVELS = "glide_divide", ("n64_lod", "n64_threepoint_levels", "n64_threepoint_levels", "n64_lerp")
TWO_TILES = ("n64_walk", "n64_threepoint", "n64_threepoint")
MIPS = (DIVIDED, "glide_lod", "glide_bilinear_mips")

#: By the mode's name.
PASSES: dict[str, tuple[str, ...]] = {
    "point_shift": ("n64_walk", "n64_tile", "n64_point"),
    "point_perspective": ("n64_divide", "n64_point"),
    "threepoint": ("n64_walk", "n64_threepoint"),
    "threepoint_perspective": ("n64_divide", "n64_threepoint"),
    "average": ("n64_walk", "n64_average"),
    "wrap": ("n64_walk", "n64_tile", "n64_threepoint"),
    "trilinear": LEVELS,
    "trilinear_shade": (*LEVELS, "n64_shade", "n64_modulate"),
    "sharpen": LEVELS,
    "detail": LEVELS,
    "modulate_shade": ("n64_walk", "n64_threepoint", "n64_shade", "n64_modulate"),
    "modulate_primitive": ("n64_walk", "n64_threepoint", "n64_map"),
    "blend": (*TWO_TILES, "n64_lerp"),
    "general": (*TWO_TILES, "n64_modulate"),
    "intensity_primitive": ("n64_walk", "n64_threepoint_intensity", "n64_map_intensity"),
    "intensity_product": ("n64_walk", "n64_threepoint_intensity", "n64_threepoint_intensity", "n64_modulate_intensity"),
    "any": (*TWO_TILES, "n64_widen", "n64_widen", *("n64_combiner",) * 4, "n64_narrow"),
    "yuv_filter": ("n64_walk", "n64_tile_walked", "n64_threepoint_yuv"),
    "threepoint_16": ("n64_walk", "n64_threepoint_16"),
    "trilinear_16": (*LEVELS, "n64_store_16"),
    "glide_point_clamp": ("glide_walk_clamp", "glide_point"),
    "glide_bilinear": ("glide_walk_small", "glide_bilinear"),
    "glide_bilinear_clamp": ("glide_walk_clamp", "glide_bilinear"),
    "glide_bilinear_8": ("glide_walk_small", "glide_bilinear_8"),
    "glide_point_perspective": (DIVIDED, "glide_point"),
    "glide_bilinear_perspective": (DIVIDED, "glide_bilinear"),
    "glide_bilinear_every_16": ("glide_pieces_16", "glide_bilinear"),
    "glide_bilinear_every_8": ("glide_pieces", "glide_bilinear"),
    "glide_mip_point": (DIVIDED, "glide_lod", "glide_point_mips"),
    "glide_mip_point_dither": (DIVIDED, "glide_lod", "glide_point_mips"),
    "glide_mip_bilinear": MIPS,
    "glide_mip_bilinear_dither": MIPS,
    "glide_mip_level": ("glide_walk_small", "glide_bilinear"),
    "glide_trilinear": (*MIPS, "glide_bilinear_mips", "glide_lerp"),
    "glide_modulate": ("glide_walk_small", "glide_bilinear", "glide_bilinear_times"),
    "glide_modulate_perspective": (DIVIDED, "glide_bilinear", "glide_bilinear_times"),
    "glide_add": ("glide_walk_small", "glide_bilinear", "glide_bilinear", "glide_add"),
}


def cycles(figures: dict[tuple[str, str], float], name: str, machine: str) -> float | None:
    """Returns the cycles a pixel of a mode's passes together; None: it has none. ``figures``: of rows."""
    return sum(figures[row, machine] for row in PASSES[name]) if name in PASSES else None
