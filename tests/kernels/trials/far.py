"""Trials of perspective from the far ends of lines: depths of polygons, tables of lines with planes inside the table,
the lines themselves, K and C of triangles."""

from collections.abc import Iterator

import numpy as np

from tests.helpers.kernel_checker import Memory
from tests.kernels.trials.edge import SPARE, SPLITS, side
from tests.kernels.trials.outline import at_of, embed
from tests.kernels.trials.polygon import sides_numbers, sides_pointers, wanted_sides
from tests.kernels.trials.span import FRAME, picture_ground
from tmap.base.fixed import M32, ONE
from tmap.bench import far as bench
from tmap.bench.perspective import plan_of
from tmap.bench.trial import Trial, Write, anything, fields
from tmap.build import layout
from tmap.guest.kernels import Case
from tmap.setup import far as model
from tmap.setup.edges import measure
from tmap.setup.perspective import Perspective, perspective

WIDTH, HEIGHT = 320, 200
PITCH = 1152
#: Pixels of a table's lines, as many as a frame has room for.
COUNTS = [*range(1, 20), 0, -3, *range(30, 35), 47, 48, 49, 64, 65, 100, 256, 257, 320,
          1024][:FRAME // PITCH - 1]
NAMES = ("x", "y", "q", "s", "t")  # of a corner
DEPTHS = (1.01, 1.5, 2, 3, 4, 6, 30, 1000)
ACROSS = max(COUNTS) + 4
LINES = [(k % 4, count) for k, count in enumerate(COUNTS)]
COARSE = (0, model.COARSE, 2 * model.COARSE)
MARGIN = 4000 * len(LINES)  # q grows by up to 4000 a line


def triangles(rng, count: int):
    """Planes of triangles on the screen whose w differs up to some ratio."""
    while count:
        points = [tuple(int(c) for c in rng.integers(-20 << 16, (side + 20) << 16, 3))
                  for side in (WIDTH, HEIGHT)]
        ratio = float(rng.choice(DEPTHS))
        reach = int(rng.choice((16, 128, 256))) << 16
        vertices = [(x, y, *(int(c) for c in rng.integers(-reach, reach, 2)),
                     int(65536 * ratio ** float(rng.random()))) for x, y in zip(*points)]
        sides = measure(vertices, WIDTH, HEIGHT)
        deep = sides and perspective(vertices, sides.corners, sides.box)
        if deep:
            count -= 1
            yield deep


def any_q(leftwards: bool, rng) -> tuple[int, int, int]:
    """q at the table's corner and its growth a pixel and a line: any step, from as far as it may be."""
    step = int(2.0 ** rng.uniform(0, 30)) // ACROSS + 1
    least = 1 << 29 - model.DEEP
    while step << (31 - least.bit_length() & ~1) > model.MOST:
        least *= 2
    most = (1 << 31) - 1 - ACROSS * step - MARGIN
    low = int((least + MARGIN) * 2.0 ** rng.uniform(0, np.log2(most / (least + MARGIN))))
    down = int(rng.integers(-4000, 4000))
    return (low + ACROSS * step, -step, down) if leftwards else (low, step, down)


def even_q(leftwards: bool, pixels: int, every: str, rng) -> tuple[int, int, int]:
    """The same between 2^28 and 2^30, for pieces of so many pixels everywhere."""
    most = min((model.LENGTHS[every][pixels] or 1 << 23) // 2, (3 << 28) // ACROSS - MARGIN // ACROSS * 2 - 1)
    step = int(2.0 ** rng.uniform(0, np.log2(most))) + 1
    low = int(rng.integers((1 << 28) + MARGIN, (1 << 30) - ACROSS * step - MARGIN))
    down = int(rng.integers(-4000, 4000))
    return (low + ACROSS * step, -step, down) if leftwards else (low, step, down)


def span_trial(every: str, leftwards: bool, coarse: int, rng, even: int = 0) -> Trial:
    """Any constants. ``even``: the pixels of pieces wherever they begin; 0: not even."""
    c, dc = ([int(rng.integers(-1 << bits, 1 << bits)) for bits in rng.integers(*reach, 2)]
             for reach in ((9, 31), (2, 23)))
    made = model.Constants(
        tuple(int(n) for n in rng.integers(0, 1 << 32, 2)), tuple(c), tuple(dc),
        *(even_q(leftwards, even, every, rng) if even else any_q(leftwards, rng)), 0, 0,
        every, coarse, [0, 0], even > 0)
    return bench.span_trial(Memory(int(rng.integers(1 << 30))), picture_ground(), made, LINES, PITCH, f"{made}")


def any_place(rng) -> tuple[int, ...]:
    """Where lines are, and q."""
    return (int(rng.integers(0, 1 << 31)), int(rng.integers(-2000, 2000)), int(rng.integers(0, 1 << 32)),
            *(int(n) for n in rng.integers(-1 << 31, 1 << 31, 2)))


def edges_trial(splits, exact: bool, rng) -> Trial:
    """Edges of any slopes; ``splits``: lines of each, by sides."""
    sides, where = [side(rng, split, None, exact) for split in splits], any_place(rng)
    return bench.edges_trial(Memory(int(rng.integers(1 << 30))), *sides, where, f"{sides}, {where}", SPARE)


def lines_trial(leftwards: bool, rng) -> Trial:
    """A table with any lines."""
    lines = [(int(left), int(count)) for left, count in rng.integers((-9, -3), (1100, 300), (20, 2))]
    where = any_place(rng)
    return bench.lines_trial(Memory(int(rng.integers(1 << 30))), lines, leftwards, where, f"{lines}, {where}")


def constants_trials(deep, less: int) -> Iterator[Trial]:
    """K of a triangle and, if it is near enough, C. ``less``: the bits that K lacks."""
    names = ("x", "y", "q", "s", "t")
    top, bottom, middle = (dict(zip(names, three)) for three in deep.corners.three)
    vectors = [{name: n - top[name] for name, n in other.items()} for other in (bottom, middle)]
    swapped = vectors[0]["x"] * vectors[1]["y"] < vectors[1]["x"] * vectors[0]["y"]
    shape, plan_shape = layout.load().struct("plane_corner"), layout.load().struct("far_plan").fields
    ks = model.asymptotes(deep, less)
    farthest = max(model.to_farthest(deep, ks, less)) if ks else 0
    bits = model.BITS_COARSE if less or farthest > model.REACH else model.BITS
    for kernel in ("far_asymptotes", "far_constants"):
        if kernel == "far_constants" and (not ks or farthest > model.REACH << model.COARSE + less):
            return
        memory = Memory()
        rows = [top, *(vectors[::-1] if swapped else vectors)]
        corners = memory.struct("plane_corners", {}, area=[0] * 8, x=0, y=deep.corners.y,
                                **{name: list(shape.pack(**row)) for name, row in zip(("first", "a", "b"), rows)})
        at = layout.load().struct("plane_corners").fields["b" if swapped else "a"]["offset"]
        texels = dict(zip(("top_u", "top_v", "bottom_u", "bottom_v"),
                          (n << model.K_BITS >> less for n in sum(deep.corners.texels[:2], ()))))
        given = dict(zip(("ku", "kv"), ks)) if kernel == "far_constants" else {"ku": 0, "kv": 0}
        plan = memory.struct("far_plan", dict(corners=corners, bottom=corners + at), scale=deep.scale, less=less,
                             cu=0, cv=0, dcu=0, dcv=0, rest_u=0, rest_v=0, **given, **texels)
        found = ks if kernel == "far_asymptotes" else model.starts(deep, ks, bits, less)
        made = ("ku", "kv") if kernel == "far_asymptotes" else ("cu", "cv", "dcu", "dcv", "rest_u", "rest_v")
        if found:
            flat = found if kernel == "far_asymptotes" else sum(found, [])
            writes = fields(plan, "far_plan", dict(zip(made, flat)))
        else:
            writes = [anything(plan + plan_shape[name]["offset"], 4) for name in made]
        registers = {"d0": bits} if kernel == "far_constants" else {}
        yield Trial(Case(kernel, memory, registers, {"a0": plan}), f"{deep}", {"d0": int(bool(found))}, writes=writes)


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


def far_corners(rng, count: int) -> Iterator[list[tuple[int, ...]]]:
    """Triangles whose first corner is at an end of the range of vertices, to the left or above the frame."""
    for k in range(count):
        far = (-16384 + int(rng.integers(20)), -int(rng.integers(9, 90)))[::1 if k % 2 else -1]
        points = far, (WIDTH - 9, int(rng.integers(9, HEIGHT // 2))), (int(rng.integers(9, 30)), HEIGHT - 9)
        yield [(x << 16, y << 16, *(int(c) for c in rng.integers(-4 << 16, 4 << 16, 2)), int(rng.integers(60000, 70000)))
               for x, y in points]


def depth_made(deep: Perspective, box, count: int, depth: int, plan: int) -> list[Write]:
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
        writes = (depth_made(deep, sides.box, len(vertices), depth, plan)
                  + corners_made(deep, sides.box, wanted_sides(vertices), depth + at_of("depth", "corners")))
    else:
        writes = [anything(place, layout.load().struct(name).size)
                  for place, name in ((plan, "perspective_plan"), (depth, "depth"))]
    return Trial(case, f"{vertices}", {"d0": int(deep is not None)}, writes=writes)


def texels_trial(vertices, sides) -> Trial | None:
    """The planes of s and t of a polygon; None without perspective."""
    deep = perspective(vertices, sides.corners, sides.box)
    if not deep:
        return None
    memory, wanted = Memory(), wanted_sides(vertices)
    plan, depth = memory.room("perspective_plan"), memory.room("depth")
    made = [write for write in (*depth_made(deep, sides.box, len(vertices), depth, plan),
                                *corners_made(deep, sides.box, wanted, depth + at_of("depth", "corners")))
            if write.at >= depth]
    for write in made:
        memory.data[write.at:write.at + len(write.expected)] = write.expected
    case = Case("perspective_texels", memory, pointers={"a0": plan, "a1": depth})
    if not deep.is_sure:
        return Trial(case, f"{vertices}", {"d0": 0}, writes=[])
    number = lambda n: (n & (1 << 64) - 1).to_bytes(8, "big")  # noqa: E731
    writes = [Write(plan + at_of("perspective_plan", plane) + at_of("screen_plane", name),
                    number(getattr(getattr(deep, plane), name))) for plane in "st" for name in ("at", "dx", "dy")]
    writes += fields(plan, "perspective_plan", {"gentle": deep.gentle}) + fields(depth, "depth", {"has_texels": 1})
    return Trial(case, f"{vertices}", {"d0": 1}, writes=writes)


def find_trial(vertices, sides, exact: bool, every: str) -> Trial | None:
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
    asked = "pixel" if every == "tolerance" else setting
    for name, value in (("edges", constants["EDGES_EXACT" if exact else "EDGES_SUBPIXEL"]),
                        ("perspective", constants[f"PERSPECTIVE_{asked.upper()}"])):
        memory.data[material + at_of("material", name)] = value
    setup = setup_of(memory, vertices, sides.box, plan, {"material": material})
    place_number(memory, setup, "setting", constants[f"PERSPECTIVE_{setting.upper()}"])
    count = setup + at_of("setup", "span") + at_of("span_plan", "count")
    memory.data[count:count + 4] = (sides.box[3] - sides.box[1]).to_bytes(4, "big")
    way = memory.room("far_way")
    case = Case("far_find", memory, pointers={"a0": way, "a1": setup, "d0": depth})
    found = model.find(deep, every, sides.box, exact)
    if not found:
        writes = [anything(way, layout.load().struct("far_way").size)]
    else:
        writes = find_made(deep, found, sides.box, exact, every, way, depth, right)
    return Trial(case, f"{every}, exact {exact}, {vertices}", {"d0": int(found is not None)}, writes=writes)


def find_made(deep: Perspective, found, box, exact: bool, every: str, way: int, depth: int, right: bool) -> list[Write]:
    """What far_find writes where it finds that."""
    pixels = box[3] - box[1] + box[2] - box[0]
    least = model.least_of(deep, pixels, exact)
    shift, even = model.shift_of(deep, abs(found.dqdx), every, least)
    ks = model.asymptotes(deep, found.less)
    (cu, cv), (dcu, dcv), (rest_u, rest_v) = model.starts(
        deep, ks, model.BITS_COARSE if found.coarse else model.BITS, found.less)
    texels = dict(zip(("top_u", "top_v", "bottom_u", "bottom_v"),
                      (n << model.K_BITS >> found.less for n in sum(deep.corners.texels[:2], ()))))
    bottom = depth + at_of("depth", "corners") + at_of("plane_corners", "b" if right else "a")
    writes = fields(way, "far_plan", dict(
        scale=deep.scale, less=found.less, ku=ks[0], kv=ks[1], cu=cu, cv=cv, dcu=dcu, dcv=dcv, rest_u=rest_u,
        rest_v=rest_v, **texels), {"corners": depth, "bottom": bottom})
    writes += fields(way, "far_way", dict(zip(("to_u", "to_v"), model.to_farthest(deep, ks, found.less))) | {
        "shift": shift, "even": even, "coarse": found.coarse // model.COARSE,
        "part": model.OFF_PART + (pixels + deep.corners.off + model.OFF_CORNERS << shift >> 11)})
    return [*writes, anything(way + at_of("far_way", "lengths"), 4)]


def far_span_trial(vertices, sides, exact: bool, every: str) -> Trial | None:
    """The span of a polygon whose lines are drawn from their far ends; None if they are not."""
    deep = perspective(vertices, sides.corners, sides.box)
    found = deep and model.find(deep, every, sides.box, exact)
    if not found:
        return None
    memory, constants = Memory(), layout.load().constants
    plan = plan_of(memory, deep, "every16", 1, dict(lines=0, to=0))
    table, count = bench.table(memory), sides.box[3] - sides.box[1]
    lengths, texels = bench.lengths(memory, every), memory.add(bytes(4), name="map")
    renderer = memory.room("renderer")
    setup = setup_of(memory, vertices, sides.box, plan, {"renderer": renderer})
    for struct, name, value in ((renderer, ("renderer", "reciprocals"), table),
                                (setup, ("setup", "span", "span_plan", "map"), texels)):
        place = struct + sum(at_of(*pair) for pair in zip(name[::2], name[1::2]))
        memory.data[place:place + 4] = value.to_bytes(4, "big")
        memory.pointers.append(place)
    place_number(memory, setup, "setting", constants["PERSPECTIVE_EVERY16" if every == "every16" else
                                                     "PERSPECTIVE_EVERY8"])
    at = setup + at_of("setup", "span") + at_of("span_plan", "count")
    memory.data[at:at + 4] = count.to_bytes(4, "big")
    way, depth, span = memory.room("far_way"), memory.room("depth"), memory.room("far_span")
    place = depth + at_of("depth", "down")
    memory.data[place:place + 4] = deep.corners.down.to_bytes(4, "big")
    for write in find_made(deep, found, sides.box, exact, every, way, depth, False):
        memory.data[write.at:write.at + len(write.expected)] = write.expected
    place = way + at_of("far_way", "lengths")
    memory.data[place:place + 4] = lengths.to_bytes(4, "big")
    memory.pointers += [place, *(way + at_of("far_plan", name) for name in ("corners", "bottom"))]
    values = bench.plan_fields(found) | {"count": count}
    if not found.even:
        del values["from_8"], values["from_16"]
    writes = fields(span, "far_span", values, {"map": texels, "table": table, "lengths": lengths}
                    | ({"ends": table + 2 * found.ahead} if found.even else {}))
    case = Case("far_span_find", memory, pointers={"a0": span, "a1": setup, "d0": depth, "d1": way})
    return Trial(case, f"{every}, exact {exact}, {vertices}", writes=writes)


def depth_trials(rng) -> Iterator[Trial]:
    """Depths of polygons, and how they are drawn."""
    found = [(vertices, sides) for vertices in (*polygons(rng, 260), *far_corners(rng, 24))
             if (sides := measure(vertices, WIDTH, HEIGHT)) and len({v[4] for v in vertices}) > 1]
    for k, each in enumerate(found):
        yield depth_trial(*each)
        if texels := texels_trial(*each):
            yield texels
        if far := find_trial(*each, bool(k % 4), tuple(model.LENGTHS)[k % len(model.LENGTHS)]):
            yield far
        if span := far_span_trial(*each, bool(k % 4), tuple(model.LENGTHS)[k % len(model.LENGTHS)]):
            yield span


def trials() -> list[Trial]:
    rng = np.random.default_rng(24)
    ways = [(every, leftwards) for every in model.LENGTHS for leftwards in (False, True)]
    return [*(span_trial(*way, coarse, rng) for way in ways for coarse in COARSE for _ in range(16)),
            *(span_trial(every, leftwards, coarse, rng, even) for every, leftwards in ways
              for coarse in COARSE for even in (4, 8, 16) for _ in range(6)),
            *(edges_trial(splits, exact, rng) for splits in SPLITS for exact in (False, True) for _ in range(3)),
            *(lines_trial(leftwards, rng) for leftwards in (False, True) for _ in range(8)),
            *(trial for deep in triangles(rng, 60) if deep.scale < model.K_SCALE
              for less in (0, model.COARSE) for trial in constants_trials(deep, less)),
            *depth_trials(rng)]
