"""The Amiga programs against bad files: one clear line each, return code 10, 20 where memory is
short, no crash.

Everything runs in a few boots. Scene files are named s0, s1, ..., plans p0, p1, ...
"""

import zlib

import mesh_cases
import numpy as np
from mesh_bad_files import wrong_meshes
from tmu_bad_files import wrong_pipes
from tx_bad_files import wrong_primitives
from wrong_fields import Row, WrongFields

from tools import emulator, fuzz, kernels, layout, model, scene_file
from tools.kernels import Case
from tools.scene_file import Material, Object, Scene, Texture
from tools.scene_meshes import Instance

SHAPES = layout.load()
NOT_A_SCENE, NOT_A_PLAN = ": not a usable scene file: ", ": not a usable plan file: "
M32 = 0xFFFFFFFF
#: Commands of one boot: finding a file among many is slow.
TOGETHER = 80


def example(textures: int = 1, side: int = 8, corners: int = 6, seed: int = 1) -> Scene:
    """A scene of random numbers: two objects, or three overlapping ones from 20 corners on."""
    random = np.random.default_rng(seed)
    objects = [Object(0, 0, 3, 0, 3, 0), Object(1, 2, 4, 2, 2, 1)]
    if corners >= 20:
        objects += [Object(1, 3, corners - 3, 0, 3, 0)]
    return Scene(
        width=side, height=side, frames=3, background=7,
        palette=random.integers(0, 256, (256, 3)).astype(np.uint8),
        textures=[Texture(random.integers(0, 256, (256, 256)).astype(np.uint8))
                  for _ in range(textures)],
        materials=[Material(colour=255), Material("affine", texture=textures - 1) if textures
                   else Material()], objects=objects,
        vertices=random.integers(-2**31, 2**31, (corners, 6)),
        poses=random.integers(-2**31, 2**31, (4, 6)))


def large_with(perspective: str) -> Scene:
    """A scene that leaves some 600 KB of chip RAM alone, its polygons drawn with a perspective."""
    scene = example(8)
    scene.materials = [Material("affine", perspective=perspective, texture=0)] * 2
    scene.vertices[:, 5] = 65536 << np.arange(len(scene.vertices))
    return scene


def every_mapper() -> Scene:
    """A scene with a triangle of each mapper, material n with texture n - 2."""
    scene = example(0)
    sizes = {"page": (16, 8), "linear": (7, 30), "tiled": (256, 256), "columns": (8, 64),
             "margins": (256, 256), "light": (256, 64)}
    scene.textures = [Texture(np.zeros((height, width), np.uint8), layout)
                      for layout, (width, height) in sizes.items()]
    mappers = list(scene_file.MAPPERS[1])
    scene.materials = [Material(mapper, gradients="polygon", texture=max(n - 2, -1))
                       for n, mapper in enumerate(mappers[:7])]
    scene.materials += [Material("lit", texture=0, light=5),
                        Material("lit_gouraud", texture=0, light=5),
                        Material("dithered", texture=0)]
    scene.vertices = np.full((6, 6), 65536)
    scene.objects = [Object(n, 0, 3, 0, 3, 0) for n in range(len(mappers))]
    return scene


def lit() -> Scene:
    """A scene with a lit triangle."""
    scene = every_mapper()
    scene.objects = [Object(7, 0, 3, 0, 3, 0)]
    return scene


def wide_pixels(pixels: str, mapper: str) -> Scene:
    """A scene in a wide format: a flat triangle and one with a map."""
    scene = example(0)
    scene.format, scene.background, layout = pixels, 0xFFFF, scene_file.MAPPER_LAYOUT[mapper]
    scene.textures = [Texture(np.zeros((8, 16), scene.pixel.dtype), layout)]
    scene.materials = [Material(colour=0xFFFF), Material(mapper, texture=0)]
    return scene


