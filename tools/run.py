"""``tmap run``: a scene rendered on the emulated A1200, as pictures and figures."""

import json
import os
import re
import sys
import tempfile
from pathlib import Path

import numpy as np
from PIL import Image
from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn

from . import emulator, maps, model, provenance
from .emulator import CYCLES_PER_TICK
from .errors import UserError
from .scene import compile_scene, parse
from .scene_file import SETTINGS, TEXEL, Scene, write

CLOCK_HZ = 14_187_580  # of a PAL A1200's 68EC020
CYCLES_UNIT = (f"CPU cycles, {CLOCK_HZ / 1e6} MHz, from the background to the last polygon, "
               f"DMA and interrupts off; measured in E-clock ticks of {CYCLES_PER_TICK} cycles")
GIF_FRAME_MS = 40
ROWS_MAX = 10  # frames that are listed one by one
#: What a run writes and the next one replaces, run.json first: it describes the rest.
WRITTEN = ("run.json", "animation.gif", "frame_[0-9][0-9][0-9].chunky",
           "frame_[0-9][0-9][0-9].png")
FRAME_LINE = re.compile(r"frame (\d+) ticks (\d+) polygons (\d+)((?: [a-z]\w* \d+)*)")
#: Not "scene": the Amiga would take that argument for its template's keyword.
SCENE_NAME = "input.scene"


def check_directory(out: Path) -> None:
    """Refuses a place where no directory can be, before the work begins."""
    for place in (out, *out.parents):
        if os.path.lexists(place):
            if not place.is_dir():
                raise UserError(f"{place}: is not a directory")
            return


def parse_output(output: str, frames: int) -> list[dict]:
    """The figures of each frame in what ``render`` printed, one line a frame."""
    lines = output.splitlines()
    if len(lines) != frames:
        raise UserError(f"render: {len(lines)} lines of output for {frames} frames; "
                        + emulator.last_words(output))
    figures = []
    for number, line in enumerate(lines):
        match = FRAME_LINE.fullmatch(line)
        if not match or int(match[1]) != number:
            raise UserError(f"render: {line!r} is not the line of frame {number}")
        words = match[4].split()
        spans = {kind: int(count) for kind, count in zip(words[::2], words[1::2])}
        figures.append({"number": number, "cycles": int(match[2]) * CYCLES_PER_TICK,
                        "polygons": int(match[3]), "pixels": sum(spans.values()),
                        "spans": spans})
    return figures


def check_frame(frame: np.ndarray, scene: Scene, number: int) -> None:
    """Refuses a frame of one colour unless nothing else is to be seen, says the model."""
    if (frame == frame[0, 0]).all() and (model.render(scene, number) != frame).any():
        raise UserError(f"frame {number}: one colour only, though the scene has something to "
                        "show there: the run failed")


def load_dumps(volume: Path, scene: Scene) -> list[np.ndarray]:
    """All frames, (height, width) pixels (palette indices or RGB565), checked."""
    names = [f"frame_{number:03}.chunky" for number in range(scene.frames)]
    found = sorted(path.name for path in volume.glob("frame_*.chunky"))
    if found != names:
        odd = sorted(set(names) ^ set(found))[0]
        raise UserError(f"render: {odd} is {'missing' if odd in names else 'one frame too many'}")
    frames = []
    for number, name in enumerate(names):
        data = (volume / name).read_bytes()
        if len(data) != scene.width * scene.height * scene.pixel_bytes:
            raise UserError(f"render: {name} has {len(data)} bytes, not "
                            f"{scene.width}x{scene.height}"
                            + (f"x{scene.pixel_bytes}" if scene.pixel_bytes > 1 else ""))
        pixel = TEXEL[scene.pixel_bytes]
        found = np.frombuffer(data, pixel.newbyteorder(">")).astype(pixel)
        frames.append(found.reshape(scene.height, scene.width))
        check_frame(frames[-1], scene, number)
    return frames


def render(scene: Scene, machine: str, form: str) -> tuple[list[np.ndarray], list[dict]]:
    """Frames and figures of a run, with a bar on stderr where that is a terminal."""
    console = Console(stderr=True)
    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(),
               TimeElapsedColumn())
    with (emulator.workspace() as directory,
          Progress(*columns, console=console, transient=True,
                   disable=not sys.stderr.isatty()) as bar):
        task = bar.add_task(f"rendering on {machine}", total=scene.frames)
        done = emulator.run(
            "render", f"{SCENE_NAME} FORM {form} COUNT", {SCENE_NAME: write(scene)}, machine,
            directory, lambda output: bar.update(task, completed=output.count("\n")))
        if done.code:
            raise UserError(f"render: return code {done.code}; "
                            + emulator.last_words(done.output))
        figures = parse_output(done.output, scene.frames)
        return load_dumps(done.directory, scene), figures


def total(figures: list[dict]) -> dict:
    """The sum of all frames' figures."""
    sums = {key: sum(frame[key] for frame in figures) for key in ("cycles", "polygons", "pixels")}
    kinds = dict.fromkeys(kind for frame in figures for kind in frame["spans"])
    sums["spans"] = {kind: sum(f["spans"].get(kind, 0) for f in figures) for kind in kinds}
    pixels = sums["pixels"]  # of the polygons, hidden ones too
    return sums | {"cycles_per_pixel": round(sums["cycles"] / pixels, 3) if pixels else None}


