"""``tmap readme``: writes the tables and pictures of the pages, so that nobody types them.

Figures are the committed baselines'; tools/pages.py has where tables stand.
"""

import json

import numpy as np
from PIL import Image

from . import (bench, bench_effects, bench_instructions, bench_rules, dither_errors, emulator, engines, pages, palette,
               polys, readme_modes, readme_numbers, readme_programs, readme_scenes, run, scene, scene_file)
from .paths import ACCURACY_BASELINE, BASELINE, POLYS_BASELINE, ROOT, SCENES

PICTURE, ANIMATION = SCENES / "default.png", SCENES / "environment.gif"
METHODS = SCENES / "methods.png"
COLOURS = 24  # of the animation
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


#: What accuracy costs: edges, gradients, start, mapper of the table's lines.
ACCURACY_LINES = (("integer", "polygon", "truncated", "affine"),
                  ("subpixel", "polygon", "truncated", "affine"),
                  ("subpixel", "polygon", "subtexel", "affine"),
                  ("subpixel", "plane", "subtexel", "affine"),
                  ("exact", "plane", "subtexel", "affine"),
                  ("exact", "scanline", "subtexel", "affine"),
                  *(("exact", "plane", "subtexel", mapper) for mapper in (
                      "arbitrary", "tiled", "columns", "generated", "gouraud",
                      "lit", "lit_gouraud", "dithered")))


def accuracy_table(baseline: dict) -> str:
    """Markdown: the medium set in fast RAM."""
    rows = {(r["edges"], r["gradients"], r["start"], r["mapper"]): r for r in baseline["rows"]
            if r["machine"] == "a1200-fast" and r["name"] == "medium"}
    lines = ["| mapper | edges | gradients | start | cycles a pixel | wrong pixels in 10^6 "
             "| rms error, texels | wrong texels |", "|---|---|---|---|--:|--:|--:|--:|"]
    for edges, gradients, start, mapper in ACCURACY_LINES:
        r = rows[edges, gradients, start, mapper]
        lines.append(f"| {mapper} | {edges} | {gradients} | {start} | {r['cycles_per_pixel']:.1f} "
                     f"| {r['coverage_errors_per_million']:,.0f} | {r['texel_error_rms']:.4f} "
                     f"| {r['wrong_texels_percent']:.2f} % |")
    return "\n".join(lines)


#: Perspective: title, setting, bench row of its spans, of the ones that take over.
PERSPECTIVE_LINES = (("none: affine", "none", "affine_addx", None),
                     ("every 16 pixels", "every16", "persp_every16", "persp_every16_exact"),
                     ("every 8 pixels", "every8", "persp_every8", "persp_every8_exact"),
                     ("each pixel, 1/32 texel", "pixel", "persp_pixel", "persp_pixel_exact"),
                     ("each pixel, 1/128 texel", "fine", "persp_pixel_fine", None))


def perspective_table(baseline: dict, accuracy: dict) -> str:
    """Markdown: spans of 256 pixels in fast and mixed RAM, whole polygons in fast RAM."""
    figures = {bench.key(row): bench.cycles(row) for row in baseline["rows"]}
    rows = {r["perspective"]: r for r in accuracy["rows"] if r["name"] == "depth"
            and (r["machine"], r["edges"]) == ("a1200-fast", "exact")}
    lines = ["| perspective | span, fast RAM | data in chip | the exact form | polygons | largest error, "
             "texels | rms |", "|---|--:|--:|--:|--:|--:|--:|"]
    for title, setting, name, exact in PERSPECTIVE_LINES:
        cells = [figures[name, machine, 256] for machine in ("a1200-fast", "a1200-mixed")]
        other = f"{figures[exact, 'a1200-fast', 256]:.1f}" if exact else ""
        r = rows[setting]
        lines.append(f"| {title} | {cells[0]:.1f} | {cells[1]:.1f} | {other} | {r['cycles_per_pixel']:.0f} "
                     f"| {r['texel_error_max']:.3f} | {r['texel_error_rms']:.4f} |")
    return "\n".join(lines)


#: Effects: title, bench row, its length.
EFFECT_LINES = (("rotator, 320x256, addx", "rotator", 320),
                ("rotator, v wraps more than once a line", "rotator_wrap", 320),
                ("rotator, swap", "rotator_swap", 320),
                ("rotator, generated code", "rotator_generated", 320),
                ("v's step 0: floors, upright pictures", "affine_row", 256),
                ("u's step 0: walls on their side", "affine_column", 256),
                ("texels and frame of 16 bits", "affine_16", 256),
                ("the same, v's step 0, a texel a pixel: copied", "affine_16_copy", 256),
                ("texels and frame of 32 bits", "affine_32", 256),
                ("lit, one level", "affine_lit", 256),
                ("lit, a level each pixel", "affine_gouraud", 256))


def effects_table(baseline: dict) -> str:
    """Markdown: cycles a pixel on each machine, pixels a second and wrong texels."""
    figures = {bench.key(row): bench.cycles(row) for row in baseline["rows"]}
    lines = ["| cycles a pixel | " + " | ".join(MACHINES.values())
             + " | pixels a second, fast RAM | wrong texels |", "|---|" + "--:|" * 5]
    for title, name, length in EFFECT_LINES:
        found = [figures[name, machine, length] for machine in MACHINES]
        kernel, _, steps = bench_effects.ROTATORS.get(name, ("exact", "", bench_effects.TURNED))
        wrong = 100 * bench_effects.wrong_texels(kernel, steps)
        lines.append(f"| {title} | " + " | ".join(f"{n:.1f}" for n in found)
                     + f" | {run.CLOCK_HZ / found[0]:,.0f} | {wrong:.0f} % |")
    return "\n".join(lines)


