"""Noise for computed pictures. It repeats at every border and depends on its seed alone."""

import numpy as np

from tmap.base.elementary import each, power as power_of


def noise(height: int, width: int, power: float, seed: int, lowest: int = 0) -> np.ndarray:
    """Returns white noise whose waves of n periods along the longer side are weakened to n^-power;
    waves of fewer than ``lowest`` periods are left out. The mean is 0, the standard deviation 1."""
    white = np.random.default_rng(seed).standard_normal((height, width))
    periods = max(height, width) * np.hypot(np.fft.fftfreq(height)[:, None],
                                            np.fft.rfftfreq(width)[None])
    periods[0, 0] = 1
    waves = np.fft.rfft2(white) * each(power_of, periods, -power) * (periods >= lowest)
    made = np.fft.irfft2(waves, (height, width))
    made -= made.mean()
    return made / made.std()


def grain(height: int, width: int, power: float, seed: int) -> np.ndarray:
    """Returns noise scaled to 0 to 1."""
    made = noise(height, width, power, seed)
    return (made - made.min()) / np.ptp(made)


def smeared(made: np.ndarray) -> np.ndarray:
    """Smears noise downwards over four texels, like wood grain."""
    return sum(np.roll(made, k, 0) for k in range(4)) / 2.2


def tinted(tint: tuple[float, float, float], light: np.ndarray) -> np.ndarray:
    """Returns a colour times the light of each texel: height, width, 3."""
    return np.array(tint) * light[..., None]
