"""Trials of perspective_depth and far_find: the plane of q, the ranges of u and v and the corners of polygons, and how
they are drawn from the far ends of their lines; against the model."""

from collections.abc import Iterator

import numpy as np

from tests.helpers.kernel_checker import Memory
from tests.kernels.trials.far import DEPTHS
from tests.kernels.trials.outline import at_of, embed
from tests.kernels.trials.polygon import HEIGHT, WIDTH, sides_numbers, sides_pointers, wanted_sides
from tmap.base.fixed import M32, ONE
from tmap.bench.perspective import plan_of
from tmap.bench.trial import Trial, Write, anything, fields
from tmap.build import layout
from tmap.guest.kernels import Case
from tmap.setup import edges, far
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


def setup_of(memory: Memory, vertices, box, plan: int, more: dict[str, int]) -> int:
    """struct setup of a polygon with perspective. ``more``: places of other structs, by its pointers' names."""
    shape, wanted = layout.load().struct("vertex"), wanted_sides(vertices)
    at = memory.add(b"".join(shape.pack(**dict(zip("xystw", v)), shade=0) for v in vertices), name="vertices",
                    shape=shape)
    setup = memory.room("setup")
    for name, value in {"vertices": at, "perspective": plan, **more}.items():
        place = setup + at_of("setup", name)
        memory.data[place:place + 4] = value.to_bytes(4, "big")
        memory.pointers.append(place)
    place_number(memory, setup, "count", len(vertices))
    embed(memory, setup, "setup", "sides", "sides", sides_pointers(at, vertices, wanted),
          **sides_numbers(vertices, wanted), spare=[0] * 3, area=list(wanted[4].to_bytes(8, "big")))
    embed(memory, setup, "setup", "box", "rectangle", {}, **dict(zip(("left", "top", "right", "bottom"), box)))
    return setup


def place_number(memory: Memory, setup: int, name: str, value: int) -> None:
    """Sets a long of a setup."""
    place = setup + at_of("setup", name)
    memory.data[place:place + 4] = value.to_bytes(4, "big")


def depth_trial(vertices, sides) -> Trial:
    """A polygon's depth."""
    memory = Memory()
    plan, depth = memory.room("perspective_plan"), memory.room("depth")
    setup = setup_of(memory, vertices, sides.box, plan, {})
    deep = perspective(vertices, sides.corners, sides.box)
    case = Case("perspective_depth", memory, pointers={"a0": depth, "a1": setup})
    if deep:
        writes = (made(deep, sides.box, len(vertices), depth, plan)
                  + corners_made(deep, sides.box, wanted_sides(vertices), depth + at_of("depth", "corners")))
    else:
        writes = [anything(place, layout.load().struct(name).size)
                  for place, name in ((plan, "perspective_plan"), (depth, "depth"))]
    return Trial(case, f"{vertices}", {"d0": int(deep is not None)}, writes=writes)


def far_trial(vertices, sides, exact: bool, every: str) -> Trial | None:
    """Whether the polygon's lines are drawn from their far ends, and how; None without perspective."""
    deep = perspective(vertices, sides.corners, sides.box)
    if not deep:
        return None
    memory, constants = Memory(), layout.load().constants
    plan = plan_of(memory, deep, "every16", 1, dict(lines=0, to=0))
    first, bottom, middle = deep.corners.three
    shape, right = layout.load().struct("plane_corner"), wanted_sides(vertices)[-1]
    rows = [[n - o for n, o in zip(row, first)] for row in ((middle, bottom) if right else (bottom, middle))]
    packed = {name: list(shape.pack(**dict(zip(NAMES, row)))) for name, row in zip(("first", "a", "b"), (first, *rows))}
    corners = layout.load().struct("plane_corners").pack(area=[0] * 8, x=0, y=deep.corners.y, **packed)
    depth = memory.struct("depth", {}, corners=list(corners), scale=deep.scale, is_triangle=0, has_texels=0, right=0,
                          down=deep.corners.down, off=deep.corners.off, least=0, gentle=int(deep.corners.gentle))
    material = memory.add(bytearray(layout.load().struct("material").size), name="material",
                          shape=layout.load().struct("material"))
    setting = "every16" if every == "every16" else "every8"
    for name, value in (("edges", constants["EDGES_EXACT" if exact else "EDGES_SUBPIXEL"]),
                        ("perspective", constants[f"PERSPECTIVE_{'PIXEL' if every == 'tolerance' else setting.upper()}"])):
        memory.data[material + at_of("material", name)] = value
    setup = setup_of(memory, vertices, sides.box, plan, {"material": material})
    place_number(memory, setup, "setting", constants[f"PERSPECTIVE_{setting.upper()}"])
    count = setup + at_of("setup", "span") + at_of("span_plan", "count")
    memory.data[count:count + 4] = (sides.box[3] - sides.box[1]).to_bytes(4, "big")
    way = memory.room("far_way")
    case = Case("far_find", memory, pointers={"a0": way, "a1": setup, "d0": depth})
    found = far.find(deep, every, sides.box, exact)
    if not found:
        writes = [anything(way, layout.load().struct("far_way").size)]
    else:
        writes = far_made(deep, found, sides.box, exact, every, way, depth, right)
    return Trial(case, f"{every}, exact {exact}, {vertices}", {"d0": int(found is not None)}, writes=writes)


def far_made(deep: Perspective, found, box, exact: bool, every: str, way: int, depth: int, right: bool) -> list[Write]:
    """What far_find writes where it finds that."""
    pixels = box[3] - box[1] + box[2] - box[0]
    least = far.least_of(deep, pixels, exact)
    shift, even = far.shift_of(deep, abs(found.dqdx), every, least)
    ks = far.asymptotes(deep, found.less)
    (cu, cv), (dcu, dcv), (rest_u, rest_v) = far.starts(
        deep, ks, far.BITS_COARSE if found.coarse else far.BITS, found.less)
    texels = dict(zip(("top_u", "top_v", "bottom_u", "bottom_v"),
                      (n << far.K_BITS >> found.less for n in sum(deep.corners.texels[:2], ()))))
    bottom = depth + at_of("depth", "corners") + at_of("plane_corners", "b" if right else "a")
    writes = fields(way, "far_plan", dict(
        scale=deep.scale, less=found.less, ku=ks[0], kv=ks[1], cu=cu, cv=cv, dcu=dcu, dcv=dcv, rest_u=rest_u,
        rest_v=rest_v, **texels), {"corners": depth, "bottom": bottom})
    writes += fields(way, "far_way", dict(zip(("to_u", "to_v"), far.to_farthest(deep, ks, found.less))) | {
        "shift": shift, "even": even, "coarse": found.coarse // far.COARSE,
        "part": far.OFF_PART + (pixels + deep.corners.off + far.OFF_CORNERS << shift >> 11)})
    return [*writes, anything(way + at_of("far_way", "lengths"), 4)]


def trials() -> list[Trial]:
    rng = np.random.default_rng(31)
    found = [(vertices, sides) for vertices in polygons(rng, 260)
             if (sides := edges.measure(vertices, WIDTH, HEIGHT)) and len({v[4] for v in vertices}) > 1]
    far_ones = (far_trial(*each, bool(k % 4), tuple(far.LENGTHS)[k % len(far.LENGTHS)])
                for k, each in enumerate(found))
    return [*(depth_trial(*each) for each in found), *filter(None, far_ones)]
