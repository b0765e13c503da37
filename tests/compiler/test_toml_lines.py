"""Lines of keys in TOML: the right ones, of exactly the keys that tomllib reads, and in messages."""

import tomllib

import numpy as np
import pytest

from tmap.base.errors import UserError
from tmap.base.fields import join
from tmap.base.paths import SCENES
from tmap.base.toml_lines import Lines, parts_of
from tmap.compiler.scene import parse

#: The lines of a text, each with the paths that it names first. A string of several lines begins
#: where its key is.
EVERY_FORM = (
    ('# A comment: [not] = "a table" #', []),
    ("a = 1", ["a"]),
    ("  \"b c\".'d' = \"\"\"not = this", ["'b c'", "'b c'.d"]),
    ('[nor] this \\""" #""" # but this ends it', []),
    ("e.f . \"g\" = [", ["e", "e.f", "e.f.g"]),
    ("  1979-05-27 07:32:00Z, # a comma, [and] more", ["e.f.g[0]"]),
    ('  [1, "]",', ["e.f.g[1]", "e.f.g[1][0]", "e.f.g[1][1]"]),
    ("   { x = 2, y.z = [{}] }],", [f"e.f.g[1][2]{end}" for end in ("", ".x", ".y", ".y.z", ".y.z[0]")]),
    ("] # the end", []),
    ("e.h = '''", ["e.h"]),
    ("'quoted' # = 3'''", []),
    ("[ t . u ]", ["t", "t.u"]),
    ("v = true", ["t.u.v"]),
    ("[[list]]", ["list", "list[0]"]),
    ("k = 1", ["list[0].k"]),
    ("[list.inner]", ["list[0].inner"]),
    ('k = "\\"#"', ["list[0].inner.k"]),
    ("[[list.more]]", ["list[0].more", "list[0].more[0]"]),
    ("[[list.more]]", ["list[0].more[1]"]),
    ("w = {}", ["list[0].more[1].w"]),
    ("[[list]]", ["list[1]"]),
    ("k = 2", ["list[1].k"]),
    ("[[list.more]]", ["list[1].more", "list[1].more[0]"]),
    ("z = '#'", ["list[1].more[0].z"]),
    ("[list.more.deep]", ["list[1].more[0].deep"]),
    ('"" = 0', ["list[1].more[0].deep.''"]))


def paths(value, path: str = ""):
    """Yields the path of each key and entry in a content, with the key's name; None: an entry."""
    pairs = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, inner in pairs:
        deeper = join(path, key) if isinstance(key, str) else f"{path}[{key}]"
        yield deeper, key if isinstance(key, str) else None
        yield from paths(inner, deeper)


@pytest.mark.parametrize("scene", sorted(SCENES.rglob("*.toml")), ids=lambda path: path.stem)
def test_every_key_of_every_scene(scene) -> None:
    """The paths are tomllib's, and a key's line has its name."""
    text = scene.read_text()
    found, lines = Lines(text).found, text.splitlines()
    wanted = dict(paths(tomllib.loads(text)))
    assert found.keys() == wanted.keys()
    for path, name in wanted.items():
        line = found[path]
        assert name is None or name in lines[line - 1], f"{path} is not in line {line}: {lines[line - 1]}"


@pytest.mark.parametrize("ending", ["\n", "\r\n"])
def test_all_forms(ending: str) -> None:
    """Strings of all kinds, dotted keys, tables in a line, lists over several lines, lists of tables."""
    text = ending.join(line for line, _ in EVERY_FORM)
    wanted = {path: number for number, (_, named) in enumerate(EVERY_FORM, 1) for path in named}
    assert dict(paths(tomllib.loads(text))).keys() == wanted.keys() and Lines(text).found == wanted


