"""``tmap run``: renders a scene on the emulated A1200 to pictures and figures."""

import json
import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from PIL import Image

from tmap.base.errors import UserError
from tmap.base.fixed import ONE
from tmap.base.outputs import bars, check_directory, replaced, save_animation
from tmap.build import layout
from tmap.compiler.scene import compile_scene, parse
from tmap.guest import emulator, provenance
from tmap.guest.emulator import CLOCK_HZ, CYCLES_PER_TICK
from tmap.model import model
from tmap.run import conversion, memory
from tmap.scene_file.materials import SETTINGS
from tmap.scene_file.scene_file import Scene, write

CYCLES_UNIT = (f"CPU cycles, {CLOCK_HZ / 1e6} MHz, from the background to the last polygon, "
               f"DMA and interrupts off; measured in colour clocks of {CYCLES_PER_TICK} cycles")
GIF_STEP_MS = 10
GIF_LEAST_MS = 20  # of a frame: browsers show a shorter one for 100 ms
GIF_MOST_MS = 65535 * GIF_STEP_MS  # of an animation: equal frames become one, whose time is 16 bits
ROWS_MAX = 10  # frames listed one by one, at most
#: Files that a run writes and the next one replaces. run.json is first: it describes the rest.
WRITTEN = ("run.json", "animation.gif", "frame_[0-9][0-9][0-9].chunky", "frame_[0-9][0-9][0-9].png")
COUNTS = r"((?: [a-z]\w* \d+)*)"
FRAME_LINE = re.compile(rf"frame (\d+) ticks (\d+) polygons (\d+){COUNTS}")
#: Kinds of spans that light pixels that others have drawn.
PASSES = ("light", "light_gouraud")
MATERIAL_LINE = re.compile(rf"material (\d+) polygons (\d+) unsure (\d+)(?: hidden (\d+) pixels (\d+))?"
                           rf" rules{COUNTS} spans{COUNTS}")
#: Not "scene": the Amiga would take that argument for the keyword in its template.
SCENE_NAME = "input.scene"


def counts_of(text: str) -> dict[str, int]:
    """Parses alternating names and numbers."""
    words = text.split()
    return {name: int(count) for name, count in zip(words[::2], words[1::2])}


def drawn(spans: dict[str, int]) -> int:
    """Returns the pixels that spans drew; PASSES went over them once more."""
    return sum(pixels for kind, pixels in spans.items() if kind not in PASSES)


def parse_lines(lines: list[str], pattern: re.Pattern, noun: str) -> list[re.Match]:
    """Matches lines with a pattern and checks their numbers, which count from 0."""
    found = []
    for number, line in enumerate(lines):
        match = pattern.fullmatch(line)
        if not match or int(match[1]) != number:
            raise UserError(f"render: {line!r} is not the line of {noun} {number}")
        found.append(match)
    return found


def parse_output(output: str, frames: int, materials: int) -> tuple[list[dict], list[dict]]:
    """Parses ``render``'s output, a line for each frame and material; returns their figures."""
    lines = output.splitlines()
    if len(lines) != frames + materials:
        raise UserError(f"render: {len(lines)} lines of output for {frames} frames and "
                        f"{materials} materials; " + emulator.last_words(output))
    figures = []
    for match in parse_lines(lines[:frames], FRAME_LINE, "frame"):
        spans = counts_of(match[4])
        figures.append({"number": int(match[1]), "cycles": int(match[2]) * CYCLES_PER_TICK,
                        "polygons": int(match[3]), "pixels": drawn(spans),
                        "spans": spans})
    executed = [{"polygons": int(match[2]), "unsure": int(match[3]), "hidden": int(match[4] or 0),
                 "hidden_pixels": int(match[5] or 0), "rules": counts_of(match[6]), "spans": counts_of(match[7])}
                for match in parse_lines(lines[frames:], MATERIAL_LINE, "material")]
    return figures, executed


def check_frame(frame: np.ndarray, scene: Scene, number: int) -> None:
    """Refuses a frame of one colour unless the model's frame is the same."""
    if (frame == frame[0, 0]).all() and (model.render(scene, number) != frame).any():
        raise UserError(f"frame {number}: one colour only, though the scene has something to "
                        "show there: the run failed")


