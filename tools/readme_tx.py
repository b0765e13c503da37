"""The README's tables of the texture engine: what its modes and texel formats cost and are off."""

from . import bench, tx_errors
from .bench_modes import FIRST_ROW, PLAIN_END, PLAIN_MACHINE, ROW
from .tx_modes import EVERY, FORMATS, MODES

MACHINES = {"a1200-fast": "fast RAM", "a1200-mixed": "data in chip", "a1200": "chip RAM only"}


def figures_of(baseline: dict) -> dict[tuple[str, str], float]:
    """Cycles by a row's name and machine."""
    return {(row["name"], row["machine"]): bench.cycles(row)
            for kind in ("modes", "first_frames") for row in baseline[kind]}


def ratio(figures: dict, name: str) -> float:
    """How many times the plain C of a mode takes."""
    return figures[f"{ROW}{name}{PLAIN_END}", PLAIN_MACHINE] / figures[ROW + name, PLAIN_MACHINE]


def modes_table(baseline: dict) -> str:
    """Markdown: cycles a pixel, in plain C, and of the first frame; errors on both pictures."""
    figures = figures_of(baseline)
    titles = [*MACHINES.values(), "plain C, fast RAM", "times", "first frame, kcycles more",
              *tx_errors.TITLES]
    lines = ["| cycles a pixel; errors in 1/255 | " + " | ".join(titles) + " |",
             "|---|" + "--:|" * len(titles)]
    for mode in MODES:
        cells = [f"{figures[ROW + mode.name, machine]:,.1f}" for machine in MACHINES]
        cells += [f"{figures[f'{ROW}{mode.name}{PLAIN_END}', PLAIN_MACHINE]:,.0f}",
                  f"{ratio(figures, mode.name):.1f}",
                  f"{figures[FIRST_ROW + mode.name, PLAIN_MACHINE] / 1000:,.0f}"]
        lines.append(f"| {mode.title} | " + " | ".join([*cells, *tx_errors.cells(mode)]) + " |")
    return "\n".join(lines)


def formats_table(baseline: dict) -> str:
    """Markdown: each texel format, point sampled and three-point filtered."""
    figures = figures_of(baseline)
    titles = [f"{how}: {what}" for how in ("point", "three-point") for what in (
        "fast RAM", "chip RAM only", "plain C", "first frame, kcycles", "largest error", "rms")]
    lines = ["| texels | " + " | ".join(titles) + " |", "|---|" + "--:|" * len(titles)]
    for form, names in FORMATS.items():
        cells = []
        for name in names:
            found = [figures[ROW + name, machine] for machine in ("a1200-fast", "a1200")]
            cells += [f"{n:,.1f}" for n in found]
            cells += [f"{figures[f'{ROW}{name}{PLAIN_END}', PLAIN_MACHINE]:,.0f}",
                      f"{figures[FIRST_ROW + name, PLAIN_MACHINE] / 1000:,.0f}",
                      *tx_errors.cells(EVERY[name])[:2]]
        lines.append(f"| {form} | " + " | ".join(cells) + " |")
    return "\n".join(lines)
