"""A white room in which a red box slides and turns, and a lantern swings: 4 s that repeat."""
import math

from . import shapes
from .glb import Glb, axis_angle

SECONDS = 4


def build():
    glb = Glb("tools/make_assets.py")
    white, red, cord = (glb.material(name, color) for name, color in (
        ("white", (0.7, 0.7, 0.7)), ("red", (0.7, 0.03, 0.03)), ("cord", (0.1, 0.1, 0.1))))
    emitter = glb.material("glow", (0.5, 0.4, 0.2), emissive=((1.0, 0.65, 0.25), 2, None))

    # The inside is the front, as in the Cornell box; the front (+Z) is open: floor, ceiling, back, right, left.
    room = shapes.quads(((-1.4, 0, 1), (2.8, 0, 0), (0, 0, -2)), ((-1.4, 2, -1), (2.8, 0, 0), (0, 0, 2)),
                        ((-1.4, 0, -1), (2.8, 0, 0), (0, 2, 0)), ((1.4, 0, -1), (0, 0, 2), (0, 2, 0)),
                        ((-1.4, 0, 1), (0, 0, -2), (0, 2, 0)))
    glb.part("room", room, white)

    # Along the back wall and back again, faster in the middle: a spline through three keys, half a turn on the way.
    box = glb.part("box", shapes.box((0.6, 0.9, 0.6), None), red, translation=[-0.85, 0, -0.45])
    left, right, still = (-0.85, 0, -0.45), (0.85, 0, -0.45), (0, 0, 0)
    glb.animate("run", box, "translation", [0, SECONDS / 2, SECONDS],
                [still, left, still, still, right, still, still, left, still], "CUBICSPLINE")
    glb.animate("run", box, "rotation", [0, 1, 2, 3, 4], [axis_angle((0, 1, 0), d) for d in (0, 90, 180, 90, 0)])

    # The lantern hangs on an arm that turns about the ceiling.
    arm = glb.node("arm", translation=[0.5, 2, 0.35])
    glb.part("cord", shapes.box((0.03, 0.7, 0.03), None), cord, arm, translation=[0, -0.7, 0])
    glb.part("lantern", shapes.box((0.22, 0.26, 0.22), None), emitter, arm, translation=[0, -0.96, 0])
    times = [SECONDS * k / 16 for k in range(17)]
    glb.animate("run", arm, "rotation", times,
                [axis_angle((0, 0, 1), 32 * math.sin(2 * math.pi * t / SECONDS)) for t in times])

    glb.camera("front", (0, 1.0, 4.3), (0, 1.0, 0), 42)
    # Through the open front from the upper right: the box's front is lit everywhere on its way.
    glb.directional_light("sun", (-0.35, -0.5, -1.0), (1, 1, 1), round(math.pi, 6))
    return glb
