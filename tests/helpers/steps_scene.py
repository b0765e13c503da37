"""A scene on which every step of accuracy shows: each mapper with an 8-bit frame."""

from tests.helpers.engine_scenes import save_noise
from tmap.compiler.scene import compile_scene
from tmap.scene_file.scene_file import Scene

TEXT = """\
width = 104
height = 72
frames = {frames}
background = "#102030"
[textures]
noise.image = "noise.png"
[materials]
flat = {{colour = "#ff0000"}}
gouraud = {{shades = ["#201040", "#ffe0a0"], gradients = "scanline"}}
affine = {{texture = "noise", edges = "exact"}}
quad = {{texture = "noise", gradients = "scanline", start = "truncated"}}
columns = {{texture = "noise", mapper = "columns"}}
arbitrary = {{texture = "noise", mapper = "arbitrary"}}
lit = {{texture = "noise", mapper = "lit"}}
gradual = {{texture = "noise", mapper = "lit_gouraud"}}
dithered = {{texture = "noise", mapper = "dithered", edges = "integer"}}
deep = {{texture = "noise", perspective = "every8"}}
bent = {{texture = "noise", perspective = "pixel", edges = "integer", tolerance = 0.5}}
cube = {{texture = "noise", perspective = "every16"}}
wall = {{texture = "noise"}}
[camera]
eye = [0, 0, 3]
target = [0, 0, 0]
fov = 60
near = 0.25
"""
PLANE = "vertices = [[3.3, 2.7, 0, 0], [29.6, 5.2, 200, 10], [8.1, 33.9, 20, 180]]"
DEEP = "vertices = [[{}.3, 2.7, 0, 0, 1], [{}.6, 5.2, 90, 10, 3.5], [{}.1, 33.9, 30, 120, 2]]"
FOUR = "vertices = [[1.5, 40.2, 0, 0], [30.4, 43.7, 150, 0], [30.4, 69, 150, 120], [1.5, 65.5, 0, 120]]"
#: Edges through pixels' centres and texels' borders at them, by thirds: no binary number is exact.
THIRDS = "vertices = [[33.5, 2.5, 0, 0], [93.5, 2.5, 40, 0], [53.5, 62.5, 0, 40]]"
MOVING = "sides = 3\nradius = 9\ncentre = [12, 12]\nmove = [17.3, 9.1]"
OBJECTS = (("affine", THIRDS), ("flat", PLANE),
           ("gouraud", "sides = 3\nradius = 14\ncentre = [40.3, 15.1]"),
           ("affine", PLANE + "\ncentre = [25, 22]"), ("quad", FOUR),
           ("columns", PLANE + "\ncentre = [28, 37]"),
           ("arbitrary", "sides = 3\nradius = 13\ncentre = [50.2, 20.9]\nmap_radius = 90\nangle = 17"),
           ("lit", "sides = 3\nradius = 12.5\ncentre = [83.7, 58.3]\nangle = 50\nshades = [150]"),
           ("gradual", "vertices = [[33.3, 42.7, 0, 0, 30], [52.6, 45.2, 90, 10, 250], "
                       "[38.1, 69.9, 20, 80, 120]]"),
           ("dithered", "sides = 3\nradius = 11\ncentre = [62.2, 60.9]\nangle = 17"),
           ("deep", DEEP.format(60, 80, 66)), ("bent", DEEP.format(76, 94, 79)),
           ("cube", "points = [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]\n"
            "faces = [[0, 1, 2, 3]]\nuvs = [[[0, 256], [256, 256], [256, 0], [0, 0]]]\n"
            "triangles = true\ntwo_sided = true\nsize = 0.5\nrotation = [10, 60, 0]"),
           ("wall", "points = [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]\n"
            "faces = [[0, 1, 2, 3]]\nuvs = [[[0, 200], [200, 200], [200, 0], [0, 0]]]\n"
            "two_sided = true\nsize = 0.4\nposition = [0.8, 0.6, 0]\nrotation = [-20, 65, 0]"),
           ("quad", MOVING))


def steps_scene(folder, frames: int = 1) -> Scene:
    """Compiles the scene in a folder; one of its objects moves."""
    save_noise(folder, 5, noise=(64, 64))
    text = TEXT.format(frames=frames) + "".join(
        f'[[objects]]\nmaterial = "{name}"\n{lines}\n' for name, lines in OBJECTS)
    (folder / "steps.toml").write_text(text)
    return compile_scene(folder / "steps.toml")
