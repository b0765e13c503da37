"""The integer model's perspective: c/perspective/perspective.c, src68k/polygon/corners_find
and planes_find.s, src68k/edge/perspective_lines and the spans src68k/span/perspective_*.

q = (least w) / w, S = u q and T = v q are planes over the screen. On each line u and v are
divided at the first and the last pixel. Between them u = first + (last - first) * part, with
part = (k q1) / ((n - k) q0 + k q1) at pixel k of n. It is always between 0 and 1, so no pixel ever
leaves the range of its line's ends.
"""

from dataclasses import dataclass, replace
from functools import cache
from math import isqrt

import numpy as np

from tmap.base.fixed import M32, cut_quotient, mul_div, signed, wide_mul
from tmap.build import layout
from tmap.setup.texturing import gradients

Q_ONE = 1 << 30  # q of the nearest vertex
Q_SURE = 4  # the least ratio of q to its error
TOO_STEEP = 1 << 28  # Q_SURE times this is above every q except the nearest one's
STEEP_2_14 = 1 << 14  # 2^16 units per pixel: half of the range of 32 bits
PIECES = {"every16": 16, "every8": 8}
EXACT = PIECES | {"every32": 32, "every64": 64}  # pieces that are drawn exactly, where q grows slowly
CURVES = ("pixel", "fine")
OCTAVE = 64  # steps of a logarithm
#: OCTAVE log2(1 + (i + 1) / OCTAVE) rounded up, and OCTAVE log2(1 + i / OCTAVE) rounded down: the
#: bit length of the OCTAVEth power of OCTAVE + i, minus that of OCTAVE's.
LG_UP = [((OCTAVE + i + 1) ** OCTAVE - 1).bit_length() - 6 * OCTAVE for i in range(OCTAVE)]
LG_DOWN = [((OCTAVE + i) ** OCTAVE).bit_length() - 1 - 6 * OCTAVE for i in range(OCTAVE)]


def root_up(power: int) -> int:
    """Returns 2^(power / OCTAVE), rounded up: six square roots in a row."""
    value = (1 << power) - 1
    for _ in range(6):
        value = isqrt(value)
    return value + 1


EXP_UP = [root_up(15 * OCTAVE + i) for i in range(OCTAVE)]
NEVER = (1 << 31) - 1  # above all weights


@dataclass(frozen=True)
class Way:
    """How a setting's lines are drawn; derived in c/span/perspective.h."""

    piece: int  # log2 of a piece's pixels; for curves of the longest piece's
    bend: int  # for curves; else 0
    off: int  # error allowed to a level line, in 1/65536 texel
    width: int  # the largest width of a polygon with level lines
    raised: int  # units by which lines are raised
    saved: int  # cycles that columns save, a pixel
    chain: int  # the longest line of level lines by a chain of u and v
    straight: int  # for curves: units that straight pieces may be off
    spare: int  # units that steps of level lines by reciprocals may add
    even: int  # straight pieces: log2 of the parts of a texel that level lines may be off


@cache
def way(setting: str) -> Way:
    """Returns the setting's numbers from the C headers."""
    found = layout.load().constants

    def number(what: str, otherwise: int = 0) -> int:
        return found.get(f"PERSPECTIVE_{what}_{setting.upper()}", otherwise)

    widest = found["FRAME_SIDE_MAX" if setting != "fine" else "PERSPECTIVE_LEVEL_WIDTH"]
    chain = {"pixel": found["PERSPECTIVE_CHAIN_PIXEL"], "fine": 0}.get(setting, widest)
    return Way(found[f"PERSPECTIVE_PIECE_{setting.upper()}"], number("BEND"), number("LEVEL"),
               widest, number("RAISE"), number("SAVED"), chain, number("STRAIGHT"),
               number("SPARE", found["PERSPECTIVE_SPARE_PIECES"]), number("EVEN"))


def raise_of(exact: str) -> int:
    """Returns the units by which lines of a setting, or of a name of EXACT, are raised."""
    return 2 * EXACT[exact] + 2 if exact in EXACT else way(exact).raised


@dataclass
class Plane:
    """V * 2^scale over the screen, modulo 2^64: the value at pixel (i, j), its growth per pixel and
    per line."""

    at: int
    dx: int
    dy: int

    def scaled(self, bits: int) -> "Plane":
        """Returns the plane times 2^bits."""
        return Plane(*(signed(n << bits, 64) for n in (self.at, self.dx, self.dy)))

    def value(self, x: int, y: int) -> int:
        """Returns the value x pixels right of (i, j) and y lines below it."""
        return signed(self.at + x * self.dx + y * self.dy, 64)

    def values(self, x: np.ndarray, y: np.ndarray) -> np.ndarray:
        """Returns ``value`` of several pixels, int64, which is modulo 2^64 too."""
        return self.at + x * self.dx + y * self.dy


