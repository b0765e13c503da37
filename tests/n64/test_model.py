"""The texture unit's model: reference data, and worked examples of each rule."""

import numpy as np
import pytest

from tests.helpers.arrays import check_equal
from tests.n64.reference import FOLDER, differences
from tmap.base.errors import UserError
from tmap.n64 import commands
from tmap.n64.combiner import Sources, combine
from tmap.n64.coordinates import position
from tmap.n64.divide import divide
from tmap.n64.filters import Quad, interpolate
from tmap.n64.lod import choose
from tmap.n64.misuse import Misuse
from tmap.n64.state import CI, RGBA, TWO_CYCLES, YUV, Axis, Combine, Image, Inputs, State, Tile
from tmap.n64.texels import entries, fetch
from tmap.vectors.n64_text import SHAPES, read
from tmap.vectors.vector_text import parse_line, xorshift, xorshift_step

FILES = sorted(FOLDER.glob("tx_*.txt.gz"))


def test_there_is_reference_data():
    assert len(FILES) == 9, f"nine files tx_*.txt.gz expected in {FOLDER}, {len(FILES)} found"


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


def test_xorshift():
    """Many numbers at once equal those of single steps; the first is computed by hand."""
    assert xorshift_step(1) == 270369
    x, numbers = 5, []
    for _ in range(1000):
        x = xorshift_step(x)
        numbers.append(x)
    assert list(xorshift(5, 1000)) == numbers


def ramp() -> State:
    """A unit in which byte n of TMEM is n & 255 in the lower half, ~n & 255 in the upper one."""
    n = np.arange(4096)
    return State(tmem=np.where(n < 2048, n, ~n).astype(np.uint8))


def test_places_of_texels():
    """Rows are one line apart; in odd rows the halves of each word are exchanged."""
    state = State()
    state.tmem[::2], state.tmem[1::2] = np.arange(2048) >> 8, np.arange(2048) & 255
    s, row = np.array([0, 0, 2, 3]), np.array([0, 1, 1, 1])
    places = np.array([0, 20, 16, 18])
    want = fetch(state, Tile(RGBA, 2), places // 2, np.zeros(4, int))
    assert len(np.unique(want, axis=0)) == 4
    check_equal(fetch(state, Tile(RGBA, 2, line=2), s, row), want, "texel, channel")


def test_halves_of_wide_texels():
    """Red and green are in the lower half of TMEM, blue and alpha in the upper one."""
    assert list(fetch(ramp(), Tile(RGBA, 3, line=1), 1, 0)) == [2, 3, 255 - 2, 255 - 3]


def test_palette_entry():
    """The 4-bit index follows the tile's palette number; each entry is stored four times in the
    upper half."""
    state = State()
    state.tmem[0] = 0x50
    state.tmem[0x9A8:0x9AA] = 0xAB, 0xCD
    state.modes.tlut = 1
    assert entries(state, Tile(CI, 0, palette=3), np.array(0), np.array(0)) == 0xABCD


@pytest.mark.parametrize("axis, c, want", [
    (Axis(mask=5, shift=1), 0x50, (1, 8, 1)),
    (Axis(mask=5, shift=15), 0x50, (5, 0, 1)),
    (Axis(clamp=1, high=31 << 2), 992, (31, 0, 1)),
    (Axis(clamp=1, high=31 << 2), 991, (30, 31, 1)),
    (Axis(clamp=1, high=31 << 2), -1, (0, 0, 1)),
    (Axis(mask=2, mirror=1), 3 * 32, (3, 0, 0)),
    (Axis(mask=2, mirror=1), 4 * 32, (3, 0, -1)),
    (Axis(mask=2, mirror=1), 7 * 32, (0, 0, 0)),
    (Axis(mask=2, mirror=1), 8 * 32, (0, 0, 1)),
    (Axis(mask=2), 3 * 32 + 5, (3, 5, -3)),
])
def test_axis(axis, c, want):
    assert tuple(int(x) for x in position(axis, np.array(c), False)) == want


@pytest.mark.parametrize("fs, ft, want", [(8, 0, 64), (24, 16, 191)])
def test_three_points(fs, ft, want):
    low, high = np.array([0]), np.array([255])
    assert interpolate(Quad(low, high, low, high), np.array(fs), np.array(ft)) == want


@pytest.mark.parametrize("s, w, want", [(8225, 23754, 11345), (3270, 28965, 3699), (1, 0, 32767)])
def test_divide(s, w, want):
    assert divide(np.array(s), np.array(0), np.array(w), True).s == want


@pytest.mark.parametrize("lod, modes, want", [
    (80, {"lod": 1}, (1, 2, 64)), (24, {"lod": 1, "sharpen": 1}, (0, 1, 0x1C0)),
    (24, {"lod": 1, "detail": 1}, (0, 1, 0xC0)), (24, {"lod": 1}, (0, 0, 0))])
def test_levels(lod, modes, want):
    state = State(max_level=5)
    for name, value in modes.items():
        setattr(state.modes, name, value)
    chosen = choose(state, np.array(lod), np.array(False))
    assert tuple(int(x) for x in chosen) == want


ZERO = 7


def combined(state, texel0=(0,) * 4, texel1=(0,) * 4, shade=None, fraction=0) -> list[int]:
    """The combined colour of one pixel."""
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
