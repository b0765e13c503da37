"""The bytes that a scene's texture units load or draw from."""

from dataclasses import dataclass, field

ALIGN = 8  # of addresses: an N64 image and Glide's registers need it


@dataclass
class BytePool:
    """Consecutive blocks, each at a multiple of ALIGN; equal blocks are stored once."""

    data: bytearray = field(default_factory=bytearray)
    known: dict[bytes, int] = field(default_factory=dict)

    def put(self, block: bytes) -> int:
        """Returns a block's address; appends the block if it is new."""
        if block not in self.known:
            self.known[block] = len(self.data)
            self.data += block + bytes(-len(block) % ALIGN)
        return self.known[block]
