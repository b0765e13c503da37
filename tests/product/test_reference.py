"""The page on scene files: every key of the schema has its line there and an example that compiles."""

import re
import tomllib

import pytest

from tmap.base.fields import Field, Reader
from tmap.base.paths import SCENES
from tmap.build import layout
from tmap.compiler import scene
from tmap.compiler.scene import compile_scene, schema
from tmap.report import pages, readme_reference
from tmap.scene_file import scene_file

PAGE = "tests/scenes/REFERENCE.md"
TEXT = pages.read()[PAGE]
EXAMPLES = re.findall(r"^```toml\n(.*?)^```", TEXT, re.M | re.S)
HEAD = {"width": 320, "height": 200, "frames": 50, "background": "#203040"}
ROOT = schema(layout.load().constants)
#: A key of a table: the table's path, its kind if there are several, the key.
Key = tuple[str, str, str]


def line_of(key: str, field: Field) -> str:
    """Returns a key's line on the page."""
    return f"| {' | '.join(readme_reference.rows(readme_reference.Keys('', (), {key: field}))[0])} |"


def every(reader: Reader, path: str = "") -> dict[Key, Field]:
    """Returns all keys that a value may have in it."""
    found = {}
    for inner in filter(None, (reader.element, reader.entry)):
        found |= every(inner, path + ".NAME" * (inner is reader.entry))
    for kind, fields in reader.groups.items():
        for key, field in fields.items():
            found[path, kind, key] = field
            found |= every(field.reader, f"{path}.{key}".lstrip("."))
    return found


def used(reader: Reader, value, path: str = "") -> set[Key]:
    """Returns the keys that a value has."""
    found = set()
    for each in value if reader.element and isinstance(value, list) else ():
        found |= used(reader.element, each, path)
    for each in value.values() if reader.entry else ():
        found |= used(reader.entry, each, f"{path}.NAME")
    for kind, fields in reader.groups.items():
        if not kind or kind in value:
            for key in value.keys() & fields.keys():
                found |= {(path, kind, key)} | used(fields[key].reader, value[key], f"{path}.{key}".lstrip("."))
    return found


def test_no_key_lacks_a_line() -> None:
    """Each key of each table and kind, with its values, unit, default and what it does."""
    lines = TEXT.splitlines()
    assert len(every(ROOT)) > 200
    for (path, kind, key), field in every(ROOT).items():
        assert len(field.says.split()) > 1, f"{path} {kind} {key}: the schema does not say what it does"
        assert line_of(key, field) in lines, f"{path} {kind} {key} has no line in {PAGE}: scripts/tmap readme"


@pytest.mark.parametrize("number", range(len(EXAMPLES)))
def test_example_compiles(tmp_path, number: int) -> None:
    """Each example is a scene, but for the four keys that every scene needs."""
    for file in SCENES.iterdir():
        (tmp_path / file.name).symlink_to(file)
    content = tomllib.loads(EXAMPLES[number])
    head = "".join(f"{key} = {value!r}\n" for key, value in HEAD.items() if key not in content)
    (tmp_path / "example.toml").write_text(head + EXAMPLES[number])
    scene_file.write(compile_scene(tmp_path / "example.toml"))


def test_every_line_has_an_example() -> None:
    """A key that has the same line in several tables is in one example at least."""
    fields = every(ROOT)
    found = set().union(*(used(ROOT, HEAD | tomllib.loads(text)) for text in EXAMPLES))
    shown = {line_of(key, fields[path, kind, key]) for path, kind, key in found}
    missing = {key for key, field in fields.items() if line_of(key[2], field) not in shown}
    assert not missing, f"{PAGE}: no example has {sorted(missing)}"


def test_a_key_without_a_line_is_found(monkeypatch) -> None:
    """A new key of the schema is missing on the page."""
    fields = scene.placing_fields(99) | {"spin": (scene.text, None, "turns it without an end")}
    monkeypatch.setattr(scene, "placing_fields", lambda far: fields)
    made = readme_reference.tables()
    assert pages.with_tables({PAGE: TEXT}, made)[PAGE] != TEXT
