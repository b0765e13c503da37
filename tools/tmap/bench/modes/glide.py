"""Modes and formats of Glide's texture unit that are priced (tmap.bench.modes.modes)."""

from dataclasses import dataclass
from pathlib import Path

from tmap.bench.modes import modes
from tmap.compiler import glide, glide_build
from tmap.base.elementary import cos, power, sin
from tmap.base.fixed import fix
from tmap.bench.modes.modes import FINE, LEVEL, OTHER, PICTURE, SHEER, SIDE, TRIANGLE
from tmap.glide.state import SIDE as UNITS  # s and t along a map's longer side
from tmap.glide.words import FORMATS as TEXELS

TEXEL = UNITS // SIDE  # in s and t
TURN = 0.5  # radians


def turned(texels: float) -> tuple:
    """A triangle of a map that is turned and so many texels a pixel large."""
    c, s = texels * cos(TURN), texels * sin(TURN)
    return TRIANGLE, tuple((x * c - y * s, x * s + y * c) for x, y in TRIANGLE), LEVEL


#: Besides those of every engine, or instead: maps magnified 2 and 8 times, or between two levels; all
#: as deep; three levels of a map of SIDE, from the first on; near enough for all of a detail's
#: factor, and too far for any.
MORE = {
    "double": turned(1 / 2), "eightfold": turned(1 / 8), "between_levels": turned(power(2, 1.4)),
    "level": (*modes.POLYGONS["turned"][:2], (2.5, 2.5, 2.5)),
    "far": (TRIANGLE, ((3.2, 4.1), (355, 60), (36, 296)), (1, 6.2, 8.1)),
    "close": (TRIANGLE, ((3.2, 4.1), (8.9, 5.2), (4.3, 9.3)), (1, 2.2, 3.1)),
    "small": (tuple((x / 16, y / 16) for x, y in TRIANGLE), *modes.POLYGONS["deep"][1:]),
    "away": (TRIANGLE, ((3.2, 4.1), (504, 106.3), (86.4, 420.7)), (1, 2.2, 3.1)),
}
#: s, t and depth of the second unit's corners, of polygons that it projects a map on.
PROJECTED = (((4.5, 6.1), (27.3, 9.2), (11.7, 26.8)), (1.5, 2.6, 1.2))


@dataclass(frozen=True)
class Mode(modes.Mode):
    """A material with a table ``glide``."""

    POLYGONS = modes.POLYGONS | MORE
    SCHEMA, TABLE, MAPPER = glide, "glide", "glide"
    PLAIN, PLAIN_SHIFT = "glide_plain,glide_passes", 2

    @property
    def vertices(self) -> list[tuple[int, ...]]:
        """x, y, s, t, 0, w of the corners, 16.16; and of the second unit's."""
        points, texels, depths = self.POLYGONS[self.polygon]
        found = [(texels, depths)]
        if self.table["units"][-1].get("own"):
            found.append(PROJECTED)
        return [tuple(map(fix, (*point, s * TEXEL, t * TEXEL, 0, w))) for texels, depths in found
                for point, (s, t), w in zip(points, texels, depths)]

    def tables(self, spec: dict, folder: Path, frames: int, where: str) -> dict:
        """The units' registers and memory."""
        return glide_build.build(spec, folder, where)[1]


def unit(form: str = "rgb565", **more) -> dict:
    """A unit with one level of SIDE x SIDE texels, which it shows as they are."""
    return {"image": PICTURE, "format": form, "mipmap": "none", **more}


def of(*units: dict, **more) -> dict:
    """A material of units, or of a plain one."""
    return {"units": list(units or (unit(),)), **more}


def by(function: str, factor: str = "zero", **more) -> dict:
    """How a unit combines."""
    return {"combine": {"function": function, "factor": factor}, **more}


SMOOTH = {"min": "bilinear", "mag": "bilinear"}
DEEP = {"perspective": True}
CLAMPED = {"s": "clamp", "t": "clamp"}
LEVELS = {"mipmap": "box"}
BILINEAR = unit(**SMOOTH)
LIGHT = unit(**SMOOTH | {"image": OTHER})
SPLIT = (unit(**SMOOTH, **LEVELS, **by("blend", "lod_fraction"), levels="even", trilinear=True),
         unit(**SMOOTH, **LEVELS, levels="odd", trilinear=True))
#: All of it at level 1, the first of a map of 128 texels, none from level 3 on.
DETAIL = unit(**SMOOTH | LEVELS | by("blend", "one_minus_detail") | {
    "image": FINE, "detail": {"bias": 3, "scale": 7, "max": 1.0}})
MODULATE, ADD = by("scale_other", "local"), by("scale_other_add_local", "one")

