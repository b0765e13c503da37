"""Which tests come first: ``make test`` gives whole files to two processes in this order."""

#: The files that take longest, longest first, so that neither process ends long before the other.
LONGEST = ("bench", "kernels", "guest_input", "hard_cases", "hard_meshes", "meshes", "fuzz",
           "lowering", "polygons", "accuracy", "run", "properties", "showcase", "bounds",
           "mappers", "readme")
RANKS = {f"test_{name}": rank for rank, name in enumerate(LONGEST)}


def pytest_collection_modifyitems(items: list) -> None:
    """Sorts the tests by their files' ranks; all others stay as they are, behind them."""
    items.sort(key=lambda item: RANKS.get(item.path.stem, len(RANKS)))
