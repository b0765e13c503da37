"""The work of each bench row: what is called, on what memory, and what must come out.

Every row checks its own pixels: a loop that draws something else is not measured.
Conditions: DMA and interrupts off, instruction cache warm; 256x256 8-bit map,
du 1.5 and dv 1.25 texels a pixel, 16 fraction bits, u and v both wrap.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from . import (bench_instructions, bench_logarithm, bench_perspective, bench_reciprocal, bench_screen,
               bench_tmu, bench_tx, layout, maps, model)
from .bench_dithered import dithered_rows
from .bench_effects import LIT, ROTATORS, SCREEN, lit_case, rotator_case, shade_case
from .bench_mappers import first_difference, mapper_case
from .bench_mesh import CASES as MESH_CASES
from .kernels import M32, Arena, Case, Result
from .scanline import MASKS, add_span_plan, pack, rounded_edge

DU, DV = 0x18000, 0x14000  # texels a pixel, 16.16
DC = 0x00A00  # shade a pixel, 16.16
SPAN_LENGTHS = (256, 64, 16, 4)
#: Of the spans for short lines and of the copying one: kernel, steps, lengths.
SPECIAL = (("affine_copy", 1 << 16, 0, (256, 64, 16, 4, 1)), ("affine_short", DU, DV, (16, 4, 1)),
           ("affine_short_wrap", DU, DV, (16, 4, 1)), ("affine_row_short", DU, 0, (24, 16, 4, 1)))
EDGE_LINES = 64


@dataclass
class Row:
    """One measured row: ``units`` pixels (or steps, lines, points) are drawn by one call.

    ``check`` gives an error text, or None when the result is right.
    """

    name: str
    length: int
    units: int
    case: Case
    check: Callable[[Result], str | None]


def texture() -> np.ndarray:
    """A 256x256 map of noise: a wrong texel is seen with 255 chances in 256."""
    return np.random.default_rng(256).integers(0, 256, (256, 256), dtype=np.uint8)


def wide_texture(kernel: str) -> np.ndarray:
    """The same with as many bytes a texel as the kernel's name says, big-endian."""
    picture = texture()
    for bits, shifts in (("16", (8,)), ("32", (8, 16, 24))):
        if bits in kernel.split("_"):
            wide = sum(picture.astype(int) << shift for shift in shifts) | picture.T
            return wide.astype(f">u{int(bits) // 8}")
    return picture