def load_dumps(volume: Path, scene: Scene) -> list[np.ndarray]:
    """Loads and checks all frames, (height, width) pixels in the host's byte order."""
    names = [f"frame_{number:03}.chunky" for number in range(scene.frames)]
    found = sorted(path.name for path in volume.glob("frame_*.chunky"))
    if found != names:
        odd = sorted(set(names) ^ set(found))[0]
        raise UserError(f"render: {odd} is {'missing' if odd in names else 'one frame too many'}")
    frames = []
    for number, name in enumerate(names):
        data = (volume / name).read_bytes()
        size = scene.pixel.bytes
        if len(data) != scene.width * scene.height * size:
            raise UserError(f"render: {name} has {len(data)} bytes, not "
                            f"{scene.width}x{scene.height}"
                            + (f"x{size}" if size > 1 else ""))
        pixel = scene.pixel.dtype
        found = np.frombuffer(data, pixel.newbyteorder(">")).astype(pixel)
        frames.append(found.reshape(scene.height, scene.width))
        check_frame(frames[-1], scene, number)
    return frames


@dataclass
class Rendered:
    """The results of a run."""

    frames: list[np.ndarray]  # from ``load_dumps``
    figures: list[dict]  # of each frame
    #: For each material: polygons, those affine for want of precision, polygons by rule, pixels by span.
    executed: list[dict]


def render(scene: Scene, machine: str, form: str, off: str | None = None, timed: bool = True) -> Rendered:
    """Renders all frames, without the rules ``off``; ``timed``: as in emulator.run_batch. Shows a bar if stderr is a
    terminal."""
    with emulator.workspace() as directory, bars() as bar:
        task = bar.add_task(f"rendering on {machine}", total=scene.frames)
        done = emulator.run(
            "render", f"{SCENE_NAME} FORM {form} COUNT" + (f" OFF {off}" if off else ""),
            {SCENE_NAME: write(scene)}, machine, directory,
            lambda output: bar.update(task, completed=output.count("\n")),
            patience=emulator.PATIENT_SECONDS if len(scene.units) + len(scene.pipes) else None, timed=timed)
        if done.code:
            raise UserError(f"render: return code {done.code}; " + emulator.last_words(done.output))
        figures, executed = parse_output(done.output, scene.frames, len(scene.materials))
        return Rendered(load_dumps(done.directory, scene), figures, executed)


def total(figures: list[dict]) -> dict:
    """Sums the figures of all frames."""
    sums = {key: sum(frame[key] for frame in figures) for key in ("cycles", "polygons", "pixels")}
    kinds = dict.fromkeys(kind for frame in figures for kind in frame["spans"])
    sums["spans"] = {kind: sum(f["spans"].get(kind, 0) for f in figures) for kind in kinds}
    pixels = sums["pixels"]  # of the polygons, hidden ones too
    return sums | {"cycles_per_pixel": round(sums["cycles"] / pixels, 3) if pixels else None}


def as_json(about: dict) -> str:
    """Returns JSON with a line for each field and for each frame."""
    texts = {key: json.dumps(value) for key, value in about.items()}
    texts["frames"] = "[\n  " + ",\n  ".join(map(json.dumps, about["frames"])) + "]"
    return "{\n " + ",\n ".join(f'"{key}": {text}' for key, text in texts.items()) + "\n}\n"


def picture_of(frame: np.ndarray, scene: Scene) -> Image.Image:
    """Returns a scene's frame as a picture, with a pixel for each of low resolution."""
    frame = frame.repeat(scene.pixel_height, axis=0).repeat(scene.pixel_width, axis=1)
    if scene.pixel.colours:
        return Image.fromarray(scene.pixel.picture(frame))
    picture = Image.fromarray(frame, "P")
    picture.putpalette(scene.palette.tobytes())
    return picture


def gif_times(figures: list[dict]) -> list[int]:
    """Returns for how many ms an animation shows each frame: as long as the machine draws it, as far as
    GIFs can. What is rounded off a frame is added to the next. ``figures``: of each frame."""
    most = GIF_MOST_MS // len(figures) // GIF_STEP_MS * GIF_STEP_MS
    times, left = [], 0.0
    for frame in figures:
        left += 1000 * frame["cycles"] / CLOCK_HZ
        times.append(min(max(GIF_STEP_MS * round(left / GIF_STEP_MS), GIF_LEAST_MS), most))
        left -= times[-1]
    return times


