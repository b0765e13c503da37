"""The pages' tables of texture engines: cycles and errors of their modes and texel formats."""

from dataclasses import dataclass

from tmap.accuracy import engines
from tmap.accuracy.engines import Engine
from tmap.base.markdown import MACHINES, table
from tmap.bench import bench
from tmap.bench.modes import passes
from tmap.bench.modes.measure import FIRST_ROW, PLAIN_END, PLAIN_MACHINE, ROW

Figures = dict[tuple[str, str], float]
Rows = dict[tuple[str, str], dict]


def rows_of(baseline: dict) -> Rows:
    """Returns rows by name and machine."""
    return {(row["name"], row["machine"]): row
            for kind in ("modes", "first_frames") for row in baseline[kind]}


def figures_of(baseline: dict) -> Figures:
    """Returns cycles by a row's name and machine."""
    return {name: bench.cycles(row) for name, row in rows_of(baseline).items()}


def passes_cell(baseline: dict, name: str) -> str:
    """Returns the sum of a mode's passes, or "" if it has none."""
    rows = {(row["name"], row["machine"]): bench.cycles(row) for row in baseline["rows"]}
    found = passes.cycles(rows, name, PLAIN_MACHINE)
    return f"{found:,.1f}" if found else ""


def ratio(figures: Figures, name: str) -> float:
    """Returns a mode's cycles in plain C, as a multiple of its cycles."""
    return figures[f"{ROW}{name}{PLAIN_END}", PLAIN_MACHINE] / figures[ROW + name, PLAIN_MACHINE]


def thousands(cycles: float) -> str:
    """Returns whole thousands; a number that rounds to 0 has no sign."""
    return f"{round(cycles / 1000):,}"


def modes_table(baseline: dict, engine: Engine) -> str:
    """A Markdown table: cycles a pixel, of the passes alone, in plain C, of the first frame; errors on both pictures."""
    figures, rows = figures_of(baseline), []
    for mode in engine.modes:
        cells = [f"{figures[ROW + mode.name, machine]:,.1f}" for machine in MACHINES]
        cells.append(passes_cell(baseline, mode.name))
        cells += [f"{figures[f'{ROW}{mode.name}{PLAIN_END}', PLAIN_MACHINE]:,.0f}",
                  f"{ratio(figures, mode.name):.1f}"] if mode.in_c else ["", ""]
        cells.append(thousands(figures[FIRST_ROW + mode.name, PLAIN_MACHINE]))
        rows.append([mode.title, *cells, *engine.errors(mode)])
    return table(["cycles a pixel; errors in 1/255", *MACHINES.values(), "its passes, fast RAM", "plain C, fast RAM",
                  "times", "first frame, kcycles more", *engines.TITLES], rows)


def formats_table(baseline: dict, engine: Engine) -> str:
    """Returns a Markdown table: each texel format, point sampled and filtered."""
    figures, rows = figures_of(baseline), []
    for form, names in engine.formats.items():
        cells = [form]
        for name in names:
            found = [figures[ROW + name, machine] for machine in ("a1200-fast", "a1200")]
            cells += [f"{n:,.1f}" for n in found]
            cells += [f"{figures[f'{ROW}{name}{PLAIN_END}', PLAIN_MACHINE]:,.0f}",
                      thousands(figures[FIRST_ROW + name, PLAIN_MACHINE]),
                      *engine.errors(engine.every[name])[:2]]
        rows.append(cells)
    titles = [f"{how}: {what}" for how in ("point", engine.filtered) for what in (
        "fast RAM", "chip RAM only", "plain C", "first frame, kcycles", "largest error", "rms")]
    return table(["texels", *titles], rows)


@dataclass(frozen=True)
class Step:
    """A step that can be on. ``without``, ``on``: the modes without it and with it; ``small``: the
    mode of SMALL, polygons of 8 pixels, without it."""

    title: str
    without: str
    on: str
    small: str = ""

    def more(self, figures: Figures, machine: str) -> float:
        """Returns the cycles a pixel that it adds."""
        return figures[ROW + self.on, machine] - figures[ROW + self.without, machine]


