"""Trials of src68k/polygon: texture planes of polygons, their wraps and their starts on edges,
against exact fractions and the model."""

from fractions import Fraction

import numpy as np

from tests.helpers.kernel_checker import Memory
from tests.kernels.trials.math import any_size
from tests.kernels.trials.polygon import (HEIGHT, WIDTH, box_block, described, seen_polygons,
                                          sides_block, vertex_block, wanted_sides)
from tmap.base.fixed import ONE, mul_div
from tmap.bench.spans import BIAS
from tmap.bench.trial import Check, Trial, Write, fields, values
from tmap.build import layout
from tmap.guest.kernels import M32, Case, Result
from tmap.model import model
from tmap.setup import edges as model_edges, texturing

CHAINS = ("CHAIN_NONE", "CHAIN_ANYWHERE", "CHAIN_PLANE", "CHAIN_WHOLE")
#: The chain of each, and how the model knows it: by a mapper.
SETTINGS = (("CHAIN_NONE", model.Settings(mapper="generated")),
            ("CHAIN_NONE", model.Settings(mapper="tiled")),
            ("CHAIN_NONE", model.Settings(mapper="columns")),
            ("CHAIN_ANYWHERE", model.Settings(start="truncated")),
            ("CHAIN_PLANE", model.Settings()))


def texturing_plane_trial(vertices, chain: str, settings: model.Settings) -> Trial | None:
    """The plane of a polygon; None where nothing of it is in the frame."""
    wanted, sides = wanted_sides(vertices), model_edges.measure(vertices, WIDTH, HEIGHT)
    if sides is None:
        return None
    t = texturing.plane(vertices, sides.corners, sides.box, settings)
    memory = Memory()
    at = vertex_block(memory, vertices)
    sides_at = sides_block(memory, at, vertices, wanted)
    box = box_block(memory, sides.box)
    cuts = dict(zip(("u_cut", "v_cut"), texturing.CUT.get(settings.mapper, (0, 0))))
    out = memory.struct("texturing", {}, **dict.fromkeys(layout.load().struct("texturing").fields, 7) | cuts)
    return Trial(Case("texturing_plane", memory, {"d1": layout.load().constants[chain]},
                      {"a0": out, "a1": sides_at, "d0": box}),
                 f"{chain}, {settings.mapper}, box {sides.box}: {described(vertices)}",
                 writes=plane_writes(out, t), also=steps_check(out, t, [vertices[k] for k in sides.corners]))


def plane_writes(at: int, t: model.Texturing) -> list[Write]:
    """What struct texturing becomes; v_cut stays."""
    return fields(at, "texturing", {name: int(getattr(t, name)) for name in (
        "dudx", "dvdx", "wraps", "u_cut", "wrap_bit", "dudy", "dvdy", "u", "v", "i", "j")})


def steps_check(out: int, t: model.Texturing, corners, names: str = "uv") -> Check:
    """The check that steps are as near the exact gradients through three corners as the block says."""
    a, b, c = corners
    (x1, y1, s1, t1), (x2, y2, s2, t2) = ([p - q for p, q in zip(v, a)] for v in (b, c))
    d = x1 * y2 - x2 * y1
    exact = {"dudx": Fraction(s1 * y2 - s2 * y1, d), "dudy": Fraction(x1 * s2 - x2 * s1, d),
             "dvdx": Fraction(t1 * y2 - t2 * y1, d), "dvdy": Fraction(x1 * t2 - x2 * t1, d)}

    def bound(result: Result) -> str | None:
        shape = layout.load().struct("texturing").fields
        for name, gradient in exact.items():
            if name[1] not in names:
                continue
            place = out + shape[name]["offset"]
            error = int.from_bytes(result.memory[place:place + 4], "big") - gradient * ONE
            error -= round(error / (1 << 32)) * (1 << 32)
            half = Fraction(1 << t.cuts["uv".index(name[1])], 2)
            cut = Fraction(5, 2**27) if t.gentle else abs(gradient) / 2**31 + Fraction(3, 2**32)
            allowed = half + cut * ONE
            if abs(error) > allowed:
                return (f"{name}: exact is {float(gradient):.9f} modulo 2^16: off by "
                        f"{float(error):.3f}/2^16, the block allows {float(allowed):.3f}/2^16")
        return None

    return bound


