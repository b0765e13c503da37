"""Which tests come first: ``make test`` gives whole files to two processes in this order. And what
each failure says at last: how to see it again."""

import shlex

import pytest

import tmap  # noqa: F401  before NumPy, whose threads it limits

#: The files that take most processor time, longest first, so that neither process ends long before
#: the other.
LONGEST = ("polygons", "bench", "kernels", "guest_input", "hard_cases", "tmu_tiles", "tmu_polygons",
           "tx_polygons", "lowering", "wide", "tmu_scenes", "fuzz", "show", "tx_vectors", "meshes",
           "tx_scenes", "run", "hard_meshes", "scene_program", "accuracy", "mappers", "disk", "demo",
           "showcase", "hosts", "tx_modes", "tmu_adds", "bounds", "borders", "pages", "readme", "properties", "methods",
           "kernel_checker", "report", "tmu_modes", "polys", "tx_decode", "tmu_downloads", "tx_model",
           "tx_core", "emulator", "ntsc", "still_steps", "citizen")
RANKS = {f"test_{name}": rank for rank, name in enumerate(LONGEST)}


def pytest_collection_modifyitems(items: list) -> None:
    """Sorts the tests by their files' ranks; all others stay as they are, behind them."""
    items.sort(key=lambda item: RANKS.get(item.path.stem, len(RANKS)))


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(item):
    """Adds the command that runs a failed test again."""
    report = yield
    if report.failed:
        test = f"tests/{item.path.name}::{item.nodeid.partition('::')[2]}"
        report.sections.append(
            ("again", f".deps/venv/bin/python -m pytest -q {shlex.quote(test)}"))
    return report
