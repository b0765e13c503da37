"""The one exception that reaches the user as a line instead of a traceback."""


class UserError(Exception):
    """Bad input or a failed run: one clear line naming file and field."""
