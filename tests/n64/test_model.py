"""The texture unit's model: reference data, and what they do not ask."""

import numpy as np
import pytest

from tests.n64.reference import FOLDER, differences
from tmap.base.errors import UserError
from tmap.n64 import commands
from tmap.n64.combiner import Sources, combine
from tmap.n64.misuse import Misuse
from tmap.n64.state import CI, RGBA, TWO_CYCLES, YUV, Combine, Image, Inputs, State, Tile
from tmap.vectors.n64_text import SHAPES, read
from tmap.vectors.vector_text import parse_line

FILES = sorted(FOLDER.glob("tx_*.txt.gz"))


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.name)
def test_agrees_with_reference_data(path):
    wrong, count = differences(path)
    shown = "\n".join(f"{path.name}:{line.number}: {line.command} {line.arguments}: expected "
                      f"{list(line.expected)}, the model gives {answer}"
                      for line, answer in wrong[:3])
    assert count == 1000 and not wrong, f"{len(wrong)} of {count} differ:\n{shown}"


@pytest.mark.parametrize("text, message", [
    ("tile 0 1", "18 arguments expected, 2 found"),
    ("sample 0 1 2 3", "an answer of 4 numbers expected, 0 found"),
    ("tmemrand 5 = 6", "an answer of 0 numbers expected, 1 found"),
    ("rdp 12345678", "2 arguments expected, 1 found"),
    ("mode zoom 1", "mode: there is no 'zoom'"),
    ("paint 1", "no command 'paint'"),
    ("tmemrand x", "'x' is not a decimal number"),
    ("tmemhash = g", "'g' is not a hexadecimal number"),
])
def test_bad_text(text, message):
    with pytest.raises(UserError, match="^file:7: .*" + message):
        parse_line(text, 7, SHAPES, "file:7")


def test_unreadable_files(tmp_path):
    """Compressed files that are invalid or truncated, bytes that are not text; lines are read one
    by one."""
    path = tmp_path / "x.gz"
    with pytest.raises(UserError, match="x.gz: cannot be read"):
        list(read(path))
    path.write_bytes(FILES[0].read_bytes()[:-20])
    with pytest.raises(UserError, match="x.gz: cannot be read"):
        list(read(path))
    path.write_bytes(b"tmemrand 1\n\xff\n")
    with pytest.raises(UserError, match="x.gz: not ASCII"):
        list(read(path))
    path.write_text("# plain\n\ntmemrand 9\ntile\n")
    lines = read(path)
    assert next(lines).arguments == (9,)
    with pytest.raises(UserError, match="x.gz:4: tile"):
        next(lines)


ZERO = 7


def combined(state, texel0=(0,) * 4, texel1=(0,) * 4, shade=None, fraction=0) -> list[int]:
    arrays = [np.array(c) for c in (texel0, texel1)]
    shade = None if shade is None else np.array(shade)
    return list(combine(state, Sources(*arrays, shade, np.array(fraction))))


def test_modulate():
    """Products are rounded; one-cycle mode uses the second cycle's inputs."""
    mode = Inputs(1, 8, 4, ZERO)  # (texel0 - 0) * shade + 0
    alpha = Inputs(1, ZERO, 4, ZERO)
    state = State(combine=Combine((Inputs(), mode), (Inputs(), alpha)))
    found = combined(state, (255, 100, 0, 50), shade=(255, 128, 9, 255))
    assert found == [255 * 255 + 128 >> 8, 100 * 128 + 128 >> 8, 0, 50 * 255 + 128 >> 8]


def test_interpolation_of_levels():
    """Levels are interpolated by the level's fraction, which may be negative; results stay in
    range."""
    first = Inputs(2, 1, 13, 1)  # (texel1 - texel0) * LOD fraction + texel0
    alpha = Inputs(2, 1, 0, 1)
    second = Inputs(8, 8, 31, 0)  # combined
    state = State(combine=Combine((first, second), (alpha, Inputs(ZERO, ZERO, ZERO, 0))))
    state.modes.cycle = TWO_CYCLES
    assert combined(state, (100,) * 4, (200,) * 4, fraction=64) == [125] * 4
    # with sharpen the fraction is negative: away from the coarser level, and the result stays in
    # range
    assert combined(state, (100,) * 4, (200,) * 4, fraction=0x1C0) == [75] * 4
    assert combined(state, (10, 250, 10, 250), (200, 0, 200, 0), fraction=0x180) == [0, 255, 0, 255]


def test_second_cycle_sees_the_samples_the_other_way_round():
    state = State(combine=Combine((Inputs(), Inputs(8, 8, 31, 1)),
                                  (Inputs(), Inputs(ZERO, ZERO, ZERO, 2))))
    state.modes.cycle = TWO_CYCLES
    assert combined(state, (1, 2, 3, 4), (5, 6, 7, 8)) == [5, 6, 7, 4]


