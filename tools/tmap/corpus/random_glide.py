"""Random polygons of Glide's texture units: modes, maps and vertices, each in one frame of a
scene."""

import random
from dataclasses import dataclass, field

import numpy as np

from tmap.base.pixel_formats import FORMATS as FRAMES
from tmap.corpus import written
from tmap.corpus.random_polygons import vertex_lines
from tmap.glide.words import ASPECTS, FACTORS, FILTERS, FORMATS, FUNCTIONS, LEVELS, MIPMAPS, Words
from tmap.model.model import FAR as BEYOND
from tmap.scene_file.pipes import PREFILTER_KB
from tmap.scene_file.scene_file import IDENTITY, Material, Object, Scene

PIXELS = ("rgb565", "rgba8888")
MOST = 15  # polygons in a scene: the decoded levels of each, for the passes, stay in memory
WIDTH, HEIGHT = 48, 32
ONE = 65536
REACH = 8191 * ONE
W_MAX = 1 << 30
PALETTE, NCC = 0, 1024  # addresses of tables in the texture memory
MEMORY_BYTES = 1 << 17  # of all units, random
KINDS = ("any",) * 8 + ("plain", "trilinear", "levels") * 2 + ("detail", "pass")
FAR = {"trilinear", "levels", "detail", "pass"}  # polygons with many levels
DITHERED = 7  # one polygon in so many
ADDED = 4  # one polygon in so many is added to the frame
STRIPS = ((16, 32, 48), (250, 90, 7), (96, 160, 200), (3, 255, 128))  # colours under added polygons
ALONE = ("plain", "dithered")  # kinds with one unit and one level


@dataclass
class Case:
    """One polygon of a kind, and its units; ``units``: registers, start and bytes of memory, bits
    of weights, whether it is dithered, subdivision; ``vertices``: (x, y, s, t, shade, w), as in a
    scene."""

    kind: str
    units: list[tuple]
    vertices: list[tuple]
    edges: str
    clip: str
    own: bool
    adds: bool
    modes: list[dict] = field(default_factory=list)


def combine(rng: random.Random, words: Words, is_last: bool) -> dict:
    """Random functions and factors; the last unit mostly shows its own texels."""
    if is_last and rng.randrange(3):
        chosen = ["local", "zero", "local", "zero", False, False]
    else:
        chosen = [rng.choice(list(FUNCTIONS)), rng.choice(list(FACTORS)),
                  rng.choice(list(FUNCTIONS)), rng.choice(list(FACTORS)),
                  rng.randrange(4) == 0, rng.randrange(4) == 0]
    words.combine(*chosen)
    return {"combine": chosen}


def unit(rng: random.Random, kind: str, number: int, count: int, perspective: bool) -> tuple:
    """Returns (row of the scene's table, choices) for a unit."""
    words = Words(rng.choice((1 << 17, 1 << 16, 1 << 12, 64)))
    form, aspect = rng.choice(list(FORMATS)), rng.choice(ASPECTS)
    largest = rng.choice((0, 0, 0, 1, 2, 3, rng.randrange(9)))
    smallest = rng.randrange(largest, 9)
    levels = rng.choice(("both", "both", "both", "even", "odd"))
    if kind in FAR:
        levels, largest, smallest = "both", 0, 8
    if kind == "trilinear":
        levels = ("odd", "even")[number]
    if not any(n % 2 in LEVELS[levels] for n in range(largest, smallest + 1)):
        levels = "both"
    found = {"format": form, "aspect": aspect, "levels": levels, "largest": largest,
             "smallest": smallest, "mode": rng.choice(MIPMAPS), "blend": rng.randrange(4) == 0,
             "filters": (rng.choice(FILTERS), rng.choice(FILTERS)),
             "clamp": (rng.choice(("wrap", "wrap", "clamp")), rng.choice(("wrap", "clamp"))),
             "perspective": perspective, "clamp_w": rng.randrange(3) == 0,
             "bias": rng.choice((0, 0, rng.randrange(-32, 32))),
             "limits": rng.choice((None, None, (rng.randrange(64), rng.randrange(64)))),
             "detail": (rng.randrange(-32, 32), rng.randrange(8), rng.randrange(256)),
             "ncc": rng.randrange(2), "bits": rng.choice((4, 4, 8)),
             "memory": words.memory_bytes}
    if kind in ALONE:
        found |= {"filters": 2 * ("point" if kind == "plain" else "bilinear",), "mode": "off",
                  "clamp": ("wrap", "wrap") if rng.randrange(4) else ("clamp", "wrap")}
    if kind in FAR:
        found |= {"mode": rng.choice(("nearest", "nearest", "nearest_dither")), "blend": 0,
                  "bias": rng.choice((0, 0, rng.randrange(-8, 8))), "bits": 4}
    if kind in ("trilinear", "pass"):
        found |= {"blend": 1, "filters": ("bilinear", "bilinear")}
    if kind == "detail":
        found["detail"] = (rng.randrange(9), rng.randrange(8), rng.choice((255, rng.randrange(256))))
    words.source(8 * rng.randrange(64), levels, largest, smallest, aspect, form)
    words.mipmap(found["mode"], bool(found["blend"]))
    words.filter(*found["filters"])
    words.clamp(*found["clamp"])
    words.fields["lod_bias"] = found["bias"]
    words.detail(*found["detail"])
    words.perspective(perspective, bool(found["clamp_w"]))
    words.ncc_select(found["ncc"])
    if found["limits"] and kind == "any":
        words.fields |= dict(zip(("lod_min", "lod_max"), found["limits"]))
    if kind == "trilinear" and not number:
        words.combine("blend", "one_minus_lod_fraction", "blend", "one_minus_lod_fraction")
    elif kind == "pass":
        words.blend_levels(rng.choice(("odd", "even")))
        words.combine(*("blend_local", rng.choice(("lod_fraction", "one_minus_lod_fraction"))) * 2)
    elif kind == "detail" and not number:
        words.combine(*(rng.choice(("blend", "blend", "scale_other")),
                        rng.choice(("detail", "one_minus_detail"))) * 2)
    else:
        found |= combine(rng, words, number == count - 1)
    return [*words.words(), 0, words.memory_bytes, PALETTE, NCC, found["bits"]], found


