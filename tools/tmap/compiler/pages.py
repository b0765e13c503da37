"""Maps that share pages: parts of small maps, side by side in pages of 256x256 texels.

A mapper's span reads a page of 65,536 texels, over which a smaller map is repeated. But polygons mostly read a
part of that: s and t of their corners are known here. The part that all polygons of a map read, its **window**,
is enough: what is in it is the repeated map, so a polygon whose s and t are moved there by whole texels finds the
same texel at each pixel. A window that is wider than a page is a whole row of it, where u wraps as it does in the
map's own page; it shares the page by rows. A polygon is first moved by whole repeats of the map to where the map
begins, so that all windows overlap as far as they can.

**How far outside its corners a polygon reads.** Edges are exact or snapped: the pixels' centres are inside the
polygon that is drawn, so exact s and t there are between those of its corners, in perspective too: more than three
corners are on one plane but for rounding, or drawn as triangles (c/drawing/fan.c). What is drawn may differ
(tools/tmap/ideal/bounds.py and its neighbours have the sums):

* affine: steps of u and v are rounded to 1/65536 texel and starts are raised, 2^-15 texel for each of the 2,048
  lines and pixels at most, or 1/48 by snapped edges, 6/65536 more for each texel a pixel: together below 1/4 texel
  up to 2^10 texels a pixel. Dithering moves points by 3/8 texel. One texel is enough: windows begin and end at whole
  texels, and a corner at such an end is in the texel that begins there.
* each pixel, "pixel" and "fine": these, and 1/32 texel by the setting. One texel is enough.
* pieces, "every16" and "every8": lines from their far end go along chords of K + C / q between exact values. A
  chord is on the far side of the curve, as 1 / q is convex, and not beyond the far end's value: so it does not
  leave the polygon's range, even where the last piece ends beyond the near end. Ends of even spans' pieces are ahead
  by 3/8 of a chord's error, which is a pixel at most (c/span/far.h): 3/8 of the texels of a line's nearest pixel
  outside. Roundings are 5/4 unit for each texel from K, which is at most 49,152 texels away: below one texel. Four
  texels are enough up to 8 texels a pixel.
* a tolerance adds as much: at most one texel more.

Beyond these steepnesses, and in polygons of more than three corners whose depth varies too much for exact planes
("unsure"), the texel of a neighbour in the page may be read at an edge; nothing but the page is. Rounded edges,
"truncated" starts, steps of other gradients than planes, mirrors (s and t of normals) and transparent texels (whose
rows the map describes) keep pages of their own.

**The same bits.** Corners are rounded to texels here as set-up rounds them, and a page's scale is 1: u and v differ by
whole texels alone. Set-up divides distances from a polygon's middle texel, so perspective is the same bit for bit.
Affine lines spare u's lowest bit for the times that v passes the page's border, which is elsewhere; and meshes that
are cut at the near plane round s and t there as texels: a texel may be its neighbour where its border is on a pixel's
centre.
"""

from dataclasses import dataclass, field, replace

import numpy as np

from tmap.base.fixed import ONE
from tmap.build import layout
from tmap.scene_file.materials import Material
from tmap.scene_file.meshes import ENVIRONMENT
from tmap.scene_file.scene_file import Scene
from tmap.scene_file.textures import Texture

PAGE = 256
MAPPERS = ("affine", "lit", "lit_gouraud", "dithered")
#: Texels beyond its corners that a polygon may read, by its perspective.
GUTTERS = {"none": 1, "pixel": 1, "fine": 1, "every16": 4, "every8": 4}
NAMES = 3  # of a page's maps, for messages


def gutter_of(material: Material) -> int | None:
    """Returns the texels around a material's polygons that they may read; None if that is not bounded."""
    if material.mapper not in MAPPERS or material.edges not in ("exact", "snapped") \
            or (material.gradients, material.start) != ("plane", "subtexel"):
        return None
    return GUTTERS[material.perspective] + (material.tolerance > 0)


