"""Checks for the fields of TOML files, as data; refusals name the field's path.

A check is a function of a value and its path (``scene.toml: objects[2].radius``)
that returns the value for the program or raises UserError.
"""

import re

from tmap.base.errors import UserError

REQUIRED = object()
NOUNS = {bool: "true or false", int: "a number", float: "a number", str: "text",
         list: "a list", dict: "a table"}


def fail(where: str, message: str):
    """Refuses the field at a path."""
    raise UserError(f"{where}: {message}")


def join(where: str, key: str) -> str:
    """Returns the path of a field inside a table; odd keys are quoted to stay on one line."""
    name = key if re.fullmatch(r"[\w-]+", key) else repr(key)
    return f"{where}{'' if where.endswith(': ') else '.'}{name}"


def expect(value, where: str, kinds: tuple, noun: str):
    """Refuses a value of another type; true and false are not numbers."""
    if type(value) not in kinds:
        fail(where, f"must be {noun}, not {NOUNS.get(type(value), 'a date or time')}")


def real(value, where):
    """Any number; another check limits it."""
    expect(value, where, (int, float), "a number")
    return value


def number(low: float, high: float):
    """A number from low to high."""
    def check(value, where):
        if not low <= real(value, where) <= high:  # also catches NaN
            fail(where, f"must be from {low:.15g} to {high:.15g}")
        return float(value)
    return check


def integer(low: int, high: int, multiple: int = 1):
    """A whole number from low to high."""
    def check(value, where):
        expect(value, where, (int,), "a whole number")
        if not low <= value <= high or value % multiple:
            step = f" and a multiple of {multiple}" if multiple > 1 else ""
            fail(where, f"must be from {low} to {high}{step}")
        return value
    return check


def text(value, where):
    """Text that fits a line of a message."""
    expect(value, where, (str,), "text")
    if not value.isprintable():
        fail(where, "must be text on one line")
    return value


def flag(value, where):
    """True or false."""
    if type(value) is not bool:
        fail(where, "must be true or false")
    return value


def one_of(*names: str):
    """One of these words."""
    def check(value, where):
        text(value, where)
        if value not in names:
            fail(where, f"{value!r} is not one of {', '.join(names)}")
        return value
    return check


def colour(value, where):
    """``#rrggbb`` to (red, green, blue)."""
    text(value, where)
    if not re.fullmatch(r"#[0-9a-fA-F]{6}", value):
        fail(where, 'must be a colour like "#8040ff"')
    return tuple(bytes.fromhex(value[1:]))


def rows(element, low: int, high: int):
    """A list of low to high elements."""
    def check(value, where):
        expect(value, where, (list,), "a list")
        if not low <= len(value) <= high:
            fail(where, f"must have {low}{f' to {high}' if high > low else ''} entries, "
                        f"not {len(value)}")
        return [element(entry, f"{where}[{i}]") for i, entry in enumerate(value)]
    return check


def table(fields: dict):
    """A table with exactly these fields: name to (check, default or REQUIRED)."""
    def check(value, where):
        expect(value, where, (dict,), "a table")
        for key in value:
            if key not in fields:
                fail(join(where, key), f"unknown field; known are {', '.join(fields)}")
        for key, (_, default) in fields.items():
            if default is REQUIRED and key not in value:
                fail(join(where, key), "is missing")
        return {key: field(value[key], join(where, key)) if key in value else default
                for key, (field, default) in fields.items()}
    return check


def named(element):
    """A table whose keys may be any names."""
    def check(value, where):
        expect(value, where, (dict,), "a table")
        return {key: element(entry, join(where, key)) for key, entry in value.items()}
    return check


def choice(alternatives: dict[str, dict], common: dict):
    """A table with the common fields and those of the one alternative whose key it has."""
    def check(value, where):
        expect(value, where, (dict,), "a table")
        chosen = [key for key in alternatives if key in value]
        if len(chosen) != 1:
            fail(where, f"needs exactly one of {', '.join(alternatives)}")
        return table(alternatives[chosen[0]] | common)(value, where)
    return check
