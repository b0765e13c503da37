"""Scenes in which nothing moves, written ready to draw for their program: c/frames/still.h.

Maps, materials and lists of polygons are made here, so the program has no scene file and no code that
makes them. Triangles with snapped vertices that a routine of src68k/triangle draws are prepared to that
routine's plan.
"""

from dataclasses import dataclass, field
from itertools import groupby

from tmap.base.fixed import ONE
from tmap.build import layout
from tmap.build.elf_object import Relocation, Section
from tmap.scene_file.scene_file import SETTINGS, UNITS, Object, Scene, vertices_at
from tmap.scene_file.textures import LAYOUTS, ordered
from tmap.setup import snapped
from tmap.setup.shading import LIT
from tmap.setup.texturing import Settings

START, MAIN = "still_start", "still_main"
#: A call of the first symbol goes to the second where the frames are timed.
TIMED = {"_still_draw": "_still_time"}
PAGE = 1 << 16
SIDE = 256  # of a page
#: Routines that draw prepared triangles.
ROUTINES = {"flat": "_triangles_flat", "affine": "_triangles_affine", "gouraud": "_triangles_gouraud"}
LOWEST_SHADE = ONE // 16  # shades stay so far inside their whole one


@dataclass
class Data:
    """A section that is being written: bytes, and references to symbols or sections."""

    section: Section
    bytes: bytearray = field(default_factory=bytearray)

    def put(self, data: bytes, **references: tuple) -> int:
        """Adds bytes; ``references``: fields named at_OFFSET, to pairs of a target and an addend. Returns their
        place."""
        at = len(self.bytes)
        self.bytes += data + bytes(-len(data) % 2)
        for name, (target, addend) in references.items():
            self.section.relocations.append(Relocation(at + int(name[3:]), 4, False, target, addend))
        return at

    def struct(self, name: str, **values) -> int:
        """Adds a struct; fields that are not given are 0, and pairs are references."""
        struct = layout.load().struct(name)
        references = {f"at_{struct.fields[key]['offset']}": value for key, value in values.items()
                      if isinstance(value, tuple)}
        numbers = dict.fromkeys(struct.fields, 0) | {key: value for key, value in values.items()
                                                     if not isinstance(value, tuple)}
        return self.put(struct.pack(**numbers), **references)

    def end(self, **symbols: int) -> Section:
        """Returns the section, whole."""
        self.section.data = bytes(self.bytes) + bytes(-len(self.bytes) % 4)
        self.section.size = len(self.section.data)
        self.section.symbols |= symbols
        return self.section


def cleared(name: str, size: int) -> Section:
    """Returns cleared memory of the program's."""
    return Section("", f".bss.{name}", b"", size, 8, bss=True)


def is_still(scene: Scene) -> bool:
    """Returns True if a scene has polygons of plain mappers alone, each at one place in all frames."""
    plain = all(m.mapper not in (*UNITS, "keyed", "dithered") and not m.levels for m in scene.materials)
    maps = all(t.layout != "margins" for t in scene.textures)
    return plain and maps and scene.format == "chunky" and not scene.instances and all(
        obj.first_frame == 0 and obj.poses >= scene.frames
        and (scene.poses[obj.pose:obj.pose + obj.poses] == scene.poses[obj.pose]).all() for obj in scene.objects)


