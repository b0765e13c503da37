"""``tmap choose``: finds the cheapest setting of a material within an error limit, in the rows of
``tmap accuracy``, and the cost of the next steps down and up.
"""

import json
import sys
from dataclasses import dataclass
from pathlib import Path

from tmap.accuracy.rows import beats
from tmap.base.errors import UserError
from tmap.base.paths import ACCURACY_BASELINE
from tmap.corpus.polygon_sets import SIZES
from tmap.scene_file.scene_file import MAPPER_LAYOUT

#: Mappers that draw the same picture as affine. "arbitrary" is judged alone: its polygons in the
#: sets are different ones, whose coordinates stay inside the map.
FAMILY = ("affine", "generated", "tiled", "columns")
#: Columns of a row that are settings of a material.
COLUMNS = ("mapper", "edges", "gradients", "start", "perspective")
#: The sets that are judged without a size: without depth and with it.
FLAT_SET, DEPTH_SET = "medium", "depth"
COST, WRONG = "cycles_per_pixel", "coverage_errors_per_million"
POLYGON = "cycles_per_polygon"
LARGEST, RMS = "texel_error_max", "texel_error_rms"
NUMBERS = (COST, POLYGON, WRONG, LARGEST, RMS, "wrong_texels_percent")
#: Examples of the field that a material without texture has instead.
COLOURS = {"flat": 'colour = "#ffffff"', "gouraud": 'shades = ["#000000", "#ffffff"]'}


@dataclass
class Wish:
    """The limits that a setting must keep."""

    error: float  # texels; shades for gouraud
    machine: str
    depth: bool = False
    wrong: float | None = None  # pixels in a million
    mapper: str | None = None
    measure: str = LARGEST  # or RMS
    pixels: float | None = None  # of a polygon

    @property
    def set_name(self) -> str:
        """The set of polygons whose rows are judged: with ``pixels`` the one of the nearest size, by
        ratio."""
        if self.depth:
            return DEPTH_SET
        if self.pixels is None:
            return FLAT_SET
        return min(SIZES, key=lambda name: max(SIZES[name] / self.pixels, self.pixels / SIZES[name]))

    def is_met(self, row: dict) -> bool:
        """Returns True if a row keeps both error limits."""
        return row[self.measure] <= self.error and (self.wrong is None or row[WRONG] <= self.wrong)


def load(path: Path) -> dict:
    """Returns the content of an accuracy.json with its rows checked."""
    try:
        found = json.loads(path.read_text())
    except OSError as error:
        raise UserError(f"{path}: {error.strerror or error}") from None
    except (ValueError, RecursionError) as error:
        raise UserError(f"{path}: is not JSON: {error}") from None
    rows = found.get("rows") if isinstance(found, dict) else None
    if not isinstance(rows, list):
        raise UserError(f"{path}: rows: is not a list")
    for number, row in enumerate(rows):
        if not isinstance(row, dict):
            raise UserError(f"{path}: rows[{number}]: is not an object")
        for kind, names in ((str, ("name", "machine", *COLUMNS)), ((int, float), NUMBERS)):
            for name in names:
                if not isinstance(row.get(name), kind):
                    raise UserError(f"{path}: rows[{number}].{name}: is missing or of another kind")
        if not row[COST] > 0:  # it is a divisor
            raise UserError(f"{path}: rows[{number}].{COST}: must be above 0")
    return found


def candidates(rows: list[dict], wish: Wish) -> list[dict]:
    """Returns the rows that match a wish, cheapest first."""
    mappers = (wish.mapper,) if wish.mapper else FAMILY
    return sorted((r for r in rows if (r["name"], r["machine"]) == (wish.set_name, wish.machine)
                   and r["mapper"] in mappers), key=lambda r: (r[COST], r[wish.measure]))


def choose(rows: list[dict], wish: Wish) -> tuple[dict | None, dict | None, dict | None]:
    """Returns (one step cheaper, the choice, one step more exact) of the candidates, None for each
    that does not exist.

    The step down is the most expensive of the cheaper rows that no other cheaper row beats. The
    step up is the cheapest row that is more exact and nowhere worse.
    """
    best = next((row for row in rows if wish.is_met(row)), None)
    if best is None:
        return None, None, None
    errors = wish.measure, WRONG
    cheaper = [r for r in rows if r[COST] < best[COST]]
    kept = [r for r in cheaper if not any(beats(o, r, (COST, *errors)) for o in cheaper)]
    down = max(kept, key=lambda r: r[COST], default=None)
    up = next((r for r in rows if beats(r, best, errors)), None)
    return down, best, up


