"""The pages for readers, and checks of them.

Pages are the Markdown files in the root and in the rooms. A table is between two
marker lines with its title. Every table is on one page, and every marker has a table. Links, files
and commands on a page must exist.
"""

import re
from pathlib import Path

from tmap.base.errors import UserError
from tmap.base.paths import ROOT

BEGIN, END = "<!-- {}: written by scripts/tmap readme -->", "<!-- end -->"
MARKER = re.compile(BEGIN.format("(.+)"))
ROOMS = ("src68k", "c", "tests", "tools", "scripts")
LINK = re.compile(r"\[[^\]]*\]\(([^)\s]+)\)")
HEADING = re.compile(r"^#+ +(.*)$", re.M)
FENCE = re.compile(r"^```.*?^```", re.M | re.S)
INDENTED = re.compile(r"^    .*$", re.M)
CODE = re.compile(r"`([^`]+)`")
#: A file or folder of the tree, in code: "c/span/", "tools/tmap/ideal/bounds.py", "tests/test_*.py".
FILE = re.compile(rf"(?:{'|'.join(ROOMS)})/[\w./*-]*")


def find(root: Path = ROOT) -> list[Path]:
    """Returns all pages, those in the root first."""
    return [*sorted(root.glob("*.md")),
            *(page for room in ROOMS for page in sorted((root / room).rglob("*.md")))]


def name(page: Path, root: Path = ROOT) -> str:
    """Returns a page's path in the tree."""
    return str(page.relative_to(root))


def prose(text: str) -> str:
    """Returns a page's text without its blocks of code."""
    return INDENTED.sub("", FENCE.sub("", text))


def with_tables(texts: dict[str, str], tables: dict[str, str]) -> dict[str, str]:
    """Returns the pages' texts by name, with all tables up to date."""
    pages: dict[str, str] = {}
    for page, text in texts.items():
        for title in MARKER.findall(text):
            if title not in tables:
                raise UserError(f"{page}: there is no table {title!r}")
            if title in pages:
                raise UserError(f"{page}: the table {title!r} is in {pages[title]} too")
            pages[title] = page
    if missing := tables.keys() - pages.keys():
        raise UserError(f"no page has the table {min(missing)!r}")
    made = dict(texts)
    for title, page in pages.items():
        head, begin, rest = made[page].partition(BEGIN.format(title))
        old, end, tail = rest.partition(END)
        if not end or MARKER.search(old):
            raise UserError(f"{page}: the table {title!r} has no line {END!r} behind it")
        made[page] = f"{head}{begin}\n{tables[title]}\n{END}{tail}"
    return made


def read(root: Path = ROOT) -> dict[str, str]:
    """Returns the texts of all pages by name."""
    return {name(page, root): page.read_text() for page in find(root)}


def typed_tables(text: str) -> list[str]:
    """Returns lines of tables outside all markers, which nothing keeps up to date."""
    outside = re.sub(rf"{MARKER.pattern}.*?{END}", "", FENCE.sub("", text), flags=re.S)
    return [line for line in outside.splitlines() if line.startswith("|")]


def anchor(heading: str) -> str:
    """Returns the anchor that a host gives a heading."""
    words = re.sub(r"[^\w\- ]", "", heading.replace("`", "").lower())
    return words.replace(" ", "-")


def wrong_links(page: str, texts: dict[str, str], root: Path = ROOT) -> list[str]:
    """Returns links of a page that lead to no file of the tree, or to no heading of a page."""
    wrong = []
    for target in LINK.findall(prose(texts[page])):
        if target.startswith(("http://", "https://")):
            continue
        path, _, heading = target.partition("#")
        file = (root / page).parent / path if path else root / page
        if not file.exists():
            wrong.append(target)
        elif heading:
            other = texts.get(name(file.resolve(), root), "")
            if heading not in map(anchor, HEADING.findall(FENCE.sub("", other))):
                wrong.append(target)
    return wrong


def wrong_files(text: str, root: Path = ROOT) -> list[str]:
    """Returns files and folders of the tree, named in code, that do not exist."""
    words = [word for code in CODE.findall(prose(text)) for word in code.split()]
    named = [match[0] for word in words if (match := FILE.match(word)) and "NAME" not in word]
    return [each for each in named if not any(root.glob(each.rstrip("/.")))]


def commands(text: str) -> tuple[set[str], set[str]]:
    """Returns the targets of make and the commands of scripts/tmap that a page names."""
    makes = re.findall(r"(?:^ {4}|`)(?:\w+=\S+ )*make ([a-z][\w-]*)", text, re.M)
    tmaps = re.findall(r"scripts/tmap ([a-z][\w-]*)", MARKER.sub("", text))
    return set(makes), set(tmaps)