MODES = (
    Mode("glide_copy", "point, upright, a texel a pixel", of(), "upright"),
    Mode("glide_point", "point", of()),
    Mode("glide_point_clamp", "point, clamped", of(unit(**CLAMPED)), "outside"),
    Mode("glide_point_inside", "point, clamped, inside its map", of(unit(**CLAMPED)), "inside"),
    Mode("glide_bilinear", "bilinear", of(BILINEAR), filter="bilinear"),
    Mode("glide_bilinear_clamp", "bilinear, clamped", of(BILINEAR | CLAMPED), "outside", "bilinear"),
    Mode("glide_bilinear_8", "bilinear, weights of 8 bits (Voodoo 2)", of(BILINEAR | {"weights": 8}),
         filter="bilinear"),
    Mode("glide_double", "bilinear, texels of 2 pixels", of(BILINEAR), "double", "bilinear"),
    Mode("glide_eightfold", "bilinear, texels of 8 pixels", of(BILINEAR), "eightfold", "bilinear"),
    *(Mode(f"glide_dithered{end}", f"bilinear by dithered points{title}",
           of(BILINEAR | {"bilinear": "dithered"}), polygon, "bilinear", in_c=False)
      for end, title, polygon in (("", "", "turned"),
                                  ("_eightfold", ", texels of 8 pixels", "eightfold"))),
    Mode("glide_point_perspective", "point, perspective", of(**DEEP), "deep"),
    Mode("glide_bilinear_perspective", "bilinear, perspective", of(BILINEAR, **DEEP), "deep",
         "bilinear"),
    *(Mode(f"glide_bilinear_every_{pixels}", f"the same, divided each {pixels} pixels",
           of(BILINEAR | {"subdivision": pixels}, **DEEP), "deep", "bilinear")
      for pixels in (16, 8)),
    Mode("glide_away", "the same, minified", of(BILINEAR, **DEEP), "away", "bilinear"),
    Mode("glide_level_point", "point, perspective, all as deep", of(**DEEP), "level"),
    Mode("glide_level_bilinear", "bilinear, perspective, all as deep", of(BILINEAR, **DEEP), "level",
         "bilinear"),
    Mode("glide_mip_point", "mip-mapped, perspective: point", of(unit(**LEVELS), **DEEP), "far"),
    Mode("glide_mip_point_dither", "the same, dithered", of(unit(**LEVELS, dither=True), **DEEP),
         "far"),
    Mode("glide_mip_bilinear", "mip-mapped, perspective: bilinear", of(BILINEAR | LEVELS, **DEEP),
         "far", "bilinear"),
    Mode("glide_mip_bilinear_dither", "the same, dithered, meant trilinear",
         of(BILINEAR | LEVELS | {"dither": True}, **DEEP), "far", "trilinear"),
    Mode("glide_mip_level", "mip-mapped, one level of detail: bilinear", of(BILINEAR | LEVELS),
         "between_levels", "bilinear"),
    Mode("glide_trilinear", "trilinear by two units, perspective", of(*SPLIT, **DEEP), "far",
         "trilinear"),
    Mode("glide_trilinear_level", "trilinear, one level of detail", of(*SPLIT), "between_levels",
         "trilinear"),
    Mode("glide_trilinear_double", "trilinear, texels of 2 pixels", of(*SPLIT), "double",
         "trilinear"),
    Mode("glide_detail_near", "detail texture, perspective: near, all of it",
         of(DETAIL, BILINEAR, **DEEP), "close", "bilinear"),
    Mode("glide_detail", "the same: fading", of(DETAIL, BILINEAR, **DEEP), "near", "bilinear"),
    Mode("glide_detail_away", "the same: far, none of it", of(DETAIL, BILINEAR, **DEEP), "away",
         "bilinear"),
    Mode("glide_decal", "two units, of which the first counts", of(BILINEAR, LIGHT),
         filter="bilinear"),
    Mode("glide_modulate", "two units: multiplied", of(BILINEAR | MODULATE, LIGHT),
         filter="bilinear"),
    Mode("glide_add", "two units: added", of(BILINEAR | ADD, LIGHT), filter="bilinear"),
    Mode("glide_blend", "two units: blended by the second's alpha",
         of(BILINEAR | by("blend", "other_alpha"),
            unit("argb4444", **SMOOTH | {"image": SHEER})), filter="bilinear"),
    Mode("glide_modulate_perspective", "two units: multiplied, perspective",
         of(BILINEAR | MODULATE, LIGHT, **DEEP), "deep", "bilinear"),
    Mode("glide_projected", "the same, the second projected by its own w",
         of(BILINEAR | MODULATE, LIGHT | CLAMPED | {"own": True}, **DEEP), "deep", "bilinear"),
    *(Mode(f"{name}_565", f"frame of 16 bits: {title}", table, polygon, how, "rgb565")
      for name, title, table, polygon, how in (
          ("glide_point", "point", of(), "turned", "point"),
          ("glide_bilinear", "bilinear", of(BILINEAR), "turned", "bilinear"),
          ("glide_bilinear_perspective", "bilinear, perspective", of(BILINEAR, **DEEP), "deep",
           "bilinear"),
          ("glide_mip_bilinear", "mip-mapped, perspective: bilinear",
           of(BILINEAR | LEVELS, **DEEP), "far", "bilinear"),
          ("glide_trilinear", "trilinear by two units, perspective", of(*SPLIT, **DEEP), "far",
           "trilinear"),
          ("glide_modulate", "two units: multiplied", of(BILINEAR | MODULATE, LIGHT), "turned",
           "bilinear"))),
)

#: Texel format to its modes: point sampled and bilinear.
FORMATS = {form: ("glide_point", "glide_bilinear") if form == "rgb565" else
           (f"glide_point_{form}", f"glide_bilinear_{form}") for form in TEXELS}

SHOWN = {"a8": {"image": SHEER}}  # the others' pictures are opaque

OF_FORMATS = tuple(
    Mode(name, f"{form}, {how}", of(unit(form, **more) | SHOWN.get(form, {})), filter=how)
    for form, names in FORMATS.items() if form != "rgb565"
    for name, how, more in zip(names, ("point", "bilinear"), ({}, SMOOTH)))

EVERY = {mode.name: mode for mode in (*MODES, *OF_FORMATS)}

#: Polygons of 8 pixels: what is done once a polygon.
SMALL = {mode.name: mode for mode in (
    Mode("glide_point_small", "point", of(), "small", in_c=False),
    Mode("glide_bilinear_small", "bilinear", of(BILINEAR), "small", "bilinear", in_c=False),
    Mode("glide_bilinear_perspective_small", "bilinear, perspective", of(BILINEAR, **DEEP), "small",
         "bilinear", in_c=False))}
