"""Random textures that are magnified or repeated, each in several frames: the cases for prefiltered
tiles."""

import random

import numpy as np

from tmap.base.pixel_formats import FORMATS as PIXELS
from tmap.corpus.random_glide import MEMORY_BYTES, NCC, PALETTE
from tmap.glide.words import ASPECTS, FACTORS, FORMATS, FUNCTIONS, Words
from tmap.scene_file.scene_file import Material, Object, Scene

WIDTH, HEIGHT = 96, 64
FRAMES = 6  # of each case
ONE = 65536
MOST = 3000  # s and t of two corners differ by less than twice this
KINDS = ("bilinear", "bilinear", "repeated", "trilinear", "modulate", "any", "point")


def unit(rng: random.Random, kind: str, number: int, count: int, largest: int) -> list[int]:
    """A row of the scene's table of units."""
    words = Words(rng.choice((1 << 17, 1 << 16, 1 << 12)))
    form, aspect = rng.choice(list(FORMATS)), rng.choice(ASPECTS + ("1x1",) * 3)
    levels = ("odd", "even")[number] if kind == "trilinear" else "both"
    words.source(8 * rng.randrange(64), levels, largest, 8, aspect, form)
    words.mipmap(rng.choice(("off", "nearest")), kind == "trilinear")
    if kind == "trilinear":
        words.mipmap("nearest", True)
    filters = ("point", "point") if kind == "point" else ("bilinear", "bilinear")
    if kind == "any" and rng.randrange(3) == 0:
        filters = ("bilinear", "point")
    words.filter(*filters)
    words.clamp(*(rng.choice(("wrap", "wrap", "clamp")) for _ in "st"))
    if kind == "repeated":
        words.clamp("wrap", "wrap")
    words.fields["lod_bias"] = rng.choice((0, 0, 3, -5))
    words.detail(rng.randrange(-8, 8), rng.randrange(4), rng.randrange(256))
    words.perspective(bool(rng.randrange(3)), False)
    if number < count - 1 and kind == "trilinear":
        words.combine("blend", "one_minus_lod_fraction", "blend", "one_minus_lod_fraction")
    elif number < count - 1 and kind == "modulate":
        words.combine("scale_other", "local", "scale_other", "local")
    elif kind == "any" or kind == "point":
        words.combine(*(rng.choice(list(names)) for _ in "ca" for names in (FUNCTIONS, FACTORS)))
    return [*words.words(), 0, words.memory_bytes, PALETTE, NCC, rng.choice((4, 4, 4, 8)), 0, 8]


def vertices(rng: random.Random, kind: str, texel: float) -> list[tuple]:
    """A parallelogram or a triangle around the frame's middle; ``texel``: the size in s and t of a
    texel of the finest level."""
    size = rng.uniform(12, 60)
    corners = [(-1, -1), (1, -1), (1, 1), (-1, 1)][:rng.choice((3, 4, 4))]
    texels = [rng.choice((rng.uniform(0.1, 1), rng.uniform(0.5, 3), rng.uniform(3, 12)))
              for _ in "st"]
    if kind == "repeated":
        texels = [min(rng.uniform(4, 40) * rng.choice((1, 1, 3)), MOST / texel) for _ in "st"]
    skew = rng.choice((0, 0, rng.uniform(-1, 1)))
    turned = rng.randrange(3) == 0
    s0, t0 = (rng.choice((0, rng.uniform(-40, 300), rng.uniform(-4000, 4000))) for _ in "st")
    w = round(rng.choice((1, 1, 7.3)) * ONE)
    found = []
    for x, y in corners:
        s, t = (x + skew * y) * texels[0] / 2, y * texels[1] / 2
        if turned:
            s, t = t, -s
        found.append((round(size * x * ONE), round(size * y * ONE), round((s0 + s * texel) * ONE),
                      round((t0 + t * texel) * ONE), 0, w))
    return found


def pose(rng: random.Random) -> tuple[int, ...]:
    """Turned about the frame's middle, or nearly unmoved."""
    angle = rng.choice((0, rng.uniform(-0.2, 0.2), rng.uniform(0, 6.3)))
    c, s = round(ONE * np.cos(angle)), round(ONE * np.sin(angle))
    return (c, -s, s, c, round(ONE * (WIDTH / 2 + rng.uniform(-9, 9))),
            round(ONE * (HEIGHT / 2 + rng.uniform(-9, 9))))


def scene(seed: int, numbers: list[int], pixels: str, prefilter: int) -> Scene:
    """A scene of the cases with these numbers, each FRAMES frames long; ``prefilter``: bytes."""
    memory = np.random.default_rng(seed).integers(0, 256, MEMORY_BYTES, np.uint8)
    memory[PALETTE:PALETTE + 1024:4] = 0
    materials, objects, corners, poses, glide_units, pipes = [], [], [], [], [], []
    for k, number in enumerate(numbers):
        rng = random.Random(f"tiles, {seed}, {number}")
        kind = KINDS[number % len(KINDS)]
        count = 1 if kind in ("bilinear", "repeated") else 2 if kind != "any" else rng.choice((1, 2))
        largest = rng.choice((1, 2, 2, 3, 4, 5)) if kind != "repeated" else rng.choice((4, 5, 6))
        pipes.append([len(glide_units), count, 0, prefilter, 0])
        glide_units += [unit(rng, kind, n, count, max(largest - rng.randrange(2) * n, 0))
                        for n in range(count)]
        materials.append(Material("glide", rng.choice(("subpixel", "exact")), unit=k))
        made = vertices(rng, kind, 2 ** largest)
        objects.append(Object(k, len(corners), len(made), len(poses), FRAMES, FRAMES * k))
        corners += made
        poses += [pose(rng) for _ in range(FRAMES)]
    ground, = PIXELS[pixels].flat([(16, 32, 48)])
    return Scene(WIDTH, HEIGHT, FRAMES * len(numbers), ground, np.zeros((256, 3), np.uint8), [],
                 materials, objects, np.array(corners, np.int64), np.array(poses, np.int64), pixels,
                 glide_units=np.array(glide_units, np.int64), pipes=np.array(pipes, np.int64),
                 glide_memory=memory.tobytes())
