"""Small scenes of the texture unit's model."""

import numpy as np

from tmap.n64 import commands, images
from tmap.n64.polygon import Vertex
from tmap.n64.state import CI, State
from tmap.n64.words import Cycle, List, Wrap

N = 65536
TEXEL0 = Cycle(("0", "0", "0", "texel0"), ("0", "0", "0", "texel0"))
TEXEL0_SHADE = Cycle(("texel0", "0", "shade", "0"), ("texel0", "0", "shade", "0"))


def noise(width: int, height: int, seed: int = 0) -> np.ndarray:
    """An opaque picture of random colours."""
    picture = np.random.default_rng(seed).integers(0, 256, (height, width, 4), np.uint8)
    picture[..., 3] = 255
    return picture


def smooth(side: int) -> np.ndarray:
    """An opaque, periodic picture whose neighbouring texels differ little."""
    y, x = np.mgrid[:side, :side] * (2 * np.pi / side)
    channels = [np.sin(x), np.cos(y), np.sin(x + y), np.ones_like(x)]
    return np.rint(np.stack(channels, -1) * [100, 100, 100, 127] + 128).astype(np.uint8)


def unit(texture: images.Texture, mode: str = "point", s: Wrap | None = None,
         t: Wrap | None = None, cycle: Cycle = TEXEL0, **modes) -> State:
    """A unit with a texture in tile 0 that wraps, drawn unchanged in one-cycle mode."""
    place, palette = 64, 64 + -(-len(texture.data) // 8) * 8
    dram = np.zeros(palette + 2048, np.uint8)
    for at, stored in ((place, texture.data), (palette, texture.tlut)):
        dram[at:at + len(stored)] = np.frombuffer(stored, np.uint8)
    words = List()
    s, t = (given if given is not None else Wrap(mask=side.bit_length() - 1)
            for given, side in ((s, texture.width), (t, texture.height)))
    words.load_texture_block(place, texture.form, texture.size, texture.width, texture.height,
                             0, s, t)
    if texture.form == CI:
        words.load_tlut(len(texture.tlut) // 2, 256, palette)
        words.texture_lut("ia16" if texture.ia else "rgba16")
    words.texture_filter(mode)
    words.texture_convert("filter")
    words.combine_mode(cycle, cycle)
    words.set_modes(**modes)
    state = State(dram=dram)
    commands.replay(state, words.words)
    return state


def square(left: int, top: int, size: int, s: float, t: float, colour=(255,) * 4) -> list[Vertex]:
    """A square of ``size`` pixels that shows s x t texels from (0, 0)."""
    right, bottom, s, t = left + size, top + size, int(s * N), int(t * N)
    return [Vertex(x * N, y * N, a, b, N, colour)
            for x, y, a, b in ((left, top, 0, 0), (right, top, s, 0), (right, bottom, s, t),
                               (left, bottom, 0, t))]


def floor(width: int, height: int, near: int, far: int, texels: float) -> list[Vertex]:
    """A floor that fills a frame: its upper edge at depth ``far``, its lower one at ``near``."""
    w0, w1, size = far * N, near * N, int(texels * N)
    return [Vertex(0, 0, 0, 0, w0), Vertex(width * N, 0, size * far // near, 0, w0),
            Vertex(width * N, height * N, size * far // near, size, w1),
            Vertex(0, height * N, 0, size, w1)]
