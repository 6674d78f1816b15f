"""A room under a grey sky with ten thin things: a tenth of a voxel to one and a half of a grid of 64^3, which are about 7 cm."""
import math
from dataclasses import dataclass

from . import shapes
from .blocks import Blocks
from .glb import Glb, axis_angle


@dataclass(frozen=True)
class Thing:
    name: str
    low: tuple[float, float, float]  # corners of its bounds, in metres
    high: tuple[float, float, float]
    eye: tuple[float, float, float]  # from where it is measured
    is_round: bool = False

    @property
    def size(self):
        return tuple(b - a for a, b in zip(self.low, self.high))

    @property
    def middle(self):
        return tuple((a + b) / 2 for a, b in zip(self.low, self.high))

    @property
    def axis(self):
        """The axis along which its light is measured."""
        return max((1, 0, 2), key=lambda axis: self.size[axis]) if self.name != "curtain" else 1


# The picture of a thing shows its length, in a strip of this many pixels.
LENGTH, WIDTH = 512, 40
THINGS = (
    Thing("chair leg", (-0.62, 0.0, 0.58), (-0.58, 0.44, 0.62), (0.1, 0.5, 1.9)),
    Thing("table top", (0.5, 0.72, -0.1), (1.7, 0.76, 0.6), (1.1, 0.74, 2.4)),
    Thing("column", (-0.35, 0.0, -0.95), (-0.25, 2.6, -0.85), (0.2, 1.3, 1.2), is_round=True),
    Thing("window bar", (0.885, 0.9, -2.115), (0.915, 2.1, -2.085), (0.4, 1.5, -0.6)),
    Thing("curtain", (-1.9, 0.1, -1.88), (-1.1, 2.3, -1.8), (-1.2, 1.2, 0.8)),
    Thing("shelf board", (1.7, 1.3, -1.4), (2.0, 1.325, -0.4), (0.5, 1.5, -0.9)),
    Thing("kerb", (-0.4, 0.0, 1.2), (1.2, 0.1, 1.32), (0.4, 0.9, 2.6)),
    Thing("rod", (-1.95, 2.35, -1.85), (-1.05, 2.374, -1.826), (-1.5, 2.1, -0.6), is_round=True),
    Thing("railing", (-1.6, 0.96, -0.6), (-1.55, 1.0, 1.0), (-0.5, 1.3, 0.2)),
    Thing("wire", (-0.2, 1.797, -0.303), (0.6, 1.803, -0.297), (0.2, 1.6, 0.7)))


def curtain(low, high, waves=4, thickness=0.01):
    """A sheet in waves along x, closed all around."""
    count, half = 12 * waves, (high[2] - low[2] - thickness) / 2
    line = [(low[0] + (high[0] - low[0]) * i / count, (low[2] + high[2]) / 2 + half * math.sin(2 * math.pi * waves * i / count))
            for i in range(count + 1)]
    height, t = high[1] - low[1], thickness
    sheets = []
    for (x, z), (to_x, to_z) in zip(line, line[1:]):
        along, up, through = (to_x - x, 0, to_z - z), (0, height, 0), (0, 0, t)
        back = (-along[0], 0, -along[2])
        sheets += [((x, low[1], z + t / 2), along, up), ((to_x, low[1], to_z - t / 2), back, up),
                   ((x, low[1] + height, z + t / 2), along, (0, 0, -t)), ((x, low[1], z - t / 2), along, through)]
    (x, z), (end_x, end_z) = line[0], line[-1]
    sheets += [((x, low[1], z - t / 2), (0, 0, t), (0, height, 0)), ((end_x, low[1], end_z + t / 2), (0, 0, -t), (0, height, 0))]
    return shapes.quads(*sheets)


def shape_of(thing):
    """The shape of a thing, and the place and the turn of its node."""
    x, y, z = thing.size
    if thing.name == "curtain":
        return curtain(thing.low, thing.high), {}
    if not thing.is_round:
        return shapes.box((x, y, z), None), {"translation": [thing.middle[0], thing.low[1], thing.middle[2]]}
    if thing.axis == 1:
        return shapes.cylinder(x / 2, y, 24), {"translation": [thing.middle[0], thing.low[1], thing.middle[2]]}
    return shapes.cylinder(y / 2, x, 24), {"translation": [thing.low[0], *thing.middle[1:]], "rotation": axis_angle((0, 0, 1), -90)}


def room():
    """4 m x 2.6 m x 4.2 m, open at +Z, with a window in its back."""
    blocks = Blocks()
    blocks.fill("wall", (-2.2, -0.2, -2.2), (2.2, 2.8, 2))
    blocks.carve((-2, 0, -2), (2, 2.6, 2))
    blocks.carve((0.4, 0.9, -2.2), (1.4, 2.1, -2))
    return blocks.shapes()["wall"]


def supports():
    """What holds the things."""
    boxes = [((0.42, 0.03, 0.42), (-0.79, 0.44, 0.41)), *(((0.04, 0.44, 0.04), (x, 0, z)) for x, z in
             ((-0.98, 0.22), (-0.6, 0.22), (-0.98, 0.6)))]
    boxes += [((0.05, 0.72, 0.05), (x, 0, z)) for x in (0.55, 1.65) for z in (-0.05, 0.55)]
    boxes += [((0.02, 0.96, 0.02), (-1.575, 0, -0.55 + 0.3 * i)) for i in range(6)]
    shape = shapes.Shape()
    for size, place in boxes:
        shape.append(shapes.box(size, None), place)
    return shape


def build(turn=0, only=None):
    """`turn`: of everything about the vertical axis, in degrees. `only`: the one thing to keep, without the room. Each thing has a
    camera of its name. The scene holds no light: it is meant to be lit by a sky."""
    glb = Glb("tools/eval.py")
    white, grey = glb.material("white", (0.7,) * 3), glb.material("grey", (0.5,) * 3)
    root = glb.node("all", rotation=axis_angle((0, 1, 0), turn))
    if only is None:
        glb.part("room", room(), white, root)
        glb.part("supports", supports(), grey, root)
    for thing in THINGS:
        if only in (None, thing.name):
            shape, place = shape_of(thing)
            glb.part(thing.name, shape, grey, root, **place)
        distance, length = math.dist(thing.eye, thing.middle), 1.05 * thing.size[thing.axis]
        height = length if thing.axis == 1 else length * WIDTH / LENGTH
        node = glb.camera(thing.name, thing.eye, thing.middle, math.degrees(2 * math.atan(height / 2 / distance)))
        glb.json["scenes"][0]["nodes"].remove(node)
        glb.json["nodes"][root].setdefault("children", []).append(node)
    return glb


def picture_size(thing):
    return (WIDTH, LENGTH) if thing.axis == 1 else (LENGTH, WIDTH)
