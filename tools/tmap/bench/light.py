"""Calls of the spans that light pixels that are drawn already."""

import numpy as np

from tmap.base.fixed import ONE
from tmap.bench.effects import DC, LEVELS
from tmap.bench.spans import GAP, Ground, Line, line_count, table_trial
from tmap.bench.trial import Trial
from tmap.build import layout
from tmap.guest.kernels import Arena
from tmap.setup.scanline import pack_shade


def light_trial(kernel: str, lines: list[Line], pitch: int, arena: Arena, ground: Ground,
                light: np.ndarray, light_at: int, title: str = "", *, level: int = 0,
                shades: list[int] | None = None, dcdx: int = 0, **more) -> Trial:
    """One table of pixels that the ground's frame has. ``light``: [level][pixel]; ``light_at``: where it
    is in the far arena. All is at one ``level``, or each line begins with one of ``shades``, 16.16, and
    has the step ``dcdx``."""
    blocks, before = {}, bytes(ground.arena.data)
    if shades is not None:
        added = (light_at & 0xFFFF) + layout.load().constants["LEVEL_FALLS"] * (dcdx < 0)
        blocks["shades"] = b"".join(pack_shade(shade, added).to_bytes(4, "big") for shade in shades)

    def drawn(k: int, at: int, _: int, count: int, *__: int) -> np.ndarray:
        rows = shades[k] + np.arange(count, dtype=np.int64) * dcdx >> 16 if shades else level
        return light[rows, np.frombuffer(before, np.uint8, count, at)]

    return table_trial(kernel, "flat", lines, pitch, arena, ground, drawn, title, blocks=blocks,
                       far={"light": light_at + 256 * level}, dcdx=dcdx, **more)


def light_case(kernel: str, length: int):
    """A table of lines of one length, as tmap.bench.spans.span_case."""
    rng, lines, far = np.random.default_rng(length), line_count(length), Arena()
    light = rng.integers(0, 256, (LEVELS, 256), dtype=np.uint8)
    light_at = far.add(light.tobytes(), ONE)
    frame = far.add(rng.bytes(lines * (length + GAP)))
    places = [(k % 4, length, 0, 0) for k in range(lines)]
    shades = [int(rng.integers(0, 20 << 16)) & ~3 for _ in places]
    level = {"shades": shades, "dcdx": DC} if "gouraud" in kernel else {"level": 40}
    ground = Ground(far, frame, 0, np.zeros((256, 256), np.uint8))
    return light_trial(kernel, places, length + GAP, Arena(), ground, light, light_at,
                       **level).row(lines * length)


#: Row to kernel.
SPANS = {"light": "span_light", "light_gouraud": "span_light_gouraud"}
