"""The light maps of tests/scenes/glide_lightmap.toml: a hall 4 wide and 2.5 high, from z = 2 to
-10, lit by two torches on its left wall and by the sun through two windows in its right wall."""

import numpy as np

from tmap.assets.views import averaged
from tmap.base.elementary import each, exp
from tmap.base.linear import length

NEAR, LENGTH, HEIGHT = 2, 12, 2.5
WARM, COOL = np.array((1, 0.62, 0.30)), np.array((0.55, 0.72, 1))
AMBIENT = np.array((0.10, 0.105, 0.145))
TORCHES = np.array(((-1.6, 1.55, -1.5), (-1.6, 1.55, -7.5)))
SUN = np.array((-1, -0.8, -0.3))  # the direction of its rays
SUNNY = np.array((0.6, 0.05, -4))  # the middle of the sunlit spot
TIMES = 4  # samples a texel along each axis


def normals(way: tuple[int, int, int], points: np.ndarray, to: np.ndarray
            ) -> tuple[np.ndarray, np.ndarray]:
    """Returns the cosine of the angle between a surface's normal and the direction to a point, and
    the distance to it."""
    ways = to - points
    distance = np.sqrt((ways * ways).sum(-1))
    return (ways * np.array(way)).sum(-1) / distance, distance


def soft(values: np.ndarray, low: float, high: float) -> np.ndarray:
    """Returns 1 between two borders and 0 outside, with a slope 0.07 wide."""
    return np.clip((values - low) / 0.07 + 0.5, 0, 1) * np.clip((high - values) / 0.07 + 0.5, 0, 1)


def sunlight(points: np.ndarray, way: tuple[int, int, int]) -> np.ndarray:
    """Returns the sun's light through the windows, each of which has a bar in its middle."""
    slope = max(0, -(SUN * way).sum()) / length(SUN)
    back = 2 - points[..., 0]  # to the wall with the windows, at x = 2
    y, z = points[..., 1] + 0.8 * back, points[..., 2] + 0.3 * back
    light = np.zeros(y.shape)
    for middle in (-2.6, -4.4):
        glass = soft(y, 1.15, 2.25) * soft(z, middle - 0.5, middle + 0.5) * (back > 0)
        light += glass * (1 - 0.85 * soft(z, middle - 0.05, middle + 0.05))
    return 3 * slope * light


def light(points: np.ndarray, way: tuple[int, int, int]) -> np.ndarray:
    """Returns the light at points of a surface with this normal; linear."""
    made = np.zeros(points.shape) + AMBIENT
    for torch in TORCHES:
        cosine, distance = normals(way, points, torch)
        near = 1.55 * (0.25 + 0.75 * np.clip(cosine, 0, 1)) / (0.35 + distance * distance)
        made += near[..., None] * WARM
    if way[0] != -1:
        made += sunlight(points, way)[..., None] * COOL
    cosine, distance = normals(way, points, SUNNY)
    thrown = 0.45 * np.clip(0.6 * cosine + 0.4, 0, 1) / (0.8 + distance * distance)
    return made + thrown[..., None] * COOL


def surface(origin: tuple, right: tuple, down: tuple, way: tuple, width: int = 64) -> np.ndarray:
    """Returns 16 rows of a rectangle's map, from a corner and two sides. The centres of the first
    and last texels are on the rectangle's borders."""
    y, x = np.mgrid[:16 * TIMES, :width * TIMES]
    u, v = (((k + 0.5) / TIMES - 0.5) / (n - 1) for k, n in ((x, width), (y, 16)))
    points = np.array(origin) + u[..., None] * np.array(right) + v[..., None] * np.array(down)
    return averaged(light(points, way), TIMES)


def shown(levels: np.ndarray) -> np.ndarray:
    """Converts light to levels of 0 to 255; bright light saturates."""
    return 255 * (1 - each(exp, -2.1 * levels))


def hall() -> np.ndarray:
    """Returns the maps of left wall, floor, right wall and ceiling, from top to bottom."""
    along = (0, 0, -LENGTH)
    return shown(np.concatenate([
        surface((-2, HEIGHT, NEAR), along, (0, -HEIGHT, 0), (1, 0, 0)),
        surface((-2, 0, NEAR), along, (4, 0, 0), (0, 1, 0)),
        surface((2, 0, NEAR), along, (0, HEIGHT, 0), (-1, 0, 0)),
        surface((2, HEIGHT, NEAR), along, (-4, 0, 0), (0, -1, 0))]))


def end() -> np.ndarray:
    """Returns the map of the wall at the far end."""
    return shown(surface((-2, HEIGHT, NEAR - LENGTH), (4, 0, 0), (0, -HEIGHT, 0), (0, 0, 1), 16))
