"""Runs command words, which change the state of a texture unit."""

from collections.abc import Callable, Iterable

from tmap.base.fixed import signed
from tmap.n64.combiner import check as check_combine, inputs_of
from tmap.n64.disassemble import line
from tmap.n64.loads import load_block, load_tile, load_tlut
from tmap.n64.misuse import Misuse
from tmap.n64.opcodes import (FULL_SYNC, LOAD_BLOCK, LOAD_SYNC, LOAD_TILE, LOAD_TLUT, PIPE_SYNC,
                              SET_COMBINE, SET_CONVERT, SET_ENVIRONMENT_COLOUR, SET_OTHER_MODES,
                              SET_PRIMITIVE_COLOUR, SET_TEXTURE_IMAGE, SET_TILE, SET_TILE_SIZE,
                              TEXTURE, TILE_SYNC, Word, bits)
from tmap.n64.state import (PENDING_LOAD, PENDING_PIPE, PENDING_TILE, Axis, Combine, Image, Modes,
                            State, Tile)


def set_texture_image(state: State, hi: int, lo: int) -> None:
    """Sets the image that loads read: format, size, width and address."""
    image = Image(bits(lo, 23, 0), bits(hi, 23, 21), bits(hi, 20, 19), bits(hi, 9, 0) + 1)
    state.forbids(image.address & 7 != 0, "image alignment",
                  f"image address {image.address:#x} is not a multiple of 8")
    state.image = image


def set_tile(state: State, hi: int, lo: int) -> None:
    """Sets a tile descriptor except its size."""
    state.changes(PENDING_TILE, "set tile")
    number = bits(lo, 26, 24)
    old = state.tiles[number]
    t = Axis(bits(lo, 19, 19), bits(lo, 18, 18), bits(lo, 17, 14), bits(lo, 13, 10),
             old.t.low, old.t.high)
    s = Axis(bits(lo, 9, 9), bits(lo, 8, 8), bits(lo, 7, 4), bits(lo, 3, 0),
             old.s.low, old.s.high)
    state.tiles[number] = Tile(bits(hi, 23, 21), bits(hi, 20, 19), bits(hi, 17, 9), bits(hi, 8, 0),
                               bits(lo, 23, 20), s, t)


def edges(state: State, hi: int, lo: int) -> tuple[Tile, int]:
    """Stores sl, tl, sh and th of a word into its tile; returns the tile and its number."""
    number = bits(lo, 26, 24)
    tile = state.tiles[number]
    tile.s.low, tile.t.low = bits(hi, 23, 12), bits(hi, 11, 0)
    tile.s.high, tile.t.high = bits(lo, 23, 12), bits(lo, 11, 0)
    return tile, number


def set_tile_size(state: State, hi: int, lo: int) -> None:
    """Sets a tile's edges."""
    state.changes(PENDING_TILE, "set tile size")
    edges(state, hi, lo)


def loader(load: Callable[[State, Tile], None], name: str):
    """Returns the command of a load, which also stores its edges."""
    def run(state: State, hi: int, lo: int) -> None:
        state.changes(PENDING_LOAD, name)
        load(state, edges(state, hi, lo)[0])

    run.__doc__ = f"A {name}."
    return run


def set_convert(state: State, hi: int, lo: int) -> None:
    """Sets the constants K0..K5."""
    state.changes(PENDING_PIPE, "set convert")
    both = hi << 32 | lo
    state.k = [signed(both >> shift, 9) for shift in (45, 36, 27, 18, 9, 0)]


def set_other_modes(state: State, hi: int, lo: int) -> None:
    """Sets the modes."""
    state.changes(PENDING_PIPE, "set other modes")
    state.modes = Modes(bits(hi, 21, 20), *(bits(hi, bit, bit) for bit in range(19, 8, -1)))


def set_combine(state: State, hi: int, lo: int) -> None:
    """Sets the combiner's inputs."""
    state.changes(PENDING_PIPE, "set combine")
    combine = Combine(**inputs_of(hi, lo))
    if state.checked:
        check_combine(combine)
    state.combine = combine


def colour(lo: int) -> tuple[int, int, int, int]:
    """Returns (r, g, b, a) of a word."""
    return bits(lo, 31, 24), bits(lo, 23, 16), bits(lo, 15, 8), bits(lo, 7, 0)


def set_primitive_colour(state: State, hi: int, lo: int) -> None:
    """Sets the primitive colour, its LOD fraction and the lowest level; needs no sync."""
    state.min_level, state.primitive_fraction = bits(hi, 12, 8), bits(hi, 7, 0)
    state.primitive = colour(lo)


def set_environment_colour(state: State, hi: int, lo: int) -> None:
    """Sets the environment colour."""
    state.changes(PENDING_PIPE, "set environment colour")
    state.environment = colour(lo)


def texture(state: State, hi: int, lo: int) -> None:
    """Sets the highest level and the tile, which a triangle's command contains. Not a command of
    the hardware: the number and the fields are the geometry processor's."""
    state.max_level, state.primitive_tile = bits(hi, 13, 11), bits(hi, 10, 8)


def sync(what: int):
    """Returns the command of a sync."""
    def run(state: State, hi: int, lo: int) -> None:
        state.synced(what)

    run.__doc__ = "A sync."
    return run


COMMANDS = {
    TEXTURE: texture,
    LOAD_SYNC: sync(PENDING_LOAD),
    PIPE_SYNC: sync(PENDING_PIPE),
    TILE_SYNC: sync(PENDING_TILE),
    FULL_SYNC: sync(PENDING_LOAD | PENDING_TILE | PENDING_PIPE),
    SET_CONVERT: set_convert,
    SET_OTHER_MODES: set_other_modes,
    LOAD_TLUT: loader(load_tlut, "load TLUT"),
    SET_TILE_SIZE: set_tile_size,
    LOAD_BLOCK: loader(load_block, "load block"),
    LOAD_TILE: loader(load_tile, "load tile"),
    SET_TILE: set_tile,
    SET_PRIMITIVE_COLOUR: set_primitive_colour,
    SET_ENVIRONMENT_COLOUR: set_environment_colour,
    SET_COMBINE: set_combine,
    SET_TEXTURE_IMAGE: set_texture_image,
}


def run(state: State, hi: int, lo: int) -> None:
    """Runs one command; the two highest bits are ignored."""
    operation = bits(hi, 29, 24)
    if operation not in COMMANDS:
        raise Misuse("command", f"there is no command {operation:02X}")
    COMMANDS[operation](state, hi, lo)


def replay(state: State, words: Iterable[Word], start: int = 0) -> None:
    """Runs a display list up to its first error, whose text contains the command's number."""
    for number, (hi, lo) in enumerate(words, start):
        try:
            run(state, hi, lo)
        except Misuse as misuse:
            raise Misuse(misuse.name, f"command {number} ({line(hi, lo)}): {misuse}") from None
