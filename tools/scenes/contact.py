"""Objects that rest on a floor in the open: tests contact with the floor and shadows on it."""
import math

from . import shapes
from .glb import Glb, axis_angle


def build():
    """All objects are closed, face outwards, and touch the floor exactly at y = 0."""
    glb = Glb("tools/make_assets.py")
    grey, red, white, blue = (glb.material(*m) for m in (
        ("grey", (0.6, 0.6, 0.6)), ("red", (0.65, 0.12, 0.08)), ("white", (0.75, 0.75, 0.72)),
        ("blue", (0.12, 0.25, 0.6))))

    glb.part("floor", shapes.quads(((-2, 0, 2), (4, 0, 0), (0, 0, -4))), grey)
    glb.part("box", shapes.box((0.7, 0.7, 0.7), None), red, translation=[-0.85, 0, -0.2], rotation=axis_angle((0, 1, 0), 25))
    glb.part("sphere", shapes.icosphere(0.4, 3), white, translation=[0.15, 0.4, 0.45])
    glb.part("cylinder", shapes.cylinder(0.3, 0.9, 32), blue, translation=[0.85, 0, -0.45])
    glb.part("slab", shapes.box((0.5, 0.06, 0.5), None), white, translation=[-0.55, 0, 1.0])

    glb.camera("front", (0.3, 1.5, 4.1), (0, 0.3, 0.1), 42)
    glb.directional_light("sun", (0.6, -1.0, -0.45), (1, 1, 1), round(math.pi, 6))
    return glb
