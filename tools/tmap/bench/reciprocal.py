"""What calls of lines by tables have in common: a polygon's constants, and lines that are emptied."""

from tmap.base.fixed import signed
from tmap.bench.spans import BIAS
from tmap.bench.trial import Trial, Write, anything, fields
from tmap.build import layout
from tmap.guest.kernels import Arena, Case
from tmap.setup import reciprocal as reciprocals


def constants_fields(constants) -> dict:
    """What a reciprocal_plan has of its polygon's constants."""
    longs = zip(("cu", "cv", "dcu", "dcv"), constants.c + constants.dc)
    return {name: list((n % (1 << 64)).to_bytes(8, "big")) for name, n in longs} \
        | {"ku": signed(constants.k[0]), "kv": signed(constants.k[1])}


def constants_of(deep, lines):
    """The constants of a polygon with lines (left, right, y), and the pixel they are found at."""
    x, y = next((left - deep.i, k) for k, (left, right, _) in enumerate(lines) if right > left)
    return reciprocals.find(deep, x, y), x, y


def emptied_lines(arena: Arena, planes_at: int, lines, made: list) -> list[Write]:
    """What a plan's lines are to others: empty those that were ``made``, if others were not."""
    entry = layout.load().struct("scanline")
    table = int.from_bytes(arena.data[planes_at:planes_at + 4], "big")
    some_left = any(right > left and not line for (left, right, _), line in zip(lines, made))
    return [Write(table + k * entry.size + entry.fields["last"]["offset"],
                  ((left if line and some_left else right) - 1 + BIAS).to_bytes(2, "big"))
            for k, ((left, right, _), line) in enumerate(zip(lines, made))]


def made_trial(case: Case, struct: str, out: int, planes_at: int, lines, made: list, fields_of,
               title: str) -> Trial:
    """A call that makes a table of records at ``out``. ``made``: of each line, None where it is left to
    others or empty; ``fields_of``: the fields of a record that are written."""
    size = layout.load().struct(struct).size
    writes = [anything(out, size * len(lines)), *emptied_lines(case.arena, planes_at, lines, made)]
    for k, ((left, right, _), line) in enumerate(zip(lines, made)):
        wanted = fields_of(line) if line else {"n": -1 if right > left else right - left - 1}
        writes += fields(out + k * size, struct, wanted)
    others = sum(right > left and not line for (left, right, _), line in zip(lines, made))
    return Trial(case, f"{title}, {len(lines)} lines, {others} left", {"d0": others}, writes=writes)
