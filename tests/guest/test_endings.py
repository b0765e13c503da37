"""How the Amiga programs end: return codes, Ctrl-C, and the machine as it was, however
they end, started by a shell or by a double click; what a machine lacks is reported in one line.

A separate program (endings.s) runs each and prints the machine's state before and after.
"""

import shutil
from pathlib import Path

import numpy as np
import pytest

from tests.helpers import endings
from tests.helpers.endings import AT_ONCE, DOUBLE_CLICK, IN_RAM, OLD_KICKSTART, Ended
from tmap.base.paths import PROGRAMS
from tmap.guest import emulator, kernels
from tmap.guest.kernels import Case
from tmap.product import program_layout, program_parts, scene_program
from tmap.scene_file import scene_file
from tmap.scene_file.scene_file import Material, Object, Scene
from tmap.vectors import vector_file

#: Little memory of either kind, a 68030 for its data cache, and a machine that is too small.
SOME = {"chip_memory": "1024", "fast_memory": "2048"}
MACHINES = {"some": SOME, "cached": SOME | emulator.MACHINES["a1200-030"] | SOME,
            "a600": {"amiga_model": "A600", "chip_memory": "2048"}}
BREAK = "***Break"
USAGE = "render: usage: render SCENE [FORM addx|swap|c]"


def scene(width: int = 16, height: int = 8, frames: int = 3, format: str = "chunky") -> Scene:
    """A scene with one triangle."""
    corners = [(1, 1), (14, 2), (3, 7)]
    return Scene(width=width, height=height, frames=frames, background=7, format=format,
                 palette=np.zeros((256, 3), np.uint8), textures=[], materials=[Material(colour=99)],
                 objects=[Object(0, 0, 3, 0, 1, 0)], poses=np.array([scene_file.IDENTITY]),
                 vertices=np.array([[x << 16, y << 16, 0, 0, 0, 65536] for x, y in corners]))


def refused() -> Scene:
    """A scene that is not drawn: a vertex is out of range."""
    made = scene()
    made.vertices[0, 0] = -2**31
    return made


def scenes_alone(folder: Path, **scenes: Scene) -> dict[str, Path]:
    """Programs that contain a scene, by name."""
    *sections, _ = scene_program.load_sections(scene())
    for name, made in scenes.items():
        program = program_parts.Program([*sections, scene_program.scene_section(made)],
                                scene_program.ALIASES, None)
        program_layout.Layout(program, {}).write(folder / name)
    return {name: folder / name for name in scenes}


@pytest.fixture(scope="module", autouse=True)
def machines():
    """Defines the machines of these tests."""
    with pytest.MonkeyPatch.context() as patch:
        for name, options in MACHINES.items():
            patch.setitem(emulator.MACHINES, name, options)
        yield


@pytest.fixture(scope="module")
def files(tmp_path_factory) -> dict[str, bytes | Path]:
    """The files on the volume: programs and their input."""
    folder = tmp_path_factory.mktemp("files")
    by_zero = Case("mul_div", registers={"d0": 1, "d1": 1, "a0": 0})
    questions = vector_file.Operations()
    for _ in range(3):
        questions.add("HASH")
    huge = scene(1024, 1024, format="rgba8888")
    programs = {name: PROGRAMS / name for name in ("render", "bench", "measure", "vectors")}
    return programs | scenes_alone(folder, three=scene(), huge=huge) | {
        "good": scene_file.write(scene()), "long": scene_file.write(scene(frames=200)),
        "refused": scene_file.write(refused()), "broken": b"TMAPTMAP",
        "large": scene_file.write(huge), "wide": scene_file.write(scene(640, 400, 9)),
        "calls": kernels.plan([Case("nothing")] * 3), "crash": kernels.plan([by_zero]),
        "figures": kernels.plan([Case("nothing", repeats=9)]), "asked": questions.file(),
        "90.run": b"good\nnone\n", "91.run": b"none\nnone\n"}


