"""Compares arrays of numbers with the expected ones and describes failures."""

import numpy as np


def check_equal(found, expected, what: str = "") -> None:
    """Fails if the arrays, after broadcasting, differ or are empty; reports how many numbers are
    wrong, and the first one's position, expected and found value."""
    __tracebackhide__ = True
    found, expected = np.broadcast_arrays(found, expected)
    assert found.size, f"{what}: nothing to compare"
    wrong = np.argwhere(found != expected)
    if len(wrong):
        at = tuple(wrong[0].tolist())
        raise AssertionError(f"{what}: {len(wrong)} of {found.size} numbers differ; the first at "
                             f"{at}: expected {expected[at]}, found {found[at]}")


def check_within(found, expected, bound, what: str = "") -> None:
    """Fails if numbers are farther apart than ``bound``, a number or an array; reports the one that
    exceeds it most."""
    __tracebackhide__ = True
    found, expected, bound = np.broadcast_arrays(found, expected, bound)
    assert found.size, f"{what}: nothing to compare"
    beyond = abs(np.subtract(found, expected, dtype=float)) - bound
    if not (beyond <= 0).all():
        at = tuple(map(int, np.unravel_index(np.argmax(np.nan_to_num(beyond, nan=np.inf)), beyond.shape)))
        raise AssertionError(
            f"{what}: {np.count_nonzero(~(beyond <= 0))} of {found.size} numbers are off by too "
            f"much; the worst at {at}: expected {expected[at]}, found {found[at]}, at most "
            f"{bound[at]} apart")
