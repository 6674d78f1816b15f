"""A box with a red wall, a ball and a ring, after the scene of Wahlen's thesis (2016): about 1,300 triangles."""
import math

from . import shapes
from .glb import Glb, axis_angle, tidy

WHITE, RED, YELLOW, GREEN = (0.64, 0.64, 0.64), (0.64, 0.04, 0.04), (0.64, 0.64, 0.08), (0.08, 0.64, 0.24)


def build(scale=1.0):
    """`scale`: metres per unit of the description; 1 makes a box of 2 m. The picture does not depend on it."""
    glb = Glb("tools/make_assets.py")
    root = None if scale == 1 else glb.node("root", scale=[scale] * 3)
    white, red, yellow, green = (glb.material(*m) for m in (
        ("white", WHITE), ("red", RED), ("yellow", YELLOW), ("green", GREEN)))

    # The inside is the front: floor, ceiling, back, right; then left. The front (+Z) is open.
    rest = shapes.quads(((-1, -1, 1), (2, 0, 0), (0, 0, -2)), ((-1, 1, -1), (2, 0, 0), (0, 0, 2)),
                        ((-1, -1, -1), (2, 0, 0), (0, 2, 0)), ((1, -1, -1), (0, 0, 2), (0, 2, 0)))
    left = shapes.quads(((-1, -1, 1), (0, 0, -2), (0, 2, 0)))
    glb.node("box", root, mesh=glb.mesh("box", glb.primitive(rest, white), glb.primitive(left, red)))

    glb.part("ball", shapes.icosphere(0.4, 2), yellow, root, translation=[0.45, -0.6, 0.4])

    # 22 x 22 quads = 968 triangles, as many as the thesis's second object; it floats at the left back.
    glb.part("ring", shapes.torus(0.34, 0.14, 22, 22), green, root, translation=[-0.3, -0.1, -0.25],
             rotation=axis_angle((1, 0, 0.5), 55))

    # At z = 1 the opening is 2 m high and 2.85 m away: 2 atan(1 / 2.85) = 38.7 degrees, and a margin.
    # A camera has no scale, so it does not hang on the root.
    glb.camera("front", (0, 0, tidy(3.85 * scale)), (0, 0, 0), 40, (0.1 * scale, 100.0 * scale))

    # Through the open front from the upper right. It lights nearly all of the red wall (n.l = 0.45), the floor where
    # x < 1 - 0.56 (1 - z) and the lower left of the back wall: red on the floor's dark half, on the ceiling and on the
    # rest of the back wall has come from the red wall.
    glb.directional_light("sun", (-0.5, -0.45, -0.9), (1, 1, 1), round(math.pi, 6))
    return glb