def animation(figures: list[dict]) -> dict | None:
    """Returns an animation's times, ms of each frame, and its factor: how many times as long as on the
    machine it takes. None of a single frame, which has no animation."""
    if len(figures) < 2:
        return None
    times = gif_times(figures)
    seconds = sum(frame["cycles"] for frame in figures) / CLOCK_HZ
    return {"times_ms": times, "factor": round(sum(times) / 1000 / seconds, 3)}


def save(folder: Path, frames: list[np.ndarray], scene: Scene, about: dict) -> None:
    """Writes dumps, pictures and run.json."""
    pictures = []
    for number, frame in enumerate(frames):
        picture = picture_of(frame, scene)
        picture.save(folder / f"frame_{number:03}.png")
        dump = frame.astype(frame.dtype.newbyteorder(">")).tobytes()
        (folder / f"frame_{number:03}.chunky").write_bytes(dump)
        pictures.append(picture)
    if about["animation"]:
        save_animation(folder / "animation.gif", pictures, about["animation"]["times_ms"], optimize=False)
    (folder / "run.json").write_text(as_json(about))


def print_lowering(materials: dict) -> None:
    """Prints for each material its settings, the spans executed, and the rules that chose them."""
    width = max(map(len, materials), default=0)
    for name, material in materials.items():
        pixels = drawn(material["spans"])
        spans = ", ".join(f"{kind} {100 * count / pixels:.3g} %"
                          for kind, count in material["spans"].items()) or "nothing"
        mapper, depth = (material["asked"][kind] for kind in ("mapper", "perspective"))
        asked = mapper + (f", perspective {depth}" if depth != "none" else "")
        print(f"{name:<{width}}  asked {asked}; drew {spans}")
        if material["rules"]:
            print(f"{'':<{width}}  by " + ", ".join(f"{rule} {count:,}" for rule, count
                                                    in material["rules"].items()))
        if material["unsure"]:
            print(f"{'':<{width}}  {material['unsure']:,} of its polygons are affine: their depth varies too much "
                  "for exact planes; cut them")
    print()


def textures_text(kinds: dict[str, int]) -> str:
    """Returns what a run's table says of the memory of textures."""
    text = " and ".join(f"{size:,} bytes of {kind} RAM" for kind, size in kinds.items())
    return text + (": texels cost more in chip RAM" if len(kinds) > 1 else "")


def hidden_row(materials, shown: int) -> dict[str, str]:
    """Returns the row that says what was hidden and not drawn, of a scene with ``visible = "once"``. ``shown``: pixels
    of all frames."""
    materials = list(materials)
    pixels = sum(material["hidden_pixels"] for material in materials)
    drawn_once = sum(drawn(material["spans"]) for material in materials) - pixels
    return {"not drawn": f"{sum(material['hidden'] for material in materials):,} polygons and {pixels:,} pixels that are "
                         f"hidden: {drawn_once / shown:.2f} drawn for one of the frame"} if pixels else {}


def on_screen(drawing: float, converting: float | None) -> str:
    """Returns what a run's table says of a frame that is converted and shown after ``drawing`` cycles."""
    if converting is None:
        return "too large for the screen"
    return f"{CLOCK_HZ / (drawing + converting):.1f} on the screen (converted in {converting:,.0f} cycles)"


