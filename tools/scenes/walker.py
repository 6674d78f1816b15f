"""A figure that walks out of the sun, through a door, into a room: 4 s."""
import math

from . import figure, shapes
from .glb import Glb

SECONDS = 4


def build():
    glb = Glb("tools/make_assets.py")
    white, brick, blue = (glb.material(name, color) for name, color in (
        ("white", (0.75, 0.75, 0.72)), ("brick", (0.6, 0.2, 0.12)), ("blue", (0.12, 0.25, 0.6))))

    # Fronts face the camera's side and the inside; the front (+Z) is open.
    plaster = shapes.quads(((-2.4, 0, 1.2), (4.8, 0, 0), (0, 0, -2.4)),  # floor
                           ((-2.4, 0, -1.2), (2.3, 0, 0), (0, 2.5, 0)),  # back of the room
                           ((-2.4, 0, 1.2), (0, 0, -2.4), (0, 2.5, 0)),  # its far end
                           ((-2.4, 2.5, -1.2), (2.3, 0, 0), (0, 0, 2.4)))  # ceiling
    glb.part("room", plaster, white)
    glb.part("roof", shapes.box((2.3, 0.1, 2.4), None), white, translation=[-1.25, 2.5, 0])
    glb.part("yard", shapes.quads(((-0.1, 0, -1.2), (2.5, 0, 0), (0, 2.5, 0))), brick)
    # The wall with the door, which is 1.1 m wide and 2.1 m high: two posts and what is over it.
    for name, size, place in (("post behind", (0.2, 2.5, 0.65), (0, 0, -0.875)), ("post before", (0.2, 2.5, 0.65), (0, 0, 0.875)),
                              ("lintel", (0.2, 0.4, 1.1), (0, 2.1, 0))):
        glb.part(name, shapes.box(size, None), white, translation=list(place))

    nodes = figure.add(glb, blue)
    figure.walk(glb, "walk", nodes, SECONDS, (1.7, 0.0), (-3.2, 0.0), 4)
    glb.camera("front", (-0.6, 1.55, 5.6), (-0.1, 1.1, 0), 38)
    glb.directional_light("sun", (-1.0, -0.62, -0.12), (1, 0.95, 0.85), round(2 * math.pi, 6))
    return glb
