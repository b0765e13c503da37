"""Uses of the texture unit that the hardware's manual forbids, as named errors."""

from tmap.base.errors import UserError


class Misuse(UserError):
    """A forbidden use. ``name``: the broken rule, one or two words that stay the same."""

    def __init__(self, name: str, text: str):
        super().__init__(text)
        self.name = name
