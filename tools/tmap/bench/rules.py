"""What each rule of lowering saves: a polygon it applies to, drawn with it and without it.

The rules are lines of c/drawing/lower.c and, in c/drawing/parts, vertices.c and steps.c; those of tolerances
change the picture and have no row.
"""

from dataclasses import dataclass
from functools import cache

import numpy as np

from tmap.base.pixel_formats import FORMATS
from tmap.corpus import random_maps
from tmap.guest import guest_frames
from tmap.guest.conditions import CONDITIONS
from tmap.guest.emulator import CYCLES_PER_TICK
from tmap.model import model
from tmap.scene_file.scene_file import IDENTITY, ONE, Material, Object, Scene, Texture

WIDTH, HEIGHT = 160, 128
COPIES = 8  # of a polygon: two ticks of doubt are then 5 cycles, of the cheapest 0.4 %
ROW = "rule_"
WITHOUT = "_off"  # ends the name of a row without its rule
#: Rules that change the picture, as far as the material's tolerance goes.
INEXACT = ("tolerance", "coarser")

AFFINE = Material("affine", texture=0)
LIT = Material("lit", texture=0, light=1)
LIT_GOURAUD = Material("lit_gouraud", texture=0, light=1)
GOURAUD = Material("gouraud")
FLAT = Material("flat", colour=77)
DEEP = Material("affine", perspective="pixel", texture=0)
ARBITRARY = Material("arbitrary", texture=2)
DITHERED = Material("dithered", texture=0)
KEYED = Material("keyed", texture=0)

#: Triangles inside the frame: of many pixels, and high ones of at most 8 and 16 pixels a line.
WIDE = [(20.3, 10.6), (140.7, 50.2), (60.1, 120.4)]
NARROW = [(20.3, 10.6), (32.2, 60.2), (22.1, 120.4)]
TURNED = ([10, 120, 60], [15, 70, 130])  # s and t that need both steps; v does not wrap
WRAPPED = ([10, 320, 60], [15, 3970, 130])  # v wraps more than once in a line


@dataclass(frozen=True)
class Case:
    """A polygon to which a rule applies."""

    rule: str
    material: Material
    points: list[tuple[float, float]]
    texels: tuple[list[float], list[float]]  # s and t
    lowered: str | None  # the span that draws it; None: nothing is drawn
    asked: str | None  # without the rule
    shades: tuple[float, ...] = (100, 100, 100)
    depths: tuple[float, ...] = (1, 1, 1)
    pixels: str = "chunky"  # of FORMATS

    @property
    def name(self) -> str:
        """The rule, and in a frame of wider pixels their bits."""
        bits = 8 * FORMATS[self.pixels].bytes
        return self.rule if bits == 8 else f"{self.rule}_{bits}"

    @property
    def group(self) -> tuple[str, str]:
        """What cases of one scene share."""
        return self.pixels, self.material.perspective

    @property
    def vertices(self) -> list[tuple[int, ...]]:
        """x, y, s, t, shade, w; 16.16."""
        rows = zip(self.points, *self.texels, self.shades, self.depths)
        return [tuple(round(c * ONE) for c in (*point, *rest)) for point, *rest in rows]


def heights(points) -> list[float]:
    """A coordinate of the map that stands still along lines."""
    return [y for _, y in points]


CASES = (
    Case("outside", FLAT, [(200, 10), (260, 40), (180, 90)], TURNED, None, None),
    Case("equal_shades", GOURAUD, WIDE, TURNED, "fill", "gouraud", (200.1, 200.9, 200.4)),
    Case("equal_levels", LIT_GOURAUD, WIDE, TURNED, "lit", "lit_gouraud", (120.1, 121.9, 123.5)),
    Case("no_light", LIT, WIDE, TURNED, "fill", "lit", (3.9, 100, 200)),
    Case("full_light", LIT, WIDE, TURNED, "affine_addx", "lit", (252, 0, 0)),
    Case("constant_w", DEEP, WIDE, TURNED, "affine_addx", "affine_scanline", depths=(3.7,) * 3),
    Case("inside_frame", AFFINE, WIDE, TURNED, "affine_addx", "affine_addx"),
    Case("inside_range", ARBITRARY, WIDE, ([10, 150, 70], [15, 60, 100]), "arbitrary",
         "arbitrary"),
    Case("still_v", AFFINE, WIDE, (TURNED[0], heights(WIDE)), "affine_row", "affine_addx"),
    Case("unit_step", AFFINE, WIDE, ([x + 7 for x, _ in WIDE], heights(WIDE)), "affine_copy",
         "affine_row"),
    Case("still_u", AFFINE, WIDE, (heights(WIDE), TURNED[1]), "affine_column", "affine_addx"),
    Case("no_wrap", AFFINE, WIDE, TURNED, "affine_addx", "affine_addx_wrap"),
    Case("no_wrap_lit", LIT, WIDE, TURNED, "lit", "lit_wrap"),
    Case("no_wrap_dithered", DITHERED, WIDE, TURNED, "dithered", "dithered_wrap"),
    Case("still_v_keyed", KEYED, WIDE, (TURNED[0], heights(WIDE)), "keyed_rows", "keyed"),
    Case("opaque_rows", KEYED, WIDE, (TURNED[0], heights(WIDE)), "keyed_rows", "keyed_row"),
    Case("no_wrap_keyed", KEYED, WIDE, TURNED, "keyed", "keyed_wrap"),
    Case("short", AFFINE, NARROW, TURNED, "affine_short", "affine_addx"),
    Case("short_wrap", AFFINE, NARROW, WRAPPED, "affine_short_wrap", "affine_addx_wrap"),
    Case("short_row", AFFINE, NARROW, (TURNED[0], heights(NARROW)), "affine_row_short",
         "affine_row"),
    Case("short_gouraud", GOURAUD, NARROW, TURNED, "gouraud_short", "gouraud", (10, 100, 200)),
    Case("short_lit", LIT, NARROW, TURNED, "lit_short", "lit"),
    Case("short_lit_wrap", LIT, NARROW, WRAPPED, "lit_short_wrap", "lit_wrap"),
    *(Case("still_v", AFFINE, WIDE, (TURNED[0], heights(WIDE)), f"affine_{bits}_row",
           f"affine_{bits}", pixels=pixels)
      for bits, pixels in ((16, "rgba5551"), (32, "rgba8888"))),
    Case("unit_step", AFFINE, WIDE, ([x + 7 for x, _ in WIDE], heights(WIDE)), "affine_16_copy",
         "affine_16_row", pixels="rgba5551"),
    *(Case("no_wrap", AFFINE, WIDE, TURNED, f"affine_{bits}", f"affine_{bits}_wrap", pixels=pixels)
      for bits, pixels in ((16, "rgba5551"), (32, "rgba8888"))),
    *(Case("no_wrap_dithered", DITHERED, WIDE, TURNED, f"dithered_{bits}", f"dithered_{bits}_wrap",
           pixels=pixels) for bits, pixels in ((16, "rgba5551"), (32, "rgba8888"))),
)
#: Cases that share a scene: of one format, and those with perspective apart, as the tables that it
#: needs would be made for all the others too.
GROUPS = [[case for case in CASES if case.group == group]
          for group in dict.fromkeys(case.group for case in CASES)]