@dataclass
class Window:
    """The part of a repeated map that polygons read, in texels. Without polygons it is one texel."""

    texture: int
    gutter: int = 0
    low: list[int] = field(default_factory=lambda: [PAGE, PAGE])
    high: list[int] = field(default_factory=lambda: [-PAGE, -PAGE])
    page: int = 0
    at: tuple[int, int] = (0, 0)  # in the page

    def add(self, texels: np.ndarray) -> None:
        """Adds a polygon's u and v, 16.16, moved to where the map begins."""
        for k, column in enumerate(texels.T):
            self.low[k] = min(self.low[k], int(column.min()) >> 16)
            self.high[k] = max(self.high[k], -(-int(column.max()) >> 16))

    def first(self) -> list[int]:
        """Returns the window's first u and v; 0 where it is a whole row or column."""
        return [0 if size == PAGE or high < low else low - self.gutter
                for low, high, size in zip(self.low, self.high, self.size())]

    def size(self) -> list[int]:
        """Returns its width and height."""
        return [1 if high < low else min(high - low + 2 * self.gutter, PAGE)
                for low, high in zip(self.low, self.high)]

    def moves(self) -> np.ndarray:
        """Returns what is added to u and v, 16.16."""
        return (np.array(self.at) - self.first()) * ONE

    def texels(self, texture: Texture) -> np.ndarray:
        """Returns its texels."""
        (left, top), (width, height) = self.first(), self.size()
        rows, columns = texture.texels.shape
        return texture.texels[np.ix_((top + np.arange(height)) % rows, (left + np.arange(width)) % columns)]


def texels_of(values: np.ndarray, texture: Texture) -> np.ndarray:
    """Returns u and v, 16.16, of rows of s and t, as c/drawing/material.c rounds them, moved by whole repeats of the
    map so that the least are in it."""
    longer = max(texture.texels.shape)
    texels = values * longer + 128 >> 8
    sides = np.array(texture.texels.shape[::-1]) * ONE
    return texels - texels.min(axis=0) // sides * sides


@dataclass
class Uses:
    """Which rows of s and t each texture's polygons have."""

    polygons: dict[int, list[slice]]  # of the vertices, by texture
    faces: dict[int, list[slice]]  # of the corners
    fixed: set[int]  # textures that need pages of their own


def faces_of(scene: Scene, number: int) -> list[slice]:
    """Returns the rows of a mesh's corners, face by face."""
    mesh = scene.meshes[number]
    return [slice(mesh.corner + first, mesh.corner + first + count)
            for first, count in scene.faces[mesh.face:mesh.face + mesh.faces, 4:6].tolist()]


def unbounded(scene: Scene) -> set[int]:
    """Returns the textures that need pages of their own whatever s and t are, and those that have other layouts."""
    found = {n for n, texture in enumerate(scene.textures) if texture.layout != "page"}
    found |= {m.texture for m in scene.materials if gutter_of(m) is None}
    found |= {level.texture for m in scene.materials if m.levels
              for level in (m, *scene.materials[m.level:m.level + m.levels])}  # mip maps: each half the last
    return found | {scene.materials[i.material].texture for i in scene.instances if i.flags & ENVIRONMENT}


def apart(scene: Scene, fixed: set[int]) -> Scene:
    """Returns a scene in which materials with different textures have different meshes; copies have the same points,
    normals and faces, and corners of their own. ``fixed``: textures whose s and t do not change."""
    users: dict[tuple[int, int], int] = {}  # mesh and texture: the mesh to have
    meshes, corners, instances, taken = list(scene.meshes), [scene.corners], [], set()
    count = len(scene.corners)
    for each in scene.instances:
        texture = scene.materials[each.material].texture
        key = each.mesh, -1 if texture in fixed else texture
        if texture >= 0 and key not in users:
            users[key] = each.mesh
            if each.mesh in taken:
                mesh = scene.meshes[each.mesh]
                corners.append(scene.corners[mesh.corner:mesh.corner + mesh.corners])
                users[key] = len(meshes)
                meshes.append(replace(mesh, corner=count))
                count += mesh.corners
            taken.add(each.mesh)
        instances.append(replace(each, mesh=users.get(key, each.mesh)))
    if max(count, len(meshes)) > layout.load().constants["SCENE_COUNT_MAX"]:
        return scene
    return replace(scene, meshes=meshes, corners=np.concatenate(corners), instances=instances)


def uses_of(scene: Scene, fixed: set[int]) -> Uses:
    """Returns the rows of all textured polygons of a scene. Where a mesh has several textures, as its copies were too
    many, none of them can move. ``fixed``: as in ``apart``."""
    found, owner = Uses({}, {}, set(fixed)), {}
    for obj in scene.objects:
        texture = scene.materials[obj.material].texture
        if texture >= 0:
            found.polygons.setdefault(texture, []).append(slice(obj.vertex, obj.vertex + obj.vertices))
    for each in scene.instances:
        texture = scene.materials[each.material].texture
        first = owner.setdefault(each.mesh, texture) if texture >= 0 else texture
        if first != texture and not {first, texture} <= fixed:
            found.fixed |= {first, texture}
    for mesh, texture in owner.items():
        found.faces.setdefault(texture, []).extend(faces_of(scene, mesh))
    return found


