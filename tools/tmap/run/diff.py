"""Compares frames: dumps of the chunky buffer, PNGs, or whole run directories.

Dumps of indices are compared by the colours of their palettes, or by index if one has no palette.
"""

import json
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from PIL import Image

from tmap.base.errors import UserError
from tmap.base.outputs import check_directory, replaced
from tmap.base.pixel_formats import FORMATS, PixelFormat

DEFAULT_WIDTH = 320  # pixels of a dump without a run.json beside it
FRAMES = "frame_*.chunky"
GAP = 4  # pixels between the panels of a picture
MARK = (255, 0, 160)  # a differing pixel in the third panel


@dataclass
class Difference:
    """How two frames differ; all fields but ``count`` mean nothing when it is 0."""

    count: int  # differing pixels
    box: tuple[int, int, int, int]  # left, top, right, bottom; all inside
    first: tuple[int, int]  # x, y of the first in reading order
    values: tuple  # of a and b at that pixel: value, [r, g, b], or index and colour in words
    largest: int  # difference of a value or channel

    def __str__(self) -> str:
        left, top, right, bottom = self.box
        return (f"{self.count} pixels differ, in x {left} to {right}, y {top} to {bottom}; "
                f"first ({self.first[0]}, {self.first[1]}): {self.values[0]} / {self.values[1]}; "
                f"largest difference {self.largest}")


@dataclass
class Frame:
    """A frame to compare and how to show it."""

    values: np.ndarray  # (h, w) pixels, or uint8 (h, w, 3) colours
    palette: np.ndarray | None = None  # uint8 (256, 3), of indices
    pixel: PixelFormat = FORMATS["chunky"]

    def picture(self) -> np.ndarray:
        """Returns uint8 (h, w, 3); indices without a palette are shown as greys."""
        if self.values.ndim == 3:
            return self.values
        if self.pixel.colours:
            return self.pixel.picture(self.values)
        greys = np.repeat(np.arange(256, dtype=np.uint8)[:, None], 3, axis=1)
        return (greys if self.palette is None else self.palette)[self.values]


def comparable(a: Frame, b: Frame) -> tuple[np.ndarray, np.ndarray]:
    """Returns what is compared of two frames: colours if both have palettes, otherwise pixels as they are."""
    if a.palette is None or b.palette is None:
        return a.values, b.values
    return a.picture(), b.picture()


