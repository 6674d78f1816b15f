"""Two rooms and a door between them, which opens within half a second: 2 s. A lamp lights the room behind the door."""
from . import shapes
from .glb import Glb, axis_angle

SECONDS = 2


def build():
    glb = Glb("tools/make_assets.py")
    white, wood = glb.material("white", (0.7, 0.7, 0.7)), glb.material("wood", (0.5, 0.35, 0.2))
    glow = glb.material("glow", (0.5, 0.5, 0.5), emissive=((1, 0.9, 0.8), 8, None))
    glb.part("rooms", shapes.quads(((-4, 0, 1.5), (8, 0, 0), (0, 0, -3)), ((-4, 2.6, -1.5), (8, 0, 0), (0, 0, 3)),
                                   ((-4, 0, -1.5), (8, 0, 0), (0, 2.6, 0)), ((4, 0, 1.5), (-8, 0, 0), (0, 2.6, 0)),
                                   ((4, 0, -1.5), (0, 0, 3), (0, 2.6, 0)), ((-4, 0, 1.5), (0, 0, -3), (0, 2.6, 0))), white)
    # The doorway is 1 m wide and 2.1 m high.
    wall = shapes.Shape()
    for z in (-1, 1):
        wall.append(shapes.box((0.1, 2.6, 1), None), (0, 0, z))
    wall.append(shapes.box((0.1, 0.5, 1), None), (0, 2.1, 0))
    glb.part("wall", wall, white)
    glb.part("lamp", shapes.box((0.5, 0.1, 0.5), None), glow, translation=[-2, 2.4, 0])

    leaf = shapes.Shape()
    leaf.append(shapes.box((0.04, 2.1, 1), None), (0, 0, 0.5))
    hinge = glb.node("hinge", translation=[0, 0, -0.5])
    glb.part("door", leaf, wood, hinge)
    glb.animate("run", hinge, "rotation", [0, 0.5, 0.75, 1, 2], [axis_angle((0, 1, 0), d) for d in (0, 0, 45, 90, 90)])

    glb.camera("dark room", (3.8, 1.6, 1.2), (0.8, 0.9, -0.2), 75)
    return glb
