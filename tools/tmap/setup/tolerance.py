"""The integer model's tolerance: c/perspective/tolerance.c, which derives the errors."""

from tmap.base.fixed import mul_div, signed
from tmap.setup.level import keeps_level
from tmap.setup.perspective import EXACT, PIECES, Perspective, way

STEEP = 8  # q may grow per pixel by at most its least value shifted right by so many bits


def is_flat(vertices, tolerance: int) -> bool:
    """Returns true if a triangle of (x, y, u, v, w) may be drawn affine."""
    if len(vertices) != 3 or not tolerance:
        return False
    ws = [v[4] for v in vertices]
    least, grows = min(ws), max(ws) - min(ws)
    halves = [(max(c) >> 1) - (min(c) >> 1) + 1 for c in ([v[k] for v in vertices] for k in (2, 3))]
    return grows <= least and mul_div(max(halves), grows, least) < 2 * tolerance


def bend(p: Perspective) -> int | None:
    """Returns a piece's largest error as a factor of its pixels squared / 4; None if too large."""
    steep, *rest = (abs(signed(plane.dx, 64)) >> 32 for plane in (p.q, p.s, p.t))
    steep, grows = steep + 1, max(rest) + 1
    if steep > p.least >> STEEP or grows > p.least >> 2:
        return None
    a = mul_div(steep, 1 << 24, p.least) + 1
    slope = mul_div(grows, 1 << 30, p.least >> 2) + 1 + (p.farthest * a >> 24) + 1
    return (slope * a >> 24) + 1


def coarser(p: Perspective, width: int, setting: str, tolerance: int) -> tuple[str, bool]:
    """Returns the setting that the tolerance allows, and true if lines may be straight."""
    if not tolerance:
        return setting, False
    if keeps_level(p, width, tolerance):
        return setting, True
    if tolerance < (way(setting).straight or 0):
        return setting, False
    pixel = bend(p)
    for longer in ("every16", "every8"):
        if setting == longer:
            break
        if pixel is not None and pixel * PIECES[longer] * PIECES[longer] // 4 <= tolerance:
            return longer, False
    return setting, False


def straight(p: Perspective, setting: str) -> str | None:
    """Returns the name of EXACT of the longest straight pieces that are within the tolerance of a setting with curves;
    None if there are none."""
    pixel, most = bend(p), way(setting).straight
    fit = [m for m in EXACT.values() if pixel is not None and pixel <= (most - 4 * m) // (m * m // 4)]
    return f"every{max(fit)}" if fit else None
