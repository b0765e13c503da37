"""Numbers of the commands, bits 29:24 of a command's first word."""

Word = tuple[int, int]  # hi, lo

#: Not a hardware command: the geometry processor's, for a triangle's textures.
TEXTURE = 0x17

LOAD_SYNC, PIPE_SYNC, TILE_SYNC, FULL_SYNC = 0x26, 0x27, 0x28, 0x29
SET_CONVERT, SET_OTHER_MODES = 0x2C, 0x2F
LOAD_TLUT, SET_TILE_SIZE, LOAD_BLOCK, LOAD_TILE, SET_TILE = 0x30, 0x32, 0x33, 0x34, 0x35
SET_PRIMITIVE_COLOUR, SET_ENVIRONMENT_COLOUR, SET_COMBINE = 0x3A, 0x3B, 0x3C
SET_TEXTURE_IMAGE = 0x3D

NAMES = {
    TEXTURE: "texture", LOAD_SYNC: "load sync", PIPE_SYNC: "pipe sync", TILE_SYNC: "tile sync",
    FULL_SYNC: "full sync", SET_CONVERT: "set convert", SET_OTHER_MODES: "set other modes",
    LOAD_TLUT: "load TLUT", SET_TILE_SIZE: "set tile size", LOAD_BLOCK: "load block",
    LOAD_TILE: "load tile", SET_TILE: "set tile", SET_PRIMITIVE_COLOUR: "set primitive colour",
    SET_ENVIRONMENT_COLOUR: "set environment colour", SET_COMBINE: "set combine",
    SET_TEXTURE_IMAGE: "set texture image",
}


def bits(word: int, high: int, low: int) -> int:
    """Returns bits high:low of a word."""
    return word >> low & (2 << high - low) - 1