#: Dithered points beside points: title, bench rows.
DITHERED_LINES = (("8 bits", "dithered", "affine_addx"),
                  ("8 bits, where v may wrap", "dithered_wrap", "affine_addx_wrap"),
                  ("16 or 32 bits", "dithered_16", "affine_16"),
                  ("16 or 32 bits, where v may wrap", "dithered_16_wrap", "affine_16_wrap"))


def dithered_tables(baseline: dict) -> str:
    """Markdown: what dithered points are off from the bilinear filter, and what they cost."""
    figures = {bench.key(row): bench.cycles(row) for row in baseline["rows"]}
    lines = ["| cycles a pixel, dithered / points | " + " | ".join(MACHINES.values()) + " |",
             "|---|" + "--:|" * len(MACHINES)]
    for title, *names in DITHERED_LINES:
        cells = [" / ".join(f"{figures[name, machine, 256]:.1f}" for name in names)
                 for machine in MACHINES]
        lines.append(f"| {title} | " + " | ".join(cells) + " |")
    return "\n".join([dither_errors.table(), "", *lines])


#: Meshes: title of a line, row.
MESH_LINES = (("a point, to the camera and the screen", "mesh_transform"),
              ("a point outside the borders", "mesh_transform_outside"),
              ("a normal: one of s, t and shade", "mesh_looks"),
              ("a face of four corners that is seen", "mesh_faces"),
              ("a face seen from the back", "mesh_faces_back"),
              ("a new corner where a border cuts", "mesh_cut"))


def mesh_table(baseline: dict) -> str:
    """Markdown: what meshes cost before their polygons are drawn."""
    figures = {bench.key(row): bench.cycles(row) for row in baseline["points"]}
    lines = ["| cycles | " + " | ".join(MACHINES.values()) + " |",
             "|---|" + "--:|" * len(MACHINES)]
    for title, name in MESH_LINES:
        cells = [f"{figures[name, machine, 1]:.0f}" for machine in MACHINES]
        lines.append(f"| {title} | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def rules_table(baseline: dict) -> str:
    """Markdown: what a polygon costs without each rule of lowering, and with it."""
    figures = {bench.key(row): bench.cycles(row) for row in baseline["rules"]}
    machines = {"a1200-fast": "fast RAM", "a1200": "chip RAM only"}
    lines = ["| rule | spans without it | with it | " + " | ".join(machines.values()) + " |",
             "|---|---|---|" + "--:|" * len(machines)]
    for case in bench_rules.CASES:
        cells = []
        for machine in machines:
            on, off = (figures[f"rule_{case.name}{end}", machine, 1] / 1000
                       for end in ("", bench_rules.WITHOUT))
            cells.append(f"{off:.1f} / {on:.1f}")
        lines.append(f"| {case.name} | {case.asked or 'none'} | {case.lowered or 'none'} | "
                     + " | ".join(cells) + " |")
    return "\n".join(lines)


def tables() -> dict[str, str]:
    """All tables of all pages by title, as the baselines have them."""
    measured, accuracy = (json.loads(path.read_text()) for path in (BASELINE, ACCURACY_BASELINE))
    counted = json.loads(POLYS_BASELINE.read_text())
    found = {"addx against swap": table(measured), "effects": effects_table(measured),
             "meshes": mesh_table(measured), "rules": rules_table(measured),
             "what accuracy costs": accuracy_table(accuracy),
             "dithered points": dithered_tables(measured),
             "perspective": perspective_table(measured, accuracy),
             "polygons a second": polys.table(counted["rows"]).rstrip(),
             "instructions": bench_instructions.table(measured, MACHINES),
             "Glide's steps": readme_modes.steps_table(measured),
             "Glide's steps not called for": readme_modes.uncalled_table(measured)}
    for engine in engines.ENGINES.values():
        found |= {f"{engine.title} modes": readme_modes.modes_table(measured, engine),
                  f"{engine.title} formats": readme_modes.formats_table(measured, engine)}
    return (found | readme_numbers.tables() | readme_programs.tables(measured)
            | readme_scenes.tables(measured, accuracy, counted))


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


def fewer_colours(full: np.ndarray, frame: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """COLOURS colours for what a frame shows of a palette, its first one kept, and which of them
    stands for each entry."""
    shown = Image.fromarray(full[frame[frame != 0]][None])
    reduced = shown.quantize(COLOURS - 1, Image.Quantize.MEDIANCUT, kmeans=1,
                             dither=Image.Dither.NONE).getpalette()
    colours = np.concatenate([full[:1], np.array(reduced, np.uint8).reshape(-1, 3)])[:COLOURS]
    return colours, palette.nearest(full, colours)


def animation() -> list[Image.Image]:
    """Every other frame of the environment-mapped knot, in few colours: half the bytes."""
    compiled = scene.compile_scene(SCENES / "environment.toml")
    frames = run.render(compiled, "a1200-fast", "addx").frames
    colours, entries = fewer_colours(compiled.palette, frames[0])
    images = [Image.fromarray(entries[frame]) for frame in frames[::2]]
    for image in images:
        image.putpalette(colours.tobytes())
    return images


def command() -> int:
    """Writes the tables and all pictures."""
    from . import methods

    before = pages.read()
    after = pages.with_tables(before, tables())
    changed = [name for name, text in after.items() if text != before[name]]
    for name in changed:
        (ROOT / name).write_text(after[name])
    picture().save(PICTURE, optimize=True)
    first, *others = animation()
    first.save(ANIMATION, save_all=True, append_images=others, duration=80, loop=0)
    methods.write_picture(methods.measure("a1200-fast"), METHODS)
    pictures = [str(path.relative_to(ROOT)) for path in (PICTURE, ANIMATION, METHODS)]
    print(f"written: {', '.join([*changed, *pictures])}")
    return 0