def pasted(row: dict) -> str:
    """Returns lines for a scene file that set a row's settings."""
    mapper = row["mapper"]
    words = [COLOURS.get(mapper, 'texture = "my_texture"')]
    if MAPPER_LAYOUT[mapper]:
        words += [f'{name} = "{row[name]}"' for name in COLUMNS]
    else:
        words += [f'{name} = "{row[name]}"' for name in ("edges", "gradients", "start")]
    return "[materials]\nmy_material = { " + ", ".join(words) + " }"


def table(steps: tuple[dict | None, dict, dict | None]) -> str:
    """Returns a table of the choice and its neighbours."""
    titles = ("", *COLUMNS, "cycles/polygon", "cycles/pixel", "largest error", "rms error",
              "wrong in 10^6", "wrong texels")
    lines = [titles]
    for title, row in zip(("cheaper", "choice", "more exact"), steps):
        lines.append((title, *(row[s] for s in COLUMNS), f"{row[POLYGON]:,.0f}", f"{row[COST]:.2f}", f"{row[LARGEST]:.4f}",
                      f"{row[RMS]:.4f}", f"{row[WRONG]:,.0f}",
                      f"{row['wrong_texels_percent']:.2f} %")
                     if row else (title, "-", *[""] * (len(titles) - 2)))
    widths = [max(map(len, column)) for column in zip(*lines)]
    first_number = 1 + len(COLUMNS)
    return "\n".join("  ".join(
        word.rjust(width) if k >= first_number else word.ljust(width)
        for k, (word, width) in enumerate(zip(line, widths))).rstrip() for line in lines)


def asked(wish: Wish) -> str:
    """Returns a wish in words."""
    unit = "shades" if wish.mapper == "gouraud" else "texels"
    kind = "an rms" if wish.measure == RMS else "a largest"
    words = f"{kind} error of at most {wish.error:g} {unit}"
    if wish.wrong is not None:
        words += f" and {wish.wrong:g} wrong pixels in a million"
    return words


def change_in_words(best: dict, row: dict | None, change: str, saying: str, wish: Wish) -> str:
    """Returns a sentence about the step from the choice to a neighbour."""
    if not row:
        return f"No setting is {change}."
    cycles = abs(row[COST] - best[COST])
    words = (f"The next {change} one {saying} {cycles:.2f} cycles a pixel "
             f"({100 * cycles / best[COST]:.1f} %); its "
             f"{'rms' if wish.measure == RMS else 'largest'} error is {row[wish.measure]:g}")
    if row[WRONG] != best[WRONG]:
        words += f", its wrong pixels are {row[WRONG]:,.0f} in a million"
    return words + "."


def command(wish: Wish, data: Path | None) -> int:
    """``tmap choose``: prints the choice. Returns 1 if no setting keeps the limits."""
    source = data or ACCURACY_BASELINE
    found = load(source)
    rows = candidates(found["rows"], wish)
    if not rows:
        raise UserError(f"{source}: no row of set {wish.set_name} on {wish.machine} has mapper "
                        + (wish.mapper or " or ".join(FAMILY)))
    steps = choose(rows, wish)
    down, best, up = steps
    if best is None:
        nearest = min(rows, key=lambda r: (wish.wrong is not None and r[WRONG] > wish.wrong,
                                           r[wish.measure], r[COST]))
        print(f"tmap: choose: no setting has {asked(wish)} on {wish.machine}; the most exact has "
              f"{nearest[wish.measure]:g} ({', '.join(nearest[s] for s in COLUMNS)}), "
              f"{nearest[WRONG]:g} wrong pixels in a million, at {nearest[COST]:.2f} cycles "
              "a pixel",
              file=sys.stderr)
        return 1
    print(f"The cheapest with {asked(wish)}, on {wish.machine}"
          + (", textures in perspective:" if wish.depth else ":") + f"\n\n{table(steps)}\n")
    for row, change, saying in ((down, "cheaper", "saves"), (up, "more exact", "costs")):
        print(change_in_words(best, row, change, saying, wish))
    about = [str(found.get(name, "")) for name in ("conditions", "emulator", "compiler")]
    print(f"\n{pasted(best)}\n\nSet {wish.set_name} of {source.name}: {' '.join(about)}, "
          f"commit {found.get('commit', '')}.")
    return 0
