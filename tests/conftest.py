"""Which tests come first: ``make test`` gives whole files to two processes in this order."""

#: The files that take longest, longest first, so that neither process ends long before the other.
LONGEST = ("kernels", "guest_input", "bench", "accuracy", "hard_cases", "meshes", "fuzz", "hard_meshes",
           "wrong_renderers", "properties", "showcase", "readme", "run", "lowering", "space")
RANKS = {f"test_{name}": rank for rank, name in enumerate(LONGEST)}


def pytest_collection_modifyitems(items: list) -> None:
    """Sorts the tests by their files' ranks; all others stay as they are, behind them."""
    items.sort(key=lambda item: RANKS.get(item.path.stem, len(RANKS)))
