"""The display as programs use it: what its copper lists and planes show, that its two sets
alternate, and that the machine is as before, however a program ends."""

import re
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import pytest

from tests.helpers import endings, guest_program
from tests.screen import copper_lists
from tmap.base import maps, planar
from tmap.build import layout
from tmap.guest import emulator

MODES = ("SHOW", "KEYS", "CRASH", "QUIET_CRASH", "AGAIN", "SHORT", "REFUSED", "POST", "BUSY", "BLITTER",
         "BOXES", "BLIT_BOXES", "UNALIGNED")
FRAMES = 3
BOX = slice(3, 8), slice(32, 96)  # rows and columns of the last frame that are converted
TOP, BOTTOM, LEFT = 32, 288, 0x81  # lines and positions of the beam: the area for pictures
LAST_START = 20  # the last line in which a list may be started
MACHINE = "a1200"


@dataclass(frozen=True)
class Shown:
    """A kind of frame that the guest shows."""

    kernel: str
    width: int
    height: int
    colours: object = None  # of pixels; None: from the palette
    pixel: tuple[int, int] = (1, 1)  # its width and height, of low resolution
    mode: str = "SHOW"  # of MODES

    @property
    def format(self) -> int:
        name = {"c2p_8": "CHUNKY", "c2p_8_2x1": "CHUNKY", "c2p_ham8_16": "RGB565", "c2p_ham8_5551": "RGBA5551",
                "c2p_ham8_32": "RGBA8888"}[self.kernel]
        return layout.load().constants[f"PIXEL_{name}"]

    @property
    def arguments(self) -> str:
        return f"{self.format} {self.width} {self.height} {self.pixel[0]} {self.pixel[1]}"

    @property
    def is_small(self) -> bool:
        """Whether it is shown twice as large."""
        return self.colours and self.pixel == (1, 1) and self.width <= 160 and self.height <= 128

    @property
    def resolution(self) -> int:
        """0: low, 1: high, 2: super-high."""
        return 0 if not self.colours else 1 if self.is_small or self.pixel[0] == 2 else 2

    @property
    def rows(self) -> int:
        """How often a row is shown."""
        return 2 if self.is_small else self.pixel[1]


SHOWN = {
    "whole": Shown("c2p_8", 320, 256),
    "odd": Shown("c2p_8", 200, 61),  # its columns end within 32, its middle is between two lines
    "high": Shown("c2p_ham8_16", 136, 59, maps.from_rgb565),
    "super": Shown("c2p_ham8_5551", 184, 33, maps.from_rgba5551),
    "tall": Shown("c2p_ham8_32", 104, 130, maps.from_rgba8888),
    "wide_pixels": Shown("c2p_8_2x1", 160, 256, pixel=(2, 1)),
    "high_pixels": Shown("c2p_8", 320, 127, pixel=(1, 2)),
    "odd_wide_pixels": Shown("c2p_8_2x1", 104, 61, pixel=(2, 1)),  # its columns end within 16
    "blits": Shown("c2p_8", 320, 256, mode="BLITTER"),
    "odd_blits": Shown("c2p_8", 200, 61, mode="BLITTER"),
    "wide_blits": Shown("c2p_8_2x1", 160, 256, pixel=(2, 1), mode="BLITTER"),
    "odd_wide_blits": Shown("c2p_8_2x1", 104, 61, pixel=(2, 1), mode="BLITTER"),
    "large_blits": Shown("c2p_8_2x1", 136, 99, pixel=(2, 2), mode="BLITTER"),
    "blits_of_colours": Shown("c2p_ham8_16", 96, 64, maps.from_rgb565, (2, 1), "BLITTER"),  # by the processor
    "large_pixels": Shown("c2p_8_2x1", 136, 99, pixel=(2, 2)),
    "wide_colours": Shown("c2p_ham8_16", 96, 200, maps.from_rgb565, (2, 1)),
    "high_colours": Shown("c2p_ham8_32", 160, 100, maps.from_rgba8888, (1, 2)),
    "large_colours": Shown("c2p_ham8_5551", 128, 90, maps.from_rgba5551, (2, 2)),
}

