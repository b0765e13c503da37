"""The tables of the page on scenes: content and cycles of each, and answers to questions of the
notes that the project grew from."""

import json
import re
from functools import cache

from PIL import Image

from tmap.accuracy.italian_methods import is_of_the_note
from tmap.base.errors import UserError
from tmap.base.markdown import table
from tmap.base.paths import SCENES
from tmap.bench import bench, scenes
from tmap.bench.modes.measure import ROW
from tmap.compiler.scene import compile_scene
from tmap.guest.emulator import CLOCK_HZ
from tmap.run import conversion
from tmap.scene_file.scene_file import Scene


def shows(name: str) -> str:
    """Returns the first sentence of the comment at the start of a scene's file."""
    lines = []
    for line in (SCENES / f"{name}.toml").read_text().splitlines():
        if not line.startswith("#"):
            break
        lines.append(line.removeprefix("#").strip())
    sentence = re.split(r"(?<=[^.])[.](?= |$)", " ".join(lines))[0]
    if not sentence:
        raise UserError(f"{name}.toml: does not begin with a comment that says what it shows")
    return sentence.replace("`", "")


@cache
def first_frames() -> dict[str, Scene]:
    """Returns a scene of one frame for each file of tests/scenes, by name."""
    return {path.stem: compile_scene(path, 1) for path in sorted(SCENES.glob("*.toml"))}


def rates(scene: Scene, machine: str, spent: float) -> str:
    """Returns frames a second without a display, and on the screen if that can show them."""
    converted = conversion.cycles(scene, machine, spent)
    return f"{CLOCK_HZ / spent:.1f}" + (f"; {CLOCK_HZ / (spent + converted):.1f}" if converted else "")


def scenes_table(baseline: dict) -> str:
    """A Markdown table: each scene, its cycles a frame and frames a second if measured."""
    figures, rows = {(row["name"], row["machine"]): bench.cycles(row) for row in baseline["frames"]}, []
    for name, scene in first_frames().items():
        cells = []
        for machine in ("a1200-fast", "a1200"):
            spent = figures.get((f"{scenes.ROW}{name}", machine))
            cells += [f"{spent / 1000:,.0f}", rates(scene, machine, spent)] if spent else ["", ""]
        rows.append([name, shows(name), *cells])
    return table(["scene", "shows", "fast RAM, kcycles a frame", "a second; on the screen",
                  "chip RAM only", "a second; on the screen"], rows, "llr")


def fatmap2(accuracy: dict, counted: dict) -> list[tuple[str, str]]:
    """Questions and answers: cycles of exactness, and fatmap2's fillers compared with ours."""
    rows = {(row["edges"], row["gradients"], row["start"]): row for row in accuracy["rows"]
            if (row["name"], row["machine"], row["mapper"]) == ("medium", "a1200-fast", "affine")}
    plain, exact = (rows[settings] for settings in (
        ("integer", "polygon", "truncated"), ("exact", "plane", "subtexel")))
    return [("cycles a pixel of triangles: cut to whole pixels and texels; exact",
             f"{plain['cycles_per_pixel']:.1f}; {exact['cycles_per_pixel']:.1f}"),
            ("how far texels are off, root of the mean square: the same",
             f"{plain['texel_error_rms']:.2f}; {exact['texel_error_rms']:.4f}"),
            *((f"thousand cycles a triangle, {row['name']}: Pentium 120; 68020",
               f"{row['pentium_kilocycles']:.1f}; {row['kilocycles_per_polygon']:.1f}")
              for row in counted["rows"] if row["machine"] == "a1200-fast")]


def tiles(pixels: dict, counted: dict) -> list[tuple[str, str]]:
    """Returns questions and answers: cycles of tiles on processors with hardly a cache."""
    kilocycles = {(row["name"], row["machine"]): f"{row['kilocycles_per_polygon']:.1f}"
                  for row in counted["rows"] + counted["rows_68030"]}
    return [(f"thousand cycles a random triangle, {words}: rows; tiles of 8x8",
             "; ".join(kilocycles[name, machine] for name in ("texture", "tiled")))
            for words, machine in (("68020", "a1200-fast"),
                                   ("68030 with its data cache", "a1200-030, data cache"))] + [
        ("cycles a pixel of spans: rows; tiles; columns",
         "; ".join(f"{pixels[name]:.1f}" for name in ("affine_addx", "tiled", "columns")))]


def a1200_note(pixels: dict) -> list[tuple[str, str]]:
    """Returns questions and answers: swap and addx, and the three methods on the turning face."""
    with Image.open(SCENES / "methods.png") as picture:
        methods = json.loads(picture.text["Description"])
    found = [(f"cycles a {what}: swap; addx", "; ".join(
        f"{pixels[name.format(form)]:.1f}" for form in ("swap", "addx")))
        for what, name in (("step of one number", "step_{}_1"), ("textured pixel", "pixel_{}_2"))]
    return found + [(f"method {name}: thousand cycles a frame; texels off (rms)",
                     f"{each['cycles'] / 1000:,.0f}; {each['rms']:.2f}")
                    for name, each in sorted(methods.items()) if is_of_the_note(name)]


#: Tables of the texture units: by title, questions and the modes that answer them.
MODES = {"the N64's manual": {
    "points; the three-point filter": ("point", "threepoint"),
    "the same with perspective": ("point_perspective", "threepoint_perspective"),
    "trilinear, levels of detail and perspective; sharpened": ("trilinear", "sharpen"),
    "two tiles blended by a constant": ("blend",)},
         "Glide's guide": {
    "points; the bilinear filter": ("glide_point", "glide_bilinear"),
    "the same with perspective": ("glide_point_perspective", "glide_bilinear_perspective"),
    "the same with a level of detail a pixel": ("glide_mip_point", "glide_mip_bilinear"),
    "trilinear by two units": ("glide_trilinear",)}}


def mode_rows(baseline: dict, questions: dict[str, tuple[str, ...]]) -> list[tuple[str, str]]:
    """Returns questions and answers: cycles a pixel of modes."""
    modes = {row["name"]: bench.cycles(row) for row in baseline["modes"]
             if row["machine"] == "a1200-fast"}
    return [(f"cycles a pixel of polygons: {question}",
             "; ".join(f"{modes[ROW + name]:,.0f}" for name in names))
            for question, names in questions.items()]


def tables(baseline: dict, accuracy: dict, counted: dict) -> dict[str, str]:
    """Returns the tables by title."""
    pixels = {row["name"]: bench.cycles(row) for row in baseline["rows"]
              if row["machine"] == "a1200-fast" and row["length"] >= 256}
    found = {"fatmap2": fatmap2(accuracy, counted), "tiles": tiles(pixels, counted),
             "the note for the A1200": a1200_note(pixels)}
    found |= {title: mode_rows(baseline, questions) for title, questions in MODES.items()}
    return {"scenes": scenes_table(baseline)} | {
        title: table(["question", "answer"], rows) for title, rows in found.items()}
