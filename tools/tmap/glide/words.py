"""A texture unit's registers, set field by field as Glide's calls set them.

Names replace numbers; wrong ones raise KeyError or ValueError, as only programs use this module.
The place of a map in memory follows from the same arguments.
"""

from fractions import Fraction

from tmap.glide.state import SIDE, UNIT_MEMORY

MODE, LOD, DETAIL, BASE = range(4)

#: Field to (register, lowest bit, bits).
FIELDS = {
    "perspective": (MODE, 0, 1), "minify": (MODE, 1, 1), "magnify": (MODE, 2, 1),
    "clamp_w": (MODE, 3, 1), "dither": (MODE, 4, 1), "ncc_table": (MODE, 5, 1),
    "clamp_s": (MODE, 6, 1), "clamp_t": (MODE, 7, 1), "format": (MODE, 8, 4),
    "trilinear": (MODE, 30, 1),
    "lod_min": (LOD, 0, 6), "lod_max": (LOD, 6, 6), "lod_bias": (LOD, 12, 6),
    "odd": (LOD, 18, 1), "split": (LOD, 19, 1), "s_wider": (LOD, 20, 1), "aspect": (LOD, 21, 2),
    "detail_max": (DETAIL, 0, 8), "detail_bias": (DETAIL, 8, 6), "detail_scale": (DETAIL, 14, 3),
    "base": (BASE, 0, 29),
}
#: The combine unit's fields, from the lowest bit on: bit 12 of textureMode for colour, 21 for
#: alpha.
COMBINE_FIELDS = (("zero_other", 1), ("sub_local", 1), ("mselect", 3), ("reverse", 1),
                  ("add_local", 1), ("add_alpha_local", 1), ("invert", 1))
COMBINE_SHIFTS = {"rgb": 12, "alpha": 21}


def combine_fields(part: str, lowest: int) -> dict[str, tuple[int, int, int]]:
    """Returns the fields of a half of the combine unit, as in FIELDS."""
    found = {}
    for name, bits in COMBINE_FIELDS:
        found[f"{part}_{name}"] = MODE, lowest, bits
        lowest += bits
    return found


for _part, _lowest in COMBINE_SHIFTS.items():
    FIELDS |= combine_fields(_part, _lowest)

ASPECTS = ("8x1", "4x1", "2x1", "1x1", "1x2", "1x4", "1x8")  # columns x rows
FORMATS = {"rgb332": 0, "yiq422": 1, "a8": 2, "i8": 3, "ai44": 4, "p8": 5, "argb8332": 8,
           "ayiq8422": 9, "rgb565": 10, "argb1555": 11, "argb4444": 12, "ai88": 13, "ap88": 14}
FILTERS = ("point", "bilinear")
WRAPS = ("wrap", "clamp")
MIPMAPS = ("off", "nearest", "nearest_dither")
LEVELS = {"even": (0,), "odd": (1,), "both": (0, 1)}  # the parities of a map's levels

#: Function to the fields that it sets.
FUNCTIONS = {
    "zero": ("zero_other",),
    "local": ("zero_other", "add_local"),
    "local_alpha": ("zero_other", "add_alpha_local"),
    "scale_other": (),
    "scale_other_add_local": ("add_local",),
    "scale_other_add_local_alpha": ("add_alpha_local",),
    "scale_other_minus_local": ("sub_local",),
    "blend": ("sub_local", "add_local"),
    "blend_add_local_alpha": ("sub_local", "add_alpha_local"),
    "blend_local": ("zero_other", "sub_local", "add_local"),
    "blend_local_add_local_alpha": ("zero_other", "sub_local", "add_alpha_local"),
}
_SELECTED = ("zero", "local", "other_alpha", "local_alpha", "detail", "lod_fraction")
#: Factor to (mselect, reverse).
FACTORS = {name: (n, 1) for n, name in enumerate(_SELECTED)} | {
    "one" if name == "zero" else f"one_minus_{name}": (n, 0) for n, name in enumerate(_SELECTED)}

ALIGN = 8  # bytes per step of texBaseAddr