#: Kinds of frames of which only what was touched is converted.
BOXED = {
    "boxes": Shown("c2p_8", 320, 96, mode="BOXES"),
    "odd_boxes": Shown("c2p_8", 200, 61, mode="BOXES"),
    "wide_boxes": Shown("c2p_8_2x1", 104, 61, pixel=(2, 1), mode="BOXES"),
    "colour_boxes": Shown("c2p_ham8_16", 136, 59, maps.from_rgb565, mode="BOXES"),
    "blit_boxes": Shown("c2p_8", 320, 96, mode="BLIT_BOXES"),
    "odd_blit_boxes": Shown("c2p_8", 200, 61, mode="BLIT_BOXES"),
    "wide_blit_boxes": Shown("c2p_8_2x1", 136, 99, pixel=(2, 2), mode="BLIT_BOXES"),
}
#: Boxes by frame, in tenths of the frame's sides: left, top, right, bottom. None: all is converted.
BOXES = [[(2, 1, 4, 3)], [(2, 1, 4, 3), (7, 6, 12, 9)], [(0, 5, 1, 6)], [], [], None, [(-3, -2, 1, 1), (9, 8, 10, 10)],
         [(5, 2, 4, 3), (4, 4, 6, 6), (4, 7, 6, 8)], [(1, 2, 9, 9)]]


def command(mode: str, rest: str = "0 320 256 1 1") -> str:
    """The guest's command line."""
    return f"display {MODES.index(mode)} {rest}"


#: Kinds of frames whose pixels or pitch are no multiples of 8: chunky, pixels of two dots, HAM8.
UNALIGNED = "0 64 32 1 1", "0 64 32 2 1", "1 64 32 1 1"
#: How programs end, and their return codes.
ENDINGS = {command("CRASH"): 20, command("QUIET_CRASH"): 20, command("AGAIN", "1 160 64 1 1"): 0,
           command("KEYS", "0 32 32 1 1"): 0, command("POST", "0 32 32 1 1"): 0, command("SHORT"): 20,
           command("REFUSED", "0 324 256 1 1"): 10, command("REFUSED", "0 320 257 1 1"): 10,
           **{command("UNALIGNED", rest): 0 for rest in UNALIGNED}, command("REFUSED", "0 168 64 2 1"): 10, command("REFUSED", "1 64 129 1 2"): 10}


@pytest.fixture(scope="module")
def programs(tmp_path_factory):
    """A folder with the guest, linked as the Makefile does."""
    folder = tmp_path_factory.mktemp("programs")
    guest_program.build(folder, *endings.DISPLAY)
    return folder


@pytest.fixture(scope="module")
def pixels():
    """Random frames by name: [frame][row][x]."""
    rng = np.random.default_rng(9)
    return {name: np.stack([planar.noise(s.kernel, rng, s.width, s.height) for _ in range(FRAMES)])
            for name, s in SHOWN.items()}