@dataclass
class Corners:
    """What the planes are found from: top, bottom and middle."""

    three: list[tuple[int, ...]]  # x, y, q, s, t
    texels: list[tuple[int, int]]  # u and v less their bases
    y: int  # from the top to the first line, 16.16
    down: int  # lines from the top to the last line, rounded up
    off: int  # units by which q may be off
    gentle: bool  # no step of q reaches 2^30 units


@dataclass
class Perspective:
    """The planes of q (in their upper 32 bits), S and T (S / q is u - base in 16.16)."""

    q: Plane
    s: Plane
    t: Plane
    i: int
    j: int
    base: tuple[int, int]  # a whole texel plus a unit
    scale: int  # log2 of the factor of S and T
    least: int  # of q
    most: int
    low: tuple[int, int]  # of u and v, relative to their bases
    high: tuple[int, int]
    gentle: bool = True  # no gradient is too steep for 32 integer bits
    raised: tuple[int, int] = (0, 0)  # units by which S and T are raised
    tilt: int = 0  # of level lines: q's growth a pixel, 24.8
    chained: bool = False  # level lines: u and v are stepped by a chain; v's wraps change u
    inverse: object = None  # level lines by reciprocals: level_reciprocal.Constants
    corners: Corners | None = None
    is_sure: bool = True  # S and T are accurate enough

    @property
    def farthest(self) -> int:
        """The largest distance of u or v from its base."""
        return max(*self.high, *(-c for c in self.low))

    def turned(self, x: int, y: int) -> "Perspective":
        """Returns the planes with lines and columns exchanged, at pixel (x, y) of the frame."""
        q, s, t = (Plane(plane.value(x - self.i, y - self.j), plane.dy, plane.dx)
                   for plane in (self.q, self.s, self.t))
        return replace(self, q=q, s=s, t=t, i=y, j=x, tilt=0, chained=False, inverse=None)

    def quotients(self, x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, list[np.ndarray]]:
        """Returns q at pixels, at least ``least``, and u and v, less their bases, divided by it."""
        at = x - self.i, y - self.j
        q = np.maximum(self.q.values(*at) >> 32, self.least)
        return q, [cut_quotients(plane.values(*at), q) for plane in (self.s, self.t)]

    def divided(self, x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, list[np.ndarray]]:
        """Returns q at pixels, and u and v within their ranges."""
        q, found = self.quotients(x, y)
        return q, [base + c.clip(low, high) for base, c, low, high in zip(self.base, found, self.low, self.high)]


@dataclass
class Ends:
    """A line's pixels left to left + n: u and v of the first, their differences to the last, and
    the weights of both ends, each 1/n of its q."""

    left: int
    n: int
    u: int
    v: int
    du: int = 0
    dv: int = 0
    first: int = 0
    last: int = 0

    def weight(self, k: int) -> int:
        """Returns q of pixel k, in the line's scale."""
        return (self.n - k) * self.first + k * self.last

    def at(self, k: int) -> tuple[int, int]:
        """Returns u and v of pixel k, 16.16; exact at both ends, else up to 3 units low."""
        if k == self.n:
            return self.u + self.du & M32, self.v + self.dv & M32
        if k == 0:
            return self.u, self.v
        part = (k * (self.last >> 1) << 32) // self.weight(k)
        return tuple(c + 2 * (d * part >> 32) & M32
                     for c, d in ((self.u, self.du), (self.v, self.dv)))


def steepness(gradient: int) -> int:
    """Returns the magnitude of a gradient's upper half, as ``perspective_steepness``."""
    high = signed(gradient, 64) >> 32
    return high if high >= 0 else (~high if gradient & M32 else -high)


def error_part(gradient: int, pixels: int) -> int:
    """Returns the units by which a plane may be off after some pixels, by its gradient (48.16)."""
    steep = abs(signed(gradient, 64)) >> 32
    if steep < 1 << 16:
        return (steep * pixels >> 15) + (pixels >> 14) + 2
    steep = (steep >> 15) + 1
    return TOO_STEEP if steep > TOO_STEEP // pixels else steep * pixels + (pixels >> 14) + 2