def differing(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Returns bool (h, w): pixels that differ in any value."""
    different = a != b
    return different if different.ndim == 2 else different.any(axis=2)


def compare(a: np.ndarray, b: np.ndarray) -> Difference:
    """Returns the difference of two frames of the same shape and kind, as in ``Frame``."""
    if a.shape != b.shape:
        raise ValueError(f"shapes {a.shape} and {b.shape}")
    y, x = np.nonzero(differing(a, b))
    if not len(x):
        return Difference(0, (0, 0, 0, 0), (0, 0), (0, 0), 0)
    largest = np.abs(a.astype(int) - b.astype(int)).max()
    return Difference(
        len(x), (int(x.min()), int(y.min()), int(x.max()), int(y.max())), (int(x[0]), int(y[0])),
        (a[y[0], x[0]].tolist(), b[y[0], x[0]].tolist()), int(largest))


def panels(a: Frame, b: Frame, different: np.ndarray) -> np.ndarray:
    """Returns A, B, and A in dark grey with the pixels marked that are ``different``, bool (h, w), side by
    side."""
    left, right = a.picture(), b.picture()
    marked = np.repeat((left.mean(axis=2, keepdims=True) / 3).astype(np.uint8), 3, axis=2)
    marked[different] = MARK
    gap = np.full((left.shape[0], GAP, 3), 255, np.uint8)
    return np.concatenate([left, gap, right, gap, marked], axis=1)


def load_dump(path: Path) -> Frame:
    """Loads a raw dump, with its size, pixels and colours from the run.json beside it."""
    data = path.read_bytes()
    described = path.with_name("run.json")
    width, height, palette = DEFAULT_WIDTH, len(data) // DEFAULT_WIDTH, None
    pixel = FORMATS["chunky"]
    if described.exists():
        try:
            about = json.loads(described.read_text())
            width = int(about.get("width", DEFAULT_WIDTH))
            pixel = FORMATS[about.get("format", "chunky")]
            height = int(about.get("height", len(data) // (width * pixel.bytes)))
            palette = about.get("palette")
            if palette is not None:
                palette = np.array(palette, np.uint8).reshape(256, 3)
        except (ValueError, TypeError, AttributeError, OverflowError, ZeroDivisionError, KeyError,
                RecursionError):
            raise UserError(f"{described}: width, height, format or palette cannot be used"
                            ) from None
    if len(data) == 0 or width < 1 or len(data) != width * height * pixel.bytes:
        of = f" of {pixel.bytes} bytes" if pixel.bytes > 1 else ""
        raise UserError(f"{path}: {len(data)} bytes is not {width}x{height or '?'} pixels{of}")
    values = np.frombuffer(data, pixel.dtype.newbyteorder(">")).astype(pixel.dtype)
    return Frame(values.reshape(height, width), palette, pixel)


def load_frame(path: Path) -> Frame:
    """Loads a dump or a PNG, depending on its name."""
    if not path.is_file():
        raise UserError(f"{path}: no such file")
    if path.suffix == ".chunky":
        return load_dump(path)
    if path.suffix != ".png":
        raise UserError(f"{path}: neither a .chunky dump nor a .png frame")
    try:
        with Image.open(path, formats=("PNG",)) as image:
            return Frame(np.array(image.convert("RGB")))
    except Exception as error:  # a damaged file raises exceptions of many kinds
        raise UserError(f"{path}: cannot be read: {' '.join(str(error).split())}") from None


def load_pair(a: Path, b: Path) -> tuple[Frame, Frame]:
    """Loads two frames; refuses them if size or kind differ."""
    frames = load_frame(a), load_frame(b)
    shapes = [frame.values.shape for frame in frames]
    if len(shapes[0]) != len(shapes[1]):
        raise UserError(f"{a} and {b}: one is a dump, the other a picture")
    if shapes[0] != shapes[1]:
        sizes = " and ".join(f"{shape[1]}x{shape[0]}" for shape in shapes)
        raise UserError(f"{a} and {b}: {sizes} pixels")
    formats = [frame.pixel.name for frame in frames]
    if formats[0] != formats[1]:
        raise UserError(f"{a} and {b}: {formats[0]} and {formats[1]}")
    return frames


def frames_of(folder: Path) -> list[str]:
    """Returns the names of a run directory's dumps."""
    names = sorted(path.name for path in folder.glob(FRAMES))
    if not names:
        raise UserError(f"{folder}: is no run directory: it has no {FRAMES}")
    return names


def pairs(a: Path, b: Path) -> list[tuple[Path, Path]]:
    """Returns the frames to compare: a and b, or those of two run directories, which have the same names."""
    for path in (a, b):
        if not path.exists():
            raise UserError(f"{path}: no such file or directory")
    if a.is_dir() != b.is_dir():
        raise UserError(f"{a} and {b}: one is a directory, the other is not")
    if not a.is_dir():
        return [(a, b)]
    names, others = frames_of(a), frames_of(b)
    if len(names) != len(others):
        raise UserError(f"{a} and {b}: {len(names)} and {len(others)} frames")
    for name, other in zip(names, others):
        if name != other:
            raise UserError(f"{a} and {b}: {min(name, other)} is in one only")
    return [(a / name, b / name) for name in names]


@dataclass
class Compared:
    """The differences of two runs, or of two frames."""

    different: list[tuple[Path, Path]]
    lines: list[str]  # one for each that differs
    others: int = 0  # frames of the same colours with other indices
    kind: str = "colour"  # what was compared

    def summary(self, count: int) -> str:
        """The last line. ``count``: of frames."""
        others = f"; {self.others} of the same colours by other indices" if self.others else ""
        return f"{count} frame{'s' if count > 1 else ''}: {len(self.different)} different in {self.kind}{others}"


def compare_all(work: list[tuple[Path, Path]]) -> Compared:
    """Compares pairs of frames; refuses all if one cannot be compared."""
    done = Compared([], [])
    for one, other in work:
        a, b = load_pair(one, other)
        values = comparable(a, b)
        if values[0].ndim == 2 and not a.pixel.colours:
            done.kind = "index, for want of two palettes"
        elif a.pixel.channels == "RGBA":
            done.kind = "colour or alpha"
        found = compare(*values)
        if found.count:
            if a.values.ndim == 2 and values[0].ndim == 3:
                x, y = found.first
                found.values = tuple(f"{frame.values[y, x]} = {value}"
                                     for frame, value in zip((a, b), found.values))
            done.different.append((one, other))
            done.lines.append(f"{one.stem}: {found}")
        else:
            done.others += bool(differing(a.values, b.values).any())
    return done


def command(a: Path, b: Path, out: Path | None = None) -> int:
    """``tmap diff``: prints how two dumps, PNGs or run directories differ; raises UserError.

    Every differing frame's panels go to ``out`` as ``NAME_diff.png``, if given.
    Returns 0: equal, 1: different.
    """
    if out is not None:
        check_directory(out)
    work = pairs(a, b)
    done = compare_all(work)
    if out is not None and done.different:
        with replaced(out, (), "") as folder:
            for one, other in done.different:
                frames = load_pair(one, other)
                picture = panels(*frames, differing(*comparable(*frames)))
                Image.fromarray(picture).save(folder / f"{one.stem}_diff.png")
    print("\n".join([*done.lines, done.summary(len(work))]))
    return 1 if done.different else 0