def span_case(kernel: str, form: str, length: int, du: int = DU, dv: int = DV, lines: int = 0):
    """A table of spans of one length; starts such that v wraps once in a long one."""
    rng = np.random.default_rng(length)
    lines = lines or min(128, max(16, 2048 // length))
    pitch = length + 4  # bytes from line to line: each line begins 0 to 3 bytes on
    constants = layout.load().constants
    arena, far, picture = Arena(), Arena(), wide_texture(kernel)
    size = picture.itemsize
    stored = maps.to_tiled(picture) if "tiled" in kernel else \
        maps.to_columns(picture) if "columns" in kernel else maps.to_page(picture)
    map_at = far.add(stored.tobytes(), constants["ARENA_ALIGN"])
    if size > 1 and "affine" in kernel:
        map_at += stored.nbytes // 2
    entries = np.zeros(lines, layout.load().struct("scanline").dtype)
    starts = []
    for k in range(lines):
        u, v = int(rng.integers(0, 1 << 24)) & ~1, int(rng.integers(0, 190 << 16))
        starts.append((u, v))
        for field, value in pack(form, u, v).items():
            entries[k][field] = value
        entries[k]["left"] = constants["EDGE_BIAS"] + k % 4
        entries[k]["last"] = entries[k]["left"] + length - 1
    pointers = dict(lines=arena.add(entries.tobytes()))
    if "scanline" in kernel:
        pointers["steps"] = arena.add(layout.load().struct("scanline_step").pack(
            dudx=du, dvdx=dv) * lines)
    if "columns" in kernel:
        pointers["columns"] = arena.struct("column_layout", {}, v_bits=8, u_mask=0xFC03,
                                           v_mask=0x3FC)
    frame_at = far.add(bytes(pitch * lines * size))
    plan_at = add_span_plan(
        arena, pointers, dict(row=frame_at - constants["EDGE_BIAS"] * size, map=map_at),
        count=lines, pitch=pitch * size, dudx=du, dvdx=dv, colour=0x5C)
    expected = np.zeros((lines, pitch), picture.dtype)
    n = np.arange(length)
    for k, (u, v) in enumerate(starts):
        texels = picture[(v + n * dv) >> 16 & 255, (u + n * du) >> 16 & 255]
        expected[k, k % 4:k % 4 + length] = 0x5C if "fill" in kernel else texels

    def check(result: Result) -> str | None:
        found = np.frombuffer(result.far_memory, picture.dtype, expected.size, frame_at)
        return first_difference(expected, found.reshape(expected.shape))

    return lines * length, Case(kernel, arena, pointers={"a0": plan_at}, far=far), check


def edge_case(name: str):
    """One section of EDGE_LINES lines: left slope -0.7, right slope 1.3 pixels a line."""
    form, exact = name.split("_")[1], name.endswith("_exact")
    form = "plain" if form == "swap" else form
    shapes = layout.load()
    bias, shape = shapes.constants["EDGE_BIAS"], shapes.struct("scanline")
    arena = Arena()
    table_at = arena.add(bytes(shape.size * EDGE_LINES))
    height = 1 << 22  # 64 lines; x is in units of height pixels
    ratios = -45875 * height // 65536, 85197 * height // 65536
    n = range(EDGE_LINES)
    slopes = (-45875, 85197)
    starts = (100 + bias) * 65536 + 12345, (110 + bias) * 65536 + 54321
    sides, columns = [], []
    for x, slope, ratio in zip(starts, slopes, ratios):
        edge = rounded_edge(EDGE_LINES, x, slope)
        if exact:
            first = x * height >> 16
            edge |= {"x": -(-first // height), "error": ~(-first % height) & M32,
                     "whole": ratio // height, "part": ratio % height, "height": height}
            columns.append([-(-(first + k * ratio) // height) for k in n])
        else:
            columns.append([(x + k * slope + 0xFFFF) >> 16 for k in n])
        sides.append(edge)
    whole = sides[0]["whole"]
    du, dv = -DV + whole * DU, DU + whole * DV  # a line and the whole pixels
    left_at, right_at = (arena.struct("edge", {}, **edge | {
        "u": 100 << 16, "v": 50 << 16, "du": du, "dv": dv}) for edge in sides)
    plan_at = arena.struct("edge_plan", dict(lines=table_at, left=left_at, right=right_at),
                           lefts=1, rights=1, dudx=DU, dvdx=DV)

    def check(result: Result) -> str | None:
        found = np.frombuffer(result.memory, shape.dtype, EDGE_LINES, table_at)
        for k, (left, right) in enumerate(zip(*columns)):
            moved = left - columns[0][0]
            wanted = {"left": left, "last": right - 1} | pack(
                form, (100 << 16) - k * DV + moved * DU, (50 << 16) + k * DU + moved * DV)
            for field, value in wanted.items():
                if (int(found[k][field]) ^ value) & MASKS[form].get(field, M32):
                    return f"line {k}: {field} is {found[k][field]}, expected {value}"
        return None

    return EDGE_LINES, Case(name, arena, pointers={"a0": plan_at}), check


def ramp_case():
    """EDGE_LINES lines of 10 pixels and more, sub-texel starts, packed."""
    shapes = layout.load()
    bias, shape = shapes.constants["EDGE_BIAS"], shapes.struct("scanline")
    arena, ramp = Arena(), shapes.struct("ramp")
    steps = {"dx": 0x4321, "du": 0x1234, "dv": -0x2345}
    starts = [dict(zip("xuv", (n << 16 for n in side))) for side in ((100, 20, 30), (110, 200, 90))]
    points = [[tuple(start[k] + n * steps["d" + k] for k in "xuv") for n in range(EDGE_LINES)]
              for start in starts]
    table = np.zeros(EDGE_LINES, shape.dtype)
    lines = []
    for entry, left, right in zip(table, *points):
        line = model.Line(model.ceil16(left[0]), model.ceil16(right[0]))
        entry["left"], entry["last"] = line.left + bias, line.right - 1 + bias
        model.scanline_line(line, left, right, truncated=False)
        lines.append(line)
    table_at = arena.add(table.tobytes())
    # A call uses the ramps up and the next one runs on from there: with the same steps
    # on both sides, at the same cost.
    ramps = [arena.add(ramp.pack(lines=EDGE_LINES, **start, **steps)) for start in starts]
    steps_at = arena.add(bytes(8 * EDGE_LINES))
    plan_at = arena.struct("ramp_plan", dict(lines=table_at, left=ramps[0], right=ramps[1],
                                             steps=steps_at),
                           count=EDGE_LINES, truncated=0, packed=1)

    def check(result: Result) -> str | None:
        found = np.frombuffer(result.memory, shape.dtype, EDGE_LINES, table_at)
        made = np.frombuffer(result.memory, ">i4", 2 * EDGE_LINES, steps_at).reshape(-1, 2)
        for k, line in enumerate(lines):
            for field, value in pack("addx", line.u, line.v).items():
                if (int(found[k][field]) ^ value) & MASKS["addx"][field]:
                    return f"line {k}: {field} is {found[k][field]}, expected {value}"
            if (made[k] != [model.signed(line.dudx), model.signed(line.dvdx)]).any():
                return f"line {k}: steps {made[k]}, expected {line.dudx}, {line.dvdx}"
        return None

    return EDGE_LINES, Case("edge_ramp", arena, pointers={"a0": plan_at}), check


def step_case(form: str, count: int):
    """1,024 steps of ``count`` interpolants; the registers tell whether they were right."""
    steps = 1024
    values = [(3 + k) * 65536 + 0x1234 * (k + 1) for k in range(count)]
    speeds = [65536 * k + 0x9876 + 0x321 * k for k in range(count)]

    def swapped(x: int) -> int:
        return (x << 16 | x >> 16) & M32

    if form == "chain":  # each fraction above the integer of the one before it
        fractions = lambda xs: [(xs[k] & 0xFFFF) << 16 | xs[k - 1] >> 16 for k in range(count)]
        start, step = fractions(values), fractions(speeds)
        ends = [x + steps * s for x, s in zip(values, speeds)]
        late = values[-1] + (steps - 1) * (speeds[-1] & 0xFFFF) >> 16
        end = fractions(ends)
        end[0] = (ends[0] & 0xFFFF) << 16 | late + steps * (speeds[-1] >> 16)
    else:
        turn = swapped if form == "addx" else (lambda x: x)
        start, step = map(turn, values), map(turn, speeds)
        end = [turn(x + steps * s & M32) for x, s in zip(values, speeds)]
    registers = {f"d{k}": v for k, v in enumerate(start)}
    registers |= {f"d{k + 3}": v for k, v in enumerate(step)}
    registers |= {"d6": 0, "d7": steps // 16 - 1}

    def check(result: Result) -> str | None:
        found = [result.registers[f"d{k}"] for k in range(count)]
        return None if found == end else f"expected {end}, found {found}"

    return steps, Case(f"step_{form}_{count}", registers=registers), check


def pixel_case(form: str, count: int, length: int = 256):
    """One line of whole pixels: row, map, or map and table of shades."""
    rng = np.random.default_rng(count)
    picture, shades = texture(), rng.integers(0, 256, (256, 256), dtype=np.uint8)
    far = Arena()
    map_at = far.add(picture.tobytes(), 65536)
    table_at = far.add(shades.tobytes(), 65536)
    out_at = far.add(bytes(length))
    u, v, c = 0x123456, 0x456788, 0x105678
    n = np.arange(length)
    du = DU if count > 1 else 0xF800
    registers, pointers = {}, {"a1": out_at, "a6": out_at + length}
    if count == 1:
        expected = picture.reshape(-1)[(u + n * du) >> 16]
        if form == "swap":
            registers = {"d0": u, "d2": du}
        else:
            registers = {"d0": u << 16 & M32 | u >> 16, "d2": du << 16 & M32 | du >> 16}
            expected = picture.reshape(-1)[late_carry(u, du, length)]
        pointers["a0"] = map_at
    else:
        texels = picture[(v + n * DV) >> 16 & 255, (u + n * DU) >> 16 & 255]
        expected = texels if count == 2 else shades[(c + n * DC) >> 16 & 255, texels]
        registers, more = pixel_registers(form, count, u, v, c, map_at, table_at)
        pointers |= more

    def check(result: Result) -> str | None:
        found = np.frombuffer(result.far_memory, np.uint8, length, out_at)
        return first_difference(expected[None], found[None])

    return length, Case(f"pixel_{form}_{count}", registers=registers, far=far,
                        far_pointers=pointers), check


def late_carry(u: int, du: int, length: int) -> list[int]:
    """Integers of a self-chained register: its carry counts one step later."""
    whole, fraction, carry, out = u >> 16, u & 0xFFFF, 0, []
    for _ in range(length):
        out.append(whole)
        total = fraction + (du & 0xFFFF)
        whole, fraction, carry = whole + (du >> 16) + carry, total & 0xFFFF, total >> 16
    return out


def pixel_registers(form: str, count: int, u: int, v: int, c: int, map_at: int, table_at: int):
    """Registers and pointers of the pixels with two and three interpolants."""
    if form == "swap":
        registers = {"d0": u, "d1": (v << 8) ^ 1 << 31, "d2": DU, "d3": DV << 8, "d7": 0xFFFFFF}
        pointers = {"a0": map_at + 32768}
        if count == 3:
            registers |= {"d5": (c << 8) ^ 1 << 31, "a4": DC << 8}
            pointers |= {"a3": table_at + 32768}
        return registers, pointers
    first = [u << 16 & M32 | v >> 8 & 0xFFFF, u >> 16 & 255]
    step = [DU << 16 & M32 | DV >> 8 & 0xFFFF, DU >> 16 & 255]
    if count == 2:  # A's v one step ahead; these numbers make no carry of it at the start
        first[1] |= (v + DV & 0xFF) << 24
        step[1] |= (DV & 0xFF) << 24
        return dict(zip(("d0", "d1", "d2", "d3"), first + step)), {"d4": map_at}
    first += [(v + DV & 0xFF) << 24 | c >> 8 & 0xFFFF]
    step += [(DV & 0xFF) << 24 | DC >> 8 & 0xFFFF]
    first[1] |= (c & 0xFF) << 24
    step[1] |= (DC & 0xFF) << 24
    return dict(zip(("d0", "d1", "d2", "d3", "d4", "d5"), first + step)), \
        {"d6": map_at, "d7": table_at}


def floor_case(name: str, length: int = 1024):
    """Memory alone: one byte fetched, stored, or both, for each pixel."""
    far = Arena()
    source_at = far.add(b"\x5c" * 4)
    out_at = far.add(bytes(length))

    def check(result: Result) -> str | None:
        found = result.far_memory[out_at:out_at + length]
        return None if name == "fetch" or found == b"\x5c" * length else "bytes were not stored"

    return length, Case(f"floor_{name}", registers={"d0": 0x5C, "d7": length // 16 - 1},
                        far=far, far_pointers={"a0": source_at, "a1": out_at}), check


def special_rows() -> list[Row]:
    """The spans of special cases; what ends in _once draws a table of one pixel."""
    rows = [Row(name, length, *span_case(f"span_{name}", "addx", length, du, dv))
            for name, du, dv, lengths in SPECIAL for length in lengths]
    rows += [Row(f"{name}_once", 1, *span_case(f"span_{name}", "addx", 1, lines=1))
             for name in ("affine_addx", "affine_short")]
    rows += [Row("gouraud_short", n, *mapper_case("gouraud_short", n)) for n in (48, 16, 4, 1)]
    return rows + [Row(f"affine_{name}", n, *lit_case(f"span_{name}", n))
                   for name in ("lit_short", "lit_short_wrap") for n in (12, 4, 1)]


def wide_rows(length: int) -> list[Row]:
    """The spans with texels of 16 and 32 bits."""
    steps = {"": (DU, DV), "_wrap": (DU, DV), "_row": (DU, 0), "_copy": (1 << 16, 0)}
    names = {f"affine_{bits}{kind}": pair for bits in (16, 32) for kind, pair in steps.items()
             if (bits, kind) != (32, "_copy")}
    return [Row("fill_32", length, *span_case("span_fill_32", "flat", length))] + [
        Row(name, length, *span_case(f"span_{name}", "addx", length, *pair))
        for name, pair in names.items()]


def placed(rows: list[Row], chip: bool) -> list[Row]:
    """The rows, with their data in chip RAM or not."""
    for row in rows:
        row.case.chip = chip
    return rows


def pixel_rows(chip: bool) -> list[Row]:
    """All rows counted in pixels (or steps of one pixel)."""
    rows = []
    for length in SPAN_LENGTHS:
        for name, form in (("affine_addx", "addx"), ("affine_addx_wrap", "addx"),
                           ("affine_scanline", "addx"), ("affine_swap", "plain"),
                           ("affine_c", "plain"), ("tiled", "plain"), ("columns", "plain"),
                           ("columns_16", "plain"), ("fill", "flat"), ("fill_16", "flat")):
            rows.append(Row(name, length, *span_case(f"span_{name}", form, length)))
        rows += wide_rows(length)
        rows += [Row(*row) for row in dithered_rows(length)]
        rows.append(Row("affine_row", length, *span_case("span_affine_row", "addx", length, dv=0)))
        rows.append(Row("affine_column", length,
                        *span_case("span_affine_column", "addx", length, du=0)))
        for name in ("gouraud", "arbitrary", "generated"):
            rows.append(Row(name, length, *mapper_case(name, length)))
        for name, (setting, ratio) in bench_perspective.SPANS.items():
            rows.append(Row(name, length, *bench_perspective.span_case(setting, ratio, length)))
        for name, m in bench_reciprocal.SPANS.items():
            rows.append(Row(name, length, *bench_reciprocal.span_case(m, length)))
        rows.append(Row("persp_pixel", length, *bench_logarithm.span_case(length)))
        rows.append(Row("arbitrary_row", length, *mapper_case("arbitrary", length, dv=1 << 16)))
        rows += [Row(name, length, *lit_case(kernel, length)) for name, kernel in LIT.items()]
    rows += special_rows()
    rows += [Row(name, SCREEN[0], *rotator_case(*how)) for name, how in ROTATORS.items()]
    # One line: written, flushed and drawn once.
    rows.append(Row("generated_once", 1024, *mapper_case("generated", 1024, lines=1)))
    for count in (1, 2, 3):
        for form in ("swap", "addx", "chain"):
            rows.append(Row(f"step_{form}_{count}", 1024, *step_case(form, count)))
        for form in ("swap", "addx"):
            rows.append(Row(f"pixel_{form}_{count}", 256, *pixel_case(form, count)))
    for name in ("fetch", "store", "copy"):
        rows.append(Row(f"floor_{name}", 1024, *floor_case(name)))
    rows += [Row(name, bench_tx.LENGTH, *bench_tx.pass_case(name)) for name in bench_tx.NAMES]
    rows += [Row(name, bench_tx.LENGTH, *bench_tmu.pass_case(name)) for name in bench_tmu.NAMES]
    rows += [Row(name, bench_screen.SCREENS[bench_screen.routine_of(name)][0],
                 *bench_screen.screen_case(name)) for name in bench_screen.NAMES]
    for end in ("_low", "_super"):  # what is drawn while something is shown
        rows.append(Row(f"affine_addx{end}", 256, *span_case("span_affine_addx", "addx", 256)))
        rows[-1].case.display = bench_screen.SHOWN[end]
    return placed(rows, chip)


def line_rows(chip: bool) -> list[Row]:
    """All rows counted in lines: the edge steppers."""
    rows = [Row(name, EDGE_LINES, *edge_case(name)) for name in (
        "edge_addx", "edge_addx_exact", "edge_plain", "edge_plain_exact", "edge_swap",
        "edge_flat", "edge_flat_exact")]
    rows.append(Row("edge_ramp", EDGE_LINES, *ramp_case()))
    rows.append(Row("edge_shade", EDGE_LINES, *shade_case(EDGE_LINES)))
    rows.append(Row("edge_shade_inside", EDGE_LINES, *shade_case(EDGE_LINES, inside=1)))
    rows += [Row(name, bench_perspective.LINES, *bench_perspective.lines_case(setting))
             for name, setting in (("perspective_lines", "every16"),
                                   ("perspective_lines_curves", "pixel"))]
    rows.append(Row("level_lines", bench_perspective.LINES, *bench_perspective.level_case()))
    rows.append(Row("reciprocal_lines", bench_perspective.LINES, *bench_reciprocal.lines_case(16)))
    rows.append(Row("logarithm_lines", bench_perspective.LINES, *bench_logarithm.lines_case()))
    return placed(rows, chip)


def point_rows(chip: bool) -> list[Row]:
    """All rows counted in points, normals, faces or vertices of meshes."""
    return placed([Row(name, 1, *make()) for name, make in MESH_CASES.items()], chip)


def instruction_rows(chip: bool) -> list[Row]:
    """All rows counted in instructions."""
    return placed([Row(*row) for row in bench_instructions.rows()], chip)