#: Steps of Glide's unit with an effect.
STEPS = (Step("bilinear instead of points", "glide_point", "glide_bilinear"),
         Step("the same in perspective", "glide_point_perspective", "glide_bilinear_perspective"),
         Step("the same, mip-mapped", "glide_mip_point", "glide_mip_bilinear"),
         Step("weights of 8 bits instead of 4", "glide_bilinear", "glide_bilinear_8"),
         Step("perspective, of points", "glide_point", "glide_point_perspective"),
         Step("perspective, of bilinear texels", "glide_bilinear", "glide_bilinear_perspective"),
         Step("a level of detail each pixel, of points", "glide_point_perspective",
              "glide_mip_point"),
         Step("a level of detail each pixel, of bilinear texels", "glide_bilinear_perspective",
              "glide_mip_bilinear"),
         Step("its dither", "glide_mip_bilinear", "glide_mip_bilinear_dither"),
         Step("trilinear, by a second unit", "glide_mip_bilinear", "glide_trilinear"),
         Step("a detail texture, by a second unit", "glide_bilinear_perspective", "glide_detail"),
         Step("a second unit, multiplied", "glide_bilinear", "glide_modulate"),
         Step("the same in perspective", "glide_bilinear_perspective", "glide_modulate_perspective"),
         Step("own s, t and w of the second unit: projected", "glide_modulate_perspective",
              "glide_projected"))
#: Steps that are on without effect on their polygon.
UNCALLED = (Step("clamping, inside the map", "glide_point", "glide_point_inside", "glide_point_small"),
            Step("perspective, all as deep: points", "glide_point", "glide_level_point",
                 "glide_point_small"),
            Step("perspective, all as deep: bilinear", "glide_bilinear", "glide_level_bilinear",
                 "glide_bilinear_small"),
            Step("mip maps, one level of detail", "glide_bilinear", "glide_mip_level",
                 "glide_bilinear_small"),
            Step("trilinear filtering, magnified", "glide_double", "glide_trilinear_double",
                 "glide_bilinear_small"),
            Step("a detail texture, too far away", "glide_away", "glide_detail_away",
                 "glide_bilinear_perspective_small"),
            Step("a second unit that does not count", "glide_bilinear", "glide_decal",
                 "glide_bilinear_small"))


def steps_table(baseline: dict) -> str:
    """A Markdown table: cycles that each step of Glide's unit adds when it has an effect."""
    figures, rows = figures_of(baseline), []
    for step in STEPS:
        cells = []
        for machine in MACHINES:
            cells += [f"{figures[ROW + step.without, machine]:,.1f}",
                      f"{step.more(figures, machine):+,.1f}"]
        rows.append([step.title, *cells])
    titles = [f"{what}, {words}" for words in MACHINES.values()
              for what in ("without", "more with it")]
    return table(["cycles a pixel", *titles], rows)


def polygon(rows: Rows, name: str, machine: str) -> float:
    """Returns the cycles of a mode's whole polygon."""
    row = rows[ROW + name, machine]
    return bench.cycles(row) * row["length"]


def uncalled_table(baseline: dict) -> str:
    """Returns a Markdown table: cycles that each step without effect adds to a polygon, compared
    with the cycles of a polygon of a few pixels."""
    measured, rows = rows_of(baseline), []
    for step in UNCALLED:
        cells = []
        for machine in MACHINES:
            on, without, small = (polygon(measured, name, machine)
                                  for name in (step.on, step.without, step.small))
            cells += [f"{on - without:+,.0f}", f"{small:,.0f}"]
        rows.append([step.title, *cells])
    titles = [f"{what}, {words}" for words in MACHINES.values()
              for what in ("more", "one of 8 pixels")]
    return table(["cycles a polygon", *titles], rows)