def print_report(about: dict, out: Path) -> None:
    """Prints a short table: each frame if there are few, the spans executed, then the whole run."""
    frames, totals = about["frames"], about["totals"]
    count = len(frames)
    print(f"{about['title'] or about['scene']}: {about['width']}x{about['height']} "
          f"{'pixels of ' + about['pixel'] + ' ' if about['pixel'] != '1x1' else ''}on "
          f"{about['machine']}, form {about['form']}\n")
    if count <= ROWS_MAX:
        print(f"{'frame':>5} {'polygons':>9} {'pixels':>10} {'cycles':>12} {'cycles a pixel':>15}")
        for frame in frames:
            each = f"{frame['cycles'] / frame['pixels']:.1f}" if frame["pixels"] else "-"
            print(f"{frame['number']:>5} {frame['polygons']:>9} {frame['pixels']:>10,} "
                  f"{frame['cycles']:>12,} {each:>15}")
        print()
    print("Each material, pixels of its spans, and polygons to which each rule applied:\n")
    print_lowering(about["lowering"])
    mean, worst = totals["cycles"] / count, max(frames, key=lambda frame: frame["cycles"])
    each, shown = totals["cycles_per_pixel"], about["width"] * about["height"] * count
    rows = {"frames": count, "polygons": f"{totals['polygons']:,}",
            "pixels": f"{totals['pixels']:,}" + (f", {each:.1f} cycles each" if each else ""),
            "overdraw": f"{totals['pixels'] / shown:.2f} pixels drawn for one of the frame",
            **hidden_row(about["lowering"].values(), shown),
            "cycles a frame": f"{mean:,.0f} mean, {worst['cycles']:,} worst "
                              f"(frame {worst['number']})",
            "frames a second": f"{CLOCK_HZ / mean:.1f} without a display, {on_screen(mean, about['conversion'])}; "
                               f"estimates for {CLOCK_HZ / 1e6} MHz",
            "spans used": ", ".join(f"{kind} {pixels:,} pixels" for kind, pixels
                                    in totals["spans"].items()) or "none"}
    if about["trees"]["nodes"]:
        rows["trees"] = f"{about['trees']['faces']:,} faces in {about['trees']['nodes']:,} nodes, those counted " \
                        "that splits made"
    if about["textures"]:
        rows["textures"] = textures_text(about["textures"])
    if about["shared"]["pages"]:
        rows["pages"] = "{maps} maps share {pages}".format(**about["shared"])
    if about["animation"]:
        factor = about["animation"]["factor"]
        limit = f"a frame is shown for {GIF_LEAST_MS} ms at least" if factor > 1 \
            else f"all frames are shown for {GIF_MOST_MS // 1000} s at most"
        rows["animation"] = "at the estimated speed" if f"{factor:.2f}" == "1.00" \
            else f"takes {factor:.2f} times as long as estimated: {limit}"
    last = f" to frame_{count - 1:03}.png, animation.gif" if count > 1 else ""
    rows["pictures"] = f"{out}/frame_000.png{last}"
    for name, text in rows.items():
        print(f"{name:<16} {text}")


def rules(off: str | None) -> str | None:
    """Checks the names in a list separated by commas; returns the list."""
    known = layout.load().names("RULE_")
    for name in off.split(",") if off else []:
        if name not in ("all", *known):
            raise UserError(f"--off: {name!r} is not one of all, {', '.join(known)}")
    return off


def make(path: Path, out: Path, machine: str, frames: int | None, form: str,
         off: str | None = None) -> dict:
    """Renders a scene file into the directory ``out``; returns run.json's content."""
    check_directory(out)
    scene = compile_scene(path, frames)
    memory.check(scene, machine, str(path))
    done = render(scene, machine, form, rules(off))
    content = parse(path)
    lowering = {name: {"asked": {kind: getattr(material, kind) for kind in SETTINGS}
                       | {"tolerance": material.tolerance / ONE}} | executed
                for name, material, executed in zip(content["materials"], scene.materials,
                                                    done.executed)}
    about = {"scene": path.stem, "title": content["title"], "machine": machine, "form": form, "off": off,
             **provenance.record(), "width": scene.width, "height": scene.height, "pixel": content["pixel"],
             "format": scene.format, "lowering": lowering,
             "trees": {"faces": len(scene.slots), "nodes": len(scene.nodes)},
             "palette": None if scene.pixel.colours else scene.palette.tolist(),
             "cycles_unit": CYCLES_UNIT,
             "conversion": conversion.cycles(scene, machine, total(done.figures)["cycles"] / len(done.figures)),
             "textures": memory.for_textures(scene, machine), "shared": memory.shared(scene),
             "animation": animation(done.figures), "frames": done.figures, "totals": total(done.figures)}
    with replaced(out, WRITTEN, WRITTEN[0]) as folder:
        save(folder, done.frames, scene, about)
    return about


def command(path: Path, out: Path, machine: str, frames: int | None, form: str,
            off: str | None = None) -> int:
    """``tmap run``: renders, prints a table; raises UserError."""
    print_report(make(path, out, machine, frames, form, off), out)
    return 0
