"""Maps that share pages: polygons find the texels that they find in pages of their own."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from tmap.compiler import pages
from tmap.compiler.scene import compile_scene
from tmap.model import model
from tmap.run import memory, run
from tmap.scene_file import scene_file
from tmap.scene_file.meshes import ENVIRONMENT
from tmap.scene_file.scene_file import IDENTITY, Material, Object, Scene
from tmap.scene_file.textures import Texture
from tmap.setup.texturing import Settings

SIDE, CELL, COLUMNS = 160, 40, 4


def triangles(seed: int, edges: str, perspective: str, repeats: tuple[float, float], size=(64, 64), **more) -> Scene:
    """Triangles that overlap, each with a texture of its own, of which it shows up to ``repeats``."""
    random = np.random.default_rng(seed)
    count, vertices = COLUMNS**2, []
    for number in range(count):
        x, y = number % COLUMNS * CELL, number // COLUMNS * CELL
        for _ in range(3):
            place = random.uniform(-10, 50, 2) + (x, y)
            texel = random.uniform(0, 256, 2) * repeats
            depth = random.uniform(1, 4) if perspective != "none" else 1
            vertices.append([*(65536 * np.array([*place, *texel, 200, depth])).astype(int)])
    return Scene(SIDE, SIDE, 1, 0, random.integers(0, 256, (256, 3)).astype(np.uint8),
                 [Texture(random.integers(0, 256, size[::-1]).astype(np.uint8), name=str(n)) for n in range(count)],
                 [Material("affine", edges, "plane", "subtexel", perspective=perspective, texture=n, **more)
                  for n in range(count)],
                 [Object(n, 3 * n, 3, n, 1, 0) for n in range(count)], np.array(vertices),
                 np.array([IDENTITY] * count))


@pytest.mark.parametrize("repeats", [(1, 1), (2, 1), (6, 1), (1, 6)])
@pytest.mark.parametrize("perspective", ["every16", "every8", "pixel", "fine"])
def test_same_picture_in_perspective(perspective: str, repeats: tuple) -> None:
    """What is divided are distances from a polygon's middle texel: whole texels more change no bit."""
    for seed in range(3):
        own = triangles(seed, "exact", perspective, repeats)
        shared = pages.share(own)
        assert len(shared.textures) <= 6 and sum(t.maps for t in shared.textures) == len(own.textures)
        assert np.array_equal(model.render(own, 0), model.render(shared, 0))


def coordinates(scene: Scene, number: int):
    """Returns a triangle's u and v as they are stepped, line by line, and its map."""
    material = scene.materials[number]
    texels = scene.textures[material.texture].texels
    size, settings = texels.shape[::-1], Settings(material.edges, "plane", "subtexel", mapper="affine")
    vertices = [tuple(map(int, v)) for v in scene.vertices[3 * number:3 * number + 3]]
    polygon = model.set_up(model.adapt(vertices, settings, max(size)), SIDE, SIDE, True, settings, size)
    lines = enumerate(polygon.lines, polygon.top) if polygon else ()
    return texels, [polygon.coordinates(y) for y, line in lines]


@pytest.mark.parametrize("repeats", [(1, 1), (2, 1), (6, 1), (1, 6)])
@pytest.mark.parametrize("edges", ["exact", "snapped"])
def test_same_texels_without_perspective(edges: str, repeats: tuple) -> None:
    """v is the same but for whole texels. u may lack its lowest bit where v passes a page's border, which is
    elsewhere now: up to 1.5 units a step, and as many for raised starts. Texels are the same where u's whole part
    is."""
    for seed in range(3):
        own = triangles(seed, edges, "none", repeats)
        shared = pages.share(own)
        assert len(shared.textures) <= 6
        most = 3 * 2 * (50 + 10 + SIDE)
        for number in range(len(own.objects)):
            (small, before), (page, after) = coordinates(own, number), coordinates(shared, number)
            for (u, v), (x, y) in zip(before, after, strict=True):
                u, v, x, y = (np.asarray(each, np.int64) for each in (u, v, x, y))
                moves = [int(each[0]) + 0x8000 >> 16 << 16 for each in (x - u, y - v)] if len(u) else [0, 0]
                off = (x - u - moves[0] + (1 << 31)) % (1 << 32) - (1 << 31)
                assert not len(u) or abs(off).max() <= most and not ((y - v - moves[1]) % (1 << 32)).any()
                same = (x - moves[0]) >> 16 == u >> 16
                found = page[(y >> 16) % page.shape[0], (x >> 16) % page.shape[1]]
                wanted = small[(v >> 16) % small.shape[0], (u >> 16) % small.shape[1]]
                assert (found == wanted)[same].all()


