"""Trials of perspective_depth: the plane of q, the ranges of u and v and the corners of polygons, against the model."""

from collections.abc import Iterator

import numpy as np

from tests.helpers.kernel_checker import Memory
from tests.kernels.trials.far import DEPTHS
from tests.kernels.trials.outline import at_of, embed
from tests.kernels.trials.polygon import HEIGHT, WIDTH, sides_numbers, sides_pointers, wanted_sides
from tmap.base.fixed import M32, ONE
from tmap.bench.trial import Trial, Write, anything, fields
from tmap.build import layout
from tmap.guest.kernels import Case
from tmap.setup import edges
from tmap.setup.perspective import Perspective, perspective

NAMES = ("x", "y", "q", "s", "t")


def polygons(rng, count: int) -> Iterator[list[tuple[int, ...]]]:
    """Polygons in and around the frame, many of them slivers, whose w may be any."""
    for k in range(count):
        corners = int(rng.choice((3, 3, 3, 4, 5, 8)))
        size = float(rng.choice((1, 10, 100, 400)))
        angles = np.sort(rng.uniform(0, 2 * np.pi, corners))[::int(rng.choice((-1, 1)))]
        wide = float(rng.choice((0.02, 1, 1)))
        points = rng.uniform((0, 0), (WIDTH, HEIGHT)) + size * np.transpose((np.cos(angles), wide * np.sin(angles)))
        ratio, reach = float(rng.choice((*DEPTHS, 65536))), int(rng.choice((4, 128, 4000))) << 16
        yield [(*(round(c * ONE) for c in point), *(int(c) for c in rng.integers(-reach, reach, 2)),
                int(1 + (16384 if k % 3 else 40) * ratio ** float(rng.random()))) for point in points]


def made(deep: Perspective, box, count: int, depth: int, plan: int) -> list[Write]:
    """What is written where the polygon is drawn with perspective."""
    number = lambda n: (n & (1 << 64) - 1).to_bytes(8, "big")  # noqa: E731
    limits = {f"{c}_{end}": n for end, ends in (("low", deep.low), ("high", deep.high)) for c, n in zip("uv", ends)}
    writes = fields(plan, "perspective_plan", limits | dict(zip("uv", deep.base)) | {
        "left": box[0], "q_low": deep.least, "q_high": deep.most})
    writes += [Write(plan + at_of("perspective_plan", "q") + at_of("screen_plane", name), number(getattr(deep.q, name)))
               for name in ("at", "dx", "dy")]
    x = (box[0] << 16) - deep.corners.three[0][0]
    return writes + fields(depth, "depth", {
        "scale": deep.scale, "is_triangle": count == 3, "has_texels": 0, "gentle": deep.corners.gentle,
        "right": (abs(x) >> 16) + box[2] - box[0] + 1, "down": deep.corners.down, "off": deep.corners.off,
        "least": deep.least + deep.corners.off * (count == 3)})


def corners_made(deep: Perspective, box, wanted, at: int) -> list[Write]:
    """The corners, as two vectors from the first."""
    *_, area, right = wanted
    first, bottom, middle = deep.corners.three
    shape, writes = layout.load().struct("plane_corner"), []
    a, b = ([n - o for n, o in zip(corner, first)] for corner in ((middle, bottom) if right else (bottom, middle)))
    for name, row in (("first", first), ("a", a), ("b", b)):
        writes.append(Write(at + at_of("plane_corners", name), shape.pack(**dict(zip(NAMES, row)))))
    writes.append(Write(at + at_of("plane_corners", "area"), area.to_bytes(8, "big")))
    return writes + fields(at, "plane_corners", {
        "x": (box[0] << 16) - first[0] & M32, "y": (box[1] << 16) - first[1] & M32})


def trial(vertices) -> Trial | None:
    """A polygon's trial; None if nothing of it is in the frame, or w is constant."""
    wanted, sides = wanted_sides(vertices), edges.measure(vertices, WIDTH, HEIGHT)
    if sides is None or len({v[4] for v in vertices}) == 1:
        return None
    memory = Memory()
    shape = layout.load().struct("vertex")
    at = memory.add(b"".join(shape.pack(**dict(zip("xystw", v)), shade=0) for v in vertices), name="vertices",
                    shape=shape)
    setup, plan, depth = (memory.room(name) for name in ("setup", "perspective_plan", "depth"))
    for name, value in (("vertices", at), ("count", len(vertices)), ("perspective", plan)):
        place = setup + at_of("setup", name)
        memory.data[place:place + 4] = value.to_bytes(4, "big")
        if name != "count":
            memory.pointers.append(place)
    embed(memory, setup, "setup", "sides", "sides", sides_pointers(at, vertices, wanted),
          **sides_numbers(vertices, wanted), spare=[0] * 3, area=list(wanted[4].to_bytes(8, "big")))
    embed(memory, setup, "setup", "box", "rectangle", {}, **dict(zip(("left", "top", "right", "bottom"), sides.box)))
    deep = perspective(vertices, sides.corners, sides.box)
    case = Case("perspective_depth", memory, pointers={"a0": depth, "a1": setup})
    if deep:
        writes = (made(deep, sides.box, len(vertices), depth, plan)
                  + corners_made(deep, sides.box, wanted, depth + at_of("depth", "corners")))
    else:
        writes = [anything(place, layout.load().struct(name).size)
                  for place, name in ((plan, "perspective_plan"), (depth, "depth"))]
    return Trial(case, f"{vertices}", {"d0": int(deep is not None)}, writes=writes)


def trials() -> list[Trial]:
    rng = np.random.default_rng(31)
    return [made for vertices in polygons(rng, 220) if (made := trial(vertices))]
