"""The Cornell box by its published measurements, with the emitter in its ceiling as its only light.

Geometry and camera are Cornell University's (Program of Computer Graphics, "Cornell Box Data", 1998), in millimetres
there and metres here; the walls are not exactly square, as in the real box. Reflectances and the emitter's radiance are the
linear RGB values that renderers commonly use for the measured spectra. The published emitter lies in the plane of the ceiling;
here it is a tenth of a millimetre below.
"""
import math

from . import shapes
from .glb import Glb

WHITE, RED, GREEN = (0.725, 0.71, 0.68), (0.63, 0.065, 0.05), (0.14, 0.45, 0.091)
LAMP, RADIANCE = (0.78, 0.78, 0.78), (17.0, 12.0, 4.0)

# Corners as published, x to the left of the picture, counter-clockwise as seen from the lit side.
FLOOR = ((552.8, 0, 0), (0, 0, 0), (0, 0, 559.2), (549.6, 0, 559.2))
CEILING = ((556, 548.8, 0), (556, 548.8, 559.2), (0, 548.8, 559.2), (0, 548.8, 0))
BACK = ((549.6, 0, 559.2), (0, 0, 559.2), (0, 548.8, 559.2), (556, 548.8, 559.2))
RIGHT = ((0, 0, 559.2), (0, 0, 0), (0, 548.8, 0), (0, 548.8, 559.2))
LEFT = ((552.8, 0, 0), (549.6, 0, 559.2), (556, 548.8, 559.2), (556, 548.8, 0))
LIGHT = ((343, 548.7, 227), (343, 548.7, 332), (213, 548.7, 332), (213, 548.7, 227))
SHORT_BLOCK = (((130, 165, 65), (82, 165, 225), (240, 165, 272), (290, 165, 114)),
               ((290, 0, 114), (290, 165, 114), (240, 165, 272), (240, 0, 272)),
               ((130, 0, 65), (130, 165, 65), (290, 165, 114), (290, 0, 114)),
               ((82, 0, 225), (82, 165, 225), (130, 165, 65), (130, 0, 65)),
               ((240, 0, 272), (240, 165, 272), (82, 165, 225), (82, 0, 225)))
TALL_BLOCK = (((423, 330, 247), (265, 330, 296), (314, 330, 456), (472, 330, 406)),
              ((423, 0, 247), (423, 330, 247), (472, 330, 406), (472, 0, 406)),
              ((472, 0, 406), (472, 330, 406), (314, 330, 456), (314, 0, 456)),
              ((314, 0, 456), (314, 330, 456), (265, 330, 296), (265, 0, 296)),
              ((265, 0, 296), (265, 330, 296), (423, 330, 247), (423, 0, 247)))


def metres(corner):
    return tuple(x / 1000 for x in corner)


def surface(*quads):
    """A shape of separate quads. The normal of a quad whose corners do not lie in one plane is the mean one."""
    shape = shapes.Shape()
    for quad in quads:
        a, b, c, d = map(metres, quad)
        first = len(shape.positions)
        u, v = ([q - p for p, q in zip(*diagonal)] for diagonal in ((a, c), (b, d)))
        normal = shapes.unit((u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]))
        shape.positions += [a, b, c, d]
        shape.normals += [normal] * 4
        shape.indices += [first + i for i in (0, 1, 2, 0, 2, 3)]
    return shape


def build():
    """The front (-Z) is open towards the camera, and the blocks stand on the floor without undersides, as published."""
    glb = Glb("tools/make_assets.py")
    white, red, green = (glb.material(*m) for m in (("white", WHITE), ("red", RED), ("green", GREEN)))
    # glTF's factor is at most 1: the brightest channel is the strength.
    strength = max(RADIANCE)
    emitter = glb.material("lamp", LAMP, emissive=([round(x / strength, 9) for x in RADIANCE], strength, None))

    glb.node("box", mesh=glb.mesh("box", glb.primitive(surface(FLOOR, CEILING, BACK), white),
                                  glb.primitive(surface(RIGHT), green), glb.primitive(surface(LEFT), red)))
    glb.part("short block", surface(*SHORT_BLOCK), white)
    glb.part("tall block", surface(*TALL_BLOCK), white)
    glb.part("lamp", surface(LIGHT), emitter)

    # A focal length of 35 mm before 25 mm of film.
    glb.camera("front", metres((278, 273, -800)), metres((278, 273, 0)), math.degrees(2 * math.atan(12.5 / 35)),
               (0.01, 10.0))
    glb.directional_light("sun", (-0.5, -1.0, -0.4), (1, 1, 1), 0.0)
    return glb
