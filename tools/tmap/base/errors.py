"""The one exception that is shown to the user as a line instead of a traceback."""


class UserError(Exception):
    """Bad input or a failed run: one clear line naming file and field."""


def require(name: str, where: str, value: int, low: int, high: int, unit: str = "") -> None:
    """Refuses a value outside low..high; ``name``: the file's name, ``where``: the field's."""
    if not low <= value <= high:
        raise UserError(f"{name}: {where}: {value} is not from {low} to {high}{unit}")