def test_combiner_refuses():
    """Noise, unless checks are off, and shade if there is none."""
    with pytest.raises(Misuse, match="no noise") as caught:
        commands.run(State(), 0x3C << 24 | 7 << 20, 0)
    assert caught.value.name == "combine input"
    commands.run(State(checked=False), 0x3C << 24 | 7 << 20, 0)
    with pytest.raises(Misuse, match="shade"):
        combined(State(combine=Combine((Inputs(4),) * 2, (Inputs(),) * 2)))


DRAM = np.zeros(1 << 16, np.uint8)
LOAD_TILE, LOAD_BLOCK, LOAD_TLUT = 0x34, 0x33, 0x30


@pytest.mark.parametrize("name, size, tile, operation, hi, lo", [
    ("image size", 0, Tile(), LOAD_TILE, 0, 4 << 12),
    ("image size", 0, Tile(), LOAD_BLOCK, 0, 4 << 12),
    ("tile edges", 2, Tile(), LOAD_TILE, 8 << 12, 4 << 12),
    ("block length", 2, Tile(), LOAD_BLOCK, 0, 2048 << 12),
    ("dram", 2, Tile(), LOAD_BLOCK, 0xFFF, 2047 << 12),
    ("TLUT image", 1, Tile(tmem=256), LOAD_TLUT, 0, 60 << 12),
    ("TLUT tile", 2, Tile(size=2, tmem=256), LOAD_TLUT, 0, 60 << 12),
    ("TLUT rows", 2, Tile(tmem=256), LOAD_TLUT, 0, 60 << 12 | 4),
    ("TLUT entries", 2, Tile(tmem=256), LOAD_TLUT, 0, 1024 << 12),
    ("TLUT place", 2, Tile(tmem=255), LOAD_TLUT, 0, 60 << 12),
    ("TLUT place", 2, Tile(tmem=500), LOAD_TLUT, 0, 60 << 12),
])
def test_bad_loads(name, size, tile, operation, hi, lo):
    state = State(dram=DRAM, image=Image(size=size, width=64))
    state.tiles[0] = tile
    with pytest.raises(Misuse) as caught:
        commands.run(state, operation << 24 | hi, lo)
    assert caught.value.name == name


def test_bad_commands():
    with pytest.raises(Misuse, match=r"^command 1 \(3e000000 00000007\): there is no command 3E"):
        commands.replay(State(), [(0x26 << 24, 0), (0x3E000000, 7)])
    with pytest.raises(Misuse, match="not a multiple of 8"):
        commands.run(State(), 0x3D << 24, 4)


@pytest.mark.parametrize("tile, tlut, good", [
    (Tile(RGBA, 2), 0, True), (Tile(RGBA, 1), 0, False), (Tile(CI, 0), 0, False),
    (Tile(CI, 0), 1, True), (Tile(CI, 2), 1, False), (Tile(YUV, 2), 0, True),
    (Tile(YUV, 2), 1, False)])
def test_formats_of_tiles(tile, tlut, good):
    state = State()
    state.tiles[0], state.modes.tlut = tile, tlut
    if good:
        state.check_tile(0)
    else:
        with pytest.raises(Misuse) as caught:
            state.check_tile(0)
        assert caught.value.name == "tile format"
    state.checked = False
    state.check_tile(0)


LOAD_SYNC, PIPE_SYNC, TILE_SYNC, FULL_SYNC = 0x26, 0x27, 0x28, 0x29


@pytest.mark.parametrize("operation, needed", [
    (LOAD_BLOCK, LOAD_SYNC), (LOAD_TILE, LOAD_SYNC), (LOAD_TLUT, LOAD_SYNC), (0x35, TILE_SYNC),
    (0x32, TILE_SYNC), (0x2F, PIPE_SYNC), (0x3C, PIPE_SYNC), (0x3B, PIPE_SYNC), (0x2C, PIPE_SYNC),
    (0x3A, None), (0x3D, None)])
def test_strict_mode(operation, needed):
    for sync in (None, LOAD_SYNC, PIPE_SYNC, TILE_SYNC, FULL_SYNC):
        state = State(dram=DRAM, strict=True, image=Image(size=2))
        state.tiles[0] = Tile(tmem=256)
        commands.run(state, operation << 24, 0)  # nothing drawn yet
        state.draws()
        if sync:
            commands.run(state, sync << 24, 0)
        if needed is None or sync in (needed, FULL_SYNC):
            commands.run(state, operation << 24, 0)
        else:
            with pytest.raises(Misuse, match="after a primitive, without a"):
                commands.run(state, operation << 24, 0)