#: How, command line, return code, beginning of the last line of output, files that must not exist.
ENDINGS = [
    (0, "render good", 0, "frame 2 ticks"),
    (0, "render good COUNT", 0, ""),
    (0, "render good FORM c CHIP", 0, "frame 2 ticks"),
    (0, "render refused", 5, "render: not all could be drawn: a vertex is out of range"),
    (0, "render", 10, USAGE),
    (0, "render good FORM mmx", 10, "render: FORM: not one of addx, swap, c"),
    (0, "render nothing", 10, "nothing: cannot be opened"),
    (0, "render broken", 10, "broken: not a usable scene file: size"),
    (0, "render good DIGEST no/where", 10, "no/where: cannot be created"),
    (0, "render large", 20, f"render: not enough memory for the frame: {2**22 + 8192} bytes; the "
                            "largest free piece has "),
    (0, "render large CHIP", 20, f"render: not enough memory for the frame: {2**22 + 8192} bytes "
                                 "of chip RAM; the largest free piece has "),
    (0, "render good DCACHE", 20, "render: DCACHE: this processor has no data cache"),
    (AT_ONCE, "render good", 5, BREAK),
    (10, "render long", 5, BREAK, "frame_199.chunky"),
    (10, "render long DIGEST sums", 5, BREAK, "sums"),
    (0, "bench calls out", 0, "case 0 of 3: nothing"),
    (0, "bench", 10, "bench: usage: bench PLAN RESULTS"),
    (0, "bench broken out", 10, "broken: not a usable plan file: size"),
    (0, "bench calls no/where", 10, "no/where: cannot be created"),
    (0, "bench crash gone", 20, "0000", "gone"),
    (AT_ONCE, "bench calls gone", 5, BREAK, "gone"),
    (0, "measure table PLAN figures", 0, "Saved as table"),
    (0, "measure no/where PLAN figures", 10, "no/where cannot be created: "),
    (0, "measure PLAN broken", 10, "broken: not a usable plan file: size"),
    (AT_ONCE, "measure gone PLAN figures", 5, BREAK, "gone"),
    (0, "vectors asked told", 0, "operation 0"),
    (0, "vectors asked", 10, "vectors: usage: vectors QUESTIONS ANSWERS"),
    (0, "vectors broken told", 10, "broken: not a usable file of questions: size"),
    (AT_ONCE, "vectors asked gone", 5, BREAK, "gone"),
    (0, "batch render 90", 0, None),
    (0, "batch render", 10, "batch: usage: batch PROGRAM FIRST"),
    (0, "batch nothing 90", 10, "nothing: cannot be loaded"),
    (AT_ONCE, "batch render 91", 5, BREAK, "92.code"),
    (0, "three", 0, ""),
    (AT_ONCE, "three", 5, BREAK),
    (0, "huge", 20, "not enough memory"),
    (OLD_KICKSTART, "render good", 20, "needs Kickstart 2.0 or later"),
    (OLD_KICKSTART, "three", 20, "needs Kickstart 2.0 or later"),
]
CLICKED = [(DOUBLE_CLICK, line) for line in ("render", "bench", "three")]
#: A full volume: a file that did not fit must not exist.
FULL = [(IN_RAM, "render SYS:wide"), (IN_RAM, "render frame_008.chunky")]


@pytest.fixture(scope="module")
def ended(files, tmp_path_factory) -> list[Ended]:
    """ENDINGS, CLICKED and FULL in one boot; the volume in memory comes last."""
    return endings.run(ENDINGS + CLICKED + FULL, files, "some", tmp_path_factory.mktemp("some"), timed=False)


def test_endings(ended):
    """Checks return code and last line, and that everything is given back."""
    wrong = []
    for (how, line, code, words, *absent), found in zip(ENDINGS, ended):
        last = found.said[-1] if found.said else None
        good = (found.code == code and not found.lost()
                and (last is None if words is None else (last or "").startswith(words)))
        if not good or any((found.directory / name).exists() for name in absent):
            wrong.append(f"{line} ({how}): wanted {code}, {words!r}, without {absent}; got "
                         f"{found.code}, {last!r}, lost: {found.lost()}")
    assert not wrong, "\n".join(wrong)


def test_full_volume(ended):
    """A file that did not fit is deleted, and a line says so."""
    *_, full, left = ended
    last = int(full.said[-2].split()[1]) + 1  # the frame after the last written one
    assert (full.code, full.said[-1]) == (10, f"frame_{last:03}.chunky: cannot be written")
    assert not full.lost(("chip RAM", "fast RAM"))  # the volume is in memory
    assert left.said == ["frame_008.chunky: cannot be opened"]


def test_data_cache_is_as_before(files, tmp_path):
    for found in endings.run([(0, "render good DCACHE"), (AT_ONCE, "render good DCACHE")], files,
                             "cached", tmp_path, timed=False):
        assert not found.lost() and found.said[0].startswith("frame 0 ticks"), found.said


def test_double_click(ended):
    """The line that a shell would show is in a window that stays open until it is closed; files of
    the drawer are found. AmigaDOS's console keeps some memory."""
    shown, again, none = ended[len(ENDINGS):-len(FULL)]
    assert (shown.code, again.code, none.code) == (2, 2, 0)
    assert not again.lost(("fast RAM",)) and not none.lost(("fast RAM",))


def test_processor_that_is_too_small(files, tmp_path):
    lines = ("render good", "bench calls out", "vectors asked told", "batch render 90", "three")
    programs = tmp_path / "programs"
    programs.mkdir()
    for line in lines:
        name = line.split()[0]
        shutil.copy(files.get(name, PROGRAMS / name), programs)
    results = emulator.run_batch(list(lines), {}, "a600", tmp_path / "run", programs=programs,
                                apart=True, timed=False)
    for line, result in zip(lines, results):
        assert (result.output, result.code) == ("needs a 68020 or better\n", 20), line
