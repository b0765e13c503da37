"""The bench's rows: what is called, on what memory, and what must come out.

Every row checks its own pixels: a loop that draws something else is not measured.
Conditions: DMA and interrupts off, instruction cache warm; 256x256 8-bit map,
du 1.5 and dv 1.25 texels a pixel, 16 fraction bits, u and v both wrap.
"""

from dataclasses import dataclass

from tmap.bench import (edges, glide, instruction_costs, logarithm, n64, perspective, reciprocal,
                        screen, steps as bench_steps)
from tmap.bench.dithered import dithered_rows
from tmap.bench.effects import LIT, ROTATORS, SCREEN, lit_case, rotator_case, shade_case
from tmap.bench.mappers import mapper_case
from tmap.bench.mesh import CASES as MESH_CASES
from tmap.bench.spans import DU, DV, LENGTHS, SPANS, SPECIAL, span_case
from tmap.bench.trial import Check
from tmap.guest.kernels import Case


@dataclass
class Row:
    """One measured row: ``units`` pixels (or steps, lines, points) are drawn by one call.

    ``check`` gives an error text, or None when the result is right.
    """

    name: str
    length: int
    units: int
    case: Case
    check: Check


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


def span_rows(length: int) -> list[Row]:
    """The spans that have a row at each of LENGTHS."""
    rows = [Row(name, length, *span_case(f"span_{name}", form, length)) for name, form in SPANS]
    rows += wide_rows(length)
    rows += [Row(*row) for row in dithered_rows(length)]
    rows.append(Row("affine_row", length, *span_case("span_affine_row", "addx", length, dv=0)))
    rows.append(Row("affine_column", length, *span_case("span_affine_column", "addx", length, du=0)))
    rows += [Row(name, length, *mapper_case(name, length))
             for name in ("gouraud", "arbitrary", "generated")]
    rows += [Row(name, length, *perspective.span_case(setting, ratio, length))
             for name, (setting, ratio) in perspective.SPANS.items()]
    rows += [Row(name, length, *reciprocal.span_case(m, length))
             for name, m in reciprocal.SPANS.items()]
    rows.append(Row("persp_pixel", length, *logarithm.span_case(length)))
    rows.append(Row("arbitrary_row", length, *mapper_case("arbitrary", length, dv=1 << 16)))
    return rows + [Row(name, length, *lit_case(kernel, length)) for name, kernel in LIT.items()]


def race_rows() -> list[Row]:
    """addx against swap, and memory alone."""
    rows = []
    for count in (1, 2, 3):
        rows += [Row(f"step_{form}_{count}", bench_steps.STEPS, *bench_steps.step_case(form, count))
                 for form in ("swap", "addx", "chain")]
        rows += [Row(f"pixel_{form}_{count}", bench_steps.PIXELS, *bench_steps.pixel_case(form, count))
                 for form in ("swap", "addx")]
    return rows + [Row(f"floor_{name}", bench_steps.STEPS, *bench_steps.floor_case(name))
                   for name in ("fetch", "store", "copy")]


def pass_rows() -> list[Row]:
    """A line by each pass of the texture engines, and a screen by each way to it."""
    return [*(Row(name, n64.LENGTH, *n64.pass_case(name)) for name in n64.NAMES),
            *(Row(name, n64.LENGTH, *glide.pass_case(name)) for name in glide.NAMES),
            *(Row(name, screen.SCREENS[screen.routine_of(name)][0],
                  *screen.screen_case(name)) for name in screen.NAMES)]


def pixel_rows(chip: bool) -> list[Row]:
    """All rows counted in pixels (or steps of one pixel)."""
    rows = [row for length in LENGTHS for row in span_rows(length)] + special_rows()
    rows += [Row(name, SCREEN[0], *rotator_case(*how)) for name, how in ROTATORS.items()]
    # One line: written, flushed and drawn once.
    rows.append(Row("generated_once", 1024, *mapper_case("generated", 1024, lines=1)))
    rows += race_rows() + pass_rows()
    for end in ("_low", "_super"):  # what is drawn while something is shown
        rows.append(Row(f"affine_addx{end}", 256, *span_case("span_affine_addx", "addx", 256)))
        rows[-1].case.display = screen.SHOWN[end]
    return placed(rows, chip)


def line_rows(chip: bool) -> list[Row]:
    """All rows counted in lines: the edge steppers."""
    rows = [Row(name, edges.LINES, *edges.edge_case(name)) for name in (
        "edge_addx", "edge_addx_exact", "edge_plain", "edge_plain_exact", "edge_swap",
        "edge_flat", "edge_flat_exact")]
    rows.append(Row("edge_ramp", edges.LINES, *edges.ramp_case()))
    rows.append(Row("edge_shade", edges.LINES, *shade_case()))
    rows.append(Row("edge_shade_inside", edges.LINES, *shade_case(inside=1)))
    rows += [Row(name, perspective.LINES, *perspective.lines_case(setting))
             for name, setting in (("perspective_lines", "every16"),
                                   ("perspective_lines_curves", "pixel"))]
    rows.append(Row("level_lines", perspective.LINES, *perspective.level_case()))
    rows.append(Row("reciprocal_lines", perspective.LINES, *reciprocal.lines_case(16)))
    rows.append(Row("logarithm_lines", perspective.LINES, *logarithm.lines_case()))
    return placed(rows, chip)


def point_rows(chip: bool) -> list[Row]:
    """All rows counted in points, normals, faces or vertices of meshes."""
    return placed([Row(name, 1, *make()) for name, make in MESH_CASES.items()], chip)


def instruction_rows(chip: bool) -> list[Row]:
    """All rows counted in instructions."""
    return placed([Row(*row) for row in instruction_costs.rows()], chip)
