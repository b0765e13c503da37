"""The kit's examples with screens of their own: sizes, and frames beside the model's."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from tests.product.test_sdk import box, draw_triangles
from tmap.base.fixed import ONE
from tmap.base.paths import ROOT
from tmap.guest import emulator
from tmap.guest.guest_frames import first_wrong
from tmap.model import model
from tmap.product import sdk
from tmap.run import mesh_header
from tmap.scene_file.scene_file import IDENTITY, Material, Object, Scene, Texture

#: Sets of tools of the kit's Makefile: those of vbcc where they are installed.
TOOLS = ["elf", *["vbcc"] * all(map(shutil.which, ("vbccm68k", "vlink")))]
#: Bytes of each program, built with m68k-linux-gnu-gcc 12.2: some more than the current ones.
MOST = {"cube": 47_000, "viewer": 83_000, "corridor": 67_000, "rotator": 32_000}
SIZES = {"cube": (160, 128), "viewer": (320, 200), "corridor": (160, 128), "rotator": (320, 256)}
TURN = 64


@pytest.fixture(scope="module", params=TOOLS)
def frames(request, tmp_path_factory) -> dict[str, np.ndarray]:
    """The last frame of each program, built by the Makefile and run on the machine with the least memory."""
    folder, tools = tmp_path_factory.mktemp("kit"), request.param
    sdk.make(folder / "sdk")
    example = folder / "sdk" / "example"
    done = subprocess.run(
        ["make", "-C", example, f"TOOLS={tools}", "DEFINES=-DFIELDS=20 -DTURNS=1", f"PYTHON={sys.executable}",
         f"VASM={ROOT / 'scripts' / 'vasm'}", *(f"{tools}/{name}" for name in MOST)], capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    if tools == "elf":
        for name, most in MOST.items():
            assert (example / tools / name).stat().st_size <= most, name
    results = emulator.run_batch(list(MOST), {}, "a1200", folder / "run", programs=example / tools,
                                 timed=False)
    assert [(result.code, result.output) for result in results] == [(0, "")] * len(MOST)
    return {name: np.fromfile(results[0].directory / f"{name}.chunky", np.uint8).reshape(height, width)
            for name, (width, height) in SIZES.items()}


def drawn(name: str, polygons: list[list[tuple]], **settings) -> np.ndarray:
    """The model's frame: polygons of x, y, s, t, w in 16.16 with the XOR pattern."""
    width, height = SIZES[name]
    v, u = np.indices((256, 256))
    rows = [[x, y, s, t, 0, w] for corners in polygons for x, y, s, t, w in corners]
    scene = Scene(width=width, height=height, frames=1, background=0, palette=np.zeros((256, 3), np.uint8),
                  textures=[Texture((u ^ v).astype(np.uint8), "page")],
                  materials=[Material(mapper="affine", edges="exact", texture=0, **settings)],
                  objects=[Object(0, 4 * number, 4, 0, 1, 0) for number in range(len(polygons))],
                  poses=np.array([IDENTITY]), vertices=np.array(rows))
    return np.asarray(model.render(scene, 0))


def sines() -> list[int]:
    """The first quarter of stage.h's table."""
    text = (sdk.FILES / "stage.h").read_text()
    return [int(n) for n in re.search(r"quarter\[.*?\] = \{(.*?)\}", text, re.S)[1].split(",")]


def towards_zero(part: int, whole: int) -> int:
    """Divides as C does."""
    return part // whole if part >= 0 else -(-part // whole)


def corridor() -> np.ndarray:
    """Frame LAST of corridor.c."""
    edges, place = [(-1, -1), (1, -1), (1, 1), (-1, 1)], 48

    def corner(edge: int, depth: int, s: int, t: int) -> tuple:
        x, y = (towards_zero(part * 100 << 16, depth) for part in edges[edge])
        return (80 << 16) + x, (64 << 16) + y, s << 16, t << 16, depth << 16

    sides = [[corner(side, 1, 0, place), corner((side + 1) % 4, 1, 128, place),
              corner((side + 1) % 4, 8, 128, place + 448), corner(side, 8, 0, place + 448)] for side in range(4)]
    sides.append([corner(k, 8, (k in (1, 2)) * 128, (k > 1) * 128) for k in range(4)])
    return drawn("corridor", sides, perspective="every16")


def rotator() -> np.ndarray:
    """Frame LAST of rotator.c: an eighth of a turn, 1.5 texels a pixel."""
    table = sines()
    size = (table[TURN // 4] >> 8) + 128
    part = size * (table[TURN // 8] >> 5)  # sine and cosine are equal
    return drawn("rotator", [[(x << 16, y << 16, part * (x - 160) - part * (y - 128),
                               part * (x - 160) + part * (y - 128), ONE)
                              for x, y in ((0, 0), (320, 0), (320, 256), (0, 256))]])


def viewer() -> np.ndarray:
    """Frame LAST of viewer.c: the knot turned by 5/64, its triangles from the farthest to the nearest in 64 steps
    of depth."""
    made, _ = mesh_header.write(sdk.MODEL, Path(os.devnull), 1.0, True)
    width, height = SIZES["viewer"]
    table = sines()
    s, c = table[5], table[TURN // 4 - 5]
    points, looks = [], []
    for x, y, z in (made.points >> 8).tolist():
        depth = (s * x + c * z >> 14) + (5 << 8)
        points.append(((width // 2 << 16) + towards_zero((c * x - s * z >> 14) * 150 * 256, depth) * 256,
                       (height // 2 << 16) - towards_zero(y * 150 * 256, depth) * 256, depth))
    for x, y, z in (row[:3] for row in made.normals.tolist()):
        looks.append(((128 << 16) + (c * x - s * z >> 14) * 500, (128 << 16) - y * 500))
    corners = [(*points[point], *looks[normal]) for point, normal, *_ in made.corners.tolist()]
    buckets = [[] for _ in range(64)]
    for three in zip(*[iter(corners)] * 3):
        step = sum(corner[2] for corner in three) // 3 - (2 << 8) >> 4
        buckets[min(max(step, 0), 63)].append([(x, y, s, t) for x, y, _, s, t in three])
    frame = np.zeros((height, width), np.uint8)
    draw_triangles(frame, [three for bucket in buckets[::-1] for three in bucket[::-1]])
    assert len(np.unique(frame)) > 100
    return frame


@pytest.mark.parametrize("picture", [corridor, rotator, viewer])
def test_last_frames_are_the_models(frames, picture) -> None:
    found, expected = frames[picture.__name__], picture()
    assert (found == expected).all(), first_wrong(expected, found)


def test_cube_ends_as_the_box_does(frames) -> None:
    assert (frames["cube"] == box(1)).all()
