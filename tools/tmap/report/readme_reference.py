"""The tables of the page on scene files: every key, from the schema by which the compiler reads them."""

from collections.abc import Iterator
from typing import NamedTuple

from tmap.base.fields import REQUIRED, Field, Reader, figure
from tmap.base.markdown import table
from tmap.build import layout
from tmap.compiler import scene

TOP = "a scene"


class Keys(NamedTuple):
    """Keys of a table in scene files that the same alternatives of it have."""

    table: str  # as a scene writes its head
    only: tuple[str, ...]  # the alternatives, by the key that makes each; empty: all
    fields: dict[str, Field]

    @property
    def title(self) -> str:
        """Returns the title of the keys on the page."""
        return f"keys of {self.table}" + f" with {' or '.join(self.only)}" * bool(self.only)

    @property
    def head(self) -> str:
        """Returns the head of the first column."""
        if self.table == TOP:
            return "key"
        return f"`{self.table}`" + f" with {' or '.join(f'`{kind}`' for kind in self.only)}" * bool(self.only)


def toml(value) -> str:
    """Returns a default as a scene would write it."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, dict):
        pairs = ", ".join(f"{key} = {toml(each)}" for key, each in value.items())
        return f"{{ {pairs} }}" if pairs else "{}"
    if isinstance(value, list):
        return f"[{', '.join(map(toml, value))}]"
    return f'"{value}"' if isinstance(value, str) else figure(value).replace(",", "")


def default(value) -> str:
    """Returns what the page says of a default."""
    if value is REQUIRED:
        return "required"
    return "" if value is None else f"`{toml(value)}`"


def head(path: str, is_list: bool) -> str:
    """Returns the head of a table."""
    if not path:
        return TOP
    return f"[[{path}]]" if is_list else f"[{path}]"


def split(reader: Reader, name: str) -> Iterator[Keys]:
    """Yields a table's keys, those together that the same alternatives have, and those of all first."""
    found: dict[tuple[str, ...], dict[str, Field]] = {}
    for fields in reader.groups.values():
        for key, field in fields.items():
            owners = tuple(kind for kind, those in reader.groups.items() if those.get(key) == field)
            found.setdefault(() if len(owners) == len(reader.groups) else owners, {})[key] = field
    for owners in sorted(found, key=bool):
        yield Keys(name, owners, found[owners])


def tables_in(reader: Reader, path: str = "", is_list: bool = False) -> Iterator[tuple[str, Reader]]:
    """Yields the tables that a value may have in it, by their heads; NAME stands for any name."""
    if reader.element:
        yield from tables_in(reader.element, path, True)
    if reader.entry:
        yield from tables_in(reader.entry, f"{path}.NAME")
    if reader.groups:
        yield head(path, is_list), reader
        for key, field in {key: field for fields in reader.groups.values() for key, field in fields.items()}.items():
            yield from tables_in(field.reader, f"{path}.{key}".lstrip("."))


def keys(root: Reader) -> list[Keys]:
    """Returns all keys of a schema."""
    return [part for name, reader in tables_in(root) for part in split(reader, name)]


def rows(part: Keys) -> list[list[str]]:
    """Returns the rows of a table on the page."""
    return [[f"`{key}`", field.reader.says, field.reader.unit, default(field.default), field.says]
            for key, field in part.fields.items()]


def tables() -> dict[str, str]:
    """Returns the tables by title. Of those with equal lines only the first is there."""
    made: dict[str, str] = {}
    known: list[list[list[str]]] = []
    for part in keys(scene.schema(layout.load().constants)):
        lines = rows(part)
        if lines not in known:
            known.append(lines)
            made[part.title] = table([part.head, "values", "unit", "default", "what it does"], lines, "l")
    return made