def tangles(seed: int, reach: int) -> Scene:
    """A scene no compiler writes: 300 polygons of random corners, dented and crossing,
    within ``reach`` pixels of a small frame."""
    random = np.random.default_rng(seed)
    counts = random.choice([3, 3, 4, 5, 8, 64], 300)
    vertices = random.integers(-reach * 65536, reach * 65536, (counts.sum(), 6))
    vertices[random.random(len(vertices)) < 0.2] &= ~0xFFFF
    scene = example()
    scene.width, scene.height, scene.frames, scene.vertices = 64, 48, 1, vertices
    scene.poses = np.array([(65536, 0, 0, 65536, 32 * 65536, 24 * 65536)])
    scene.objects = [Object(n % 2, first, count, 0, 1, 0) for n, (count, first) in
                     enumerate(zip(counts.tolist(), (counts.cumsum() - counts).tolist()))]
    return scene


def changed(data: bytes, at: int, value: int, header: str, summed: str) -> bytes:
    """A file with one longword replaced, and the checksum right again where that is covered."""
    fields = SHAPES.struct(header).fields
    start, place = fields[summed]["offset"], fields["checksum"]["offset"]
    out = bytearray(data[:at] + (value & M32).to_bytes(4, "big") + data[at + 4:])
    if at >= start:
        total = kernels.checksum if header == "plan_header" else zlib.crc32
        out[place:place + 4] = total(out[start:]).to_bytes(4, "big")
    return bytes(out)


def lengths(header: str, data: bytes) -> list[int]:
    return [3, SHAPES.struct(header).size - 1, SHAPES.struct(header).size, len(data) // 2,
            len(data) - 1]


def wrong_mappers() -> list[Row]:
    """Textures, materials and vertices that do not fit each other: file, place, value, field."""
    rows: list[Row] = []
    every, wide, widest, light_only = (WrongFields(scene, rows) for scene in (
        every_mapper(), wide_pixels("rgb565", "columns"), wide_pixels("rgba8888", "affine"), lit()))
    size = "texture.width or texture.height"
    page, linear, tiled, columns, margins, light = range(6)
    flat, gouraud, affine, arbitrary, *_, lit_flat, lit_gouraud, dithered = range(10)
    every.entry("textures", page, "layout", 6, M32)
    every.entry("textures", page, "layout", linear, said="material.texture")
    every.entry("textures", page, "texel_bytes", 0, 2, M32)
    every.entry("textures", page, "at", 0, 82, len(every.data) - 124, M32 - 3)
    for index, widths in ((page, (0, 4, 12, 512, M32, 2**31)), (linear, (0, 1025, M32, 2**31)),
                          (tiled, (0, 255, 512, M32)), (columns, (4, 48, 2**16, M32, 2**31)),
                          (margins, (8, 512, M32)), (light, (255, 128, M32))):
        every.entry("textures", index, "width", *widths, said=size)
        every.entry("textures", index, "height", *widths, said=size)
    wide.entry("textures", 0, "layout", linear, tiled, light)
    wide.entry("textures", 0, "texel_bytes", 1, 4)
    widest.entry("textures", 0, "layout", columns)
    widest.entry("materials", 1, "mapper", gouraud, arbitrary, 4, 5, 6, 7, 8)
    widest.entry("materials", 1, "perspective", 1, 4)
    every.entry("materials", flat, "mapper", 10, 11, M32)
    every.entry("materials", flat, "texture", 0)
    every.entry("materials", gouraud, "texture", 0)
    every.entry("materials", affine, "texture", linear, light, -1, 6)
    for field, past in (("edges", 3), ("gradients", 3), ("start", 2), ("clip", 2)):
        every.entry("materials", affine, field, past, M32)
    every.entry("materials", affine, "light", 0, light)
    for index in lit_flat, lit_gouraud:
        every.entry("materials", index, "texture", linear, light, -1)
        every.entry("materials", index, "light", page, -1, 6, M32)
    for index in lit_gouraud, dithered:
        every.entry("materials", index, "gradients", 0, 1)
        every.entry("materials", index, "start", 0)
    every.entry("materials", dithered, "texture", linear, light, -1)
    every.entry("materials", dithered, "perspective", 1, 4)
    light_only.entry("vertices", 0, "shade", -1, 256 << 16, 2**31)
    wide.entry("materials", 0, "colour", 65536)
    every.entry("objects", gouraud, "vertices", 4)
    every.entry("objects", arbitrary, "vertices", 4)
    every.entry("vertices", 1, "shade", -1, 256 << 16, 2**31)
    every.entry("vertices", 2, "s", -1, (256 << 16) + 1, 61 << 16, 2**31, 2**31 - 1)
    every.entry("vertices", 2, "t", -1, (256 << 16) + 1, 2**31)
    return rows


