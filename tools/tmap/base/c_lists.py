"""Lists that C headers hold as macros, such as ``MAPPER_LIST`` of c/polygon/mapper_list.h."""

import re

from tmap.base.paths import ROOT

COMMENT = re.compile(r"/\*.*?\*/", re.DOTALL)


def rows(header: str, entry: str, of: str = "") -> list[list[str]]:
    """Returns the arguments of each ``entry(...)`` in the list of a header, named as in its #include.
    ``of``: the list's name without _LIST, if that is not ``entry``."""
    text = COMMENT.sub("", (ROOT / "c" / header).read_text()).replace("\\\n", " ")
    listed = text[text.index(f"#define {of or entry}_LIST("):].partition("\n")[0].partition(")")[2]
    return [[" ".join(argument.split()) for argument in found.split(",")]
            for found in re.findall(rf"\b{entry}\(([^()]*)\)", listed)]