def perspective(vertices, corners, box) -> Perspective | None:
    """Returns the planes of (x, y, u, v, w) vertices; None if the polygon is drawn affine: w is
    constant, or the plane of q is not accurate enough.

    ``corners``: indices of top, bottom and middle.
    """
    ws = [v[4] for v in vertices]
    if min(ws) == max(ws):
        return None
    spans = [[v[k] for v in vertices] for k in (2, 3)]
    base = tuple((min(span) + max(span) >> 1) & ~0xFFFF for span in spans)
    low = tuple(min(span) - b for span, b in zip(spans, base))
    high = tuple(max(span) - b for span, b in zip(spans, base))
    farthest = max(*high, *(-c for c in low))
    shift = max(farthest.bit_length(), 16)
    three, texels = [], []
    for x, y, u, v, w in (vertices[k] for k in corners):
        q = mul_div(min(ws), Q_ONE, w)
        texels.append((u - base[0], v - base[1]))
        three.append((x, y, q, *(n * q >> shift for n in texels[-1])))
    left, top, right, bottom = box
    x, y = signed((left << 16) - three[0][0]), signed((top << 16) - three[0][1])
    ways = (abs(x) >> 16) + right - left + 1, (abs(y) >> 16) + bottom - top + 1
    planes, shares = [], 1 if len(vertices) == 3 else 3
    for key in (2, 3, 4):
        gx, gy = gradients(three, key)
        planes.append(Plane((three[0][key] << 16) + (gx * x >> 16) + (gy * y >> 16), gx, gy))
    q, *st = planes
    at = [corner[2] for corner in three] if len(vertices) == 3 else [
        signed((q.at >> 16) + wide_mul(q.dx, signed(v[0] - (left << 16)))
               + wide_mul(q.dy, signed(v[1] - (top << 16)))) for v in vertices]
    least = min(at)
    errors = [2 + error_part(plane.dx, ways[0]) + error_part(plane.dy, ways[1]) for plane in planes]

    def is_sure(error: int) -> bool:
        return error < TOO_STEEP and least >= Q_SURE * error

    if not is_sure(errors[0]):
        return None
    raised = tuple(error + errors[0] + 2 * shares + 2 for error in errors[1:])
    for plane, units in zip(st, raised):  # s / q is never below u
        plane.at += units << 16
    gentle = [all(abs(signed(g, 64)) >> 32 < STEEP_2_14 for g in each)
              for each in ((q.dx, q.dy), (p.dx for p in st))]
    return Perspective(q.scaled(16), *(plane.scaled(shift - 16) for plane in st), left, top,
                       tuple(b + 1 for b in base),  # quotients are cut
                       shift, least - (errors[0] if len(vertices) == 3 else 0), max(at), low, high, all(gentle),
                       raised, corners=Corners(three, texels, y, ways[1], errors[0], gentle[0]),
                       is_sure=all(map(is_sure, errors)))


def cut_quotients(n: np.ndarray, d: np.ndarray) -> np.ndarray:
    """Returns n / d cut towards zero, d > 0."""
    found = n // d
    return found + ((n < 0) & (found * d != n))