def bad_scenes() -> list[tuple[bytes, str]]:
    """Files and what must be said of each."""
    data, textured = (scene_file.write(example(textures)) for textures in (0, 1))
    header = SHAPES.struct("scene_header")
    cases = [(b"", ": is empty"), (data + b"\0", NOT_A_SCENE + "size")]
    cases += [(data[:length], NOT_A_SCENE + "size") for length in lengths("scene_header", data)]

    def header_field(name, *values, said=None):
        at, source = header.fields[name]["offset"], textured if "texture" in name else data
        cases.extend((changed(source, at, value, "scene_header", "width"),
                      NOT_A_SCENE + (said or name)) for value in values)

    for name in ("magic", "version", "size", "checksum"):
        header_field(name, 0, M32)
    for name in ("width", "height", "frames"):
        header_field(name, 0, 1025, M32, 2**31 - 1)
    header_field("width", 6)
    header_field("background", 256, M32)
    header_field("format", 4, M32)
    header_field("palette_at", 0, 78, len(data), M32 - 3)
    for name in scene_file.TABLES:
        header_field(name, 65537, 2**28, M32, said=f"{name} or {name}_at")
        header_field(f"{name}_at", 0, 78, len(textured), M32 - 3, said=f"{name} or {name}_at")
    header_field("textures", 0, said="material.texture")
    header_field("materials", 1, said="object.material")
    header_field("vertices", 5, said="object.vertices")
    header_field("poses", 3, said="object.poses")

    for table, name, values in (
            ("materials", "texture", (0, -2, 2**31 - 1)), ("materials", "colour", (256, M32)),
            ("objects", "material", (2, M32)), ("objects", "vertices", (2, 65, 7, M32)),
            ("objects", "vertex", (4, 6, M32, M32 - 1)), ("objects", "pose", (2, 4, M32)),
            ("objects", "poses", (0, 5, M32)), ("objects", "first_frame", (3, M32))):
        entry, source = f"scene_{table[:-1]}", textured if name == "texture" else data
        at = header.unpack(source)[f"{table}_at"] + SHAPES.struct(entry).fields[name]["offset"]
        said = {"vertex": "vertices", "pose": "poses"}.get(name, name)
        cases += [(changed(source, at, value, "scene_header", "width"),
                   f"{NOT_A_SCENE}{table[:-1]}.{said}") for value in values]
    cases += [(changed(source, at, value, "scene_header", "width"), NOT_A_SCENE + said)
              for source, at, value, said in wrong_mappers() + wrong_meshes() + wrong_primitives()
              + wrong_pipes()]
    many = mesh_cases.boxes(1)
    many.points = np.zeros((4096, 3), np.int64)
    many.meshes[0].points, many.meshes[1].point, many.textures = 4096, 0, many.textures[:0]
    many.materials, many.instances = [Material()], [Instance(0, 0, 0, 0, 1, 0)] * 17
    cases.append((scene_file.write(many), NOT_A_SCENE + "points, normals or faces of meshes"))
    cases += [(bytes(3 << 20), f": not enough memory for the file: {3 << 20} bytes; the largest"),
              (scene_file.write(example(14)), ": not enough memory for the textures: "),
              (scene_file.write(large_with("pixel")),
               ": not enough memory for the logarithms of perspective: ")]
    return cases


