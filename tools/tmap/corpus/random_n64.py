"""Random polygons and rectangles of the N64's texture engine: modes, tiles and vertices, each in one
frame of a scene."""

import random
from dataclasses import dataclass, field

import numpy as np

from tmap.base.pixel_formats import FORMATS
from tmap.corpus import written
from tmap.corpus.random_polygons import vertex_lines
from tmap.model.model import FAR
from tmap.n64.opcodes import SET_COMBINE
from tmap.n64.state import CI, LEGAL, RGBA, TMEM_WORDS, YUV, Axis, Tile
from tmap.n64.words import CONVERTS, DETAILS, FILTERS, List, Wrap
from tmap.scene_file.scene_file import IDENTITY, Material, Object, Scene
from tmap.scene_file.units import RECTANGLES, rectangle_ends

PIXELS = ("rgba5551", "rgba8888")
MOST = 100  # polygons in a scene: engines keep decoded fills, which take memory
WIDTH, HEIGHT = 48, 32
ONE = 65536
HALF = TMEM_WORDS // 2
REACH = 1024 * ONE
W_MAX = 1 << 30
DRAM_BYTES = 4096 + 512  # all of TMEM, and a TLUT
KINDS = ("any",) * 8 + ("plain",) * 3 + ("levels",) * 3 + ("flat",)
#: Kinds of primitives: those of units.PRIMITIVES, or rectangles in copy mode.
SHAPES = (("polygons",) * 9 + ("coloured",) * 3 + ("rectangles",) * 2 + ("flipped",) * 2
          + ("copies",) * 4)
STEPS = (1024, 1024, 1024, 512, 2048, -1024, 0, 1023, 1025)  # of rectangles, s5.10
#: Valid codes of the colour inputs A, B, C, D, and of alpha's.
RGB_CODES = ([0, 1, 1, 2, 2, 3, 4, 5, 6, 15], [0, 1, 1, 2, 3, 4, 5, 7, 15],
             [0, 1, 2, 3, 4, 5, 7, 8, 9, 10, 11, 12, 13, 13, 14, 15, 31], [0, 1, 2, 3, 4, 5, 6, 7])
ALPHA_CODES = (list(range(8)),) * 4
#: Codes of inputs that are the same for all pixels.
CONSTANT_CODES = ([3, 5, 6, 15], [3, 5, 7, 15], [3, 5, 10, 12, 14, 15, 31], [3, 5, 6, 7])
CONSTANT_ALPHA_CODES = ([3, 5, 6, 7], [3, 5, 6, 7], [3, 5, 6, 7], [3, 5, 6, 7])
PASS = (15, 15, 31)  # (0 - 0) * 0, to which D is added
BLEND = [[2, 1, 13, 1], [2, 1, 0, 1]]  # of texels 0 and 1 by the level's fraction
PRODUCT = [[1, 15, 2, 7], [1, 7, 2, 7]]  # of texels 0 and 1
#: Second cycles: the first one's result, times shade, between two colours.
AFTER = ([[*PASS, 0], [7, 7, 7, 0]],) * 2 + ([[0, 15, 4, 7], [0, 7, 4, 7]], [[3, 5, 0, 5], [7, 7, 7, 6]])


@dataclass
class Case:
    """One polygon or rectangle and the engine that draws it; ``vertices``: (x, y, s, t, shade, w),
    as in a scene."""

    words: list[tuple[int, int]]
    vertices: list[tuple]
    edges: str
    clip: str
    tiles: list[Tile]
    primitive: str = "polygons"
    modes: dict = field(default_factory=dict)


def shown(axis: Axis) -> int:
    """The number of columns or rows that an axis can show."""
    inside = (axis.high >> 2) - (axis.low >> 2) + 1
    if not axis.mask:
        return inside
    return min(inside, 1 << axis.mask) if axis.clamp else 1 << axis.mask


