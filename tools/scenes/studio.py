"""A room with textures, a lamp on a crate and a figure that walks in place: the scene of examples/engine."""
import math

from . import figure, pictures, shapes
from .glb import Glb

REPEAT = 10497


def build():
    glb = Glb("tools/make_assets.py")
    white = (1.0, 1.0, 1.0)
    paving = glb.material("paving", white, glb.texture("paving", pictures.paving(), REPEAT))
    bricks = glb.material("bricks", white, glb.texture("bricks", pictures.bricks(), REPEAT))
    plaster, blue, wood = (glb.material(name, color) for name, color in (
        ("plaster", (0.75, 0.73, 0.7)), ("blue", (0.12, 0.25, 0.6)), ("wood", (0.4, 0.25, 0.12))))
    shade = glb.material("lamp", (0.5, 0.5, 0.5), emissive=((1.0, 0.75, 0.45), 12.0, None))

    # The front (+Z) is open. The feet sink into the floor, which is so thick that the figure never leaves the room's bounds.
    back = shapes.Shape()
    shapes.add_quad(back, (-2, 0, -1.5), (4, 0, 0), (0, 2.5, 0), (2.5, 1.5))
    glb.part("floor", shapes.box((4, 0.1, 3), 1.0), paving, translation=[0, -0.1, 0])
    glb.part("back", back, bricks)
    glb.part("room", shapes.quads(((-2, 0, 1.5), (0, 0, -3), (0, 2.5, 0)), ((2, 0, -1.5), (0, 0, 3), (0, 2.5, 0)),
                                  ((-2, 2.5, -1.5), (4, 0, 0), (0, 0, 3))), plaster)
    glb.part("crate", shapes.box((0.6, 0.6, 0.6), None), wood, translation=[1.2, 0, -0.6])
    glb.part("lamp", shapes.box((0.2, 0.3, 0.2), None), shade, translation=[1.2, 0.6, -0.6])

    nodes = figure.add(glb, blue)
    figure.walk(glb, "walk", nodes, 1, (-0.5, 0.1), (0.0, 0.0), 1)
    glb.camera("front", (0, 1.35, 5.2), (0, 1.1, 0), 38)
    glb.directional_light("sun", (0.75, -0.7, -0.6), (1, 0.95, 0.85), round(0.6 * math.pi, 6))
    return glb
