"""Bytes that a scene's texture units load from or draw with."""

from dataclasses import dataclass, field

ALIGN = 8  # of addresses: what an N64 image and Glide's registers have


@dataclass
class BytePool:
    """Blocks one behind the other, each at a multiple of ALIGN; the same bytes are there once."""

    data: bytearray = field(default_factory=bytearray)
    known: dict[bytes, int] = field(default_factory=dict)

    def put(self, block: bytes) -> int:
        """The address of a block."""
        if block not in self.known:
            self.known[block] = len(self.data)
            self.data += block + bytes(-len(block) % ALIGN)
        return self.known[block]