def fits(tile: Tile, low_only: bool) -> bool:
    """Returns whether all that a tile can show is inside TMEM."""
    columns, rows = shown(tile.s), shown(tile.t)
    if min(columns, rows) < 1 or columns > 1024 or rows > 256:
        return False
    if any((axis.clamp or not axis.mask) and axis.high >> 2 < axis.low >> 2
           for axis in (tile.s, tile.t)):
        return False
    per_word = 16 if tile.size == 0 else 8 if tile.size == 1 or tile.format == YUV else 4
    end = tile.tmem + (rows - 1) * tile.line - (-columns // per_word)
    split = tile.format == YUV or (tile.format, tile.size) == (RGBA, 3)
    return end <= (HALF if split or low_only else TMEM_WORDS)


def axis(rng: random.Random, plain: bool) -> Axis:
    """A random axis with any wrapping; ``plain``: without a shift."""
    low = rng.choice((0, 0, 4 * rng.randrange(64), rng.randrange(256)))
    high = low + rng.choice((0, 3, 28, 60, 124, rng.randrange(200)))
    return Axis(rng.randrange(2), rng.randrange(2), rng.choice((0, 1, 2, 3, 4, 5, 5, 6)),
                0 if plain else rng.choice((0, 0, 0, 0, 1, 2, 3, 5, 10, 11, 14, 15)), low, high)


def tile(rng: random.Random, tlut: bool, plain: bool, copies: bool) -> Tile:
    """A random tile that may be drawn, or copied."""
    pairs = sorted(pair for pair in LEGAL if (pair[0] == CI) == tlut
                   and (tlut or not copies or (pair[1] == 2 and pair[0] != YUV)))
    while True:
        form, size = rng.choice(pairs)
        made = Tile(form, size, rng.choice((0, 1, 2, 4, 8, rng.randrange(32))),
                    rng.choice((0, rng.randrange(TMEM_WORDS))), rng.randrange(16),
                    axis(rng, plain), axis(rng, plain))
        if fits(made, tlut):
            return made


def level_tiles(rng: random.Random, first: int, tlut: bool) -> list[Tile]:
    """Levels of a map, half as large from tile ``first`` on, which mostly wrap; of any texels."""
    sides = [rng.randrange(3, 6) for _ in "st"]
    pairs = sorted(pair for pair in LEGAL if (pair[0] == CI) == tlut and pair[0] != YUV)
    found = []
    for n in range(8):
        level = n - first & 7
        axes = []
        for side in sides:
            mask = max(side - level, 0)
            clamp, low = rng.choice(((0, 0),) * 30 + ((1, 0), (0, 4)))
            axes.append(Axis(clamp, rng.randrange(2), mask, level, low, low + ((1 << mask) - 1 << 2)))
        form, size = rng.choice(pairs)
        made = Tile(form, size, rng.choice((1, 2, 4)), 64 * rng.randrange(4), rng.randrange(16), *axes)
        found.append(made if fits(made, tlut) else Tile(form, 2 if form != CI else size, 1, 0, 0, *axes))
    return found


def cycle_codes(rng: random.Random, kind: str) -> list[list[int]]:
    """Inputs of colour and alpha of one cycle: all random, the texel alone or multiplied by a
    constant, or constants."""
    if kind == "texel":
        return [[*PASS, 1], [7, 7, 7, 1]]
    if kind == "plain":
        return [[1, 15, rng.choice((3, 4, 5, 14)), rng.choice((3, 7))], [1, 7, 3, 7]]
    tables = (CONSTANT_CODES, CONSTANT_ALPHA_CODES) if kind == "flat" else (RGB_CODES, ALPHA_CODES)
    return [[rng.choice(codes) for codes in table] for table in tables]


def combine_word(cycles: list[list[list[int]]]) -> tuple[int, int]:
    """Hi and lo of a set combine."""
    ((a0, b0, c0, d0), (p0, q0, r0, u0)), ((a1, b1, c1, d1), (p1, q1, r1, u1)) = cycles
    return (a0 << 20 | c0 << 15 | p0 << 12 | r0 << 9 | a1 << 5 | c1,
            b0 << 28 | b1 << 24 | p1 << 21 | r1 << 18 | d0 << 15 | q0 << 12 | u0 << 9
            | d1 << 6 | q1 << 3 | u1)


def without_shade(cycle: list[list[int]]) -> list[list[int]]:
    """A cycle's inputs with shade replaced by the environment colour."""
    (a, b, c, d), alpha = ([5 if code == 4 else code for code in codes] for codes in cycle)
    return [[a, b, 12 if c == 11 else c, d], alpha]


def modes(rng: random.Random, words: List, kind: str, shape: str) -> dict:
    """Sets random modes: any, or only those of the plain mappers, according to ``KINDS``."""
    colour = [rng.randrange(256) for _ in range(8)]
    chosen = {"cycles": rng.choice(("one", "two")), "perspective": rng.randrange(2),
              "detail": rng.choice(list(DETAILS)), "lod": rng.randrange(2),
              "filter": rng.choice(list(FILTERS)), "convert": rng.choice(list(CONVERTS)),
              "max level": rng.randrange(8), "tile": rng.randrange(8),
              "lowest level": rng.randrange(32), "fraction": rng.randrange(256)}
    if rng.randrange(3):
        chosen["convert"] = "filter"
    if kind == "plain":
        chosen |= {"cycles": "one", "perspective": 0, "lod": 0, "filter": "point"}
    if kind == "levels":
        chosen |= {"cycles": "two", "lod": 1, "convert": "filter",
                   "filter": rng.choice(("bilerp", "bilerp", chosen["filter"]))}
    is_rectangle = shape not in ("polygons", "coloured")
    if is_rectangle:
        chosen["perspective"] = 0
    if shape == "copies":
        chosen["cycles"] = "copy"
    words.cycle_type(chosen["cycles"])
    words.texture_perspective(bool(chosen["perspective"]))
    words.texture_detail(chosen["detail"])
    words.texture_lod(bool(chosen["lod"]))
    words.texture_filter(chosen["filter"])
    words.texture_convert(chosen["convert"])
    words.set_convert(*(rng.randrange(-256, 256) for _ in range(6)))
    words.prim_colour(chosen["lowest level"], chosen["fraction"], tuple(colour[:4]))
    words.env_colour(tuple(colour[4:]))
    words.texture(chosen["max level"], chosen["tile"])
    usual = (kind, kind) if kind == "flat" else (kind, kind, "texel")
    cycles = [cycle_codes(rng, rng.choice(usual)) for _ in range(2)]
    if kind == "levels":
        cycles = [rng.choice((BLEND, BLEND, PRODUCT)), rng.choice((*AFTER, cycles[1]))]
    if is_rectangle:
        cycles = [without_shade(cycle) for cycle in cycles]
    if chosen["cycles"] == "one":
        cycles[0] = cycles[1]
    words.add(SET_COMBINE, *combine_word(cycles))
    return chosen | {"combine": cycles}


def written_vertices(rng: random.Random, steady: bool) -> list[tuple]:
    """Corners as people write them, over part of the tile or all of it; ``steady``: with one w for
    all."""
    points = written.outline(rng, WIDTH, HEIGHT)
    texels = written.texels(rng, points, [rng.choice((8, 16, 32, 33, 64, 128)) for _ in "st"])
    texels = [tuple(min(max(c, -REACH // 2), REACH // 2 - 1) for c in st) for st in texels]
    ws = [1] * len(points) if steady else written.depths(rng, points)
    shade = rng.choice((0, 128, 255)) * ONE
    shades = [shade if rng.randrange(2) else rng.choice((0, 128, 255)) * ONE for _ in points]
    return [(*p, *st, shade, round(w * ONE)) for p, st, shade, w in zip(points, texels, shades, ws)]


def vertices(rng: random.Random, steady: bool) -> list[tuple]:
    """Corners round a centre, some beyond the frame, or corners as people write them; ``steady``:
    with one w for all."""
    if rng.random() < written.SHARE:
        return written_vertices(rng, steady)
    count = rng.choice((3, 3, 4, 4, 5, 7))
    x0, y0 = rng.uniform(0, WIDTH), rng.uniform(0, HEIGHT)
    size = rng.choice((rng.uniform(2, 12), rng.uniform(12, 40), rng.uniform(40, 300)))
    turn = rng.choice((0.125, 0.125, rng.random()))
    angles = sorted((turn + (k + rng.uniform(0, 0.6)) / count) % 1 for k in range(count))
    if count == 4 and rng.randrange(2):
        angles = [turn + k / 4 for k in range(4)]
    texels = rng.choice((rng.uniform(0, 8), rng.uniform(8, 80), rng.uniform(80, 300), 500))
    s0, t0 = (rng.choice((0, rng.uniform(-40, 40), rng.uniform(-500, 500))) for _ in range(2))
    deepest = rng.choice((1.5, 4, 40, 2000))
    base = rng.choice((1, 1, rng.uniform(0.1, 300)))
    same = rng.randrange(255 * ONE) if rng.randrange(3) == 0 else None
    out = []
    for angle in angles:
        c = np.exp(2j * np.pi * angle)
        x, y = x0 + size * c.real, y0 + size * c.imag
        flat = rng.randrange(3) == 0
        s = s0 + texels * (c.real if flat else rng.uniform(-1, 1))
        t = t0 + texels * (c.imag if flat else rng.uniform(-1, 1))
        w = base * (1 if steady else deepest ** rng.random())
        out.append((*(max(-FAR, min(round(v * ONE), FAR - 1)) for v in (x, y)),
                    *(max(-REACH, min(round(v * ONE), REACH - 1)) for v in (s, t)),
                    same if same is not None else rng.randrange(256 * ONE),
                    min(round(w * ONE), W_MAX)))
    if rng.randrange(4) == 0:
        out = [(x & -ONE, y & -ONE, s & -ONE, t & -ONE, *rest) for x, y, s, t, *rest in out]
    return out


def axis_steps(rng: random.Random, pixels: int, many: int, four: bool) -> tuple[int, int]:
    """Random start (s10.5) and step (s5.10) of a coordinate that stays in range over ``pixels``
    pixels, at ``many`` pixels a step; ``four``: mostly four texels a step."""
    while True:
        start = rng.choice((0, 32 * rng.randrange(-64, 64), rng.randrange(-1600, 1600),
                            rng.randrange(-1 << 15, 1 << 15)))
        step = rng.choice(STEPS + (rng.randrange(-4096, 4096), rng.randrange(-1 << 15, 1 << 15)))
        if four:
            step = rng.choice((4096,) * 9 + (4 * step, 4 * step))
        (*_, first, _), (*_, last, _) = rectangle_ends((0, 0, pixels, 1), (start, 0), (step, 0),
                                                       many == 4, False)
        if (-1 << 15 <= step < 1 << 15 and -REACH <= min(first, last) <= max(first, last) < REACH
                and abs(last - first) < REACH):
            return start, step


def rectangle(rng: random.Random, shape: str) -> list[tuple]:
    """The two vertices of a rectangle, some of which is beyond the frame."""
    spans = []
    for side in (WIDTH, HEIGHT):
        low = rng.choice((0, rng.randrange(side), rng.randrange(-16, side - 8)))
        spans.append((low, low + rng.choice((side, 4 * rng.randrange(2, 9), rng.randrange(1, side),
                                             rng.randrange(16, 200)))))
    (left, right), (top, bottom) = spans
    across, down = right - left, bottom - top
    copies = shape == "copies"
    s, dsdx = axis_steps(rng, down if shape == "flipped" else across, 4 if copies else 1, copies)
    t, dtdy = axis_steps(rng, across if shape == "flipped" else down, 1, False)
    return [(left * ONE, top * ONE, s, t, 0, ONE), (right * ONE, bottom * ONE, dsdx, dtdy, 0, ONE)]


def coloured(rng: random.Random, corners: list[tuple]) -> list[tuple]:
    """Vertices with colours instead of shades, signed as in the file."""
    same = rng.randbytes(4)
    is_same = rng.randrange(3) == 0
    return [(*v[:4], int.from_bytes(same if is_same else rng.randbytes(4), "big", signed=True),
             v[5]) for v in corners]


def case(seed: int, number: int, pixels: str) -> Case:
    """The polygon or rectangle of a seed and a number, for a frame format."""
    rng = random.Random(f"{seed}, {number}")
    shape = rng.choice(SHAPES)
    if shape == "copies" and pixels != "rgba5551":
        shape = "rectangles"
    copies = shape == "copies"
    words, kind, tlut = List(), rng.choice(KINDS), rng.randrange(4) == 0
    if copies and (kind == "levels" or rng.randrange(2)):
        kind = "plain"
    words.set_texture_image(RGBA, 2, 1, 0)
    words.set_tile(7, RGBA, 2, 0, 0)
    words.load_block(7, 0, 0, 2047, 0)
    if tlut:
        if not copies or rng.randrange(4):  # otherwise the four copies of entries differ
            words.load_tlut_pal256(4096)
        words.texture_lut(rng.choice(("rgba16", "ia16")))
    found = modes(rng, words, kind, shape)
    tiles = [tile(rng, tlut, kind == "plain", copies) for _ in range(8)]
    if kind == "levels":
        tiles = level_tiles(rng, found["tile"], tlut)
    for n, each in enumerate(tiles):
        wraps = (Wrap(a.clamp, a.mirror, a.mask, a.shift) for a in (each.s, each.t))
        words.set_tile(n, each.format, each.size, each.line, each.tmem, each.palette, *wraps)
        words.set_tile_size(n, each.s.low, each.t.low, each.s.high, each.t.high)
    primitive = "rectangles" if copies else shape
    if primitive in RECTANGLES:
        corners = rectangle(rng, shape)
    else:
        corners = vertices(rng, rng.randrange(4) == 0)
    if primitive == "coloured":
        corners = coloured(rng, corners)
    return Case(words.words, corners, rng.choice(("subpixel", "exact")),
                rng.choice(("scissor", "vertices")), tiles, primitive, found | {"tlut": tlut})


def rank(_seed: int, _number: int) -> int:
    """Polygons of a lower rank are drawn before others of a scene."""
    return 0


def scene(cases: list[Case], seed: int, pixels: str) -> Scene:
    """A scene of the cases, one a frame, each with a separate engine; a dot in a corner ensures
    that no frame has only one colour."""
    rng = np.random.default_rng(seed)
    texels = rng.integers(0, 256, DRAM_BYTES, np.uint8)
    materials, objects, corners, units, lists, words = [], [], [], [], [], []
    for n, each in enumerate(cases):
        materials.append(Material("n64", each.edges, clip=each.clip, unit=n,
                                  primitive=each.primitive))
        objects.append(Object(n, len(corners), len(each.vertices), 0, 1, n))
        corners += each.vertices
        units.append([n, 1])
        lists.append([len(words), len(each.words)])
        words += each.words
    ground, dot = FORMATS[pixels].flat([(16, 32, 48), (240, 24, 24)])
    materials.append(Material(colour=dot))
    objects.append(Object(len(cases), len(corners), 3, 0, len(cases), 0))
    corners += [(x * ONE, y * ONE, 0, 0, 0, ONE) for x, y in ((0, 0), (2, 0), (0, 2))]
    return Scene(WIDTH, HEIGHT, len(cases), ground, np.zeros((256, 3), np.uint8), [], materials,
                 objects, np.array(corners, np.int64), np.array([IDENTITY] * len(cases), np.int64),
                 pixels, units=np.array(units), lists=np.array(lists),
                 words=np.array(words, np.int64), dram=texels.tobytes())


def lines(each: Case) -> list[str]:
    """Describes a case completely."""
    is_rectangle = each.primitive in RECTANGLES
    raw = "st" if is_rectangle else ("shade",) * (each.primitive == "coloured")
    return [f"  modes {each.modes}, edges {each.edges}, clip {each.clip}",
            *(f"  tile {n}: {tile}" for n, tile in enumerate(each.tiles)),
            f"  {each.primitive}" + ", s and t in s10.5, then s5.10 a step" * is_rectangle,
            *vertex_lines(each.vertices, raw)]