def texturing_plane_trials(rng) -> list[Trial]:
    made = seen_polygons(rng)
    for _ in range(60):  # anything around the frame, and slivers in it
        made.append([tuple(any_size(rng, 30) for _ in range(4)) for _ in range(3)])
        x, y = (int(n) for n in rng.integers(0, 256 * ONE, 2))
        w, h = any_size(rng, 20), any_size(rng, 22)
        made.append([(x, y, any_size(rng, 30), any_size(rng, 30)), (x + w, y + h, 5, 7),
                     (x + 2 * w + int(rng.integers(-1, 2)), y + 2 * h, any_size(rng, 26), 9)])
    trials = [texturing_plane_trial(p, *each) for p in made for each in SETTINGS]
    return [trial for trial in trials if trial]


def texturing_wrap_trial(dvdx: int, dvdy: int, v: int, box, chain: int) -> Trial:
    """How a polygon lives with wraps of v."""
    inside = chain >= 2 and texturing.inside_period(dvdx, dvdy, v, box)
    spare, guard, wraps = (0, 0, not inside) if chain == 3 else \
        texturing.wrap_bits(dvdx, box[2] - box[0], chain > 0 and not inside)
    memory = Memory()
    box_at = box_block(memory, box)
    at = memory.struct("texturing", {}, dudx=0, dvdx=dvdx, wraps=7, u_cut=0, v_cut=0, wrap_bit=7,
                       dudy=0,
                       dvdy=dvdy, u=0, v=v & M32, i=0, j=0)
    writes = fields(at, "texturing", {"u_cut": spare, "wrap_bit": guard, "wraps": int(wraps)})

    def sound(_: Result) -> str | None:
        left, top, right, bottom = box
        i, j = (left + right) >> 1, (top + bottom) >> 1
        ends = [(v & 0xFFFFFF) + (x - i) * dvdx + (y - j) * dvdy
                for x in (left, right) for y in (top, bottom)]
        if inside and not all(0 <= end < 1 << 24 for end in ends):
            return f"v leaves its period at a corner: {ends}"
        return None

    return Trial(Case("texturing_wrap", memory, {"d0": layout.load().constants[CHAINS[chain]]},
                      {"a0": at, "a1": box_at}),
                 f"{CHAINS[chain]}, box {box}, {values(dvdx=dvdx, dvdy=dvdy, v=v)}",
                 writes=writes, also=sound)