def places(shown: Shown, boxes) -> list[list[int]]:
    """A frame's boxes in pixels."""
    sides = (shown.width, shown.height) * 2
    return [[tenths * side // 10 for tenths, side in zip(box, sides)] for box in boxes or ()]


@pytest.fixture(scope="module")
def boxed() -> dict[str, np.ndarray]:
    """Frames by name, one background but for noise in boxes: [frame][row][x]."""
    rng, made = np.random.default_rng(19), {}
    for name, shown in BOXED.items():
        noise = np.stack([planar.noise(shown.kernel, rng, shown.width, shown.height) for _ in BOXES])
        frames = np.full_like(noise, 0xa5)
        for frame, content, boxes in zip(frames, noise, BOXES):
            for left, top, right, bottom in places(shown, boxes):
                part = slice(max(top, 0), bottom), slice(max(left, 0), right)
                frame[part] = content[part]
            if boxes is None:
                frame[:] = content
        made[name] = frames
    return made


def boxes_file(shown: Shown) -> bytes:
    """As tests/guest/display.c reads it."""
    numbers = [len(BOXES)]
    for boxes in BOXES:
        numbers += [-1 if boxes is None else len(boxes), *np.ravel(places(shown, boxes)).astype(int)]
    return np.array(numbers, ">i4").tobytes()


@pytest.fixture(scope="module")
def palette():
    return np.random.default_rng(10).integers(0, 256, (256, 4), np.uint8)


@pytest.fixture(scope="module")
def ended(programs, pixels, boxed, palette, tmp_path_factory) -> dict[str, endings.Ended]:
    """All commands in one boot."""
    files = {"palette": palette.tobytes(), "display": programs / "display"} | {
        name: p.astype(p.dtype.newbyteorder(">")).tobytes() for name, p in (pixels | boxed).items()} | {
        f"{name}.boxes": boxes_file(shown) for name, shown in BOXED.items()}
    # Two at first: the system frees all it can, and allocates what it needs on first use.
    shows = [command(s.mode, f"{s.arguments} {name}") for name, s in (SHOWN | BOXED).items()]
    commands = [command("AGAIN"), *shows, *ENDINGS]
    found = endings.run([(0, each) for each in commands], files, MACHINE,
                        tmp_path_factory.mktemp("run"), command("SHORT"))
    return dict(zip(commands[1:], found[1:]))


@dataclass
class Dump:
    """The screen's memory after a swap, and the numbers that the guest printed."""

    memory: bytes
    address: int
    shown: int  # the list that the copper is running
    lists: tuple[int, int]
    hidden: int
    fields: int
    last_line: int  # of the beam

    @cached_property
    def regions(self) -> list[copper_lists.Region]:
        words = np.frombuffer(self.memory, ">u2", offset=self.shown - self.address)
        return copper_lists.regions(words[:len(words) & -2])


def dumps(ended, name: str) -> list[Dump]:
    """The dumps of all frames of a form."""
    shown = (SHOWN | BOXED)[name]
    result = ended[command(shown.mode, f"{shown.arguments} {name}")]
    assert result.code == 0, result.output
    lines = [[int(n) for n in line.split()] for line in result.output.splitlines()]
    return [Dump((result.directory / f"{name}.{k}").read_bytes(), line[0], line[1],
                 (line[2], line[3]), *line[4:]) for k, line in enumerate(lines)]


def expected(name: str, pixels, number: int) -> np.ndarray:
    """The dots of a frame: the last one is the first frame with a box of the last."""
    frames = pixels[name]
    frame = frames[number]
    if number == FRAMES - 1:
        frame = frames[0].copy()
        frame[BOX] = frames[-1][BOX]
    dots = planar.FORMS[SHOWN[name].kernel].convert(frame)
    if SHOWN[name].colours:
        dots = dots | planar.ham8_control(dots.shape[1])
    return dots


@pytest.mark.parametrize("name", SHOWN)
def test_planes_of_the_shown_list_are_the_frame(ended, pixels, name):
    """The planes of the list that the copper is running hold the frame, bit for bit; the picture is
    in the middle of the screen."""
    shown = SHOWN[name]
    for number, dump in enumerate(dumps(ended, name)):
        region = dump.regions[0]
        found = copper_lists.picture(region, dump.memory, dump.address)
        dots = expected(name, pixels, number)
        assert copper_lists.resolution(region) == shown.resolution
        assert bool(region.registers[copper_lists.BPLCON0] & 0x0800) == bool(shown.colours)
        dots = np.repeat(dots, shown.rows, axis=0)
        wrong = planar.difference(dots, found.dots)
        assert wrong is None, f"{name}, frame {number}, seed 9: {wrong}"
        assert abs(found.top + found.bottom - TOP - BOTTOM) <= 1
        assert abs(found.left + found.right - 2 * LEFT - 320) <= 1
        assert found.top >= TOP and found.bottom <= BOTTOM and found.left >= LEFT


@pytest.mark.parametrize("name", BOXED)
def test_what_was_not_touched_is_what_it_was(ended, boxed, name):
    """Frames of which only touched boxes are converted are on the screen whole, whatever the set's last frame was."""
    shown = BOXED[name]
    for number, (dump, frame) in enumerate(zip(dumps(ended, name), boxed[name], strict=True)):
        dots = planar.FORMS[shown.kernel].convert(frame)
        if shown.colours:
            dots = dots | planar.ham8_control(dots.shape[1])
        found = copper_lists.picture(dump.regions[0], dump.memory, dump.address)
        wrong = planar.difference(np.repeat(dots, shown.rows, axis=0), found.dots)
        assert wrong is None, f"{name}, frame {number} of {BOXES}: {wrong}"


@pytest.mark.parametrize("name", SHOWN)
def test_sets_take_turns(ended, name):
    """Lists and planes alternate; nothing of the hidden set is shown except HAM8's planes 0 and
    1."""
    made = dumps(ended, name)
    assert [d.hidden for d in made] == [1, 0, 1]
    assert [d.lists.index(d.shown) for d in made] == [0, 1, 0]
    assert made[0].fields < made[1].fields < made[2].fields
    first, second = ([d.regions[0].registers[copper_lists.BPL1PTH + k] for k in range(0, 32, 2)]
                     for d in made[:2])
    planes = [[high << 16 | low for high, low in zip(one[::2], one[1::2])] for one in (first, second)]
    shared = set(planes[0]) & set(planes[1])
    assert len(shared) == (2 if SHOWN[name].colours else 0)
    assert shared <= set(planes[0][:2])


@pytest.mark.parametrize("name", SHOWN)
def test_colours_and_time_of_the_list(ended, palette, name):
    """All 256 colours of 24 bits; for HAM8 the colour with which lines begin. The list is through
    before the picture begins, even if it is started as late as allowed."""
    for dump in dumps(ended, name):
        above, below, *_ = dump.regions
        if SHOWN[name].colours:
            assert (above.palette[0] == 2).all()
        else:
            assert (above.palette == palette[:, 1:]).all()
        lines = above.moves * copper_lists.MOVE / copper_lists.LINE
        assert LAST_START + 1 + lines < TOP and below.line == BOTTOM


def test_half_frames_show_colours(ended, pixels):
    """The guest's dots, decoded, have the right colours in the pixels' right halves, as in
    tests/screen/test_screen.py."""
    for name, shown in SHOWN.items():
        if not shown.colours:
            continue
        dump = dumps(ended, name)[1]
        dots = copper_lists.picture(dump.regions[0], dump.memory, dump.address).dots
        seen = planar.ham8_shown(dots, tuple(dump.regions[0].palette[0]))[:, 3::4]
        colours = shown.colours(pixels[name][1])[..., :3]
        assert (seen[::len(seen) // shown.height] >> 2 == colours >> 2).all(), name


def letters(dump: Dump, line: int) -> np.ndarray:
    """A status line as 80 characters of 8 rows."""
    region = dump.regions[1]
    found = copper_lists.picture(region, dump.memory, dump.address)
    assert found.dots.shape[1] == 640 and found.top > BOTTOM and found.bottom <= 312
    rows = np.packbits(found.dots.astype(bool), axis=1)[9 * line:9 * line + 8]
    return rows.T


def test_status_lines(ended):
    """The same character always looks the same; the rest of the line after a text is cleared, and
    characters that the font lacks are blank."""
    first, second, third = dumps(ended, "whole")
    line = letters(first, 0)
    text = "0 first line"
    glyphs = {}
    for character, rows in zip(text.ljust(80), line):
        assert glyphs.setdefault(character, rows.tobytes()) == rows.tobytes(), character
    assert len(set(glyphs.values())) == len(glyphs) and not any(glyphs[" "])
    assert not letters(first, 1).any()
    assert (letters(second, 0) == line).all()
    other = letters(second, 1)
    assert other[0].any() and other[2:11].any(axis=1).all() and not other[13].any()
    assert other[13:].any(axis=1).sum() == len("beyond") + 1 - 1
    assert letters(third, 0)[0].any() and not letters(third, 0)[1:].any()
    colours = first.regions[1].palette
    assert (colours[0] == 0).all() and (colours[1] == 0xCC).all()


def test_machine_is_as_before(ended):
    for each, found in ended.items():
        assert not found.lost(), (each, found.lost())


def test_return_codes(ended):
    for each, code in ENDINGS.items():
        assert ended[each].code == code, (each, ended[each].output)


def test_keys(ended):
    """Only pressed keys are returned, in order, 15 at most; mouse buttons are not keys. Ctrl-C is a
    signal."""
    words = ended[command("KEYS", "0 32 32 1 1")].output.split()
    assert [int(word) for word in words] == [0, 0x1000, 0x45, 0x33, *range(13)]


def test_lists_and_screens(ended):
    """A posted list waits for its field; one whose field is over is shown in the next. A second
    screen fits in the first one's memory, a third does not."""
    assert ended[command("POST", "0 32 32 1 1")].output == "1 0 1 11\n"
    assert ended[command("AGAIN", "1 160 64 1 1")].output.split()[-1] == "10"


@pytest.mark.parametrize("rest", UNALIGNED)
def test_frames_that_do_not_fit_are_refused(ended, rest):
    """The conversions' loops would not end with them, or read beyond them. Nothing is shown; the next frame that is aligned is."""
    assert ended[command("UNALIGNED", rest)].output == "0000 0000 0000 0000 0000 1111 \n"


def test_refusals(ended):
    planes = 16 * 320 * 256 // 8
    said = re.fullmatch(r"screen: not enough memory for planes and copper lists: (\d+) bytes of chip "
                        r"RAM; the largest free piece has (\d+)\n",
                        ended[command("SHORT")].output)
    assert planes < int(said[1]) < planes + 10_000 and int(said[2]) < 100_000
    for size, words in (("0 324 256 1 1", "width is not 8 to 320 in steps of 8 pixels"),
                        ("0 168 64 2 1", "width is not 8 to 320 in steps of 8 pixels"),
                        ("0 320 257 1 1", "height is not 1 to 256"), ("1 64 129 1 2", "height is not 1 to 256")):
        assert ended[command("REFUSED", size)].output == f"screen: the picture's {words}\n"


def test_machine_without_aga(programs, tmp_path, monkeypatch):
    """The same processor, but the older chips."""
    monkeypatch.setitem(emulator.MACHINES, "ecs", ECS)
    result = emulator.run("display", command("SHOW").partition(" ")[2], {}, "ecs", tmp_path,
                          programs=programs)
    assert (result.code, result.output) == (20, "screen: needs AGA: an A1200 or A4000\n")


ECS = {"amiga_model": "A500+", "cpu": "68020", "uae_cpu_model": "68020", "chip_memory": "2048"}
