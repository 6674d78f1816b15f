"""A room with a hundred balls, of which none, some or all move, or the light, or the camera."""
import math

from . import shapes
from .glb import Glb, axis_angle, product

SECONDS = 2
ALONG_A_SIDE = 10
COUNT = ALONG_A_SIDE ** 2


def build(moving=0, turn_light=0, turn_camera=0):
    """4 m x 3 m x 4 m, open at +Z. `moving`: how many of the balls slide by 0.2 m. Light and camera turn by degrees."""
    glb = Glb("tools/scenes/balls.py")
    white, red = (glb.material(name, color) for name, color in (("white", (0.7,) * 3), ("red", (0.7, 0.1, 0.1))))
    walls = (((-2, 0, 2), (4, 0, 0), (0, 0, -4)), ((-2, 0, -2), (4, 0, 0), (0, 3, 0)),
             ((2, 0, -2), (0, 0, 4), (0, 3, 0)), ((-2, 0, 2), (0, 0, -4), (0, 3, 0)))
    for i, wall in enumerate(walls):
        glb.part(f"wall {i}", shapes.quads(wall), white)
    ball = glb.mesh("ball", glb.primitive(shapes.icosphere(0.1, 2), red))
    for i in range(COUNT):
        place = (-1.7 + 0.37 * (i % ALONG_A_SIDE), 0.12, -1.7 + 0.37 * (i // ALONG_A_SIDE))
        node = glb.node(f"ball {i}", mesh=ball, translation=list(place))
        # From the middle of the room on, in the order of the nodes.
        if (i + COUNT // 2) % COUNT < moving:
            glb.animate("run", node, "translation", [0, SECONDS],
                        [place, (place[0] + 0.2, place[1] + 0.1, place[2])])
    camera = glb.camera("front", (0, 2.2, 5.5), (0, 1.0, 0), 45)
    light = glb.directional_light("sun", (-0.4, -1.0, -0.6), (1, 1, 1), round(math.pi, 6))
    for node, degrees in ((camera, turn_camera), (light, turn_light)):
        if degrees:
            rotation = glb.json["nodes"][node]["rotation"]
            glb.animate("run", node, "rotation", [0, SECONDS], [rotation, product(axis_angle((0, 1, 0), degrees), rotation)])
    return glb
