"""Draws scenes on the emulated machine and compares the digests of their frames with the model's.

A digest (struct frame_digest of c/scene) shows the host whether a frame is correct and how long it
took, without the frame itself.
"""

from collections.abc import Callable, Iterable, Sequence
from pathlib import Path

import numpy as np

from tmap.base.errors import UserError
from tmap.base.fixed import M32
from tmap.build import layout
from tmap.guest import emulator
from tmap.scene_file.scene_file import Scene, write


def draw(scenes: list[tuple[Scene, str]], machine: str,
         on_output: Callable[[str], None] | None = None, patience: float | None = None,
         apart: bool = False, timed: bool = True, programs: Path = emulator.PROGRAMS) -> list[np.ndarray]:
    """Returns the digests of each scene's frames, drawn in one boot: as ``drawn``, without what is printed."""
    return [digests for digests, _ in drawn(scenes, machine, on_output, patience, apart, timed, programs)]


def drawn(scenes: list[tuple[Scene, str]], machine: str,
          on_output: Callable[[str], None] | None = None, patience: float | None = None,
          apart: bool = False, timed: bool = True,
          programs: Path = emulator.PROGRAMS) -> list[tuple[np.ndarray, str]]:
    """Returns the digests of each scene's frames and what ``render`` printed, drawn in one boot. Each scene comes with
    its form and any further arguments of ``render``. ``patience``, ``apart``, ``programs``: as in run_batch; ``timed``:
    False if no ticks are asked for, which saves the wait for the beam before each frame and emulator.UNTIMED's
    time."""
    shape = layout.load().struct("frame_digest").dtype
    files = {f"{k}.scene": write(each) for k, (each, _) in enumerate(scenes)}
    commands = [f"render {k}.scene FORM {form} DIGEST {k}.digest" + " UNTIMED" * (not timed)
                for k, (_, form) in enumerate(scenes)]
    with emulator.workspace() as directory:
        done = emulator.run_batch(commands, files, machine, directory, on_output, programs,
                                 patience, apart=apart, timed=timed)
        for result in done:
            fault = emulator.explain_fault(programs / "render", result.output)
            if fault or result.code:
                raise UserError(fault or f"render: {emulator.last_words(result.output)}")
        return [(np.fromfile(done[0].directory / f"{k}.digest", shape), result.output) for k, result in enumerate(done)]


def frame_of(this: Scene, form: str, machine: str, number: int = 0) -> np.ndarray:
    """Returns a frame of a scene as the guest draws it; ``form``: as in draw."""
    with emulator.workspace() as directory:
        done = emulator.run("render", f"input.scene FORM {form} UNTIMED", {"input.scene": write(this)},
                            machine, directory, timed=False)
        found = np.fromfile(done.directory / f"frame_{number:03}.chunky", this.pixel.dtype.newbyteorder(">"))
    return found.reshape(this.height, this.width)


def digest_of(frame: np.ndarray) -> tuple[int, int]:
    """Returns the fields sum and hash of a frame's struct frame_digest."""
    data = frame.astype(frame.dtype.newbyteorder(">")).tobytes()
    longs, factor = np.frombuffer(data, ">u4"), layout.load().constants["FRAME_HASH"]
    changes, found = np.flatnonzero(np.diff(longs, prepend=longs.dtype.type(0))), 0
    for four, left in zip(longs[changes].tolist(), (len(longs) - changes).tolist()):
        found = (((found << 16 | found >> 16) ^ four) * factor + left) & M32
    return int(longs.sum(dtype=np.uint64)) & M32, found


def is_models(frame: np.ndarray, digest) -> bool:
    """Returns True if a digest is that of the model's frame."""
    return (int(digest["sum"]), int(digest["hash"])) == digest_of(frame)


def first_wrong(expected: np.ndarray, found: np.ndarray) -> str:
    """Describes the first pixel where two frames differ."""
    y, x = np.argwhere(found != expected)[0]
    digits = 2 + 2 * expected.itemsize
    return f"pixel ({x}, {y}) is {found[y, x]:#0{digits}x}, not {expected[y, x]:#0{digits}x}"


def require_models(frames: Iterable[np.ndarray], digests, what: str, drawn: tuple[Scene, str, str],
                   names: Sequence[str] = ()) -> None:
    """Raises UserError if one of a scene's frames differs from the model's; it is drawn again for
    the message. ``frames``: the model's; ``what``: the drawing's name; ``drawn``: the scene, its
    form as in draw, the machine; ``names``: of the frames."""
    for number, (frame, digest) in enumerate(zip(frames, digests, strict=True)):
        if not is_models(frame, digest):
            name = f" ({names[number]})" if names else ""
            found = frame_of(*drawn, number)
            count = int((found != frame).sum())
            first = first_wrong(frame, found) if count else "drawn once more it is right"
            raise UserError(f"{what}: frame {number}{name}: {count} pixels are not the model's; {first}")
