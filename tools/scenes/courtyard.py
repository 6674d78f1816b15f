"""A walled courtyard: textures, an alpha mask, an emissive material and 86 nodes of few meshes."""
import math

from . import pictures, shapes
from .glb import FAN, STRIP, TRIANGLES, Glb, axis_angle

REPEAT, MIRRORED, CLAMP = 10497, 33648, 33071
WHITE = (1.0, 1.0, 1.0)


def build():
    glb = Glb("tools/make_assets.py")
    parts = make_meshes(glb)
    glb.node("floor", mesh=parts["floor"])

    court = glb.node("court")
    add_side(glb, parts, court, "east", scale=[1, 1, 1])
    add_side(glb, parts, court, "west", scale=[-1, 1, 1])  # mirrored, which reverses the winding of its triangles
    add_back(glb, parts, court)
    add_garden(glb, parts, court)

    # A matrix instead of translation, rotation and scale: a crate turned by 30 degrees about y, 0.8 of its size.
    c, s = 0.8 * math.cos(math.radians(30)), 0.8 * math.sin(math.radians(30))
    c, s = round(c, 6), round(s, 6)
    glb.node("crate", court, mesh=parts["crate"], matrix=[c, 0, -s, 0, 0, 0.8, 0, 0, s, 0, c, 0, 1.9, 0, 2.6, 1])

    glb.camera("gate", (0.6, 1.9, 7.6), (-0.2, 1.2, 0), 52)
    glb.camera("corner", (-2.0, 2.3, 3.5), (0.7, 0.4, -1.5), 62)
    glb.directional_light("sun", (-0.55, -1.0, -0.4), (1.0, 0.95, 0.85), round(math.pi, 6))
    return glb


def make_meshes(glb):
    paving = glb.texture("paving", pictures.paving(), REPEAT, nearest=True)
    bricks = glb.texture("bricks", pictures.bricks(), REPEAT)
    trellis = glb.texture("trellis", pictures.trellis(), MIRRORED)
    pane = glb.texture("lantern", pictures.lantern(), CLAMP)

    floor = glb.material("paving", WHITE, paving, uv_scale=5.0)
    wall = glb.material("bricks", WHITE, bricks)
    stone = glb.material("stone", (0.6, 0.56, 0.48))
    clay = glb.material("clay", (0.5, 0.2, 0.1))
    wood = glb.material("wood", (0.32, 0.19, 0.09))
    water = glb.material("water", (0.05, 0.2, 0.28))
    leaves = glb.material("trellis", WHITE, trellis, cutoff=0.5)
    emitter = glb.material("lantern", (0.1, 0.1, 0.1), emissive=((1.0, 0.55, 0.2), 6.0, pane))

    ground = shapes.Shape()
    shapes.add_quad(ground, (-4, 0, 4), (8, 0, 0), (0, 0, -8), (1, 1))
    panel = shapes.Shape()
    shapes.add_quad(panel, (-0.75, 0, 0), (1.5, 0, 0), (0, 1.5, 0), (1, 1))
    pot = [(0.0, 0.0), (0.2, 0.0), (0.24, 0.05), (0.29, 0.15), (0.32, 0.27), (0.33, 0.38), (0.32, 0.48),
           (0.35, 0.5), (0.36, 0.53), (0.34, 0.56), (0.3, 0.56), (0.29, 0.5), (0.0, 0.46)]
    basin = [(0.0, 0.0), (1.1, 0.0), (1.1, 0.4), (1.16, 0.42), (1.16, 0.5), (0.98, 0.5), (0.98, 0.3)]
    base = shapes.box((0.5, 0.2, 0.5), 1)

    def mesh(name, shape, material):
        return glb.mesh(name, glb.primitive(shape, material))

    return {
        "floor": mesh("floor", ground, floor),
        "wall": mesh("wall", shapes.box((2, 3, 0.25), 1.6), wall),
        "column": glb.mesh("column", glb.primitive(shapes.tube_strip(0.14, 2.2, 16, 1), stone, STRIP),
                           glb.primitive(base, stone, TRIANGLES)),
        "beam": mesh("beam", shapes.box((1, 1, 1), 1), wood),
        "trellis": mesh("trellis", panel, leaves),
        "pot": mesh("pot", shapes.lathe(pot, 24), clay),
        "basin": glb.mesh("basin", glb.primitive(shapes.lathe(basin, 32), stone),
                          glb.primitive(shapes.disc_fan(0.98, 0.38, 32), water, FAN)),
        "lantern": mesh("lantern", shapes.box((0.22, 0.3, 0.22), 0.3), emitter),
        "crate": mesh("crate", shapes.box((0.8, 0.8, 0.8), 0.8), wood),
    }


def add_side(glb, parts, court, name, scale):
    """Adds a long side: a wall, a colonnade with a beam and a slatted roof, and a lantern at each end."""
    side = glb.node(f"{name} side", court, scale=scale)
    wall = glb.node(f"{name} wall", side, translation=[3.9, 0, 0], rotation=axis_angle((0, 1, 0), 90))
    for i in range(4):
        glb.node(f"{name} wall {i}", wall, mesh=parts["wall"], translation=[2 * i - 3, 0, 0])
    colonnade = glb.node(f"{name} colonnade", side, translation=[2.7, 0, 0])
    for i in range(5):
        glb.node(f"{name} column {i}", colonnade, mesh=parts["column"], translation=[0, 0, 1.6 * i - 3.2])
    glb.node(f"{name} beam", colonnade, mesh=parts["beam"], translation=[0, 2.2, 0], scale=[0.3, 0.25, 7.4])
    for i in range(13):
        glb.node(f"{name} slat {i}", colonnade, mesh=parts["beam"], translation=[0.55, 2.45, 0.56 * i - 3.36],
                 scale=[1.5, 0.12, 0.16])
    for i, z in enumerate((-2.4, 0.8)):
        glb.node(f"{name} lantern {i}", colonnade, mesh=parts["lantern"], translation=[0, 1.85, z])


def add_back(glb, parts, court):
    back = glb.node("back", court, translation=[0, 0, -3.9])
    for i in range(4):
        glb.node(f"back wall {i}", back, mesh=parts["wall"], translation=[2 * i - 3, 0, 0])
    for i in range(2):
        glb.node(f"back trellis {i}", back, mesh=parts["trellis"], translation=[1.8 * i - 0.9, 0.6, 0.35])


def add_garden(glb, parts, court):
    garden = glb.node("garden", court, rotation=axis_angle((0, 1, 0), 12))
    glb.node("basin", garden, mesh=parts["basin"], translation=[0, 0, -0.6])
    for i in range(3):  # a screen in front of the basin, each panel turned a little further
        glb.node(f"screen {i}", garden, mesh=parts["trellis"], translation=[round(1.5 * i - 2.4, 6), 0, 1.7],
                 rotation=axis_angle((0, 1, 0), 14 * (1 - i)), scale=[1, 0.8, 1])
    for i, (x, z) in enumerate(((-1.6, -2.2), (1.6, -2.3), (-1.9, 0.6), (1.9, 0.4))):
        pot = glb.node(f"pot {i}", garden, mesh=parts["pot"], translation=[x, 0, z],
                       scale=[1, 1.1 + 0.2 * (i % 2), 1])
        for k in range(2):  # two crossed sheets of leaves
            glb.node(f"plant {i} {k}", pot, mesh=parts["trellis"], translation=[0, 0.47, 0],
                     rotation=axis_angle((0, 1, 0), 90 * k + 20), scale=[0.45, 0.5, 0.45])