def as_json(about: dict) -> str:
    """JSON with a field a line, and a frame a line."""
    texts = {key: json.dumps(value) for key, value in about.items()}
    texts["frames"] = "[\n  " + ",\n  ".join(map(json.dumps, about["frames"])) + "]"
    return "{\n " + ",\n ".join(f'"{key}": {text}' for key, text in texts.items()) + "\n}\n"


def picture_of(frame: np.ndarray, palette: np.ndarray) -> Image.Image:
    """A frame as a picture; palette uint8 (256, 3) of one with a byte a pixel."""
    if frame.dtype == TEXEL[2]:
        return Image.fromarray(maps.from_rgb565(frame))
    picture = Image.fromarray(frame, "P")
    picture.putpalette(palette.tobytes())
    return picture


def save(folder: Path, frames: list[np.ndarray], palette: np.ndarray, about: dict) -> None:
    """Writes dumps, pictures and run.json; palette uint8 (256, 3)."""
    pictures = []
    for number, frame in enumerate(frames):
        picture = picture_of(frame, palette)
        picture.save(folder / f"frame_{number:03}.png")
        dump = frame.astype(frame.dtype.newbyteorder(">")).tobytes()
        (folder / f"frame_{number:03}.chunky").write_bytes(dump)
        pictures.append(picture)
    if len(pictures) > 1:
        pictures[0].save(folder / "animation.gif", save_all=True, append_images=pictures[1:],
                         duration=GIF_FRAME_MS, loop=0, optimize=False)
    (folder / "run.json").write_text(as_json(about))


def publish(out: Path, frames: list[np.ndarray], palette: np.ndarray, about: dict) -> None:
    """Replaces what an earlier run left in ``out``, once everything new is on the disk."""
    try:
        out.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(prefix=".tmap-", dir=out) as folder:
            save(Path(folder), frames, palette, about)
            for pattern in WRITTEN:
                for old in out.glob(pattern):
                    old.unlink()
            for new in sorted(Path(folder).iterdir()):  # run.json comes last
                new.replace(out / new.name)
    except OSError as error:
        raise UserError(f"{error.filename or out}: {error.strerror or error}") from None


def print_report(about: dict, out: Path) -> None:
    """A short table: each of a few frames, then the whole run."""
    frames, totals = about["frames"], about["totals"]
    count = len(frames)
    print(f"{about['title'] or about['scene']}: {about['width']}x{about['height']} on "
          f"{about['machine']}, form {about['form']}\n")
    if count <= ROWS_MAX:
        print(f"{'frame':>5} {'polygons':>9} {'pixels':>10} {'cycles':>12} {'cycles a pixel':>15}")
        for frame in frames:
            each = f"{frame['cycles'] / frame['pixels']:.1f}" if frame["pixels"] else "-"
            print(f"{frame['number']:>5} {frame['polygons']:>9} {frame['pixels']:>10,} "
                  f"{frame['cycles']:>12,} {each:>15}")
        print()
    mean, worst = totals["cycles"] / count, max(frames, key=lambda frame: frame["cycles"])
    each = totals["cycles_per_pixel"]
    rows = {"frames": count, "polygons": f"{totals['polygons']:,}",
            "pixels": f"{totals['pixels']:,}" + (f", {each:.1f} cycles each" if each else ""),
            "cycles a frame": f"{mean:,.0f} mean, {worst['cycles']:,} worst "
                              f"(frame {worst['number']})",
            "frames a second": f"{CLOCK_HZ / mean:.1f}, an estimate for {CLOCK_HZ / 1e6} MHz "
                               "without display",
            "spans used": ", ".join(f"{kind} {pixels:,} pixels" for kind, pixels
                                    in totals["spans"].items()) or "none"}
    last = f" to frame_{count - 1:03}.png, animation.gif" if count > 1 else ""
    rows["pictures"] = f"{out}/frame_000.png{last}"
    for name, text in rows.items():
        print(f"{name:<16} {text}")


def make(path: Path, out: Path, machine: str, frames: int | None, form: str) -> dict:
    """Renders a scene file into the directory ``out``; returns what run.json says."""
    check_directory(out)
    scene = compile_scene(path, frames)
    dumps, figures = render(scene, machine, form)
    content = parse(path)
    settings = {name: {kind: getattr(material, kind) for kind in SETTINGS}
                for name, material in zip(content["materials"], scene.materials)}
    about = {"scene": path.stem, "title": content["title"], "machine": machine, "form": form,
             **provenance.record(), "width": scene.width, "height": scene.height,
             "pixel_bytes": scene.pixel_bytes, "materials": settings,
             "palette": scene.palette.tolist() if scene.pixel_bytes == 1 else None,
             "cycles_unit": CYCLES_UNIT,
             "frames": figures, "totals": total(figures)}
    publish(out, dumps, scene.palette, about)
    return about


def command(path: Path, out: Path, machine: str, frames: int | None, form: str) -> int:
    """``tmap run``: renders, prints a table; raises UserError."""
    print_report(make(path, out, machine, frames, form), out)
    return 0