def depths(rng: random.Random, count: int, signs: bool, far: bool) -> list[int]:
    """w of corners: equal, or far apart; ``signs``: some negative; ``far``: all different."""
    base, deepest = rng.choice((1, 1, rng.uniform(0.1, 300))), rng.choice((1, 1.5, 4, 40, 2000))
    if far:
        base, deepest = 1, rng.choice((20, 100, 1000, 2000))
    elif rng.randrange(8) == 0:
        base, deepest = 1 / 256, 1 << 22
    parts = [rng.choice((0, 1, rng.random())) if far else rng.random() for _ in range(count)]
    found = [min(max(round(base * deepest**part * ONE), 256), W_MAX) for part in parts]
    return [w * rng.choice((1, -1)) if signs else w for w in found]


def coordinates(rng: random.Random, around: list[complex], far: bool) -> list[tuple[int, int]]:
    """s and t of corners, in 16.16: mostly turned and scaled like the polygon; ``far``: so that
    texels are larger than pixels in its near part."""
    texels = rng.uniform(4, 80) if far else rng.choice((rng.uniform(0, 8), rng.uniform(8, 80), rng.uniform(80, 600), 4000))
    s0, t0 = (rng.choice((0, rng.uniform(-40, 300), rng.uniform(-4000, 4000))) for _ in range(2))
    flat = rng.randrange(3) == 0
    found = [(s0 + texels * (c.real if flat else rng.uniform(-1, 1)),
              t0 + texels * (c.imag if flat else rng.uniform(-1, 1))) for c in around]
    return [tuple(max(-REACH, min(round(v * ONE), REACH)) for v in pair) for pair in found]


def written_vertices(rng: random.Random, own: bool) -> list[tuple]:
    """Corners as people write them; ``own``: repeated with other coordinates for the second
    unit."""
    points, out = written.outline(rng, WIDTH, HEIGHT), []
    for second in range(1 + own):
        ends = rng.choice(((256, 256), (256, 256), (256, 128), (32, 256)))
        ws = [round(w * ONE) for w in written.depths(rng, points)]
        signs = [rng.choice((1, -1)) if second else 1 for _ in ws]
        out += [(*p, *st, 0, w * sign) for p, st, w, sign in
                zip(points, written.texels(rng, points, ends), ws, signs)]
    return out


def vertices(rng: random.Random, own: bool, far: bool) -> list[tuple]:
    """Corners round a centre, some beyond the frame, some polygons slivers, or corners as people
    write them; ``own``: repeated for the second unit; ``far``: with many levels."""
    if not far and rng.random() < written.SHARE:
        return written_vertices(rng, own)
    count = rng.choice((3, 3, 4, 4, 5, 7))
    x0, y0 = rng.uniform(0, WIDTH), rng.uniform(0, HEIGHT)
    size = rng.choice((rng.uniform(12, 40) if far else rng.uniform(2, 12), rng.uniform(12, 40),
                       rng.uniform(40, 300)))
    thin = rng.choice((1, 1, 1, 1, 0.02)) * np.exp(1j * rng.random())
    turn = rng.choice((0.125, 0.125, rng.random()))
    angles = sorted((turn + (k + rng.uniform(0, 0.6)) / count) % 1 for k in range(count))
    if count == 4 and rng.randrange(2):
        angles = [turn + k / 4 for k in range(4)]
    around = [np.exp(2j * np.pi * angle) for angle in angles]
    screen = [(max(-BEYOND, min(round(v * ONE), BEYOND - 1)) for v in (x0 + size * p.real,
                                                                  y0 + size * p.imag))
              for p in (complex(c.real, c.imag * abs(thin)) * thin / abs(thin) for c in around)]
    places = [tuple(p) for p in screen]
    out = []
    for second in range(1 + own):
        ws = depths(rng, count, bool(second) and rng.randrange(2) == 0, far)
        out += [(*place, *texel, 0, w)
                for place, texel, w in zip(places, coordinates(rng, around, far), ws)]
    return out


