"""The texture engines whose modes are priced, and tables of the modes' cycles and errors."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from tmap.accuracy import glide_errors, n64_errors
from tmap.base import markdown
from tmap.bench.modes import glide, measure, n64
from tmap.bench.modes.modes import KINDS, Mode
from tmap.guest import provenance
from tmap.ideal.texels import Error


@dataclass(frozen=True)
class Engine:
    """``name``: its name in commands; ``modes``, ``formats``, ``every``: MODES, FORMATS and EVERY
    of its module; ``filtered``: the filter that the table of texel formats shows after point
    sampling; ``meant``: the reference of the errors."""

    name: str
    title: str
    modes: tuple[Mode, ...]
    formats: dict[str, tuple[str, str]]
    every: dict[str, Mode]
    filtered: str
    error_of: Callable[[Mode, str], Error]
    meant: str

    def errors(self, mode: Mode) -> list[str]:
        """Returns the largest and the root mean square error on each kind of picture."""
        return [f"{number:.{digits}f}" for kind in KINDS
                for number, digits in zip(self.error_of(mode, kind), (1, 2))]


TITLES = [f"{kind}: {what}" for kind in KINDS for what in ("largest", "rms")]

N64 = Engine("n64", "texture engine", n64.MODES, n64.FORMATS, n64.EVERY,
             n64.THREE, n64_errors.error_of, "exact coordinates, filters and combiners")
GLIDE = Engine("glide", "Glide's texture unit", glide.MODES, glide.FORMATS, glide.EVERY,
               "bilinear", glide_errors.error_of,
               "exact coordinates, levels of detail, filters and combine units")
ENGINES = {engine.name: engine for engine in (N64, GLIDE)}


def table(engine: Engine, machine: str) -> str:
    """A Markdown table of all modes' cycles and errors. Each frame must be the model's."""
    rows = measure.measure(machine, list(engine.every), plain=False)["modes"]
    cycles = {row["name"]: row["cycles_per_pixel"] for row in rows}
    return markdown.table(
        [f"{engine.title}, {machine}; errors in 1/255", "cycles a pixel", *TITLES],
        [[mode.title, f"{cycles[measure.ROW + mode.name]:.1f}", *engine.errors(mode)]
         for mode in engine.every.values()])


def write(folder: Path, engine: Engine, machine: str) -> str:
    """Writes NAME.md; returns its table."""
    about, made = provenance.record(), table(engine, machine)
    (folder / f"{engine.name}.md").write_text(
        f"# Modes: {engine.title}\n\nPolygons of some 2,000 pixels, set-up included, tables "
        "and decoded texels made before; DMA and interrupts off. Errors of R, G and B against "
        f"{engine.meant}, on a smooth texture and on noise. "
        f"{about['emulator']}, {about['compiler']}, commit {about['commit']}.\n\n{made}\n")
    return made
