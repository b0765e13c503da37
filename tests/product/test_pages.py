"""The pages for readers: tables are generated, what the pages name exists, and pictures are what
the tree draws; tests/accuracy/test_italian_methods.py has one more picture."""

import importlib
import re

import numpy as np
import pytest
from PIL import Image

from tmap.__main__ import parser
from tmap.base.errors import UserError
from tmap.base.paths import ROOT, SCENES
from tmap.compiler.scene import compile_scene
from tmap.model import model
from tmap.report import pages, readme, readme_numbers

TEXTS = pages.read()
MARKED = "before\n{}\n| a |\n|---|\n| 1 |\n{}\nbehind\n"
AGAIN = "scripts/tmap readme"
LONGEST = 130  # characters of a line; tables and addresses may be longer


def table(title: str, end: str = pages.END) -> str:
    """A page with one table."""
    return MARKED.format(pages.BEGIN.format(title), end)


def test_tables_are_the_tools() -> None:
    """Each table is what the tool makes of the committed figures, and is in only one page."""
    made = pages.with_tables(TEXTS, readme.tables())
    for name, text in TEXTS.items():
        assert text == made[name], f"{name}: a table is not the baselines': {AGAIN}"


@pytest.mark.parametrize("page", TEXTS)
def test_page(page: str) -> None:
    """No table is written by hand, no line too long; links, files and commands exist."""
    text = TEXTS[page]
    assert not pages.typed_tables(text), f"{page}: tables that no tool writes"
    assert not pages.wrong_links(page, TEXTS), f"{page}: links that lead nowhere"
    assert not pages.wrong_files(text), f"{page}: files that are not there"
    makes, tmaps = pages.commands(text)
    targets = set(re.findall(r"^([\w-]+):", (ROOT / "Makefile").read_text(), re.M))
    assert makes <= targets, f"{page}: make has no target {makes - targets}"
    known = parser()._subparsers._group_actions[0].choices
    assert tmaps <= known.keys(), f"{page}: scripts/tmap has no command {tmaps - known.keys()}"
    long = [line for line in text.splitlines() if len(line) > LONGEST and not line.startswith("|")]
    assert not long, f"{page}: lines of more than {LONGEST} letters: {long[0]}"


def test_bounds_are_where_the_page_says() -> None:
    """Each name in the column of tools can be imported."""
    for line in readme_numbers.bounds_table().splitlines()[2:]:
        room, module, *names = line.split("`")[-2].split(".")
        found = importlib.import_module(f"tmap.{room}.{module}")
        for name in names:
            found = getattr(found, name)


def test_every_page_can_be_found() -> None:
    """Every page can be reached from README.md by links."""
    seen, todo = set(), ["README.md"]
    while todo:
        page = todo.pop()
        if page not in seen and page in TEXTS:
            seen.add(page)
            todo += [pages.name(((ROOT / page).parent / link.partition("#")[0]).resolve())
                     for link in pages.LINK.findall(pages.prose(TEXTS[page])) if "://" not in link]
    assert seen == TEXTS.keys(), f"no link leads to {TEXTS.keys() - seen}"


def test_tables_replace_what_was_there() -> None:
    made = pages.with_tables({"a": table("one"), "b": "text"}, {"one": "| b |"})
    assert made == {"a": f"before\n{pages.BEGIN.format('one')}\n| b |\n{pages.END}\nbehind\n", "b": "text"}


@pytest.mark.parametrize("texts, message", [
    ({"a": table("two")}, "a: there is no table 'two'"),
    ({"a": table("one"), "b": table("one")}, "b: the table 'one' is in a too"),
    ({"a": "text"}, "no page has the table 'one'"),
    ({"a": table("one", "")}, "a: the table 'one' has no line"),
    ({"a": table("one", "") + table("one")}, "a: the table 'one' is in a too")])
def test_wrong_markers_are_told(texts, message) -> None:
    with pytest.raises(UserError, match=re.escape(message)):
        pages.with_tables(texts, {"one": "| b |"})


def test_what_is_not_there_is_found(tmp_path) -> None:
    """Links, files, commands and hand-written tables; those in code blocks are ignored."""
    (tmp_path / "c").mkdir()
    texts = {"README.md": "[a](c/README.md) [b](c/README.md#the-numbers) [c](c/README.md#none) [d](#top)\n"
                          "# Top\n[e](gone.md) [f](https://example.org/x)\n```\n[g](gone)\n```\n",
             "c/README.md": "# The `numbers`\n"}
    for page, text in texts.items():
        (tmp_path / page).write_text(text)
    assert pages.wrong_links("README.md", texts, tmp_path) == ["c/README.md#none", "gone.md"]
    text = "`c/README.md`, `c/*.md`, `make run SCENE=tests/x.toml`, `c/gone.c`, `tools/`"
    assert pages.wrong_files(text, tmp_path) == ["c/gone.c", "tools/"]
    assert pages.typed_tables("| a |\n" + table("one")) == ["| a |"]
    assert pages.commands("`make run`, they make programs\n\n    MACHINE=a1200 make bench\n    "
                          "scripts/tmap diff a b") == ({"run", "bench"}, {"diff"})


def test_picture_is_the_default_scenes() -> None:
    compiled = compile_scene(SCENES / "default.toml", 1)
    shown = np.asarray(Image.open(readme.PICTURE).convert("RGB"))
    assert np.array_equal(shown, compiled.palette[model.render(compiled, 0)]), (
        "the README's picture is not the default scene's first frame: scripts/tmap readme")


def test_animation_is_the_knots() -> None:
    """The animation is every other frame of the scene, with fewer colours."""
    compiled = compile_scene(SCENES / "environment.toml")
    colours, entries = readme.fewer_colours(compiled.palette, model.render(compiled, 0))
    with Image.open(readme.ANIMATION) as shown:
        assert shown.n_frames == compiled.frames // 2
        for k in range(shown.n_frames):
            shown.seek(k)
            assert np.array_equal(np.asarray(shown.convert("RGB")),
                                  colours[entries[model.render(compiled, 2 * k)]]), (
                f"frame {k} of the README's animation is not the knot's: scripts/tmap readme")
