"""The tables of the page on scenes: what each shows and costs, and what became of the notes that the
project grew from."""

import json
import re

from PIL import Image

from . import bench, bench_scenes, run
from .bench_modes import ROW
from .errors import UserError
from .paths import SCENES


def shows(name: str) -> str:
    """The first sentence of the comment that a scene's file begins with."""
    lines = []
    for line in (SCENES / f"{name}.toml").read_text().splitlines():
        if not line.startswith("#"):
            break
        lines.append(line.removeprefix("#").strip())
    sentence = re.split(r"(?<=[^.])[.](?= |$)", " ".join(lines))[0]
    if not sentence:
        raise UserError(f"{name}.toml: does not begin with a comment that says what it shows")
    return sentence.replace("`", "")


def scenes_table(baseline: dict) -> str:
    """Markdown: each scene, cycles of a frame and frames a second; blank where it is not measured."""
    figures = {bench.key(row): bench.cycles(row) for row in baseline["frames"]}
    lines = ["| scene | shows | fast RAM, kcycles a frame | frames a second | chip RAM only "
             "| frames a second |", "|---|---|" + "--:|" * 4]
    for name in sorted(path.stem for path in SCENES.glob("*.toml")):
        cells = []
        for machine in ("a1200-fast", "a1200"):
            spent = figures.get((f"scene_{name}", machine, bench_scenes.FRAMES))
            cells += [f"{spent / 1000:,.0f}", f"{run.CLOCK_HZ / spent:.1f}"] if spent else ["", ""]
        lines.append(f"| {name} | {shows(name)} | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def affine_notes(pixels: dict, accuracy: dict, counted: list[dict]) -> list[tuple[str, str, str]]:
    """What became of fatmap2's ideas and of the tiles: note, question, answer."""
    plain, exact = (next(
        row for row in accuracy["rows"] if (row["name"], row["machine"], row["mapper"]) == (
            "medium", "a1200-fast", "affine") and (row["edges"], row["gradients"], row["start"])
        == settings) for settings in (("integer", "polygon", "truncated"),
                                      ("exact", "plane", "subtexel")))
    kilocycles = {(row["name"], row["machine"]): row["kilocycles_per_polygon"] for row in counted}
    found = [("fatmap2", "cycles a pixel of triangles: cut to pixels and texels, or exact",
              f"{plain['cycles_per_pixel']:.1f}, {exact['cycles_per_pixel']:.1f}"),
             ("fatmap2", "texels they are off, root of the mean square",
              f"{plain['texel_error_rms']:.2f}, {exact['texel_error_rms']:.4f}")]
    found += [("fatmap2", f"thousand cycles a {name} triangle: Pentium, 68020 with fast RAM",
               f"{row['pentium_kilocycles']:.1f}, {row['kilocycles_per_polygon']:.1f}")
              for row in counted if row["machine"] == "a1200-fast" for name in [row["name"]]]
    cached = "a1200-030, data cache"
    return found + [
        ("tiles", "the same as rows and as tiles of 8x8, with no data cache",
         f"{kilocycles['texture', 'a1200-fast']:.1f}, {kilocycles['tiled', 'a1200-fast']:.1f}"),
        ("tiles", "on a 68030 with its cache of 256 bytes",
         f"{kilocycles['texture', cached]:.1f}, {kilocycles['tiled', cached]:.1f}"),
        ("tiles", "cycles a pixel of spans: rows, tiles, columns",
         ", ".join(f"{pixels[name]:.1f}" for name in ("affine_addx", "tiled", "columns")))]


def method_notes(pixels: dict) -> list[tuple[str, str, str]]:
    """What became of the note for the A1200."""
    with Image.open(SCENES / "methods.png") as picture:
        methods = json.loads(picture.text["Description"])
    found = [("A1200", f"cycles a {what}, swap and addx",
              ", ".join(f"{pixels[name.format(form)]:.1f}" for form in ("swap", "addx")))
             for what, name in (("step of one number", "step_{}_1"), ("textured pixel", "pixel_{}_2"))]
    return found + [
        ("A1200", f"method {name}: thousand cycles a frame, texels off (rms)",
         f"{each['cycles'] / 1000:,.0f}, {each['rms']:.2f}")
        for name, each in sorted(methods.items()) if name[0].isdigit()]


#: Of the texture units: note, question, modes.
MODE_NOTES = (
    ("N64", "points, the three-point filter", ("point", "threepoint")),
    ("N64", "trilinear by levels of detail, with perspective", ("trilinear",)),
    ("Glide", "points, the bilinear filter", ("tmu_point", "tmu_bilinear")),
    ("Glide", "the same with perspective and a level of detail a pixel",
     ("tmu_mip_point", "tmu_mip_bilinear")))


def notes_table(baseline: dict, accuracy: dict, counted: list[dict]) -> str:
    """Markdown: what the notes' ideas come to on this machine; fast RAM where nothing else is said."""
    pixels = {row["name"]: bench.cycles(row) for row in reversed(baseline["rows"])
              if row["machine"] == "a1200-fast" and row["length"] >= 256}
    modes = {row["name"]: bench.cycles(row) for row in baseline["modes"]
             if row["machine"] == "a1200-fast"}
    rows = affine_notes(pixels, accuracy, counted) + method_notes(pixels)
    rows += [(note, f"cycles a pixel of polygons: {question}",
              ", ".join(f"{modes[ROW + name]:,.0f}" for name in names))
             for note, question, names in MODE_NOTES]
    lines = ["| note | question | answer |", "|---|---|--:|"]
    return "\n".join([*lines, *(f"| {' | '.join(row)} |" for row in rows)])


def tables(baseline: dict, accuracy: dict, counted: list[dict]) -> dict[str, str]:
    """By title."""
    return {"scenes": scenes_table(baseline), "notes": notes_table(baseline, accuracy, counted)}
