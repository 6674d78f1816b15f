"""A box with a glossy floor and two metal balls that rest on it: tests specular cones."""
import math

from . import shapes
from .glb import Glb

WHITE, RED, GREEN, FLOOR = (0.64, 0.64, 0.64), (0.64, 0.04, 0.04), (0.08, 0.5, 0.12), (0.2, 0.2, 0.22)
GOLD, SILVER = (0.95, 0.7, 0.3), (0.9, 0.9, 0.9)


def build(floor=0.3, gold=0.2, silver=0.5):
    """The arguments are the roughnesses of the floor, which is no metal, and of the two metal balls."""
    glb = Glb("tools/make_assets.py")
    white, red, green = (glb.material(*m) for m in (("white", WHITE), ("red", RED), ("green", GREEN)))

    # The inside is the front; the front (+Z) is open, as in cornell.py.
    rest = shapes.quads(((-1, 1, -1), (2, 0, 0), (0, 0, 2)), ((-1, -1, -1), (2, 0, 0), (0, 2, 0)))
    left, right = shapes.quads(((-1, -1, 1), (0, 0, -2), (0, 2, 0))), shapes.quads(((1, -1, -1), (0, 0, 2), (0, 2, 0)))
    glb.node("box", mesh=glb.mesh("box", glb.primitive(rest, white), glb.primitive(left, red),
                                  glb.primitive(right, green)))
    polished = glb.material("floor", FLOOR, roughness=floor)
    glb.part("floor", shapes.quads(((-1, -1, 1), (2, 0, 0), (0, 0, -2))), polished)
    for name, color, roughness, place in (("gold", GOLD, gold, (-0.4, -0.6, -0.1)),
                                          ("silver", SILVER, silver, (0.45, -0.6, 0.3))):
        metal = glb.material(name, color, metallic=1.0, roughness=roughness)
        glb.part(name, shapes.icosphere(0.4, 3), metal, translation=list(place))

    glb.camera("front", (0, 0, 3.85), (0, 0, 0), 40)
    glb.directional_light("sun", (-0.5, -0.45, -0.9), (1, 1, 1), round(math.pi, 6))
    return glb
