"""The integer model's lines of one depth each, by one reciprocal a line: src68k/edge/level_reciprocal.

u = K + C / q: if q is the same all along each line, C is the same on all lines at one x, and K everywhere. So a line
takes a reciprocal R of its q, and four products: C R and dC R for u and v."""

from dataclasses import dataclass, replace

from tmap.base.fixed import M32, signed
from tmap.build import layout
from tmap.setup.perspective import Perspective, way

FAST = 1 << 22  # v of a pixel
STEEP = 1 << 52  # of dC
RAISE = 3  # units
BITS = 31  # of C
MOST_SHIFT = 29


@dataclass(frozen=True)
class Constants:
    """What a polygon's lines have in common; pairs are of u and v."""

    q: int  # of the first line, 48.16, and up to a unit more for each line
    dq: int  # its growth a line, 48.16
    shift: int
    k: tuple[int, int]  # with the base
    c: tuple[int, int]  # at the left
    dc: tuple[int, int]
    up: tuple[int, int]  # added to steps
    farthest: int  # R of the line that is farthest
    away: tuple[int, int]  # the most that u and v are from K, units

    def reciprocal(self, q: int) -> int:
        """Returns R."""
        return ((1 << 32 + self.shift) - 1) // q


def middle(p: Perspective, width: int) -> int:
    """Returns q of the first line in the middle of the width."""
    return p.q.at + signed(p.q.dx, 64) * (width >> 1)


def find(p: Perspective, count: int, width: int, spare: int) -> Constants | None:
    """Returns the constants of ``count`` lines, all of them within ``width`` pixels; None if they do not fit.
    ``spare``: units that the steps of C may add over the width."""
    grows = signed(p.q.dy, 64)
    near = middle(p, width)
    far = signed(near + (count - 1 if grows < 0 else 0) * p.q.dy, 64)
    if not abs(grows) >> 32 or far >> 32 <= 0:
        return None
    bits = 64 - abs(grows).bit_length()
    ks, cs, away = [], [], []
    for plane, high in zip((p.s, p.t), p.high):
        rises = signed(plane.dy, 64)
        k, rest = divmod(abs(rises) << bits, abs(grows) << bits >> 32)
        if k > (2 * high | far >> 32) or k >> 31:
            return None
        away.append(k + high)
        k = -k if (rises < 0) != (grows < 0) else k
        at = signed(plane.at + (count - 1 if grows < 0 else 0) * plane.dy, 64)
        ks.append(k)
        cs.append(signed(at - (k * far >> 32) + away[-1], 64))
    dcs = [signed(plane.dx, 64) for plane in (p.s, p.t)]
    if any(not -STEEP <= dc < STEEP for dc in dcs):
        return None
    most = 0
    for c, dc in zip(cs, dcs):
        for end in (c, signed(c + width * dc, 64)):
            most = max(most, (end ^ end >> 63) >> 32)
    shift = (most + (most >> 12) + 1).bit_length() + 32 - BITS  # the width's rounded steps fit too
    if shift > MOST_SHIFT or 2 << shift > far >> 32:
        return None
    farthest = ((1 << 32 + shift) - 1) // (far >> 32)
    c, dc = (tuple(signed((n >> shift) + 1) for n in pair) for pair in (cs, dcs))
    if not -FAST <= dc[1] * farthest >> 32 < FAST or (width * (farthest >> 16) >> 16) + 1 > spare:
        return None
    up = 1 + (p.chained and dc[1] < 0), int(dcs[1] != 0)
    ks = tuple(base + n + RAISE for base, n in zip(p.base, ks))
    return Constants((near >> 16) + count + 1, grows >> 16, shift, ks, c, dc, up, farthest, tuple(away))


def settle(p: Perspective, count: int, width: int, setting: str) -> None:
    """Sets the constants of level lines with exact edges, if there is no tilt and there are enough lines."""
    if not p.tilt and count >= layout.load().constants["PERSPECTIVE_RECIPROCAL_LINES"]:
        p.inverse = find(p, count, width, way(setting).spare - (width << p.chained))


def settle_still(p: Perspective, width: int) -> None:
    """Columns by reciprocals, all of them within ``width`` pixels, on which u does not change: it has no step
    then, and v no part in it."""
    if p.inverse and p.chained and not p.s.dx and width <= layout.load().constants["PERSPECTIVE_STILL_HEIGHT"]:
        p.chained, p.inverse = False, replace(p.inverse, up=(0, p.inverse.up[1]))


def line(p: Perspective, left: int, y: int) -> list[tuple[int, int]]:
    """Returns u of a line's first pixel and its step, 16.16, and v's."""
    made = p.inverse
    r = made.reciprocal(signed(made.q + (y - p.j) * made.dq, 48) >> 16)
    return [(k + (signed(c + (left - p.i) * dc) * r >> 32) & M32, (dc * r >> 32) + up)
            for k, c, dc, up in zip(made.k, made.c, made.dc, made.up)]
