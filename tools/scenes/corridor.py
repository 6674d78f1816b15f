"""A corridor of 12 m with columns along both sides. The sun enters through its far end only."""
import math

from . import shapes
from .glb import Glb

HALF_WIDTH, HEIGHT, HALF_LENGTH = 1.4, 2.6, 6.0  # metres


def build():
    """Open at -Z only; the wall behind the camera (+Z) is beyond the sun's reach of HEIGHT / 0.32 = 8.1 m."""
    glb = Glb("tools/make_assets.py")
    plaster, stone, red, green = (glb.material(*m) for m in (
        ("plaster", (0.72, 0.7, 0.66)), ("stone", (0.55, 0.52, 0.48)), ("red", (0.6, 0.12, 0.08)),
        ("green", (0.15, 0.45, 0.15))))

    w, h, d = HALF_WIDTH, HEIGHT, HALF_LENGTH
    # Floor, ceiling, and the wall behind the camera.
    plain = shapes.quads(((-w, 0, d), (2 * w, 0, 0), (0, 0, -2 * d)), ((-w, h, -d), (2 * w, 0, 0), (0, 0, 2 * d)),
                         ((w, 0, d), (-2 * w, 0, 0), (0, h, 0)))
    left, right = shapes.quads(((-w, 0, d), (0, 0, -2 * d), (0, h, 0))), shapes.quads(((w, 0, -d), (0, 0, 2 * d), (0, h, 0)))
    glb.node("corridor", mesh=glb.mesh("corridor", glb.primitive(plain, plaster), glb.primitive(left, red),
                                       glb.primitive(right, green)))

    column = glb.mesh("column", glb.primitive(shapes.cylinder(0.16, h, 24), stone))
    for side in (-1, 1):
        for i in range(5):
            glb.node(f"column {'left' if side < 0 else 'right'} {i + 1}", mesh=column,
                     translation=[side * 0.95, 0, -4.8 + 2.4 * i])

    glb.camera("dark end", (0, 1.5, 5.7), (0, 1.25, -6), 62)
    glb.directional_light("sun", (-0.2, -0.32, 1.0), (1, 1, 1), round(4 * math.pi, 6))
    return glb