def good_plan() -> bytes:
    """Two calls that do nothing, with memory, a pointer and a timed repeat."""
    near, far = kernels.Arena(), kernels.Arena()
    near.add(bytes(64))
    near.pointers.append(near.add(bytes(4)))
    far.add(bytes(32))
    return kernels.plan([Case("nothing"), Case("nothing", near, {"d0": 3}, {"a0": 0}, far,
                                               {"a1": 4}, repeats=2)])


def bad_plans() -> list[tuple[bytes, str]]:
    """As bad_scenes, for plans."""
    data = good_plan()
    header, case = SHAPES.struct("plan_header"), SHAPES.struct("plan_case")
    second = header.unpack(data)["cases_at"] + case.size
    cases = [(b"", ": is empty")]
    for length in lengths("plan_header", data):
        cases.append((data[:length], NOT_A_PLAN + "size"))
    for name in ("magic", "version", "size", "checksum"):
        cases += [(changed(data, header.fields[name]["offset"], value, "plan_header", "cases"),
                   NOT_A_PLAN + name) for value in (0, M32)]
    for name, values in (("cases", (2**16, 2**31, M32)), ("cases_at", (2, len(data), M32 - 3))):
        cases += [(changed(data, header.fields[name]["offset"], value, "plan_header", "cases"),
                   NOT_A_PLAN + "cases_at") for value in values]

    def case_field(name, *values, said=None):
        at = second + case.fields[name]["offset"]
        cases.extend((changed(data, at, value, "plan_header", "cases"),
                      f"{NOT_A_PLAN}case 1: {said or name}") for value in values)

    case_field("name_at", len(data) - 1, len(data), M32)
    for name in ("near", "far"):
        case_field(name, 2, len(data), M32 - 3, 2**31)
        case_field(f"{name}_at", 2, len(data), M32 - 3, said=name)
        case_field(f"{name}_offsets", len(data), 2**30, M32, said=f"{name}_offsets")
        case_field(f"{name}_offsets_at", 2, len(data) + 4, M32 - 3, said=f"{name}_offsets")
    case_field("near", 0, 64, said="near_offsets")  # the pointer lies behind it now
    case_field("far_memory", 1, 4, M32)
    case_field("limit", 0, 65536, M32)
    cases.append((kernels.plan([Case("span_of_attention")]), "span_of_attention: no such kernel"))
    cases.append((kernels.plan([Case("x" * 300)]), "x" * 256))
    return cases


def check(results, said: dict[str, str]) -> None:
    """Each command said one line, as expected, and returned 20 where memory is short, else 10."""
    wrong = []
    for (command, line), result in zip(said.items(), results, strict=True):
        lines = [text for text in result.output.splitlines() if not text.startswith("case ")]
        code = 20 if "not enough memory" in line else 10
        if result.code != code or len(lines) != 1 or not lines[0].startswith(line):
            wrong.append(
                f"{command}: wanted {line!r}, code {code}; got {result.output!r}, {result.code}")
    assert not wrong, "\n".join(wrong)


def test_bad_input_is_refused(tmp_path):
    files, said = {"good": scene_file.write(example()), "calls": good_plan()}, {}
    for number, (data, line) in enumerate(bad_scenes()):
        files[f"s{number}"] = data
        said[f"render s{number}"] = f"s{number}{line}"
    for number, (data, line) in enumerate(bad_plans()):
        files[f"p{number}"] = data
        said[f"bench p{number} out"] = f"p{number}{line}" if line[0] == ":" else line
    usage = "render: usage: render SCENE"
    said |= {"render none": "none: cannot be opened", "render S": "S: cannot be opened",
             "render": usage, "render good FORM": usage, "render good FRAMES": usage,
             "render good FRAMES many": usage, "render good DIGEST": usage, "render good and more": usage,
             "render good FORM mmx": "render: FORM: not one of addx, swap, c",
             "render good FORM ADDX": "render: FORM: not one of",
             "render good FRAMES 0": "render: FRAMES: not between 1 and the scene's frames",
             "render good FRAMES 4": "render: FRAMES: not between",
             "render good FRAMES -1": "render: FRAMES: not between",
             "bench none out": "none: cannot be opened", "bench S out": "S: cannot be opened",
             "bench calls": "bench: usage", "bench calls S": "S: cannot be created",
             "bench calls :no/where": ":no/where: cannot be created"}
    commands = list(said)
    for first in range(0, len(commands), TOGETHER):
        part = commands[first:first + TOGETHER]
        words = {word for command in part for word in command.split()}
        some = {name: data for name, data in files.items() if name in words}
        folder = tmp_path / str(first)
        check(emulator.run_many(part, some, "a1200", folder), {name: said[name] for name in part})
        assert not list((folder / "volume").glob("frame_*"))


