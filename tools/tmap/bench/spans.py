"""Calls of spans from a page, and what the calls of all spans share: tables of lines, what they are
drawn on and from, what they show. Bench rows have lines of one length.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from tmap.base import maps
from tmap.bench.trial import Trial, Write, both
from tmap.build import layout
from tmap.corpus import random_maps
from tmap.guest.kernels import Arena, Case
from tmap.setup.level import wraps
from tmap.setup.scanline import add_span_plan, pack
from tmap.setup.texturing import CUT

DU, DV = 0x18000, 0x14000  # texels a pixel, 16.16
LENGTHS = (256, 64, 16, 4)  # pixels
#: Rows at each of LENGTHS: a span's name, and how its lines are packed.
SPANS = (("affine_addx", "addx"), ("affine_addx_wrap", "addx"), ("affine_scanline", "addx"),
         ("affine_16_scanline", "addx"), ("affine_32_scanline", "addx"), ("affine_upright", "addx"),
         ("affine_level", "addx"), ("affine_16_level", "addx"),
         ("affine_32_level", "addx"), ("affine_level_upright", "addx"),
         ("affine_swap", "plain"), ("affine_c", "plain"), ("tiled", "plain"), ("columns", "plain"),
         ("columns_16", "plain"), ("fill", "flat"), ("fill_16", "flat"), ("keyed", "addx"),
         ("keyed_wrap", "addx"))
#: Of the spans for short lines and of the copying one: kernel, steps, lengths.
SPECIAL = (("affine_copy", 1 << 16, 0, (256, 64, 16, 4, 1)), ("affine_short", DU, DV, (16, 4, 1)),
           ("affine_short_wrap", DU, DV, (16, 4, 1)), ("affine_row_short", DU, 0, (24, 16, 4, 1)))
BIAS = 16384  # what struct scanline adds to columns: EDGE_BIAS
COLOUR = 0x5C  # of spans without a map
GAP = 4  # pixels from a line's last to the next one's first place: lines begin 0 to 3 pixels on
#: Structs in the blocks that a span_plan points at.
SHAPES = {"lines": "scanline", "steps": "scanline_step", "columns": "column_layout"}

PIXELS = np.arange(1024, dtype=np.int64)
Line = tuple[int, int, int, int]  # first column, pixels, u, v; nothing is drawn of 0 pixels and less


@dataclass(frozen=True)
class Ground:
    """What spans are drawn on and from: a far arena, where its frame and its map begin, and the map's
    picture, [v][u], whose pixels have the frame's size."""

    arena: Arena
    frame_at: int
    map_at: int
    picture: np.ndarray


def framed(far: Arena, map_at: int, picture: np.ndarray, lines: int, length: int) -> Ground:
    """A bench row's: a frame of zeros is added, of so many lines of one length."""
    return Ground(far, far.add(bytes(lines * (length + GAP) * picture.itemsize)), map_at, picture)


