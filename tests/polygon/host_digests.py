"""``python tests/polygon/host_digests.py PART ..``: prints digests of what the tools make, as JSON;
PARTS has the parts.

tests/polygon/test_hosts.py runs it under several settings, each in a separate process: libraries
check the processor only once, when they are loaded.
"""

import hashlib
import json
import math
import sys
from collections.abc import Iterator

from tmap import assets
from tmap.accuracy import dither_errors
from tmap.base.paths import SCENES
from tmap.bench import mesh
from tmap.bench.modes import modes
from tmap.build import glide_logarithms, glide_weights, n64_weights
from tmap.compiler import scene
from tmap.corpus import polygon_sets
from tmap.glide import images, ncc
from tmap.glide.mipmap import levels
from tmap.images import palette
from tmap.images.mipmap import FILTERS
from tmap.n64 import images as n64_images
from tmap.n64.state import YUV
from tmap.scene_file import scene_file

import numpy as np  # after tools, which limit its threads

Made = Iterator[tuple[str, bytes]]


def scenes() -> Made:
    """Each scene's file, as the Amiga loads it."""
    for path in sorted([*SCENES.glob("*.toml"), *SCENES.glob("demo/*.toml")]):
        yield f"scene {path.relative_to(SCENES)}", scene_file.write(scene.compile_scene(path))


def textures() -> Made:
    """Pictures, their levels by each filter, and the tables, palettes and textures fitted to
    them."""
    for kind in modes.KINDS:
        picture = modes.picture(kind, 0, modes.SIDE, True)
        yield f"picture {kind}", picture.tobytes()
        for how in FILTERS:
            yield f"levels of {kind}, {how}", b"".join(
                level.tobytes() for level in levels(picture, how, by_alpha=True))
        table = ncc.fit([picture])
        yield f"narrow channels of {kind}", np.concatenate([*table.i, *table.q, table.y]).tobytes()
        yield f"palette of {kind}", images.palette_of([picture]).tobytes()
        yield f"YUV of {kind}", n64_images.encode(picture, YUV, 2).data
        yield f"light of {kind}", palette.light(picture.reshape(-1, 4)[:256, :3]).tobytes()


def inputs() -> Made:
    """The inputs for which committed figures are measured."""
    for name in (*polygon_sets.SHAPES, *polygon_sets.DEPTHS):
        yield f"polygons {name}", repr(polygon_sets.polygons(name)).encode()
    for name, picture in dither_errors.maps().items():
        yield f"dithered map {name}", picture.tobytes()
    yield "the bench's view", repr(mesh.view(0)).encode()
    for module in (n64_weights, glide_weights, glide_logarithms):
        yield module.__name__, module.text().encode()


def files() -> Made:
    """Meshes and pictures of tests/scenes."""
    for name, make in assets.FILES.items():
        yield f"tests/scenes/{name}", make()


def probes() -> Made:
    """Results that do depend on the processor. If a setting does not change them, it tests
    nothing."""
    numbers = np.random.default_rng(1).normal(size=(100, 100))
    yield "BLAS", (numbers @ numbers).tobytes()
    yield "libm", np.array([math.sin(x) for x in numbers.flat]).tobytes()


PARTS = {part.__name__: part for part in (scenes, textures, inputs, files, probes)}

if __name__ == "__main__":
    json.dump({name: hashlib.sha256(data).hexdigest() for part in sys.argv[1:]
               for name, data in PARTS[part]()}, sys.stdout)
