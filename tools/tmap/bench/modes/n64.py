"""Modes and formats of the N64's texture engine that are priced (tmap.bench.modes.modes)."""

from dataclasses import dataclass
from pathlib import Path

from tmap.base.fixed import fix
from tmap.bench.modes import modes
from tmap.bench.modes.modes import OTHER, PICTURE
from tmap.compiler import n64, n64_build

SHADES = (60.5, 140.2, 250.7, 120.1)


@dataclass(frozen=True)
class Mode(modes.Mode):
    """A material with a table ``n64``."""

    SCHEMA, TABLE, MAPPER, PLAIN, PLAIN_SHIFT = n64, "n64", "n64", "n64_plain,n64_passes", 0

    @property
    def vertices(self) -> list[tuple[int, ...]]:
        """x, y, s, t, shade, w; 16.16."""
        points, texels, depths = self.POLYGONS[self.polygon]
        return [tuple(map(fix, (*point, *st, shade, w)))
                for point, st, shade, w in zip(points, texels, SHADES, depths)]

    def tables(self, spec: dict, folder: Path, frames: int, where: str) -> dict:
        """An engine's display lists and DRAM."""
        return n64_build.build(spec, folder, frames, where)[1]


def tile(form: str = "rgba16", **more) -> dict:
    """A tile of SIDE x SIDE texels."""
    return {"image": PICTURE, "format": form, **more}


def of(*tiles: dict, **more) -> dict:
    """A material of tiles, or of a plain one."""
    return {"tiles": list(tiles or (tile(),)), **more}


FILTERED = {"filter": "bilerp"}
DEEP = {"perspective": True}
LEVELS = {"cycles": 2, "lod": True, "combine": "trilinear", **FILTERED, **DEEP}
MIPMAP = tile(levels=6)
CLAMPED = {"s": {"wrap": "clamp"}, "t": {"wrap": "clamp"}}
YUV = tile("yuv16", **CLAMPED)
FOLDED = tile(s={"wrap": "mirror and clamp", "mask": 5, "high": 63},
              t={"wrap": "mirror", "mask": 4, "low": 4.5, "high": 19})
#: Texel 0 towards the environment colour by texel 1.
TINTED = {"rgb": [["texel0", "environment", "texel1", "environment"], ["0", "0", "0", "combined"]],
          "alpha": [["texel0", "environment", "texel1", "environment"], ["0", "0", "0", "combined"]]}
THREE = "three-point"

MODES = (
    Mode("copy", "point, upright, a texel a pixel", of(), "upright"),
    Mode("point", "point", of()),
    Mode("point_shift", "point, of a shifted tile", of(tile(s={"shift": 1}, t={"shift": 15}))),
    Mode("point_perspective", "point, perspective", of(**DEEP), "deep"),
    Mode("threepoint", "three-point", of(**FILTERED), filter=THREE),
    Mode("threepoint_perspective", "three-point, perspective", of(**FILTERED, **DEEP), "deep",
         THREE),
    Mode("average", "average of four", of(filter="average"), "between", "bilinear"),
    Mode("wrap", "three-point, mirrored, clamped, masked", of(FOLDED, **FILTERED), "outside",
         THREE),
    Mode("trilinear", "trilinear: level of detail, perspective", of(MIPMAP, **LEVELS), "far",
         THREE),
    Mode("trilinear_shade", "the same, times shade", of(MIPMAP, **LEVELS | {
        "combine": ["trilinear", "modulate again"]}), "far", THREE),
    Mode("sharpen", "trilinear, sharpened", of(MIPMAP, **LEVELS, detail="sharpen"), "near", THREE),
    Mode("detail", "trilinear with a detail tile", of(
        tile(image=OTHER, width=16, height=16, s={"shift": 14}, t={"shift": 14}), MIPMAP,
        **LEVELS, detail="detail", min_level=8), "near", THREE),
    Mode("modulate_shade", "three-point, times shade", of(**FILTERED, combine="modulate"),
         filter=THREE),
    Mode("modulate_primitive", "three-point, times a constant", of(
        **FILTERED, combine="modulate primitive", primitive="#e0a060"), filter=THREE),
    Mode("blend", "two tiles, blended by a constant", of(
        tile(), tile(image=OTHER), **FILTERED, cycles=2, combine="mix",
        primitive_lod_fraction=96), filter=THREE),
    Mode("general", "two tiles multiplied", of(
        tile(), tile(image=OTHER), **FILTERED, cycles=2, combine="interference"), filter=THREE),
    Mode("intensity_primitive", "three-point, of intensities, times a constant", of(
        tile("i8"), **FILTERED, combine="modulate primitive", primitive="#e0a060"), filter=THREE),
    Mode("intensity_product", "two tiles of intensities multiplied, colours between two of the product", of(
        tile("i8"), tile("i8", image=OTHER), **FILTERED, cycles=2, combine=["interference", "blend again"],
        primitive="#e8f4ff", environment="#0a3c78"), filter=THREE),
    Mode("any", "two tiles, any other combination", of(
        tile(), tile(image=OTHER), **FILTERED, cycles=2, combine=TINTED,
        environment="#406080"), filter=THREE),
    Mode("yuv_point", "YUV: point, converted", of(YUV, convert="convert", combine="convert"),
         "inside"),
    Mode("yuv_filter", "YUV: three-point, then converted", of(
        YUV, YUV, **FILTERED, cycles=2, convert="filter, convert", combine=["pass", "convert"]),
         "inside", THREE),
    Mode("copy_16", "frame of 16 bits: point, upright, a texel a pixel", of(), "upright",
         pixels="rgba5551"),
    Mode("point_16", "frame of 16 bits: point", of(), pixels="rgba5551"),
    Mode("threepoint_16", "frame of 16 bits: three-point", of(**FILTERED), filter=THREE,
         pixels="rgba5551"),
    Mode("trilinear_16", "frame of 16 bits: trilinear", of(MIPMAP, **LEVELS), "far", THREE,
         "rgba5551"),
)

#: Texel format to its modes: point sampled and three-point filtered.
FORMATS = {"rgba16": ("point", "threepoint")} | {
    form: (f"point_{form}", f"threepoint_{form}")
    for form in ("rgba32", "ci4", "ci8", "ia4", "ia8", "ia16", "i4", "i8")} | {
    "yuv16": ("yuv_point", "yuv_filter")}

OF_FORMATS = tuple(
    Mode(name, f"{form}, {how}", of(tile(form), **more), filter=how)
    for form, names in FORMATS.items() if form not in ("rgba16", "yuv16")
    for name, how, more in zip(names, ("point", THREE), ({}, FILTERED)))

EVERY = {mode.name: mode for mode in (*MODES, *OF_FORMATS)}