def line_count(length: int) -> int:
    """Lines of a row: so many that a call draws 2,048 pixels, but 16 to 128."""
    return min(128, max(16, 2048 // length))


def table_of(lines: list[dict[str, int]]) -> bytes:
    """A table of struct scanline with the fields given, the others 0."""
    dtype = layout.load().struct("scanline").dtype
    rows = [tuple(line.get(name, 0) for name in dtype.names) for line in lines]
    return np.array(rows, dtype).tobytes()


def texels(picture: np.ndarray, u, v, dudx: int, dvdx: int, count: int, cut=(0, 0),
           chained: bool = False) -> np.ndarray:
    """What a line shows of a map that repeats; ``cut``: how many bits of u and v are dropped; ``chained``: v's wraps
    change u."""
    n = PIXELS[:count] if count <= len(PIXELS) else np.arange(count, dtype=np.int64)
    if chained:
        u = u + wraps(v, dvdx, n)
    x, y = ((c >> bits) + n * (step >> bits) >> 16 - bits for c, step, bits in zip((u, v), (dudx, dvdx), cut))
    return picture[y % len(picture), x % picture.shape[1]]


def table_trial(kernel: str, form: str, lines: list[Line], pitch: int, arena: Arena, ground: Ground,
                drawn: Callable[..., np.ndarray], title: str = "", *, upwards: bool = False,
                used: list[int] | None = None, blocks: dict[str, bytes] = {}, code: bytes | None = None,
                far: dict[str, int] = {}, **values: int) -> Trial:
    """One table of lines. ``pitch``: in pixels; ``drawn``: the pixels of a line, of its number, its
    place in the ground's arena and what it has; ``used``: of each line what is in the room of v--U, where the form has some. The plan
    has ``values`` and points at ``blocks`` and ``far``; ``code`` is what the routine leaves at the end
    of its plan's, but for 2 bytes."""
    wide, entries, places = ground.picture.itemsize, [], []
    for k, (column, count, u, v) in enumerate(lines):
        entry = pack(form, u, v) | {"left": BIAS + column, "last": BIAS + column + count - 1}
        if used and form == "addx":
            entry["start2"] |= used[k] << 8
        entries.append(entry)
        row = len(lines) - 1 - k if upwards else k
        places.append(ground.frame_at + (row * pitch + column) * wide)
    shapes = layout.load()
    near = {}
    for name, content in ({"lines": table_of(entries)} | blocks).items():
        shape = shapes.struct(SHAPES[name]) if name in SHAPES else None
        near[name] = arena.add(content, name=name, shape=shape)
    if code is not None:
        size = shapes.constants["CODE_BYTES"]
        near["code"] = arena.blank(size, "code")
    row = places[0] - (BIAS + lines[0][0]) * wide
    plan = add_span_plan(arena, near, {"row": row, "map": ground.map_at} | far, count=len(lines),
                         pitch=(-pitch if upwards else pitch) * wide, **values)

    def where(offset: int, is_far: bool) -> str | None:
        ends = [at + max(count, 0) * wide for at, (_, count, *_) in zip(places, lines)]
        index = min(range(len(lines)), key=lambda k: max(places[k] - offset, offset - ends[k] + 1))
        at, (column, count, u, v) = places[index], lines[index]
        if not is_far or not at - pitch * wide <= offset < ends[index] + pitch * wide:
            return None
        line = f"line {index} (left {BIAS + column}, count {count}, u {both(u)}, v {both(v)})"
        if count <= 0:
            return f"{line}: byte {offset - at}"
        if offset < at:
            return f"{line}: {at - offset} byte(s) before its start"
        beyond = offset - ends[index] + 1
        return f"{line}: {beyond} byte(s) past its end" if beyond > 0 else \
            f"{line}: pixel {(offset - at) // wide}"

    writes = [Write(at, drawn(k, at, *line).tobytes(), far=True)
              for k, (at, line) in enumerate(zip(places, lines)) if line[1] > 0]
    if code:
        writes.append(Write(near["code"] + size - 2 - len(code), code))
    return Trial(Case(kernel, arena, pointers={"a0": plan}, far=ground.arena), title, writes=writes,
                 where=where)


def columns_of(width: int, height: int) -> dict[str, int]:
    """struct column_layout of a map."""
    v_mask = (height - 1) << 2
    return dict(v_bits=height.bit_length() - 1, u_mask=width * height - 1 ^ v_mask, v_mask=v_mask)


def span_trial(kernel: str, form: str, lines: list[Line], pitch: int, arena: Arena, ground: Ground,
               title: str = "", *, dudx: int, dvdx: int, colour: int = 0,
               own_steps: list[tuple[int, int]] | None = None, **more) -> Trial:
    """One table of a span from a page, tiles or columns, or of one colour. ``own_steps``: of each line,
    which are read instead of the plan's."""
    picture, shapes, blocks = ground.picture, layout.load(), {}
    cut = CUT.get(kernel.split("_")[1], (0, 0))
    if own_steps:
        shape = shapes.struct("scanline_step")
        blocks["steps"] = b"".join(shape.pack(dudx=du, dvdx=dv) for du, dv in own_steps)
    if "columns" in kernel:
        blocks["columns"] = shapes.struct("column_layout").pack(**columns_of(*picture.shape[::-1]))

    def drawn(k: int, at: int, _: int, count: int, u: int, v: int) -> np.ndarray:
        if kernel.startswith("span_fill"):
            return np.full(count, colour & (1 << 8 * picture.itemsize) - 1, picture.dtype)
        steps = own_steps[k] if own_steps else (dudx, dvdx)
        seen = texels(picture, u, v, *steps, count, cut, kernel.endswith("_level"))
        if "keyed" in kernel and (not kernel.endswith("_rows") or more.get("used", [0] * len(lines))[k] & 1):
            return np.where(seen, seen, np.frombuffer(ground.arena.data, np.uint8, count, at))
        return seen

    return table_trial(kernel, form, lines, pitch, arena, ground, drawn, title, blocks=blocks,
                       dudx=dudx, dvdx=dvdx, colour=colour, **more)


def upright_trial(kernel: str, lines: list[Line], pitch: int, arena: Arena, ground: Ground,
                  steps: list[tuple[int, int]], title: str = "") -> Trial:
    """One table of columns, one beside the other, each with its ``steps``. A line's first column is the row of
    the frame where it begins; ``pitch``: in bytes."""
    shapes, entries, writes = layout.load(), [], []
    for k, ((row, count, u, v), step) in enumerate(zip(lines, steps)):
        entries.append(pack("addx", u, v) | {"left": BIAS + row, "last": BIAS + row + count - 1})
        seen = texels(ground.picture, u, v, *step, max(count, 0), chained="level" in kernel)
        writes += [Write(ground.frame_at + k + (row + j) * pitch, seen[j:j + 1].tobytes(), far=True)
                   for j in range(max(count, 0))]
    shape = shapes.struct("scanline_step")
    near = {"lines": arena.add(table_of(entries), name="lines", shape=shapes.struct("scanline")),
            "steps": arena.add(b"".join(shape.pack(dudx=du, dvdx=dv) for du, dv in steps), name="steps",
                               shape=shape)}
    plan = add_span_plan(arena, near, {"row": ground.frame_at - BIAS * pitch, "map": ground.map_at},
                         count=len(lines), pitch=pitch)
    return Trial(Case(kernel, arena, pointers={"a0": plan}, far=ground.arena), title, writes=writes)


def wide_texture(kernel: str) -> np.ndarray:
    """A page with as many bytes a texel as the kernel's name says, big-endian."""
    picture = random_maps.page()
    for bits, shifts in (("16", (8,)), ("32", (8, 16, 24))):
        if bits in kernel.split("_"):
            wide = sum(picture.astype(int) << shift for shift in shifts) | picture.T
            return wide.astype(f">u{int(bits) // 8}")
    return picture


def add_map(far: Arena, kernel: str, picture: np.ndarray) -> int:
    """Adds a map as a kernel wants it; where the kernel's pointer goes."""
    stored = maps.to_tiled(picture) if "tiled" in kernel else \
        maps.to_columns(picture) if "columns" in kernel else maps.to_page(picture)
    map_at = far.add(stored.tobytes(), layout.load().constants["ARENA_ALIGN"])
    return map_at + stored.nbytes // 2 if picture.itemsize > 1 and "affine" in kernel else map_at


def span_case(kernel: str, form: str, length: int, du: int = DU, dv: int = DV, lines: int = 0):
    """A table of spans of one length; v wraps once in a long one. ``lines``: or line_count's."""
    rng = np.random.default_rng(length)
    lines = lines or line_count(length)
    far, picture = Arena(), wide_texture(kernel)
    ground = framed(far, add_map(far, kernel, picture), picture, lines, length)
    starts = [(k % 4, length, int(rng.integers(0, 1 << 24)) & ~1, int(rng.integers(0, 190 << 16)))
              for k in range(lines)]
    steps = [(du, dv)] * lines if kernel.endswith(("scanline", "level", "upright")) else None
    if kernel.endswith("upright"):
        return upright_trial(kernel, starts, lines, Arena(), ground, steps).row(lines * length)
    return span_trial(kernel, form, starts, length + GAP, Arena(), ground, dudx=du, dvdx=dv,
                      colour=COLOUR, own_steps=steps).row(lines * length)