def texturing_wrap_trials(rng) -> list[Trial]:
    steps = (0, 1, -1, ONE, -ONE, 0x1000000, -0x1000000, 0xFFFFFF, 0x7FFFFFFF, -0x80000000,
             256 * ONE, 128 * ONE, -128 * ONE, 127 * ONE)
    boxes = ((0, 0, 320, 256), (0, 0, 1, 1), (5, 7, 6, 200), (0, 0, 1024, 1024), (10, 10, 13, 15))
    picked = [(int(rng.choice(steps)), int(rng.choice(steps)), any_size(rng)) for _ in range(20)]
    picked += [(any_size(rng, 18), any_size(rng, 18), any_size(rng, 24)) for _ in range(40)]
    # Steps below 1/256 texel, which 8.8 does not hold: over half a box they are many.
    picked += [(slow if along else 0, 0 if along else slow, start) for along in (False, True)
               for slow in (255, -255) for start in (100 << 8, (1 << 24) - (100 << 8))]
    # at the border between one wrap and more: ((speed >> 8) + 1) * width against 65,536
    picked += [((65536 // width - 1 + near << 8), 0, 0) for width in (1, 3, 320, 1024) for near in (0, 1)]
    return [texturing_wrap_trial(*p, box, chain) for p in picked for box in boxes for chain in (1, 2, 3)] \
        + [texturing_wrap_trial(*picked[0], boxes[0], 0)]


def texturing_starts_trials(rng) -> list[Trial]:
    trials = []
    for count in (1, 2, 5, 60):
        for _ in range(10):
            plane = {name: any_size(rng) for name in ("dudx", "dvdx", "dudy", "dvdy")}
            plane |= {"u": any_size(rng) & M32, "v": any_size(rng) & M32}
            i, j = (int(n) for n in rng.integers(0, 1024, 2))
            memory = Memory()
            at = memory.struct("texturing", {}, **plane, i=i, j=j, wraps=0, u_cut=0, v_cut=0,
                               wrap_bit=0)
            shape, edges, writes = layout.load().struct("edge"), [], []
            for _ in range(count):
                edges.append({"x": BIAS + int(rng.integers(-16384, 16384)),
                              "top": int(rng.integers(0, 1024)), "whole": any_size(rng, 15)})
            others = dict.fromkeys(shape.fields, 0)
            out = memory.add(b"".join(shape.pack(**others | edge) for edge in edges), name="edges",
                             shape=shape)
            for k, edge in enumerate(edges):
                x, y = edge["x"] - BIAS - i, edge["top"] - j
                numbers = {c: plane[c] + x * plane[f"d{c}dx"] + y * plane[f"d{c}dy"] for c in "uv"}
                numbers |= {f"d{c}": plane[f"d{c}dy"] + edge["whole"] * plane[f"d{c}dx"] for c in "uv"}
                writes += fields(out + k * shape.size, "edge", numbers)
            trials.append(Trial(
                Case("texturing_starts", memory, {"d0": count}, {"a0": at, "a1": out}),
                f"{count} edges, pixel ({i}, {j}), " + values(**plane), writes=writes))
    return trials


def corners_divide_trials(rng) -> list[Trial]:
    """Corners before the camera, and some behind it, by both units' scales."""
    shape, trials = layout.load().struct("vertex"), []
    for bits, one in [(2, 1 << 30), (5, 0x7FFF0000)] * 60:
        memory, nearest = Memory(), int(2.0 ** rng.uniform(0, 30))
        ws = [nearest, *(min(int(nearest * 2.0 ** rng.uniform(0, 22)), 1 << 30) for _ in "ab")]
        if behind := bool(rng.integers(2)):
            ws = [-w if rng.integers(2) else w for w in ws]
        places = [[any_size(rng, 29) for _ in "xy"] for _ in ws]
        coordinates = [[any_size(rng, 30 - bits) for _ in "st"] for _ in ws]
        division = {"least": nearest, "nearest": one >> behind, "one": one, "bits": bits}

        def corners(values) -> bytes:
            return b"".join(shape.pack(x=x, y=y, s=s, t=t, shade=9, w=w)
                            for (x, y), (s, t, w) in zip(places, values))

        scaled = [mul_div(division["nearest"], nearest, abs(w)) * (1 if w > 0 else -1) for w in ws]
        at = memory.add(corners([*st, w] for st, w in zip(coordinates, ws)), name="corners", shape=shape)
        wanted = corners([*(mul_div(c << bits, w, one) for c in st), w] for st, w in zip(coordinates, scaled))
        trials.append(Trial(Case("corners_divide", memory, pointers={
            "a0": at, "a1": memory.struct("planes_division", {}, **division)}),
            f"{coordinates}, w {ws}, " + values(**division), writes=[Write(at, wanted)]))
    return trials


def trials() -> list[Trial]:
    makers = (texturing_plane_trials, texturing_wrap_trials, texturing_starts_trials, corners_divide_trials)
    return [trial for seed, maker in enumerate(makers, 4)
            for trial in maker(np.random.default_rng([4, seed]))]