def weights(q0: int, q1: int, n: int) -> tuple[int, int]:
    """Returns the weights of both ends of a line of n steps: n times one is below 2^31."""
    up = 31 - max(q0, q1).bit_length()
    return max((q0 << up) // n, 1), (q1 << up) // n & ~1


def ends(p: Perspective, left: int, right: int, y: int, raised: int = 0) -> Ends:
    """Returns the line's ends; right is excluded. ``raised``: units by which u and v are raised."""
    return all_ends(p, np.array([left]), np.array([right]), np.array([y]), raised)[0]


def all_ends(p: Perspective, lefts: np.ndarray, rights: np.ndarray, ys: np.ndarray, raised: int = 0) -> list[Ends]:
    """Returns ``ends`` of several lines."""
    (q0, (u, v)), (q1, (u1, v1)) = (p.divided(x, ys) for x in (lefts, rights - 1))
    n = rights - 1 - lefts
    made = [Ends(*line) for line in zip(*(each.tolist() for each in (
        lefts, n, u + raised & M32, v + raised & M32, signed(u1 - u), signed(v1 - v))))]
    for line, *q in zip(made, q0.tolist(), q1.tolist()):
        if line.n:
            line.first, line.last = weights(*q, line.n)
    return made


def lg(x: int, table: list[int]) -> int:
    """Returns OCTAVE * log2(x) by a table, from above or from below; x > 0."""
    top = x.bit_length() - 1
    return OCTAVE * top + table[x << 31 - top >> 25 & OCTAVE - 1]


def exp_up(x: int) -> int:
    """Returns 2^(x / OCTAVE), or a little more: at most 2^31 - 1."""
    if x < 0:
        return 0
    if x >= 31 * OCTAVE:
        return NEVER
    return min((EXP_UP[x % OCTAVE] << 16 >> 31 - x // OCTAVE) + 1, NEVER)


def enough(line: Ends, setting: str) -> list[int]:
    """Returns the least weights with which curved pieces of 4, 8, 16 ... pixels stay within the
    setting's tolerance.

    A curve through three points of u = K + C / q, h pixels apart, is off by h^3 |u'''| / 15.59
    at most (9 sqrt 3), with u''' = 6 du q0 q1 dq^2 / (n q^4) in weights of the line's ends.
    """
    longest = way(setting).piece
    far = max(abs(line.du), abs(line.dv))
    step = abs(line.last - line.first)
    if not far or not step:
        return [0] * (longest - 1)
    q0, q1 = line.n * line.first, line.n * line.last
    total = (lg(far, LG_UP) + lg(max(q0, 1), LG_UP) + lg(max(q1, 1), LG_UP) + 2 * lg(step, LG_UP)
            - lg(line.n, LG_DOWN) + way(setting).bend)
    return [exp_up(total + 3 * OCTAVE * j + 3 >> 2) for j in range(1, longest)]


def pieces(line: Ends, m: int) -> list[tuple[np.ndarray, np.ndarray]]:
    """Returns u and v of the line's pixels in affine pieces of m pixels, exact at their ends to
    m - 1 units; the last piece ends with the line."""
    out, k, grid = [], 0, ~(m - 1)
    now = [c & grid for c in line.at(0)]
    steps = np.arange(m + 1, dtype=np.int64)
    while line.n - k > m:
        then = [c & grid for c in line.at(k + m)]
        out.append([c + steps[:m] * (signed(b - c) // m) for c, b in zip(now, then)])
        now, k = then, k + m
    rest = line.n - k
    rises = [cut_quotient(signed(b - c), rest) if rest else 0
             for c, b in zip(now, line.at(line.n))]
    out.append([c + steps[:rest + 1] * rise for c, rise in zip(now, rises)])
    return [tuple(part & M32 for part in piece) for piece in out]


def curve(points: list[int], j: int, count: int) -> np.ndarray:
    """Returns ``count`` values of the curve through three points 2^j pixels apart."""
    a, b, c = points
    h = 1 << j
    first, second = signed(b - a), signed(c - b)
    bend = signed(second - first) + (h * h >> 1) >> 2 * j
    step = (first >> j) - ((bend << j) - bend >> 1)
    k = np.arange(count, dtype=np.int64)
    return a + k * step + (k * (k - 1) >> 1) * bend & M32


def curves(line: Ends, setting: str) -> list[tuple[int, np.ndarray, np.ndarray]]:
    """Returns (first pixel, u, v) of the line's pieces in drawing order; later ones overwrite."""
    limits, out, k = enough(line, setting), [], 0
    longest = way(setting).piece
    j = longest
    while k < line.n:
        while j > 1:
            length = 1 << j
            start = min(k, line.n - length)
            if length <= line.n and min(line.weight(start),
                                        line.weight(start + length)) >= limits[j - 2]:
                break
            j -= 1
        if j == 1:  # one pixel
            u, v = line.at(k)
            out.append((k, np.array([u]), np.array([v])))
            k += 1
        else:
            points = [line.at(start + part) for part in (0, length // 2, length)]
            out.append((start, *(curve([p[axis] for p in points], j - 1, length)
                                 for axis in (0, 1))))
            k = start + length
        j = min(j + 1, longest)
    u, v = line.at(line.n)
    return [*out, (line.n, np.array([u]), np.array([v]))]


def coordinates(line: Ends, setting: str) -> tuple[np.ndarray, np.ndarray]:
    """Returns u and v of a line's pixels, 16.16 modulo 2^32."""
    if setting in EXACT:
        made = pieces(line, EXACT[setting])
        return tuple(np.concatenate([piece[axis] for piece in made]) for axis in (0, 1))
    u, v = np.zeros(line.n + 1, np.int64), np.zeros(line.n + 1, np.int64)
    for first, us, vs in curves(line, setting):
        u[first:first + len(us)], v[first:first + len(vs)] = us, vs
    return u, v