def level(folder: Path, walls: int, pages_: str, perspective: str, head: str = "") -> Path:
    """Writes a level of walls, each a mesh with a texture of 64x64 of its own that it repeats up to three times. All
    their colours are in the palette."""
    random = np.random.default_rng(5)
    colours = random.integers(0, 256, (200, 3)).astype(np.uint8)
    text = [f'width = 160\nheight = 100\nframes = 2\nbackground = "#000000"\npages = "{pages_}"\n{head}\n[camera]',
            "keys = [{frame = 0, eye = [0, 0, 0], target = [0, 0, -1]},",
            "        {frame = 2, eye = [3, 0, -3], target = [3.3, 0, -5]}]"]
    for n in range(walls):
        Image.fromarray(colours[random.integers(0, 200, (64, 64))]).save(folder / f"{n}.png")
        x, z, across = n % 6 * 2 - 5, -2 - n // 6 * 2, 256 * (1 + n % 3)
        text.append(f'[textures.t{n}]\nimage = "{n}.png"\nwidth = 64\nheight = 64\n'
                    f'[materials.m{n}]\ntexture = "t{n}"\nperspective = "{perspective}"\n'
                    f'[[objects]]\nmaterial = "m{n}"\ntwo_sided = true\nfaces = [[0, 1, 2, 3]]\n'
                    f"points = [[{x}, -1, {z}], [{x + 2}, -1, {z + n % 2}], [{x + 2}, 1, {z + n % 2}], [{x}, 1, {z}]]\n"
                    f"uvs = [[[512, 256], [{512 + across}, 256], [{512 + across}, 0], [512, 0]]]")
    path = folder / f"{pages_}.toml"
    path.write_text("\n".join(text))
    return path


@pytest.mark.parametrize("perspective", ["none", "every16", "every8", "pixel", "fine"])
def test_level_of_24_textures_on_a1200(tmp_path: Path, perspective: str) -> None:
    """Walls of 64x64 texels, a third of them once, twice and three times across: 24 do not fit with pages of their
    own, and take 6 pages together. In the second frame walls are cut at the camera's near plane: there s and t are
    rounded as texels, not before they are scaled to them, so a texel may be its neighbour on a border. In the first it
    may in u alone, on lines of a chain, whose u lacks its lowest bit where v passes a page's border. The setting fine
    has no chains."""
    own, shared = (compile_scene(level(tmp_path, 24, each, perspective)) for each in ("own", "shared"))
    assert memory.shared(own) == {"maps": 0, "pages": 0} and memory.shared(shared) == {"maps": 24, "pages": 6}
    assert memory.fits(shared, "a1200") and not memory.fits(own, "a1200")
    v, u = np.mgrid[:64, :64].astype(np.uint8)
    for ramp, first in ((v, False), (u, perspective != "fine")):
        ramps = replace(own, textures=[Texture(ramp)] * len(own.textures))
        for frame, most in enumerate((first, True)):
            shown = [model.render(each, frame).astype(int) for each in (ramps, pages.share(ramps))]
            assert ((shown[1] - shown[0] + most) % 64 <= 2 * most).all()
    if perspective == "every16":
        found = run.render(shared, "a1200", "addx", timed=False).frames
        assert all(np.array_equal(each, model.render(shared, n)) for n, each in enumerate(found))


