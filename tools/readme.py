"""``tmap readme``: writes the README's table and picture, so that nobody types them.

The table stands between two marker lines; its figures are the baseline's.
"""

import json

from PIL import Image

from . import bench, emulator, run, scene, scene_file
from .errors import UserError
from .paths import BASELINE, ROOT, SCENES

README = ROOT / "README.md"
PICTURE = SCENES / "default.png"
BEGIN, END = "<!-- addx against swap: written by scripts/tmap readme -->", "<!-- end -->"
MACHINES = {"a1200-fast": "fast RAM", "a1200-mixed": "data in chip", "a1200": "chip RAM only"}
#: What is compared: title, name with {} for the form, length.
LINES = [("step, 1 interpolant", "step_{}_1", 1024), ("step, 2", "step_{}_2", 1024),
         ("step, 3", "step_{}_3", 1024), ("pixel, 1 interpolant", "pixel_{}_1", 256),
         ("pixel, 2 (affine)", "pixel_{}_2", 256), ("pixel, 3 (affine, lit)", "pixel_{}_3", 256),
         *((f"affine span of {n} pixels, set-up included", "affine_{}", n)
           for n in (256, 64, 16, 4))]


def table(baseline: dict) -> str:
    """Markdown: swap / addx on each machine, cycles a pixel or step."""
    figures = {bench.key(row): bench.cycles(row) for row in baseline["rows"]}
    lines = ["| cycles, swap / addx | " + " | ".join(MACHINES.values()) + " |",
             "|---|" + "---|" * len(MACHINES)]
    for title, name, length in LINES:
        cells = [" / ".join(f"{figures[name.format(form), machine, length]:.1f}"
                            for form in ("swap", "addx")) for machine in MACHINES]
        lines.append(f"| {title} | " + " | ".join(cells) + " |")
    cells = [f"{figures['affine_c', machine, 256]:.1f}" for machine in MACHINES]
    lines.append(f"| the same span in C ({baseline['compiler']}), 256 pixels | "
                 + " | ".join(cells) + " |")
    return "\n".join(lines)


def with_table(text: str, baseline: dict) -> str:
    """The README's text with the table of a baseline."""
    if BEGIN not in text or END not in text:
        raise UserError(f"README.md: the lines {BEGIN!r} and {END!r} are not there")
    head, rest = text.split(BEGIN, 1)
    return f"{head}{BEGIN}\n{table(baseline)}\n{END}{rest.split(END, 1)[1]}"


def picture() -> Image.Image:
    """Frame 0 of the default scene, as the emulated machine draws it."""
    compiled = scene.compile_scene(SCENES / "default.toml", 1)
    with emulator.workspace() as directory:
        done = emulator.run("render", f"{run.SCENE_NAME}",
                            {run.SCENE_NAME: scene_file.write(compiled)}, "a1200-fast", directory)
        dump = (done.directory / "frame_000.chunky").read_bytes()
    image = Image.frombytes("P", (compiled.width, compiled.height), dump)
    image.putpalette(compiled.palette.tobytes())
    return image


def command() -> int:
    """Writes both."""
    README.write_text(with_table(README.read_text(), json.loads(BASELINE.read_text())))
    picture().save(PICTURE, optimize=True)
    print(f"written: {README.name}, {PICTURE.relative_to(ROOT)}")
    return 0
