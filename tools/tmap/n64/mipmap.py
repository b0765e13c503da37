"""Textures with their coarser levels, loaded into tiles for the level of detail."""

from collections.abc import Sequence

from tmap.base.errors import UserError
from tmap.n64.images import Texture
from tmap.n64.state import CI, TILES, TMEM_WORDS, YUV
from tmap.n64.words import List, Wrap, line_of

LEVELS = TILES - 1  # the last tile is for loads


def load_chain(words: List, textures: Sequence[Texture], addresses: Sequence[int],
               first: int = 0, palette: int = 0, mirror: bool = False, clamp: bool = False) -> None:
    """Adds commands that load levels, finest first, into tiles from ``first`` on, one after another
    in TMEM; level n's coordinates are shifted by n. Sides are powers of two."""
    if not 1 <= len(textures) <= LEVELS - first:
        raise UserError(f"mip map: {len(textures)} levels from tile {first} on; there are "
                        f"{LEVELS} tiles")
    tmem = 0
    for level, (texture, address) in enumerate(zip(textures, addresses, strict=True)):
        axes = []
        for side in (texture.width, texture.height):
            if side & side - 1:
                raise UserError(f"mip map: a side of {side} texels is not a power of two")
            axes.append(Wrap(int(clamp), int(mirror), side.bit_length() - 1, level))
        count = line_of(texture.form, texture.size, texture.width) * texture.height
        halves = texture.form in (CI, YUV) or texture.size == 3
        room = TMEM_WORDS // 2 if halves else TMEM_WORDS
        if tmem + count > room:
            raise UserError(f"mip map: level {level} ends at word {tmem + count} of {room} "
                            "of TMEM")
        words.load_texture_tile(address, texture.form, texture.size, texture.row_texels,
                                (0, 0, texture.width - 1, texture.height - 1), palette, *axes,
                                tmem=tmem, tile=first + level)
        tmem += count