@pytest.mark.parametrize("seed", range(20))
def test_random_content(seed: int) -> None:
    """Random tables, lists and strings, each key in a line of its own where TOML allows."""
    random = np.random.default_rng(seed)
    lines, wanted = [], {}

    def value(path: str, depth: int) -> str:
        kind = random.integers(5 if depth < 3 else 3)
        if kind < 3:
            return ["-1.5e3", "'a = [#'", '"\\\\\\"] }"'][kind]
        count = int(random.integers(4))
        if kind == 3:
            for k in range(count):
                wanted[f"{path}[{k}]"] = len(lines) + 1
            return "[" + ", ".join(value(f"{path}[{k}]", depth + 1) for k in range(count)) + "]"
        for k in range(count):
            wanted[f"{path}.k{k}"] = len(lines) + 1
        return "{" + ", ".join(f"k{k} = {value(f'{path}.k{k}', depth + 1)}" for k in range(count)) + "}"

    for k in range(30):
        if not random.integers(3):
            lines.append("# [x] = '''")
        path = f"key{k}"
        wanted[path] = len(lines) + 1
        lines.append(f"{path}={value(path, 0)}" + " # {" * int(random.integers(2)))
    text = "\n".join(lines)
    assert dict(paths(tomllib.loads(text))).keys() == wanted.keys() and Lines(text).found == wanted


@pytest.mark.parametrize("seed", range(4))
def test_edited_texts(seed: int) -> None:
    """Texts with some letters changed: of those that tomllib still reads, every key has its line."""
    random = np.random.default_rng(seed)
    marks = [*"\"'[]{}=,.#\n \\ab1-\t", '"""', "'''", "\r\n", "[[x]]\n", "a.b = 1\n", "\n[y.z]\n", ""]
    read = 0
    for _ in range(1000):
        text = "\n".join(line for line, _ in EVERY_FORM)
        for _ in range(random.integers(1, 4)):
            at, count = random.integers(len(text)), random.integers(3)
            text = text[:at] + str(random.choice(marks)) + text[at + count:]
        try:
            content = tomllib.loads(text)
        except tomllib.TOMLDecodeError:
            continue
        found, read = Lines(text).found, read + 1
        assert found.keys() == dict(paths(content)).keys(), text
        lines = text.split("\n")
        for path, name in paths(content):
            assert not (name or "").isidentifier() or name in lines[found[path] - 1], f"{path}: {text}"
    assert read > 100


def test_parts_of_keys() -> None:
    assert parts_of("a.'b.c'.\"d\\\"\".e") == ["a", "b.c", 'd"', "e"]


HEAD = 'width = 64\nheight = 48\nframes = 2\nbackground = "#000000"\n'
OBJECT = '\n[[objects]]\nmaterial = "red"\nsides = 3\nradius = 9\n'


@pytest.mark.parametrize("text, message", [
    (OBJECT, "1: width: is missing"),
    (HEAD + "colour = 3\n" + OBJECT, "5: colour: unknown field"),
    (HEAD + OBJECT, "7: objects[0].material: there is no material 'red'"),
    (HEAD + 'materials.red.colour = "#ff0000"\n' + OBJECT * 2 + "turns = [\n1]\n", "16: objects[1].turns: must be a"),
    (HEAD + 'materials.red.colour = "#ff0000"\n' + OBJECT + OBJECT.replace("radius = 9\n", ""),
     "12: objects[1].radius: is missing"),
    (HEAD + '[materials]\nblue = { colour = "#0000ff" }\nred = { colour = "#fffff" }\n' + OBJECT,
     "7: materials.red.colour: must be a colour"),
    (HEAD + "[camera]\nkeys = [\n  { frame = 0 },\n  { frame = 1, eye = [0,\n    true, 0] }]\neye = [0, 0, 1]" + OBJECT,
     "9: camera.keys[1].eye[1]: must be a number"),
    (HEAD + "[camera]\neye = [0, 0, 1]\n\nkeys = [\n  { eye = [0, 0, 0] }]\n" + OBJECT,
     "9: camera.keys[0].frame: is missing"),
    (HEAD + "\n\n[materials.red.glide]\n[[materials.red.glide.units]]\nimage = 'x.png'\n" + OBJECT,
     "8: materials.red.glide.units[0].format: is missing"),
])
def test_messages_name_the_line(tmp_path, text: str, message: str) -> None:
    """The line of the key or entry, and of the table where a key is missing."""
    (tmp_path / "scene.toml").write_text(text)
    with pytest.raises(UserError) as caught:
        parse(tmp_path / "scene.toml")
    assert str(caught.value).startswith(f"{tmp_path / 'scene.toml'}:{message}"), caught.value
