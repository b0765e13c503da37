"""Builds the registers, memory and tables of a scene's Glide texture units."""

from fractions import Fraction
from pathlib import Path

import numpy as np

from tmap.base.byte_pool import BytePool
from tmap.base.errors import UserError
from tmap.base.fields import fail, join
from tmap.compiler.glide import BLENDS, NO_MIPMAP, has_own
from tmap.glide.images import Map, encode
from tmap.glide.mipmap import levels, shape_of
from tmap.glide.registers import words_of_ncc
from tmap.glide.state import LAST_ASPECT, SIDE
from tmap.glide.words import ALIGN, FORMATS, LEVELS, Words, memory_required, place, texel_bytes
from tmap.images import images
from tmap.scene_file.pipes import COLUMNS, NO_TABLE


MEMORY, BYTES = map(COLUMNS["glide_units"].index, ("memory", "bytes"))


def picture_of(unit: dict, folder: Path, where: str) -> np.ndarray:
    """Returns a unit's picture, uint8 [height, width, 4], in the unit's size or else the
    picture's."""
    at = f"{where}.image"
    width, height = unit["width"], unit["height"]
    if width is None or height is None:
        found = images.picture(unit["image"], folder, at)
        width, height = width or found.width, height or found.height
    try:
        shape_of(width, height)
    except UserError:
        fail(at, f"{unit['image']}: {width}x{height} pixels; a map's sides are powers of two up to "
                 f"{SIDE}, one at most {1 << LAST_ASPECT} times the other")
    unit["width"], unit["height"] = width, height
    return images.load(unit["image"], folder, at, width, height, "RGBA")


def memory_of(made: Map, largest: int, smallest: int, unit: dict, aspect: str) -> bytes:
    """Returns the levels that a unit holds."""
    form, kept = unit["format"], unit["levels"]
    memory = bytearray(memory_required(kept, largest, smallest, aspect, form))
    kind = "<u2" if texel_bytes(form) == 2 else "u1"
    for level, at in place(0, kept, largest, smallest, aspect, form).items():
        data = made.levels[level - largest].astype(kind).tobytes()
        memory[at:at + len(data)] = data
    return bytes(memory)


def words_of(unit: dict, perspective: bool, memory_bytes: int, shape: tuple) -> Words:
    """Returns a unit's registers."""
    largest, smallest, aspect = shape
    words, combine = Words(memory_bytes), unit["combine"]
    words.source(0, unit["levels"], largest, smallest, aspect, unit["format"])
    words.mipmap("nearest_dither" if unit["dither"] else "nearest", unit["trilinear"])
    for field, level in (("lod_min", unit["min_level"]), ("lod_max", unit["max_level"])):
        if level is not None:
            words.fields[field] = 4 * level
    words.filter(unit["min"], unit["mag"])
    words.clamp(unit["s"], unit["t"])
    words.lod_bias(Fraction(unit["lod_bias"]))
    detail = unit["detail"]
    words.detail(detail["bias"], detail["scale"], round(255 * detail["max"]))
    words.perspective(perspective, unit["clamp_w"])
    words.combine(combine["function"], combine["factor"], combine["alpha_function"],
                  combine["alpha_factor"], combine["invert"], combine["invert_alpha"])
    return words


def row_of(unit: dict, perspective: bool, folder: Path, memory: BytePool, where: str) -> list[int]:
    """Returns a unit's row of the scene's table."""
    picture = picture_of(unit, folder, where)
    height, width = picture.shape[:2]
    largest, _, _ = shape_of(width, height)
    made = [picture]
    if unit["mipmap"] != NO_MIPMAP:
        made = levels(picture, unit["mipmap"], (unit["s"] == "wrap", unit["t"] == "wrap"))
    smallest = largest + len(made) - 1
    shorter = min(width, height)
    aspect = f"{width // shorter}x{height // shorter}"
    for name in ("min_level", "max_level"):
        if unit[name] is not None and not largest <= unit[name] <= smallest:
            fail(f"{where}.{name}", f"{width}x{height} texels have levels {largest} to {smallest}")
    if not any(n % 2 in LEVELS[unit["levels"]] for n in range(largest, smallest + 1)):
        fail(f"{where}.levels", f'"{unit["levels"]}": there is level {largest} only')
    texels = encode(made, FORMATS[unit["format"]])
    held = memory_of(texels, largest, smallest, unit, aspect)
    memory_bytes = max(1 << (len(held) - 1).bit_length(), ALIGN)
    words = words_of(unit, perspective, memory_bytes, (largest, smallest, aspect))
    palette = ncc = NO_TABLE
    if texels.palette is not None:
        r, g, b = texels.palette.T
        palette = memory.put((r << 16 | g << 8 | b).astype(">u4").tobytes())
    if texels.ncc is not None:
        registers = words_of_ncc(texels.ncc)
        ncc = memory.put(np.concatenate([registers, registers]).astype(">u4").tobytes())
    return [*words.words(), memory.put(held), memory_bytes, palette, ncc, unit["weights"],
            unit["bilinear"] == "dithered", unit["subdivision"]]


def build(spec: dict, folder: Path, where: str) -> tuple[dict[str, int], dict]:
    """Returns the number of each material's pipe, and the tables of all pipes for a Scene. Sets
    sizes that units take from their pictures."""
    numbers, known, memory = {}, {}, BytePool()
    glide_units, pipes = [], []
    for name, material in spec["materials"].items():
        if "glide" not in material:
            continue
        glide, at = material["glide"], join(f"{where}materials", name) + ".glide"
        key = repr(glide)
        if key not in known:
            made = [row_of(unit, glide["perspective"], folder, memory, f"{at}.units[{n}]")
                    for n, unit in enumerate(glide["units"])]
            known[key] = len(pipes), glide["units"]
            pipes.append([len(glide_units), len(made), 2 * has_own(material), glide["prefilter"] << 10,
                          BLENDS.index(glide["blend"])])
            glide_units += made
        numbers[name], glide["units"] = known[key]
    # What is behind a unit's levels is never read: the next unit's are there.
    end = max((unit[MEMORY] + unit[BYTES] for unit in glide_units), default=0)
    memory.data += bytes(max(end - len(memory.data), 0))
    return numbers, {"glide_units": np.array(glide_units, np.int64).reshape(-1, len(COLUMNS["glide_units"])),
                     "pipes": np.array(pipes, np.int64).reshape(-1, len(COLUMNS["pipes"])),
                     "glide_memory": bytes(memory.data)}


def size_of(material: dict) -> tuple[int, int]:
    """Returns the size in texels of the first unit's map, after ``build``."""
    unit = material["glide"]["units"][0]
    return unit["width"], unit["height"]
