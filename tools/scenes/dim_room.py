"""Two closed white rooms that share a wall of 2 cm: an emitter lights one, and the other gets its light through a small hole.

The dim room receives about 1/1000 of the light of the lit room, so every leak through the wall shows, and so does every rounding
of weak light. The emission is strong because the dim room is judged without an exposure.
"""
from . import shapes
from .glb import Glb, axis_angle

WIDTH, HEIGHT, DEPTH = 3.0, 2.4, 3.0  # metres, of each room
WALL = 0.02  # the wall's thickness
HOLE_LOW, HOLE_HIGH = (0.7, 0.8), (0.86, 0.96)  # corners of the hole in the wall: y and z, in metres
LAMP_HEIGHT, LAMP_SIDE = 1.0, 0.3
WARM, STRENGTH = (1.0, 0.72, 0.42), 36000.0


def shell():
    """The outer walls of both rooms, seen from inside."""
    w, h, d = WIDTH, HEIGHT, DEPTH / 2
    return shapes.quads(((-w, 0, d), (2 * w, 0, 0), (0, 0, -2 * d)), ((-w, h, -d), (2 * w, 0, 0), (0, 0, 2 * d)),
                        ((-w, 0, -d), (2 * w, 0, 0), (0, h, 0)), ((w, 0, d), (-2 * w, 0, 0), (0, h, 0)),
                        ((-w, 0, d), (0, 0, -2 * d), (0, h, 0)), ((w, 0, -d), (0, 0, 2 * d), (0, h, 0)))


def wall():
    """Both sides of the wall, each of four rectangles around the hole, and the hole's four edges."""
    (y0, z0), (y1, z1), d = HOLE_LOW, HOLE_HIGH, DEPTH / 2
    x, shape = WALL / 2, shapes.Shape()
    for low_y, high_y, low_z, high_z in ((0, y0, -d, d), (y1, HEIGHT, -d, d), (y0, y1, -d, z0), (y0, y1, z1, d)):
        up, along = (0, high_y - low_y, 0), (0, 0, high_z - low_z)
        shapes.add_quad(shape, (x, low_y, low_z), up, along)
        shapes.add_quad(shape, (-x, low_y, low_z), along, up)
    through, up, along = (WALL, 0, 0), (0, y1 - y0, 0), (0, 0, z1 - z0)
    shapes.add_quad(shape, (-x, y0, z0), along, through)
    shapes.add_quad(shape, (-x, y1, z0), through, along)
    shapes.add_quad(shape, (-x, y0, z0), through, up)
    shapes.add_quad(shape, (-x, y0, z1), up, through)
    return shape


def build():
    """The lit room is x < 0, the dim room x > 0.

    The emitter faces upwards and lies above the hole, so no straight line from it reaches the dim room: all light there is
    reflected at least twice. The camera stands in the dim room and does not see the hole. The node `hole` tells the path
    tracer through which opening the light comes.
    """
    glb = Glb("tools/make_assets.py")
    white, red = glb.material("white", (0.7, 0.7, 0.7)), glb.material("red", (0.6, 0.08, 0.06))
    emitter = glb.material("lamp", (0.7, 0.7, 0.7), emissive=(WARM, STRENGTH, None))

    glb.part("rooms", shell(), white)
    glb.part("wall", wall(), white)
    glb.part("pedestal", shapes.box((LAMP_SIDE, LAMP_HEIGHT, LAMP_SIDE), None), white, translation=[-1.7, 0, -0.3])
    # The emitter lies a millimetre above the pedestal.
    side = LAMP_SIDE
    glb.part("lamp", shapes.quads(((-side / 2, 0, side / 2), (side, 0, 0), (0, 0, -side))), emitter,
             translation=[-1.7, LAMP_HEIGHT + 0.001, -0.3])
    glb.part("box", shapes.box((0.6, 0.7, 0.6), None), red, translation=[1.1, 0, -0.7], rotation=axis_angle((0, 1, 0), 25))

    (y0, z0), (y1, z1) = HOLE_LOW, HOLE_HIGH
    glb.node("hole", translation=[WALL / 2, y0, z0], extras={"opening": [[0, round(y1 - y0, 6), 0], [0, 0, round(z1 - z0, 6)]]})
    glb.camera("dim room", (2.7, 1.6, 1.2), (1.0, 0.95, -1.1), 55)
    glb.directional_light("sun", (-0.5, -1.0, -0.4), (1, 1, 1), 0.0)
    return glb
