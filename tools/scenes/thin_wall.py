"""A room cut in two by a wall of 1 cm, thinner than a voxel of 256^3. The sun lights one half only."""
import math

from . import shapes
from .glb import Glb

HEIGHT, THICKNESS = 2.5, 0.01  # metres


def build():
    """The dark half (x < 0) is black.

    The sun comes over the back wall and travels towards +X -> -X and +Z: it enters where the lit half has no
    ceiling, and never through the open front. The front (+Z) is open for the camera. The room is convex and the wall
    cuts all of it, so every straight line from one half to the other meets the wall, and what leaves through the
    front does not come back: direct and indirect light in the dark half are exactly 0 after any number of bounces.
    """
    glb = Glb("tools/make_assets.py")
    white, orange = glb.material("white", (0.7, 0.7, 0.7)), glb.material("orange", (0.7, 0.35, 0.1))

    # Floor, back, right, left, and the ceiling of the dark half.
    room = shapes.quads(((-2, 0, 2), (4, 0, 0), (0, 0, -4)), ((-2, 0, -2), (4, 0, 0), (0, HEIGHT, 0)),
                        ((2, 0, -2), (0, 0, 4), (0, HEIGHT, 0)), ((-2, 0, 2), (0, 0, -4), (0, HEIGHT, 0)),
                        ((-2, HEIGHT, -2), (2 + THICKNESS / 2, 0, 0), (0, 0, 4)))
    glb.part("room", room, white)
    glb.part("wall", shapes.box((THICKNESS, HEIGHT, 4), None), orange)

    glb.camera("front", (0, 1.35, 6.2), (0, 1.2, 0), 46)
    glb.camera("dark half", (-1.7, 1.6, 1.9), (0.0, 0.9, -0.6), 65)
    glb.directional_light("sun", (-0.5, -1.0, 0.25), (1, 1, 1), round(math.pi, 6))
    return glb
