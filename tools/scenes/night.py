"""An interior at night: a closed room lit by three point lights, a spot and an emissive globe.

Intensities are a few candela, so that most values of the picture are below 1 without an exposure, as in the other scenes.
"""
import math

from . import shapes
from .glb import Glb, axis_angle

WIDTH, HEIGHT, DEPTH = 6.0, 3.0, 5.0  # metres
WARM, BLUISH, WHITE = (1.0, 0.72, 0.42), (0.45, 0.65, 1.0), (1.0, 0.95, 0.88)


def boxes(*placed):
    """Closed boxes. `placed`: (lowest corner, size) of each."""
    shape = shapes.Shape()
    for low, size in placed:
        shape.append(shapes.box(size, None), [a + b for a, b in zip(low, (size[0] / 2, 0, size[2] / 2))])
    return shape


def table():
    """1.6 m x 0.9 m, 0.75 m high, around x = z = 0."""
    legs = [((x, 0, z), (0.08, 0.7, 0.08)) for x in (-0.76, 0.68) for z in (-0.41, 0.33)]
    return boxes(((-0.8, 0.7, -0.45), (1.6, 0.05, 0.9)), *legs)


def shelf():
    """Two sides and four boards, 1.2 m wide, 1.9 m high, 0.35 m deep; open at the front and at the back."""
    boards = [((-0.55, y, 0), (1.1, 0.05, 0.35)) for y in (0.1, 0.65, 1.2, 1.75)]
    return boxes(((-0.6, 0, 0), (0.05, 1.9, 0.35)), ((0.55, 0, 0), (0.05, 1.9, 0.35)), *boards)


def shade():
    """A truncated cone of sheet metal 1.2 cm thick, open at both ends; closed as a surface. Its light is at y = 0."""
    outside = [(0.32, -0.1), (0.14, 0.2)]
    inside = [(0.128, 0.2), (0.308, -0.1)]
    shape = shapes.Shape()
    corners = [*outside, *inside]
    for a, b in zip(corners, corners[1:] + corners[:1]):
        shape.append(shapes.lathe([a, b], 24))
    return shape


def build():
    glb = Glb("tools/make_assets.py")
    material = {name: glb.material(name, color) for name, color in (
        ("plaster", (0.72, 0.7, 0.66)), ("red", (0.56, 0.12, 0.08)), ("green", (0.12, 0.4, 0.2)),
        ("floor", (0.38, 0.26, 0.16)), ("wood", (0.45, 0.3, 0.17)), ("metal", (0.12, 0.12, 0.13)),
        ("white", (0.75, 0.75, 0.72)), ("blue", (0.14, 0.24, 0.55)), ("picture", (0.7, 0.5, 0.2)))}
    add_room(glb, material)
    add_furniture(glb, material)

    # The shade is dark, because light that it reflects so near to its source is noise to a path tracer.
    glb.point_light("table lamp", (-0.75, 1.75, -0.45), WARM, 6.5)
    glb.part("shade", shade(), material["metal"], translation=[-0.75, 1.75, -0.45])
    glb.point_light("bare bulb", (0.3, 1.6, -0.3), WARM, 3.0)
    glb.point_light("night light", (-0.35, 1.75, 0.25 - DEPTH / 2), BLUISH, 0.4)
    glb.spot_light("spot", (1.0, 2.95, -1.1), (0.0, -1.2, -1.4), WHITE, 14.0, math.radians(12), math.radians(24))

    glb.camera("door", (1.0, 1.65, 2.42), (-0.15, 1.1, -1.0), 70)
    return glb


def add_room(glb, material):
    """The inside is the front."""
    x, y, z = WIDTH / 2, HEIGHT, DEPTH / 2
    plain = shapes.quads(((-x, y, -z), (2 * x, 0, 0), (0, 0, 2 * z)), ((-x, 0, -z), (2 * x, 0, 0), (0, y, 0)),
                         ((x, 0, z), (-2 * x, 0, 0), (0, y, 0)))
    left, right = shapes.quads(((-x, 0, z), (0, 0, -2 * z), (0, y, 0))), shapes.quads(((x, 0, -z), (0, 0, 2 * z), (0, y, 0)))
    floor = shapes.quads(((-x, 0, z), (2 * x, 0, 0), (0, 0, -2 * z)))
    glb.node("room", mesh=glb.mesh("room", glb.primitive(plain, material["plaster"]), glb.primitive(left, material["red"]),
                                   glb.primitive(right, material["green"]), glb.primitive(floor, material["floor"])))


def add_furniture(glb, material):
    glb.part("table", table(), material["wood"], translation=[-0.25, 0, -0.4])
    glb.part("shelf", shelf(), material["white"], translation=[-2.1, 0, -DEPTH / 2])
    for name, color, low, size in (("tall books", "blue", (-2.55, 1.25, -2.42), (0.5, 0.3, 0.22)),
                                   ("books", "picture", (-2.3, 0.7, -2.42), (0.6, 0.25, 0.22))):
        glb.part(name, boxes((low, size)), material[color])
    glb.part("small ball", shapes.icosphere(0.12, 2), material["blue"], translation=[-0.1, 0.87, -0.5])
    glb.part("ball", shapes.icosphere(0.32, 3), material["white"], translation=[-1.3, 0.32, 0.6])
    glb.part("box", shapes.box((0.8, 0.5, 0.6), None), material["blue"], translation=[1.9, 0, -1.65],
             rotation=axis_angle((0, 1, 0), -20))
    glb.part("picture", shapes.box((1.1, 0.8, 0.05), None), material["picture"], translation=[1.0, 1.35, -DEPTH / 2 + 0.025])
    emitter = glb.material("globe", (0.5, 0.5, 0.5), emissive=((1.0, 0.8, 0.55), 9.0, None))
    glb.part("globe", shapes.icosphere(0.15, 2), emitter, translation=[1.9, 0.65, -1.65])
