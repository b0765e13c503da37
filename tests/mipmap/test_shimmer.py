"""Mip maps bring a floor to the horizon nearer to its exact picture, and it flickers less."""

from tests.mipmap.shimmer import exact_frames, measured

SIZE = 128, 80


def test_far_slabs_do_not_shimmer() -> None:
    """The error of tests/scenes/terrace.toml, and what changes of it from frame to frame, are less than two thirds of
    those without mip maps."""
    frames = range(4)
    exact = exact_frames(*SIZE, frames)
    without, with_ = (measured(*SIZE, frames, each, exact) for each in (False, True))
    assert with_[0] < without[0] * 2 / 3 and with_[1] < without[1] * 2 / 3, (without, with_)
