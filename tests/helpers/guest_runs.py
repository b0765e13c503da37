"""Draws many scenes on the guest in one boot and compares them with the model: digests of all
frames, and counts."""

from dataclasses import dataclass

import numpy as np

from tmap.base.errors import UserError
from tmap.build import layout
from tmap.guest import emulator, guest_frames
from tmap.model import model
from tmap.run import run
from tmap.scene_file.scene_file import Scene, write


@dataclass(frozen=True)
class Asked:
    """A scene and how to draw it; ``off``: the rules to switch off; ``counted``: also draw the
    scene with counters on."""

    scene: Scene
    off: str | None = None
    form: str = "addx"
    counted: bool = True

    @property
    def way(self) -> str:
        return f"FORM {self.form}" + (f" OFF {self.off}" if self.off else "")


@dataclass(frozen=True)
class Drawn:
    """The result of one scene: the digests of its frames; each frame's figures, and for each
    material what was executed, in the form of ``run.parse_output``."""

    digests: np.ndarray
    figures: list[dict]
    executed: list[dict]

    @property
    def spans(self) -> set[str]:
        return set(run.total(self.figures)["spans"])

    @property
    def rules(self) -> set[str]:
        return {rule for material in self.executed for rule in material["rules"]}


def draw(asked: list[Asked], machine: str = "a1200-fast", timed: bool = False) -> list[Drawn]:
    """Draws all of them in one boot; ``timed``: as in guest_frames.draw."""
    shape = layout.load().struct("frame_digest").dtype
    files = {f"{k}.scene": write(each.scene) for k, each in enumerate(asked)}
    commands = [f"render {k}.scene {each.way} DIGEST {k}.digest" + " UNTIMED" * (not timed)
                + " COUNT" * each.counted for k, each in enumerate(asked)]
    with emulator.workspace() as folder:
        done = emulator.run_batch(commands, files, machine, folder,
                                  patience=emulator.PATIENT_SECONDS, timed=timed)
        for command, result in zip(commands, done):
            fault = emulator.explain_fault(emulator.PROGRAMS / "render", result.output)
            if fault or result.code:
                raise UserError(f"{command}: {fault or emulator.last_words(result.output)}")
        figures = [run.parse_output(result.output, each.scene.frames, len(each.scene.materials))
                   if each.counted else ([], []) for each, result in zip(asked, done)]
        drawn = [Drawn(np.fromfile(done[0].directory / f"{k}.digest", shape), *found)
                 for k, found in enumerate(figures)]
    for each, found in zip(asked, drawn):
        assert len(found.digests) == each.scene.frames, (len(found.digests), each.scene.frames)
    return drawn


def check(what: str, asked: Asked, drawn: Drawn, machine: str = "a1200-fast",
          expected: list[np.ndarray] | None = None) -> list[np.ndarray]:
    """Asserts that all frames are the model's; returns the model's frames. To say how the first
    wrong one differs, it is drawn once more. ``expected``: the model's frames, if they are known."""
    __tracebackhide__ = True
    if expected is None:
        expected = [model.render(asked.scene, number) for number in range(asked.scene.frames)]
    guest_frames.require_models(expected, drawn.digests, f"{what}, {asked.way}, {machine}",
                                (asked.scene, asked.way.removeprefix("FORM "), machine))
    return expected


def check_all(asked: dict[str, Asked], machine: str = "a1200-fast",
              colours: int = 1) -> dict[str, Drawn]:
    """Draws all in one boot, by name, and asserts that all frames are the model's, each of them of
    more than ``colours`` colours."""
    __tracebackhide__ = True
    drawn = dict(zip(asked, draw([*asked.values()], machine), strict=True))
    models: dict[int, list[np.ndarray]] = {}  # one scene may be drawn in several ways
    for name, each in asked.items():
        models[id(each.scene)] = check(name, each, drawn[name], machine, models.get(id(each.scene)))
        for number, frame in enumerate(models[id(each.scene)]):
            found = len(np.unique(frame))
            assert found > colours, f"{name}, frame {number}: {found} colours"
    return drawn


def command(name: str, frames: int, off: str | None) -> str:
    """Returns the command that draws a scene of tests/scenes again."""
    return (f"scripts/tmap run tests/scenes/{name}.toml --frames {frames}"
            + (f" --off {off}" if off else ""))
