"""The mesh of the demo's scene ``hall``: a closed hall and six pillars, with texture coordinates."""

LENGTH, HALF, HEIGHT = 36, 3, 3
MAP = 3  # units of a map
PILLARS = [(x, z) for z in (-7, -16, -25) for x in (-1.5, 1.5)]
THICK, PART = 0.4, 0.25  # half a pillar's side; the part of a map on a side

Corner = tuple[float, float, float]


def upright(a: tuple[float, float], b: tuple[float, float], maps: float) -> list[tuple[Corner, tuple]]:
    """Returns a wall's corners and texels from x, z ``a`` on its left to ``b``."""
    return [((a[0], 0, a[1]), (0, 0)), ((b[0], 0, b[1]), (maps, 0)), ((b[0], HEIGHT, b[1]), (maps, 1)),
            ((a[0], HEIGHT, a[1]), (0, 1))]


def level(y: float, first: float, last: float) -> list[tuple[Corner, tuple]]:
    """Returns a floor's or roof's corners and texels, from z ``first`` to ``last``."""
    wide, far = 2 * HALF // MAP, LENGTH // MAP
    return [((-HALF, y, first), (0, 0)), ((HALF, y, first), (wide, 0)), ((HALF, y, last), (wide, far)),
            ((-HALF, y, last), (0, far))]


def faces() -> dict[str, list[list[tuple[Corner, tuple]]]]:
    """Returns the faces of each material, counterclockwise seen from where the camera is."""
    ends = [(-HALF, 0), (-HALF, -LENGTH), (HALF, -LENGTH), (HALF, 0)]
    walls = [upright(a, b, (abs(b[0] - a[0]) + abs(b[1] - a[1])) // MAP) for a, b in zip(ends, ends[1:])]
    pillars = []
    for x, z in PILLARS:
        around = [(round(x + THICK * i, 1), round(z + THICK * k, 1)) for i, k in ((-1, 1), (1, 1), (1, -1), (-1, -1))]
        pillars += [upright(a, b, PART) for a, b in zip(around, around[1:] + around[:1])]
    return {"wall": walls, "floor": [level(0, 0, -LENGTH)], "roof": [level(HEIGHT, -LENGTH, 0)], "pillar": pillars}


def hall() -> bytes:
    """Returns the OBJ file."""
    points: dict[Corner, int] = {}
    texels: dict[tuple, int] = {}
    drawn = []
    for material, its in faces().items():
        drawn.append(f"usemtl {material}")
        for face in its:
            drawn.append("f " + " ".join(f"{points.setdefault(point, len(points) + 1)}/"
                                         f"{texels.setdefault(texel, len(texels) + 1)}" for point, texel in face))
    lines = ["# A hall of six pillars", *("v " + " ".join(f"{c:g}" for c in point) for point in points),
             *(f"vt {s:g} {t:g}" for s, t in texels), *drawn]
    return ("\n".join(lines) + "\n").encode()


FILES = {"demo/hall.obj": hall}