def level_size(aspect: str, level: int) -> tuple[int, int]:
    """Returns (columns, rows) of a level."""
    columns, rows = (int(side) for side in aspect.split("x"))
    longest = max(columns, rows)
    return tuple(max(side * (SIDE >> level) // longest, 1) for side in (columns, rows))


def texel_bytes(form: str) -> int:
    """Returns the bytes of a texel."""
    return 2 if FORMATS[form] & 8 else 1


def level_bytes(aspect: str, form: str, level: int) -> int:
    """Returns the bytes of a level: at least those of four texels."""
    columns, rows = level_size(aspect, level)
    return max(columns * rows, 4) * texel_bytes(form)


def above(aspect: str, form: str, levels: str, level: int) -> int:
    """Returns the bytes of the map's larger levels."""
    return sum(level_bytes(aspect, form, n) for n in range(level) if n % 2 in LEVELS[levels])


def place(start: int, levels: str, largest: int, smallest: int, aspect: str, form: str) -> dict[
        int, int]:
    """Returns the addresses of the map's levels. Level 0's address, present or not, is a multiple
    of 8, so the first level may begin a little after the start."""
    base = start - above(aspect, form, levels, largest)
    base += -base % ALIGN
    return {n: base + above(aspect, form, levels, n) for n in range(largest, smallest + 1)
            if n % 2 in LEVELS[levels]}


def memory_required(levels: str, largest: int, smallest: int, aspect: str, form: str) -> int:
    """Returns the bytes of a map from its start on, a multiple of 8."""
    last, address = max(place(0, levels, largest, smallest, aspect, form).items())
    end = address + level_bytes(aspect, form, last)
    return end + -end % ALIGN


class Words:
    """The registers of a unit. Initially: texels unchanged, point sampling, one level, 256 texels
    wide."""

    def __init__(self, memory_bytes: int = UNIT_MEMORY) -> None:
        self.memory_bytes = memory_bytes
        self.fields = dict.fromkeys(FIELDS, 0) | {"s_wider": 1}
        self.largest = self.smallest = 0
        self.mode = "nearest"
        self.combine("local", "zero", "local", "zero")

    def words(self) -> tuple[int, int, int, int]:
        """Returns textureMode, tLOD, tDetail, texBaseAddr."""
        words = [0, 0, 0, 0]
        for name, (register, shift, bits) in FIELDS.items():
            words[register] |= (self.fields[name] & (1 << bits) - 1) << shift
        return tuple(words)

    def source(self, start: int, levels: str, largest: int, smallest: int, aspect: str,
               form: str) -> None:
        """Sets the map to draw from."""
        addresses = place(start, levels, largest, smallest, aspect, form)
        first, address = min(addresses.items())
        base = (address - above(aspect, form, levels, first)) % self.memory_bytes
        columns, rows = level_size(aspect, 0)
        self.fields |= {
            "format": FORMATS[form], "s_wider": columns >= rows, "base": base // ALIGN,
            "aspect": (max(columns, rows) // min(columns, rows)).bit_length() - 1,
            "split": levels != "both", "odd": levels == "odd"}
        self.largest, self.smallest = largest, smallest
        self.mipmap(self.mode, bool(self.fields["trilinear"]))

    def mipmap(self, mode: str, lod_blend: bool) -> None:
        """Sets the use of mipmaps: "off" uses only the largest level."""
        self.mode = MIPMAPS[MIPMAPS.index(mode)]
        last = self.largest if mode == "off" else self.smallest
        self.fields |= {"lod_min": 4 * self.largest, "lod_max": 4 * last,
                        "dither": mode == "nearest_dither", "trilinear": lod_blend}

    def filter(self, minify: str, magnify: str) -> None:
        """Sets the filters for minified and magnified texels."""
        self.fields |= {"minify": FILTERS.index(minify), "magnify": FILTERS.index(magnify)}

    def clamp(self, s: str, t: str) -> None:
        """Sets wrapping or clamping at the map's borders."""
        self.fields |= {"clamp_s": WRAPS.index(s), "clamp_t": WRAPS.index(t)}

    def blend_levels(self, levels: str) -> None:
        """Sets the levels to blend, even or odd ones, of a map that is not split."""
        if self.fields["split"]:
            raise ValueError("the map is split")
        parity, = LEVELS[levels]
        self.fields["odd"] = parity

    def lod_bias(self, bias: Fraction) -> None:
        """Sets the bias: an eighth is added, then it is cut to quarters towards 0."""
        self.fields["lod_bias"] = int((bias + Fraction(1, 8)) * 4)

    def detail(self, bias: int, scale: int, greatest: int) -> None:
        """Sets the detail factor."""
        self.fields |= {"detail_bias": bias, "detail_scale": scale, "detail_max": greatest}

    def perspective(self, on: bool, clamp_negative_w: bool) -> None:
        """Turns the division of s and t on or off."""
        self.fields |= {"perspective": on, "clamp_w": clamp_negative_w}

    def ncc_select(self, table: int) -> None:
        """Selects one of the two NCC tables."""
        self.fields["ncc_table"] = table

    def combine(self, rgb_function: str, rgb_factor: str, alpha_function: str, alpha_factor: str,
                invert_rgb: bool = False, invert_alpha: bool = False) -> None:
        """Sets the combine functions and factors of colour and alpha."""
        for part, function, factor, invert in (("rgb", rgb_function, rgb_factor, invert_rgb),
                                               ("alpha", alpha_function, alpha_factor,
                                                invert_alpha)):
            mselect, reverse = FACTORS[factor]
            chosen = {name: name in FUNCTIONS[function] for name, _ in COMBINE_FIELDS}
            chosen |= {"mselect": mselect, "reverse": reverse, "invert": invert}
            self.fields |= {f"{part}_{name}": value for name, value in chosen.items()}
