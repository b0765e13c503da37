"""What the command line's options are made of."""

import argparse
from collections.abc import Iterable
from pathlib import Path

from tmap.base.errors import UserError
from tmap.guest.emulator import MEASURED


class Parser(argparse.ArgumentParser):
    """Reports argument errors in one line, like all other errors."""

    def error(self, message: str):
        raise UserError(f"{self.prog.removeprefix('tmap').strip() or 'usage'}: {message}; "
                        f"see {self.prog} --help")


def number(text: str) -> float:
    """Returns a finite number from 0 on. Messages on wrong numbers contain this function's name."""
    value = float(text)
    if not 0 <= value < float("inf"):
        raise ValueError
    return value


def size(text: str) -> float:
    """Returns a finite number above 0."""
    if not number(text):
        raise ValueError
    return float(text)


def rate(text: str) -> float:
    """Returns a number of frames a second."""
    return size(text)


class Commands:
    """Adds commands to a parser."""

    def __init__(self, top: Parser) -> None:
        self.commands = top.add_subparsers(title="commands", metavar="COMMAND", required=True)

    def add(self, name: str, function, text: str) -> argparse.ArgumentParser:
        """Adds a command that calls a function with its arguments."""
        command = self.commands.add_parser(name, help=text, description=text)
        command.set_defaults(function=function)
        return command


def add_out(command: argparse.ArgumentParser, text: str, metavar: str = "DIR", **more) -> None:
    """Adds a command's output option."""
    command.add_argument("-o", dest="out", type=Path, metavar=metavar, help=text, **more)


def add_machine(command: argparse.ArgumentParser, default: str | None = None, text: str | None = None,
                choices: Iterable[str] = MEASURED, **more) -> None:
    """Adds the option that chooses the emulated machine."""
    command.add_argument("--machine", choices=tuple(choices), default=default, help=text, **more)


def pair(text: str) -> tuple[int, int]:
    """Returns a width and a height, as 320x256."""
    width, _, height = text.partition("x")
    if not all(each.isascii() and each.isdigit() and int(each) for each in (width, height)):
        raise ValueError
    return int(width), int(height)