def case(seed: int, number: int, _: str = "") -> Case:
    """The polygon of a seed and a number, the same in all formats of frames."""
    rng = random.Random(f"{seed}, {number}")
    kind = rng.choice(KINDS)
    if number % DITHERED == 0:
        kind = "dithered"
    dithered = int(kind == "dithered" or number % DITHERED == 1)  # it need not have an effect
    count = (1 if kind in (*ALONE, "pass") else 2 if kind in ("trilinear", "detail")
             else rng.choice((1, 1, 2, 2, 2)))
    own = count == 2 and kind in ("any", "levels") and rng.randrange(2) == 0
    perspective = kind in FAR or rng.randrange(4) > (2 if kind in ALONE else 0)
    units, modes = [], []
    for n in range(count):
        other = kind not in FAR and rng.randrange(8) == 0  # the units may differ
        row, found = unit(rng, kind, n, count, perspective != other)
        units.append([*row, dithered])
        modes.append(found | {"dithered": dithered})
    made = Case(kind, units, vertices(rng, own, kind in FAR), rng.choice(("subpixel", "exact")),
                rng.choice(("scissor", "vertices")), own, number % ADDED == 3, modes)
    for row, found in zip(units, modes):
        found["pieces"] = rng.choice((0, 8, 8, 16, 16))
        row.append(found["pieces"])
    return made


def rank(seed: int, number: int) -> int:
    """Polygons of a lower rank are drawn before others of a scene: dithered ones are the model's only if there is memory
    for their page, which the decoded levels of others may take."""
    return int(case(seed, number).kind != "dithered")


def strip(n: int) -> list[tuple]:
    """The corners of one of the adjacent strips that fill the frame."""
    left, right = (WIDTH * (n + k) // len(STRIPS) for k in (0, 1))
    return [(x * ONE, y * ONE, 0, 0, 0, ONE)
            for x, y in ((left + 5, 0), (right + 5, 0), (right - 6, HEIGHT), (left - 6, HEIGHT))]


def scene(cases: list[Case], seed: int, pixels: str) -> Scene:
    """A scene of the cases, one a frame, each with a separate pipe; added polygons are drawn over
    coloured strips. A dot in a corner ensures that no frame has only one colour."""
    memory = np.random.default_rng(seed).integers(0, 256, MEMORY_BYTES, np.uint8)
    memory[PALETTE:PALETTE + 1024:4] = 0
    flats = FRAMES[pixels].flat(STRIPS)
    materials, objects, corners, glide_units, pipes = [], [], [], [], []
    for n in range(len(STRIPS)):
        objects += [Object(len(cases) + n, len(corners), 4, 0, 1, frame)
                    for frame, each in enumerate(cases) if each.adds]
        corners += strip(n)
    for n, each in enumerate(cases):
        materials.append(Material("glide", each.edges, clip=each.clip, unit=n))
        objects.append(Object(n, len(corners), len(each.vertices), 0, 1, n))
        corners += each.vertices
        pipes.append([len(glide_units), len(each.units), 2 * each.own, PREFILTER_KB << 10,
                      each.adds])
        glide_units += each.units
    ground, dot = FRAMES[pixels].flat([(16, 32, 48), (240, 24, 24)])
    materials += [Material(colour=colour) for colour in [*flats, dot]]
    objects.append(Object(len(materials) - 1, len(corners), 3, 0, len(cases), 0))
    corners += [(x * ONE, y * ONE, 0, 0, 0, ONE) for x, y in ((0, 0), (2, 0), (0, 2))]
    return Scene(WIDTH, HEIGHT, len(cases), ground, np.zeros((256, 3), np.uint8), [], materials,
                 objects, np.array(corners, np.int64), np.array([IDENTITY] * len(cases), np.int64),
                 pixels, glide_units=np.array(glide_units, np.int64), pipes=np.array(pipes, np.int64),
                 glide_memory=memory.tobytes())


def lines(each: Case) -> list[str]:
    """Describes a case completely."""
    return [f"  edges {each.edges}, clip {each.clip}, coordinates of its own {each.own}, "
            f"added {each.adds}, kind {each.kind}", *(f"  unit {n}: {modes}" for n, modes in enumerate(each.modes)),
            *vertex_lines(each.vertices)]