def test_strange_scenes_draw_inside_the_frame(tmp_path):
    """Numbers that no compiler writes but the file may hold: all is drawn or left out, in
    every form the same, and render's guards hold. So do plans that say nothing."""
    large = example(8, side=1024)
    files = {"noise": scene_file.write(example()), "more": scene_file.write(example(corners=64)),
             "near": scene_file.write(tangles(1, 40)), "wide": scene_file.write(tangles(2, 300)),
             "far": scene_file.write(tangles(3, 16383)), "large": scene_file.write(large),
             "fine": scene_file.write(large_with("fine")),
             "calls": good_plan(), "idle": kernels.plan([])}
    scenes = ("noise", "more", "near", "wide", "far", "fine")
    good = [f"render {name} FRAMES 1 COUNT FORM {form}" for name in scenes
            for form in ("addx", "swap", "c")] + ["bench calls out", "bench idle out"]
    said = {"render noise": "frame_001.chunky: cannot be created",
            "render noise DIGEST :no/where": ":no/where: cannot be created",
            "render large": f"render: not enough memory for the frame: {2**20 + 8192} bytes; the"}
    (tmp_path / "volume" / "frame_001.chunky").mkdir(parents=True)
    results = emulator.run_many(good + list(said), files, "a1200", tmp_path)
    for command, result in zip(good, results):
        left_out = "render: not all could be drawn: a vertex is out of range\n" in result.output
        assert result.code == 5 * left_out, f"{command}: {result.output}"
    lines = [result.output.splitlines()[0] for result in results[:3 * len(scenes)]]
    pixels = [line.split("polygons")[1].split() for line in lines]
    totals = [(count, sum(map(int, spans[1::2]))) for count, *spans in pixels]
    for number, name in enumerate(scenes):
        assert len(set(totals[3 * number:3 * number + 3])) == 1, f"{name}: {totals}"
    assert all(total[1] > 1000 for total in totals[6:12])
    failed = results[len(good):]
    for result in failed[:2]:  # frame 0 was drawn
        result.output = result.output.partition("\n")[2]
    check(failed, said)


def test_dented_polygons_are_cut_inside_their_arrays():
    """64 corners to and fro across a border, which would be 96 after it: left out; fewer are
    drawn, and what comes after them too."""
    scene = example(0)
    scene.width, scene.height = 64, 48
    scene.materials = [Material(colour=200, clip="vertices"), Material(colour=99)]
    zigzag = [[(-40, 100)[k % 2] << 16, 2 * k - 40 << 16, 0, 0, 0, 65536] for k in range(64)]
    triangle = [[x << 16, y << 16, 0, 0, 0, 65536] for x, y in ((5, 5), (20, 5), (5, 20))]
    scene.vertices = np.array([*zigzag, *triangle])
    scene.objects = [Object(0, 0, 64, 0, 1, 0), Object(1, 64, 3, 0, 3, 0), Object(0, 0, 40, 0, 1, 1),
                     Object(0, 5, 46, 0, 1, 2)]
    scene.poses = np.array([scene_file.IDENTITY] * 3)
    digests, = fuzz.draw([(scene, "addx")], "a1200-fast")
    for number, digest in enumerate(digests):
        drawn = model.render(scene, number)
        assert fuzz.is_models(drawn, digest), number
        assert (drawn == 99).any()