@cache
def textures(pixels: str) -> list[Texture]:
    """A page; in chunky frames 64 levels of light too, of which the first makes all texels one and
    the last shows them as they are, and a map of any size."""
    rng = np.random.default_rng(3)
    if pixels != "chunky":
        pixel = FORMATS[pixels]
        return [Texture(rng.integers(1, 256**pixel.bytes, (256, 256), dtype=pixel.dtype))]
    page, light = (rng.integers(1, 256, (h, 256), dtype=np.uint8) for h in (256, 64))
    light[0], light[63] = 9, np.arange(256)
    return [Texture(page), Texture(light, "light"), Texture(page[:70, :90].copy(), "linear")]


def scene_of(cases, copies: int = 1, counted: Case | None = None) -> Scene:
    """An empty frame, then one for each case of a format, drawn so many times in the same place;
    where one is ``counted``, the others are drawn once."""
    pixels = cases[0].pixels
    materials = list(dict.fromkeys(case.material for case in cases))
    vertices = [vertex for case in cases for vertex in case.vertices]
    objects = [Object(materials.index(case.material), 3 * k, 3, 0, 1, k + 1)
               for k, case in enumerate(cases)
               for _ in range(copies if counted in (None, case) else 1)]
    return Scene(WIDTH, HEIGHT, len(cases) + 1, 7, random_maps.palette(), textures(pixels), materials,
                 objects, np.array(vertices), np.array([IDENTITY]), pixels)


@cache
def shown(group: int) -> list[np.ndarray]:
    """The model's pictures of the scene of a group's cases; copies change nothing."""
    scene = scene_of(GROUPS[group])
    return [model.render(scene, number) for number in range(scene.frames)]


def runs_of(names: list[str]) -> list[tuple[int, Case | None, Scene]]:
    """What is drawn: of each group all, then cases without their rules: number, case, scene."""
    runs = []
    for number, group in enumerate(GROUPS):
        cases = [case for case in group if case.name in names]
        runs += [(number, case, scene_of(group, COPIES, case)) for case in (None, *cases) if cases]
    return runs


def row_of(name: str, machine: str, digests: np.ndarray, frame: int) -> dict:
    """A row: what a frame takes more than the empty first one, by its polygon."""
    ticks = digests["ticks"].astype(int).tolist()
    return {"name": name, "machine": machine, "length": 1,
            "cycles_per_polygon": (ticks[frame] - ticks[0]) * CYCLES_PER_TICK / COPIES,
            "one_tick": CYCLES_PER_TICK / COPIES}


def measure(machine: str, names: list[str]) -> list[dict]:
    """Two rows for each case, with its rule and without, all in one boot; ``names``: of cases."""
    runs = runs_of(names)
    if not runs:
        return []
    condition = CONDITIONS[machine]
    off = [f" OFF {case.rule}" if case else "" for _, case, _ in runs]
    scenes = [(scene, f"addx{condition.options}{end}") for end, (_, _, scene) in zip(off, runs)]
    drawn = guest_frames.draw(scenes, condition.machine)
    rows, lowered = [], {}  # the latter: digests by group
    for end, (number, case, _), scene, digests in zip(off, runs, scenes, drawn):
        group = GROUPS[number]
        guest_frames.require_models(shown(number), digests, f"bench: rules{end}, {machine}",
                                    (*scene, condition.machine), ["empty", *(case.name for case in group)])
        if case is None:
            lowered[number] = digests
            continue
        frame, name = group.index(case) + 1, f"{ROW}{case.name}"
        rows += [row_of(name, machine, lowered[number], frame),
                 row_of(name + WITHOUT, machine, digests, frame)]
    return rows
