"""Checks for the fields of TOML files, as data; refusals name the field's path.

A reader is called with a value and its path (``scene.toml: objects[2].radius``) and returns the value
for the program or raises UserError. It also says which values it takes, for the reference page
(tmap.report.readme_reference), so that a range is stated once.
"""

import re
from collections.abc import Callable
from dataclasses import dataclass, field as attribute
from typing import NamedTuple

from tmap.base.errors import UserError

REQUIRED = object()
NOUNS = {bool: "true or false", int: "a number", float: "a number", str: "text",
         list: "a list", dict: "a table"}


class Field(NamedTuple):
    """A key of a table. ``default`` is a value as in TOML, REQUIRED, or None: no value."""

    reader: "Reader"
    default: object
    says: str  # what the key does, for the reference page


@dataclass(frozen=True)
class Reader:
    """A check, and what the reference page says of it."""

    check: Callable
    says: str  # the values that it takes
    unit: str = ""
    element: "Reader | None" = None  # of a list's entries
    entry: "Reader | None" = None  # of a table with any names
    groups: dict[str, dict[str, Field]] = attribute(default_factory=dict)  # a table's keys by alternative

    def __call__(self, value, where: str):
        return self.check(value, where)


def reader(says: str, unit: str = "", **parts):
    """Decorates a check, which becomes a Reader."""
    return lambda check: Reader(check, says, unit, **parts)


def fail(where: str, message: str):
    """Refuses the field at a path."""
    raise UserError(f"{where}: {message}")


def join(where: str, key: str) -> str:
    """Returns the path of a field inside a table; odd keys are quoted to stay on one line."""
    name = key if re.fullmatch(r"[\w-]+", key) else repr(key)
    return f"{where}{'' if not where or where.endswith(': ') else '.'}{name}"


def expect(value, where: str, kinds: tuple, noun: str):
    """Refuses a value of another type; true and false are not numbers."""
    if type(value) not in kinds:
        fail(where, f"must be {noun}, not {NOUNS.get(type(value), 'a date or time')}")


def figure(value: float) -> str:
    """Returns a number as pages show it."""
    return f"{value:,.15g}"


@reader("number")
def real(value, where):
    """Any number; another check limits it."""
    expect(value, where, (int, float), "a number")
    return value


def number(low: float, high: float, unit: str = "") -> Reader:
    """A number from low to high."""
    @reader(f"number, {figure(low)} to {figure(high)}", unit)
    def check(value, where):
        if not low <= real(value, where) <= high:  # also catches NaN
            fail(where, f"must be from {low:.15g} to {high:.15g}")
        return float(value)
    return check


def integer(low: int, high: int, multiple: int = 1, unit: str = "") -> Reader:
    """A whole number from low to high."""
    step = f" and a multiple of {multiple}" if multiple > 1 else ""

    @reader(f"whole number, {low:,} to {high:,}{step}", unit)
    def check(value, where):
        expect(value, where, (int,), "a whole number")
        if not low <= value <= high or value % multiple:
            fail(where, f"must be from {low} to {high}{step}")
        return value
    return check


@reader("text")
def text(value, where):
    """Text that fits a line of a message."""
    expect(value, where, (str,), "text")
    if not value.isprintable():
        fail(where, "must be text on one line")
    return value


@reader("`true` or `false`")
def flag(value, where):
    """True or false."""
    if type(value) is not bool:
        fail(where, "must be true or false")
    return value


def one_of(*names: str) -> Reader:
    """One of these words."""
    @reader(", ".join(f'`"{name}"`' for name in names))
    def check(value, where):
        text(value, where)
        if value not in names:
            fail(where, f"{value!r} is not one of {', '.join(names)}")
        return value
    return check


@reader('colour, `"#rrggbb"`')
def colour(value, where):
    """``#rrggbb`` to (red, green, blue)."""
    text(value, where)
    if not re.fullmatch(r"#[0-9a-fA-F]{6}", value):
        fail(where, 'must be a colour like "#8040ff"')
    return tuple(bytes.fromhex(value[1:]))


def rows(element: Reader, low: int, high: int) -> Reader:
    """A list of low to high elements."""
    count = f"{low}{f' to {high}' if high > low else ''}"

    @reader(f"list of {low:,}{f' to {high:,}' if high > low else ''}: {element.says}", element.unit, element=element)
    def check(value, where):
        expect(value, where, (list,), "a list")
        if not low <= len(value) <= high:
            fail(where, f"must have {count} entries, not {len(value)}")
        return [element(entry, f"{where}[{i}]") for i, entry in enumerate(value)]
    return check


def one_or_rows(element: Reader, low: int, high: int, says: str) -> Reader:
    """A value, or a list of low to high of them; always returns a list. ``says``: when a list is meant."""
    several = rows(element, low, high)

    @reader(f"{element.says}; or {says}, a list of {low:,}{f' to {high:,}' if high > low else ''}", element.unit)
    def check(value, where):
        return several(value, where) if isinstance(value, list) else [element(value, where)]
    return check


def read(fields: dict[str, Field], value, where: str) -> dict:
    """Returns the values of a table with exactly these fields."""
    expect(value, where, (dict,), "a table")
    for key in value:
        if key not in fields:
            fail(join(where, key), f"unknown field; known are {', '.join(fields)}")
    for key, (_, default, _) in fields.items():
        if default is REQUIRED and key not in value:
            fail(join(where, key), "is missing")
    filled = {key: value.get(key, default) for key, (_, default, _) in fields.items()}
    return {key: None if given is None else fields[key].reader(given, join(where, key))
            for key, given in filled.items()}


def settled(fields: dict[str, tuple]) -> dict[str, Field]:
    """Returns the fields of a table, which may be written as plain tuples."""
    return {key: Field(*each) for key, each in fields.items()}


def table(fields: dict[str, tuple]) -> Reader:
    """A table with exactly these fields."""
    known = settled(fields)
    return Reader(lambda value, where: read(known, value, where), "table", groups={"": known})


def named(element: Reader) -> Reader:
    """A table whose keys may be any names."""
    @reader(f"table of names: {element.says}", entry=element)
    def check(value, where):
        expect(value, where, (dict,), "a table")
        return {key: element(entry, join(where, key)) for key, entry in value.items()}
    return check


def choice(alternatives: dict[str, dict], common: dict) -> Reader:
    """A table with the common fields and those of the one alternative whose key it has."""
    groups = {key: settled(fields | common) for key, fields in alternatives.items()}

    @reader("table", groups=groups)
    def check(value, where):
        expect(value, where, (dict,), "a table")
        chosen = [key for key in groups if key in value]
        if len(chosen) != 1:
            fail(where, f"needs exactly one of {', '.join(groups)}")
        return read(groups[chosen[0]], value, where)
    return check