def is_plain(rows: list[slice]) -> bool:
    """Returns True if no row is in two slices."""
    ends = sorted((each.start, each.stop) for each in rows)
    return all(a[1] <= b[0] for a, b in zip(ends, ends[1:]))


def pack(windows: list[Window]) -> int:
    """Gives each window its place, on shelves across the pages, the highest first; returns the number of pages."""
    shelves, filled = [], []  # page, first row, rows, texels in use; rows in use of each page
    for each in sorted(windows, key=lambda w: (-w.size()[1], -w.size()[0])):
        width, height = each.size()
        shelf = next((s for s in shelves if s[2] >= height and s[3] + width <= PAGE), None)
        if shelf is None:
            page = next((n for n, rows in enumerate(filled) if rows + height <= PAGE), len(filled))
            filled[page:] = filled[page:] or [0]
            shelf = [page, filled[page], height, 0]
            shelves.append(shelf)
            filled[page] += height
        each.page, each.at = shelf[0], (shelf[3], shelf[1])
        shelf[3] += width
    return len(filled)


def windows_of(scene: Scene, uses: Uses) -> list[Window]:
    """Returns the windows of the textures that could share a page."""
    found = []
    for number, texture in enumerate(scene.textures):
        if number in uses.fixed:
            continue
        window = Window(number, max((gutter_of(m) for m in scene.materials if m.texture == number), default=0))
        for table, rows in ((scene.vertices, uses.polygons), (scene.corners, uses.faces)):
            for each in rows.get(number, []):
                window.add(texels_of(table[each, 2:4], texture))
        if window.size() != [PAGE, PAGE]:
            found.append(window)
    return found


def page_of(scene: Scene, windows: list[Window]) -> Texture:
    """Returns the page of some windows."""
    texels = np.zeros((PAGE, PAGE), scene.textures[windows[0].texture].texels.dtype)
    for each in windows:
        (x, y), (width, height) = each.at, each.size()
        texels[y:y + height, x:x + width] = each.texels(scene.textures[each.texture])
    names = [scene.textures[each.texture].name for each in windows]
    return Texture(texels, "page", ", ".join(names[:NAMES]) + ", ..." * (len(names) > NAMES), len(windows))


def moved(scene: Scene, uses: Uses, windows: list[Window]) -> tuple[np.ndarray, np.ndarray]:
    """Returns the vertices and corners with s and t of their places in the pages."""
    vertices, corners = scene.vertices.copy(), scene.corners.copy()
    for window in windows:
        texture = scene.textures[window.texture]
        for table, rows in ((vertices, uses.polygons), (corners, uses.faces)):
            for each in rows.get(window.texture, []):
                table[each, 2:4] = texels_of(table[each, 2:4], texture) + window.moves()
    return vertices, corners


def share(scene: Scene) -> Scene:
    """Returns a scene whose maps share pages where that saves some; the same scene if it saves none."""
    fixed = unbounded(scene)
    made = apart(scene, fixed)
    uses = uses_of(made, fixed)
    if not is_plain(sum([*uses.polygons.values()], [])) or not is_plain(sum([*uses.faces.values()], [])):
        return scene
    windows = windows_of(made, uses)
    count = pack(windows)
    pages = [[w for w in windows if w.page == page] for page in range(count)]
    pages = [each for each in pages if len(each) > 1]
    if not pages:
        return scene
    shared = sum(pages, [])
    gone = {window.texture for window in shared}
    kept = [number for number in range(len(scene.textures)) if number not in gone]
    place = {number: n for n, number in enumerate(kept)} | {-1: -1}
    place |= {window.texture: len(kept) + n for n, page in enumerate(pages) for window in page}
    vertices, corners = moved(made, uses, shared)
    return replace(made, vertices=vertices, corners=corners,
                   textures=[scene.textures[n] for n in kept] + [page_of(made, page) for page in pages],
                   materials=[replace(m, texture=place[m.texture], light=place[m.light]) for m in scene.materials])
