"""Lines of a TOML file's keys and list entries, for messages: tomllib does not keep them.

The text must be TOML that tomllib takes, so that its parts can be told apart by few rules.
"""

import re
import tomllib
from collections.abc import Iterator
from contextlib import contextmanager
from typing import NamedTuple

from tmap.base.errors import UserError
from tmap.base.fields import join

TOKEN = re.compile(r"""
    (?P<string>"{3}(?:\\.|[^\\])*?"{3,5}|'{3}.*?'{3,5}|"(?:\\.|[^"\\])*"|'[^']*')
    |(?P<space>[ \t\r]+|\#[^\n]*)|(?P<mark>[][{}=,\n])|(?P<word>[^][{}=,\s"'\#]+)""", re.S | re.X)
OPENING, CLOSING = {"[": "]", "{": "}"}, "]}"


class Token(NamedTuple):
    """A word, string or mark, and its line from 1."""

    text: str
    line: int


def tokens(text: str) -> Iterator[Token]:
    """Yields the tokens of a text; the last one is the end of a line."""
    line = 1
    for found in TOKEN.finditer(text + "\n"):
        if found.lastgroup != "space":
            yield Token(found[0], line)
        line += found[0].count("\n")


def parts_of(key: str) -> list[str]:
    """Returns the names in a dotted key."""
    made, parts = tomllib.loads(f"{key} = 0"), []
    while made != 0:
        (name, made), = made.items()
        parts.append(name)
    return parts


class Lines:
    """The lines of a text by path, such as ``objects[2].keys[0].frame``."""

    def __init__(self, text: str) -> None:
        self.found: dict[str, int] = {}
        self.counts: dict[str, int] = {}  # entries of lists of tables so far
        self.tokens = list(tokens(text))
        self.at = 0
        table = ""
        while self.at < len(self.tokens):
            if self.tokens[self.at].text == "[":
                table = self.header()
            elif self.tokens[self.at].text != "\n":
                self.pair(table)
            self.at += 1

    def next(self) -> Token:
        """Returns the token behind this one, and goes there."""
        self.at += 1
        return self.tokens[self.at]

    def name(self, path: str, line: int) -> None:
        """Notes where a path is named first."""
        self.found.setdefault(path, line)

    def key(self, path: str, ends: str, is_list: bool = False) -> str:
        """Reads a dotted key up to the mark ``ends``; returns its path inside a table. Names of lists
        of tables mean their last entry, and ``is_list`` adds one."""
        first = self.tokens[self.at]
        words = [first.text]
        while (token := self.next()).text != ends:
            words.append(token.text)
        names = parts_of("".join(words))
        for k, each in enumerate(names):
            path = join(path, each)
            self.name(path, first.line)
            if is_list and k == len(names) - 1:
                self.counts[path] = self.counts.get(path, 0) + 1
            if path in self.counts:
                path = f"{path}[{self.counts[path] - 1}]"
                self.name(path, first.line)
        return path

    def header(self) -> str:
        """Reads the head of a table, [a.b] or [[a.b]]; returns its path."""
        is_list = self.next().text == "["
        if is_list:
            self.at += 1
        path = self.key("", "]", is_list)
        self.at += is_list
        return path

    def pair(self, table: str) -> None:
        """Reads a key and its value up to the value's last token."""
        path = self.key(table, "=")
        self.at += 1
        self.value(path)

    def value(self, path: str) -> None:
        """Reads a value up to its last token."""
        token = self.tokens[self.at]
        if token.text == "{":
            while (mark := self.next()).text != "}":
                if mark.text not in ",\n":
                    self.pair(path)
        elif token.text == "[":
            count = 0
            while (mark := self.next()).text != "]":
                if mark.text not in ",\n":
                    entry = f"{path}[{count}]"
                    self.name(entry, mark.line)
                    self.value(entry)
                    count += 1
        else:  # a date may have a space in it
            while self.tokens[self.at + 1].text not in (",", "]", "}", "\n"):
                self.at += 1

    def of(self, place: str) -> int:
        """Returns the line of the longest path with which a text begins; 1, the scene's own table's, if
        it begins with none."""
        paths = [path for path in self.found if place.startswith(path) and place[len(path):][:1] in (*":.[", "")]
        return self.found[max(paths, key=len)] if paths else 1


def with_line(message: str, file: str, text: str) -> str:
    """Returns a message that begins with ``FILE: `` and a path in its text with the path's line."""
    start = f"{file}: "
    if not message.startswith(start):
        return message
    place = message.removeprefix(start)
    return f"{file}:{Lines(text).of(place)}: {place}"


@contextmanager
def located(file: str, text: str):
    """Within this context, refusals that begin with ``FILE: `` and a path get the path's line."""
    try:
        yield
    except UserError as error:
        raise UserError(with_line(str(error), file, text)) from None