@pytest.mark.parametrize("mapper", ["lit", "lit_gouraud"])
def test_lit_maps(tmp_path: Path, mapper: str) -> None:
    """A pass of light goes over the texels of shared pages too."""
    own, shared = (compile_scene(level(tmp_path, 6, each, f'every16"\nmapper = "{mapper}')) for each in ("own", "shared"))
    assert (len(own.textures), len(shared.textures)) == (7, 3) and shared.textures[0].layout == "light"
    assert np.array_equal(model.render(shared, 1), model.render(own, 1))


def test_wider_pixels(tmp_path: Path) -> None:
    """Maps of 16-bit texels share pages of 128 KB."""
    own, shared = (compile_scene(level(tmp_path, 6, each, "every16", 'format = "rgb565"')) for each in ("own", "shared"))
    assert (len(own.textures), len(shared.textures)) == (6, 2)
    assert np.array_equal(model.render(shared, 0), model.render(own, 0))
    found, = run.render(replace(shared, frames=1), "a1200", "addx", timed=False).frames
    assert np.array_equal(found, model.render(shared, 0))


def test_a_mesh_with_several_textures(tmp_path: Path) -> None:
    """Equal meshes are one; with textures in different places their corners are apart, but points and faces are not."""
    text = level(tmp_path, 2, "shared", "none").read_text()
    first, second = (text.index("[[objects]]", at) for at in (0, text.index("[textures.t1]")))
    (tmp_path / "shared.toml").write_text(
        text[:second] + text[first:text.index("[textures.t1]")].replace('"m0"', '"m1"') + "\n")
    shared = compile_scene(tmp_path / "shared.toml")
    (tmp_path / "shared.toml").write_text((tmp_path / "shared.toml").read_text().replace('"shared"', '"own"'))
    own = compile_scene(tmp_path / "shared.toml")
    assert (len(own.meshes), len(shared.meshes), len(shared.points)) == (1, 2, len(own.points))
    assert len(shared.corners) == 2 * len(own.corners) and shared.textures[0].maps == 2
    assert np.array_equal(model.render(shared, 0), model.render(own, 0))


@pytest.mark.parametrize("change", [{"edges": "integer"}, {"edges": "subpixel"}, {"start": "truncated"},
                                    {"gradients": "scanline"}, {"mapper": "keyed"}])
def test_what_is_not_bounded_keeps_its_page(change: dict) -> None:
    own = triangles(1, "exact", "none", (1, 1))
    own = replace(own, materials=[replace(m, **change) if m.texture else m for m in own.materials])
    assert pages.share(own) is own


def test_mirrors_keep_their_page(tmp_path: Path) -> None:
    own = compile_scene(level(tmp_path, 2, "own", "none"))
    assert len(pages.share(own).textures) == 1
    own.instances[0].flags |= ENVIRONMENT
    assert pages.share(own) is own


def test_one_small_map_stays_as_it_is(tmp_path: Path) -> None:
    """No page is saved: the scene file is the same, byte for byte."""
    files = [scene_file.write(compile_scene(level(tmp_path, 1, each, "every16"))) for each in ("own", "shared")]
    assert files[0] == files[1]


def test_maps_that_are_read_in_full_stay_as_they_are() -> None:
    own = triangles(1, "exact", "none", (1, 1), (256, 256))
    own.vertices[:, 2:4] = np.tile([[0, 0], [256 << 16, 0], [0, 256 << 16]], (len(own.objects), 1))
    assert pages.share(own) is own


def test_unused_maps_take_no_page() -> None:
    own = triangles(1, "exact", "none", (1, 1))
    shared = pages.share(replace(own, objects=own.objects[:2]))
    assert memory.shared(shared) == {"maps": 16, "pages": 1}
    assert np.array_equal(model.render(shared, 0), model.render(replace(own, objects=own.objects[:2]), 0))
