"""``tmap readme``: writes the tables and pictures of the pages, so that nobody types them.

Figures come from the committed baselines. tools/tmap/report/pages.py finds the tables' places.
"""

import json

import numpy as np
from PIL import Image

from tmap.accuracy import engines, italian_methods, polys
from tmap.base import rooms
from tmap.base.markdown import MACHINES
from tmap.base.outputs import save_animation
from tmap.base.paths import ACCURACY_BASELINE, BASELINE, POLYS_BASELINE, ROOT, SCENES
from tmap.bench import instruction_costs
from tmap.compiler import scene
from tmap.fuzz import record
from tmap.images import palette
from tmap.report import (pages, readme_cycles, readme_modes, readme_numbers, readme_programs,
                         readme_reference, readme_scenes)
from tmap.run import run

PICTURE, ANIMATION = SCENES / "default.png", SCENES / "environment.gif"
METHODS = SCENES / "methods.png"
LEVEL, LEVEL_FRAMES = SCENES / "keep.png", (18, 42, 60, 84)  # two beside two
COLOURS = 24  # of the animation


def measured_tables(measured: dict, accuracy: dict, counted: dict) -> dict[str, str]:
    """Returns the tables of pages and report by title. The arguments: as bench.json, accuracy.json
    and polys.json."""
    found = {"addx against swap": readme_cycles.versus_table(measured),
             "effects": readme_cycles.effects_table(measured),
             "meshes": readme_cycles.mesh_table(measured),
             "rules": readme_cycles.rules_table(measured),
             "triangles by size": readme_cycles.triangles_table(measured),
             "prices by size": readme_cycles.prices_table(measured, accuracy),
             "perspective": readme_cycles.perspective_table(measured, accuracy),
             "polygons a second": polys.table(counted["rows"]).rstrip(),
             "Glide's steps": readme_modes.steps_table(measured),
             "Glide's steps not called for": readme_modes.uncalled_table(measured)}
    for engine in engines.ENGINES.values():
        found |= {f"{engine.title} modes": readme_modes.modes_table(measured, engine),
                  f"{engine.title} formats": readme_modes.formats_table(measured, engine)}
    return found


def tables() -> dict[str, str]:
    """Returns all tables of all pages by title, from the baselines."""
    measured, accuracy, counted = (json.loads(path.read_text()) for path in (
        BASELINE, ACCURACY_BASELINE, POLYS_BASELINE))
    return (measured_tables(measured, accuracy, counted) | rooms.tables() | readme_numbers.tables()
            | readme_programs.tables(measured) | readme_reference.tables()
            | readme_scenes.tables(measured, accuracy, counted) | record.tables()
            | {"what a triangle costs": readme_cycles.prices_table(measured, accuracy, ("affine",)),
               "what accuracy costs": readme_cycles.accuracy_table(accuracy),
               "dithered points": readme_cycles.dithered_tables(measured),
               "transparent texels": readme_cycles.keyed_table(measured),
               "instructions": instruction_costs.table(measured, MACHINES)})


def fewer_colours(full: np.ndarray, frame: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Reduces a palette to COLOURS colours for a frame, with its first entry kept. Returns them,
    and for each entry of the palette the number of its new colour."""
    shown = Image.fromarray(full[frame[frame != 0]][None])
    reduced = shown.quantize(COLOURS - 1, Image.Quantize.MEDIANCUT, kmeans=1,
                             dither=Image.Dither.NONE).getpalette()
    colours = np.concatenate([full[:1], np.array(reduced, np.uint8).reshape(-1, 3)])[:COLOURS]
    return colours, palette.nearest(full, colours)


def animation() -> list[Image.Image]:
    """Every second frame of the environment-mapped knot, in few colours, to halve the bytes."""
    compiled = scene.compile_scene(SCENES / "environment.toml")
    frames = run.render(compiled, "a1200-fast", "addx").frames
    colours, entries = fewer_colours(compiled.palette, frames[0])
    images = [Image.fromarray(entries[frame]) for frame in frames[::2]]
    for image in images:
        image.putpalette(colours.tobytes())
    return images


def level() -> Image.Image:
    """Frames of the flight through the keep, on one picture."""
    compiled = scene.compile_scene(SCENES / "keep.toml")
    frames = run.render(compiled, "a1200-fast", "addx").frames
    rows = [np.concatenate([frames[k] for k in pair], axis=1) for pair in (LEVEL_FRAMES[:2], LEVEL_FRAMES[2:])]
    return run.picture_of(np.concatenate(rows), compiled)


def command() -> int:
    """Writes the tables and all pictures."""
    italian_methods.write_picture(italian_methods.measure("a1200-fast"), METHODS)  # a table has its figures
    before = pages.read()
    after = pages.with_tables(before, tables())
    changed = [name for name, text in after.items() if text != before[name]]
    for name in changed:
        (ROOT / name).write_text(after[name])
    first = scene.compile_scene(SCENES / "default.toml", 1)
    frame, = run.render(first, "a1200-fast", "addx").frames
    run.picture_of(frame, first).save(PICTURE, optimize=True)
    save_animation(ANIMATION, animation(), 80)
    level().save(LEVEL, optimize=True)
    pictures = [str(path.relative_to(ROOT)) for path in (PICTURE, ANIMATION, METHODS, LEVEL)]
    print(f"written: {', '.join([*changed, *pictures])}")
    return 0