def texels_of(scene: Scene, number: int, vertices: list[tuple]) -> list[tuple]:
    """Returns vertices as x, y, u, v, shade: s and t times the map's scale, to the nearest."""
    scale = ONE
    if number >= 0:
        scale = max(scene.textures[number].texels.shape) * ONE // SIDE
    return [(x, y, s * scale + ONE // 2 >> 16, t * scale + ONE // 2 >> 16, shade) for x, y, s, t, shade, *_ in vertices]


def prepared(scene: Scene, obj: Object) -> list[tuple] | None:
    """Returns the snapped vertices x, y, u, v of an object, or None if only the program can tell how to draw it."""
    material = scene.materials[obj.material]
    mapper = material.mapper
    settings = Settings(mapper=mapper, edges=material.edges, gradients=material.gradients, start=material.start,
                        perspective=material.perspective)
    given = texels_of(scene, material.texture, vertices_at(scene, obj, 0))
    if mapper not in ROUTINES or not snapped.may_draw(given, settings, scene.width, scene.height):
        return None
    corners = [(snapped.snap(x), snapped.snap(y), u, v, shade) for x, y, u, v, shade in given]
    if mapper == "flat":
        return [(x, y, 0, 0) for x, y, *_ in corners]
    if mapper == "gouraud":
        if len({shade >> 16 for *_, shade in corners}) == 1:
            return None  # it is flat
        least, most = LOWEST_SHADE, ONE - 1 - LOWEST_SHADE
        return [(x, y, (shade & ~0xFFFF | min(max(shade & 0xFFFF, least), most)) + snapped.RAISED << 4, 0)
                for x, y, _, _, shade in corners]
    for one, other in zip(corners, corners[1:] + corners[:1]):
        if one[1] == other[1] and (one[2] == other[2] or one[3] == other[3]):
            return None  # u or v may be the same along lines
    return [(x, y, u + snapped.RAISED << 4, v + snapped.RAISED << 4) for x, y, u, v, _ in corners]


class Writer:
    """Writes a still scene's sections."""

    def __init__(self, scene: Scene):
        self.scene = scene
        self.data = Data(Section("", ".data.still", b"", 0, 4))
        self.texels = Data(Section("", ".rodata.scene_data", b"", 0, 4))
        self.pixels = cleared("still_pixels", scene.width * scene.height)
        self.pages = 0  # bytes
        self.copies: list[dict] = []  # of struct still_map
        self.fields: list[tuple] = []  # that maps' places are added to
        self.setup: list[tuple[str, tuple]] = []  # calls
        self.room: dict[str, Section] = {}
        self.maps: list[int | None] = [None] * len(scene.textures)
        order = sorted(range(len(scene.textures)), key=lambda number: scene.textures[number].layout == "light")
        self.places = {number: self.map_at(number) for number in order}  # light tables behind whole pages

    def cleared(self, name: str, size: int) -> Section:
        """Returns cleared memory that the whole program shares."""
        return self.room.setdefault(name, cleared(f"still_{name}", size))

    def map_at(self, number: int) -> tuple[bool, tuple | int]:
        """Adds a map's texels; returns True and its place from the pages' start, or False and a reference to it."""
        texture = self.scene.textures[number]
        stored = ordered(texture)
        at = self.texels.put(stored + bytes(-len(stored) % 4))
        height, width = texture.texels.shape
        if texture.layout not in ("page", "tiled", "light") and (height, width) != (SIDE, SIDE):
            return False, (self.texels.section, at)
        to, self.pages = self.pages, self.pages + (len(stored) if texture.layout == "light" else PAGE)
        copy = {"mask": 0, "longs": len(stored) // 4 - 1, "repeats": 0, "rows": 0}
        if texture.layout == "page" and len(stored) < PAGE:
            copy = {"mask": height - 1, "longs": width // 4 - 1, "repeats": SIDE // width - 1, "rows": SIDE - 1}
        self.copies.append({"from": (self.texels.section, at), "to": to, **copy})
        return True, to

    def texel_field(self, number: int, struct: str, name: str) -> tuple[int | tuple, int]:
        """Returns what a pointer to a map's texels holds, and the offset of the field if the program adds to it."""
        copied, place = self.places[number]
        return place, layout.load().struct(struct).fields[name]["offset"] if copied else -1

    def note(self, at: int, offset: int) -> None:
        """Notes a field that a map's place is added to, at an offset of a struct."""
        if offset >= 0:
            self.fields.append((self.data.section, at + offset))

    def map_of(self, number: int) -> tuple | int:
        """Returns a reference to a struct map, or 0."""
        if number < 0:
            return 0
        if self.maps[number] is None:
            texture = self.scene.textures[number]
            height, width = texture.texels.shape
            texels, offset = self.texel_field(number, "map", "texels")
            full = dark = 0
            if texture.layout == "light":
                rows = texture.texels.tolist()
                full, dark = rows[-1] == list(range(SIDE)), len(set(rows[0])) == 1
            self.maps[number] = self.data.struct(
                "map", texels=texels, width=width, height=height, scale=max(width, height) * ONE // SIDE,
                layout=LAYOUTS.index(texture.layout), texel_bytes=1, full=full, dark=dark)
            self.note(self.maps[number], offset)
        return self.data.section, self.maps[number]

    def renderer(self) -> tuple:
        """Returns a reference to the renderer of polygons that are not prepared."""
        if not hasattr(self, "_renderer"):
            scene, constants = self.scene, layout.load().constants
            frame = self.data.struct("frame", pixels=(self.pixels, 0), width=scene.width, height=scene.height,
                                     pitch=scene.width, pixel_bytes=1)
            scratch = self.cleared("scratch", layout.load().struct("scratch").size)
            values = {}
            if any(m.edges == "snapped" for m in scene.materials):
                tables = self.cleared("triangles", layout.load().struct("triangle_tables").size)
                values["triangles"] = tables, 0
                self.setup.append(("_triangle_tables_make", (tables, 0)))
            if any(m.perspective in ("every16", "every8") or m.perspective != "none" and m.tolerance
                   for m in scene.materials):
                table = self.cleared("far", 2 * constants["FAR_COUNT"])
                values["reciprocals"] = table, 2 * (constants["FAR_ORIGIN"] - constants["FAR_LOWEST"])
                self.setup.append(("_reciprocals_make", (table, 0)))
            self._renderer = self.data.section, self.data.struct(
                "renderer", frame=(self.data.section, frame), form=constants["FORM_ADDX"], scratch=(scratch, 0), **values)
        return self._renderer

    def material(self, number: int) -> int:
        """Adds a struct material; returns its place."""
        material = self.scene.materials[number]
        settings = {kind: names.index(getattr(material, kind)) for kind, names in SETTINGS.items()}
        light = material.light if material.mapper in LIT else -1
        return self.data.struct("material", **settings, number=number, tolerance=material.tolerance,
                                colour=material.colour, map=self.map_of(material.texture), light=self.map_of(light),
                                draw=("_polygon_draw", 0))

    def run(self, number: int, objects: list[Object]) -> tuple[str, tuple]:
        """Returns the call that draws polygons of one material."""
        corners = layout.load().struct("vertex")
        polygons = []
        for obj in objects:
            found = [self.data.put(corners.pack(x=x, y=y, s=s, t=t, shade=shade, w=w))
                     for x, y, s, t, shade, w in vertices_at(self.scene, obj, 0)]
            polygons.append({"vertices": (self.data.section, found[0]), "count": len(found), "planar": obj.planar})
        first = [self.data.struct("polygon", **each) for each in polygons][0]
        return "_still_run", (self.data.section, self.data.struct(
            "still_run", renderer=self.renderer(), polygons=(self.data.section, first),
            material=(self.data.section, self.material(number)), count=len(polygons)))

    def triangles(self, number: int, objects: list[list[tuple]]) -> tuple[str, tuple]:
        """Returns the call that draws prepared triangles of one material."""
        material, here, list_ = self.scene.materials[number], self.data.section, []
        for corners in objects:
            at = [self.data.struct("snapped_vertex", x=x + 16, y=y + 15, u=signed(u), v=signed(v))
                  for x, y, u, v in corners]
            list_ += [(at[0], *pair) for pair in zip(at[1:], at[2:])]
        first = [self.data.struct("triangle", a=(here, a), b=(here, b), c=(here, c)) for a, b, c in list_][0]
        texels, offset = 0, -1
        if material.texture >= 0:
            texels, offset = self.texel_field(material.texture, "triangle_plan", "map")
        table = self.cleared("reciprocals", 4 * layout.load().constants["SNAPPED_RECIPROCALS"])
        call = "_triangle_reciprocals_make", (table, 0)
        if call not in self.setup:
            self.setup.append(call)
        plan = {"list": (here, first), "end": (here, len(self.data.bytes)), "row": (self.pixels, 0),
                "pitch": self.scene.width, "map": texels, "reciprocals": (table, 0),
                "colour": material.colour * 0x01010101}
        # Only triangles_spans reads what follows `cull`, so it is left out.
        struct = layout.load().struct("triangle_plan")
        at = self.data.struct("triangle_plan", **plan)
        del self.data.bytes[at + struct.fields["lines"]["offset"]:]
        self.note(at, offset)
        return ROUTINES[material.mapper], (here, at)

    def picture(self) -> list[tuple[str, tuple]]:
        """Returns the calls that draw the picture."""
        scene, calls = self.scene, []
        if scene.cleared:
            box = self.data.struct("box_plan", first=(self.pixels, 0), longwords=scene.width * scene.height // 4, rows=1,
                                   pitch=scene.width * scene.height, pixels=scene.background * 0x01010101)
            calls.append(("_box_fill", (self.data.section, box)))
        known = [(obj.material, prepared(scene, obj), obj) for obj in scene.objects]
        for (number, ready), some in groupby(known, lambda each: (each[0], each[1] is not None)):
            group = list(some)
            calls.append(self.triangles(number, [corners for _, corners, _ in group]) if ready
                         else self.run(number, [obj for *_, obj in group]))
        return calls

    def sections(self) -> list[Section]:
        """Returns all sections of the scene."""
        pictures, scene = self.picture(), self.scene
        head = self.data.struct("still", frames=scene.frames, pixels=(self.pixels, 0), bytes=scene.width * scene.height,
                                pages=(cleared("still_pages", self.pages + PAGE - 1), 0) if self.pages else 0)
        for copy in self.copies:
            self.data.struct("still_map", **copy)
        self.data.put(bytes(4))
        for place in self.fields:
            self.data.put(bytes(4), at_0=place)
        self.data.put(bytes(4))
        self.calls(self.setup)
        return [self.data.end(still_head=head, still_picture=self.calls(pictures)), self.texels.end()]

    def calls(self, calls: list[tuple[str, tuple]]) -> int:
        """Adds a list of calls; returns its place."""
        at = len(self.data.bytes)
        for routine, argument in calls:
            self.data.struct("still_call", routine=(routine, 0), **{"with": argument})
        self.data.put(bytes(4))
        return at


def signed(number: int) -> int:
    """Returns a number modulo 2^32 as an int32."""
    return (number + 2**31) % 2**32 - 2**31


def sections(scene: Scene) -> list[Section]:
    """Returns the sections of a still scene."""
    return Writer(scene).sections()

