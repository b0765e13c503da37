"""Messages that name a line of a scene."""

from pathlib import Path


def without_line(message: str, scene: Path) -> str:
    """Returns a message about a key of a scene without the line's number, which must be one of the file's."""
    start = f"{scene}:"
    line, _, rest = message.removeprefix(start).partition(":")
    assert message.startswith(start) and line.isdigit() and "\n" not in message, message
    assert 1 <= int(line) <= scene.read_text().count("\n") + 1, message
    return start + rest
