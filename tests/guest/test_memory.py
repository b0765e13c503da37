"""What fits a machine's memory is known before the boot: at the edge the emulator agrees, on both sides."""

import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tests.compiler.scene_examples import example
from tests.helpers.guest_program import build
from tmap.base.errors import UserError
from tmap.guest import emulator
from tmap.guest.memory import FREE, LEAST, SPARE
from tmap.run import memory, run
from tmap.scene_file import scene_file
from tmap.scene_file.scene_file import Material, Scene
from tmap.scene_file.textures import Texture

KINDS = {2: "chip", 4: "fast"}  # bits of a header's attributes


@pytest.mark.parametrize("machine", FREE)
def test_pieces_are_the_machines(tmp_path: Path, machine: str, monkeypatch) -> None:
    """FREE has the pieces that exec lists while a program runs which fits smaller ones, after a boot that is exact: one
    that is not leaves 168 bytes more."""
    monkeypatch.setattr(emulator, "EXACT_BOOT", "memory")
    build(tmp_path, Path(__file__).with_name("memory.c"))
    done = emulator.run("memory", "", {}, machine, tmp_path / "run", programs=tmp_path)
    found: dict[str, list[tuple[int, int]]] = {}
    small = 0
    for line in done.output.splitlines():
        attributes, at, size = map(int, line.split())
        if size < LEAST:
            small += size
        else:
            found.setdefault(KINDS[attributes & 6], []).append((at, size))
    assert found == FREE[machine]
    assert 0 < small <= SPARE


def scene_of(layouts: tuple[str, ...], pages: int, rest: int) -> Scene:
    """A scene of maps of each layout, of further pages, and of ``rest`` bytes of other texels."""
    sizes = {"linear": (100, 300), "light": (64, 256)}
    maps = [Texture(np.full(sizes.get(layout, (256, 256)), 7, np.uint8), layout, layout) for layout in layouts]
    maps += [Texture(np.zeros((64, 64), np.uint8), name=f"page {n}") for n in range(pages)]
    for size in [1024] * (rest // 1024) + [rest % 1024]:
        if size:
            maps.append(Texture(np.zeros((1, size), np.uint8), "linear"))
    scene = example(0)
    page = next(number for number, each in enumerate(maps) if each.layout == "page")
    scene.vertices[:, 5] = 65536
    return replace(scene, textures=maps, materials=[scene.materials[0], Material(
        "affine", gradients="plane", perspective="every16", texture=page)])


def most(layouts: tuple[str, ...], machine: str) -> tuple[int, int]:
    """Returns the most pages that fit, and the most bytes beside them, in steps of 8."""
    def last(fits, step: int = 1) -> int:
        low, high = 0, 1
        while fits(high * step):
            low, high = high, 2 * high
        while high - low > 1:
            middle = (low + high) // 2
            low, high = (middle, high) if fits(middle * step) else (low, middle)
        return low * step
    pages = last(lambda n: memory.fits(scene_of(layouts, n + 1, 0), machine)) + 1
    return pages, last(lambda n: memory.fits(scene_of(layouts, pages, n), machine), 8)


@pytest.mark.parametrize("machine", emulator.MEASURED)
@pytest.mark.parametrize("layouts", [(), ("margins", "linear", "tiled", "margins", "light")])
def test_edge(tmp_path: Path, machine: str, layouts: tuple[str, ...]) -> None:
    """The largest scene that is not refused is drawn; with SPARE bytes and a page for each kind of memory more it does
    not fit, and with 8 bytes more it is refused."""
    pages, rest = most(layouts, machine)
    assert not memory.fits(scene_of(layouts, pages, rest + 8), machine)
    for name, more in (("fits", 0), ("not", 1)):
        scene = scene_of(layouts, pages + more * len(FREE[machine]), rest + more * SPARE)
        assert memory.fits(scene, machine) != bool(more)
        done = emulator.run("render", "x COUNT", {"x": scene_file.write(scene)}, machine, tmp_path / name,
                            patience=emulator.PATIENT_SECONDS, timed=False)
        assert ("not enough memory" in done.output) == bool(more), f"{pages} pages, {rest} bytes, {name}: {done.output}"
        assert done.code == (20 if more else 5), done.output


def test_refusal_before_the_boot(tmp_path: Path, monkeypatch) -> None:
    """One line names the sum, what is free and the largest textures; the emulator is not started."""
    monkeypatch.setattr(run, "render", None)
    monkeypatch.setattr(run, "compile_scene", lambda path, frames: scene_of(("margins",), 60, 0))
    with pytest.raises(UserError) as fault:
        run.make(tmp_path / "any.toml", tmp_path / "out", "a1200", None, "addx")
    said = str(fault.value)
    assert "\n" not in said and said.startswith(f"{tmp_path / 'any.toml'}: textures: no room on a1200: ")
    assert "4,063,232 of them for textures; free are 1," in said and "bytes of chip RAM" in said
    assert "the largest textures: margins 131,072, page 0 65,536, page 1 65,536" in said


@pytest.mark.parametrize("pages, said", [
    (4, "262,256 bytes of fast RAM"),
    (130, "@ bytes of fast RAM and @ bytes of chip RAM: texels cost more in chip RAM")])
def test_a_run_says_where_textures_are(pages: int, said: str) -> None:
    """Four pages, the head of their block and its walls; more than fast RAM has."""
    kinds = memory.for_textures(scene_of((), pages, 0), "a1200-fast")
    text = run.textures_text(kinds)
    assert text == said or re.fullmatch(said.replace("@", r"[\d,]+"), text), text
    assert sum(kinds.values()) >= pages << 16
