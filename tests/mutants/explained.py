"""Why mutants that survive are equivalent, or what else notices them."""

import json
from functools import cache
from pathlib import Path

#: A list of groups, each with its reason and the mutants that it is the reason of: file, routine, macro or function,
#: the line before and after.
FILE = Path(__file__).with_name("explained.json")


@cache
def explanations() -> dict[tuple[str, str, str, str], str]:
    """Returns the reasons by the mutants' keys."""
    return {tuple(key): group["why"] for group in json.loads(FILE.read_text()) for key in group["mutants"]}
