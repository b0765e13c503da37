"""The bench's rows: what is called, on what memory, and what must come out.

Every row checks its own pixels: a loop that draws something else is not measured.
Conditions: DMA and interrupts off, instruction cache warm; 256x256 8-bit map,
du 1.5 and dv 1.25 texels a pixel, 16 fraction bits, u and v both wrap.
"""

from collections.abc import Iterator
from dataclasses import dataclass

from tmap.base.fixed import ONE
from tmap.bench import (cubic, dithered, edges, effects, far, instruction_costs, mesh, mesh_batches,
                        n64, perspective, screen, steps, triangle_fans, triangles, visible)
from tmap.bench.examples import glide as glide_examples, n64 as n64_examples
from tmap.bench.mappers import mapper_case
from tmap.bench.spans import DU, DV, LENGTHS, SPANS, SPECIAL, span_case
from tmap.bench.trial import Check
from tmap.corpus import polygon_sets
from tmap.guest.kernels import Case

#: Ends of the names of spans with wide texels, and their steps.
WIDE = {"": (DU, DV), "_wrap": (DU, DV), "_row": (DU, 0)}
Call = tuple[int, Case, Check]  # units, case and check


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
    rough: int = 20  # cycles of a unit, about


def span_calls(length: int) -> dict[str, Call]:
    """The spans that have a row at each of LENGTHS."""
    wide = {f"affine_{bits}{end}": pair for bits, more in ((16, {"_copy": (ONE, 0)}), (32, {}))
            for end, pair in (WIDE | more).items()}
    return ({name: span_case(f"span_{name}", form, length) for name, form in SPANS}
            | {"fill_32": span_case("span_fill_32", "flat", length)}
            | {name: span_case(f"span_{name}", "addx", length, *pair)
               for name, pair in wide.items()}
            | {f"dithered{end}": dithered.dithered_case(f"span_dithered{end}", bytes_, length)
               for end, bytes_ in dithered.NAMES.items()}
            | {"affine_row": span_case("span_affine_row", "addx", length, dv=0),
               "affine_column": span_case("span_affine_column", "addx", length, du=0),
               **{name: span_case(f"span_{name}", "addx", length, dv=0) for name in ("keyed_row", "keyed_rows")}}
            | {name: mapper_case(name, length) for name in ("gouraud", "arbitrary", "generated")}
            | {name: perspective.span_case(*how, length) for name, how in perspective.SPANS.items()}
            | {name: far.span_case(*how, length) for name, how in far.SPANS.items()}
            | {name: cubic.span_case(setting, length) for name, setting in cubic.SPANS.items()}
            | {"arbitrary_row": mapper_case("arbitrary", length, dv=ONE)}
            | {name: effects.lit_case(kernel, length) for name, kernel in effects.LIT.items()}
            | {name: effects.light_case(kernel, length) for name, kernel in effects.LIGHT.items()})


def special_calls() -> Iterator[tuple[str, int, Call]]:
    """The spans of special cases; what ends in _once draws a table of one pixel."""
    for name, du, dv, lengths in SPECIAL:
        for length in lengths:
            yield name, length, span_case(f"span_{name}", "addx", length, du, dv)
    for name in ("affine_addx", "affine_short"):
        yield f"{name}_once", 1, span_case(f"span_{name}", "addx", 1, lines=1)
    for n in (48, 16, 4, 1):
        yield "gouraud_short", n, mapper_case("gouraud_short", n)
    for name in ("lit_short", "lit_short_wrap"):
        for n in (12, 4, 1):
            yield f"affine_{name}", n, effects.lit_case(f"span_{name}", n)


def pixel_calls() -> Iterator[tuple[str, int, Call]]:
    """All that is counted in pixels (or steps of one pixel)."""
    for length in LENGTHS:
        for name, call in span_calls(length).items():
            yield name, length, call
    yield from special_calls()
    for name, how in effects.ROTATORS.items():
        yield name, effects.SCREEN[0], effects.rotator_case(*how)
    # One line: written, flushed and drawn once.
    yield "generated_once", 1024, mapper_case("generated", 1024, lines=1)
    for count in (1, 2, 3):  # addx against swap
        for form in ("swap", "addx", "chain"):
            yield f"step_{form}_{count}", steps.STEPS, steps.step_case(form, count)
        for form in ("swap", "addx"):
            yield f"pixel_{form}_{count}", steps.PIXELS, steps.pixel_case(form, count)
    for name in ("fetch", "store", "copy"):  # memory alone
        yield f"floor_{name}", steps.STEPS, steps.floor_case(name)
    for examples in (n64_examples, glide_examples):
        for name in n64.names(examples):
            yield name, n64.LENGTH, n64.pass_case(name, examples)
    for name in screen.NAMES:
        yield name, screen.SCREENS[screen.routine_of(name)][0], screen.screen_case(name)
    yield "box_fill", screen.BOX[0], screen.box_case()
    for name, call in visible.CASES.items():
        yield name, visible.LENGTH, call()
    for end in ("_low", "_super"):  # what is drawn while something is shown
        call = span_case("span_affine_addx", "addx", 256)
        call[1].display = screen.SHOWN[end]
        yield f"affine_addx{end}", 256, call


def line_calls() -> Iterator[tuple[str, int, Call]]:
    """All that is counted in lines: the edge steppers, and what makes lines in perspective."""
    for name in ("edge_addx", "edge_addx_exact", "edge_plain", "edge_plain_exact", "edge_swap",
                 "edge_flat", "edge_flat_exact"):
        yield name, edges.LINES, edges.edge_case(name)
    for name, call in {"edge_ramp": edges.ramp_case(), "edge_shade": effects.shade_case(),
                       "edge_shade_inside": effects.shade_case(inside=1),
                       "perspective_lines": perspective.lines_case("every16"),
                       "perspective_lines_curves": perspective.lines_case("pixel"),
                       "level_lines": perspective.level_case(),
                       "level_lines_tilted": perspective.level_case(True),
                       "level_reciprocal": perspective.reciprocal_case(),
                       "edge_opaque": edges.opaque_case(),
                       "coverage_scan": visible.scan_case(), "coverage_cut": edges.cut_case(),
                       "edges_far": far.edges_case(), "lines_far": far.lines_case()}.items():
        yield name, edges.LINES, call


#: A kind of rows to what makes names, lengths and calls. Points are normals, faces or vertices too.
KINDS = {"rows": pixel_calls, "lines": line_calls,
         "points": lambda: ((name, 1, make()) for name, make in (
             mesh.CASES | mesh_batches.CASES | visible.NEAR_CASES | triangle_fans.CASES).items()),
         "polygons": lambda: ((name, pixels, call(pixels)) for name, call in triangles.CASES.items()
                              for pixels in polygon_sets.SIZES.values()),
         "instructions": instruction_costs.calls}


def rows(kind: str, chip: bool) -> list[Row]:
    """The rows of one of KINDS; ``chip``: their data are in chip RAM."""
    made = [Row(name, length, *call) for name, length, call in KINDS[kind]()]
    for row in made:
        row.case.chip = chip
        if kind == "polygons":
            row.rough = 1000 + 20 * row.length
    return made
