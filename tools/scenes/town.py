"""A town of 126 m: streets, houses with rooms, an arcaded court, a square with stalls, a stairwell, and a figure that walks.

It is larger than one cube of voxels resolves: at 128 voxels a side each one is a metre wide, and walls are 10 to 20 cm thick.
Buildings are closed and stand 30 cm deep in the ground, so that no light passes below or between their parts.
"""
import itertools
import math

from . import figure, shapes
from .blocks import Blocks
from .glb import Glb, axis_angle
from .radiance import picture

STOREY, SLAB, WALL, INNER = 3.0, 0.2, 0.2, 0.12
GROUND_FLOOR = 0.1  # of houses, above the street
COLORS = {
    "paving": (0.45, 0.42, 0.38), "stone": (0.66, 0.6, 0.5), "trim": (0.72, 0.7, 0.66), "lining": (0.76, 0.74, 0.7),
    "boards": (0.38, 0.24, 0.13), "tiles": (0.5, 0.18, 0.1), "slate": (0.2, 0.22, 0.26), "wood": (0.3, 0.19, 0.1),
    "red": (0.6, 0.08, 0.06), "green": (0.12, 0.42, 0.14), "blue": (0.1, 0.2, 0.55), "yellow": (0.75, 0.55, 0.12),
    "cream": (0.74, 0.66, 0.5), "rose": (0.68, 0.4, 0.34), "white": (0.78, 0.76, 0.72), "ochre": (0.66, 0.44, 0.18),
    "sky blue": (0.4, 0.52, 0.62), "leaves": (0.1, 0.3, 0.06), "iron": (0.08, 0.08, 0.09),
}
SKY = (0.26, 0.34, 0.46)


def sky():
    """One colour from everywhere. The ground hides the lower half."""
    return picture(4, lambda x, y, z: SKY)


class Town:
    def __init__(self):
        self.glb = Glb("tools/make_assets.py")
        self.materials = {name: self.glb.material(name, color) for name, color in COLORS.items()}
        self.materials["lantern"] = self.glb.material("lantern", (0.1, 0.1, 0.1), emissive=((1.0, 0.7, 0.35), 8.0, None))
        self.primitives = {}  # by name: (material, primitive), shared by all its meshes

    def place(self, name, build, position, turn=0, **painted):
        """Adds a node with what `build` returns (material -> Shape), once built for each name. `turn`: degrees about the
        vertical. `painted`: other materials for those of these names."""
        if name not in self.primitives:
            self.primitives[name] = [(m, self.glb.primitive(shape, None)) for m, shape in build().items()]
        mesh = self.glb.mesh(name, *({**primitive, "material": self.materials[painted.get(m, m)]}
                                     for m, primitive in self.primitives[name]))
        turned = {"rotation": axis_angle((0, 1, 0), turn)} if turn else {}
        self.glb.node(name, mesh=mesh, translation=[round(c, 6) for c in position], **turned)


def ground_and_wall():
    """The street is at y = 0. A wall of 6 m is around the town."""
    blocks = Blocks()
    blocks.fill("paving", (-63, -1, -52), (63, 0, 52))
    blocks.fill("stone", (-63, 0, -52), (63, 6, 52))
    blocks.carve((-62, 0, -51), (62, 6, 51))
    return blocks.shapes()


def single(material, shape):
    return lambda: {material: shape}


def merged(*parts):
    """Material -> Shape of parts (material, Shape, offset)."""
    result = {}
    for material, shape, by in parts:
        result.setdefault(material, shapes.Shape()).append(shape, by)
    return result


def prism(profile, length):
    """A closed prism along x, centred. `profile`: a convex polygon of (z, y), counter-clockwise seen from -x."""
    shape, half = shapes.Shape(), length / 2
    for (z0, y0), (z1, y1) in zip(profile, profile[1:] + profile[:1]):
        shapes.add_quad(shape, (-half, y0, z0), (length, 0, 0), (0, y1 - y0, z1 - z0))
    for x, normal in ((-half, -1), (half, 1)):
        first = len(shape.positions)
        shape.positions += [(x, y, z) for z, y in profile]
        shape.normals += [(normal, 0, 0)] * len(profile)
        for i in range(1, len(profile) - 1):
            shape.indices += [first, first + i, first + i + 1] if normal < 0 else [first, first + i + 1, first + i]
    return shape


def gable(width, depth, rise, eaves=0.5):
    """A roof that is closed below, with its ridge along x. It reaches `eaves` beyond the walls."""
    half, edge = depth / 2 + eaves, 0.18
    return prism([(-half, 0), (half, 0), (half, edge), (0, rise), (-half, edge)], width + 2 * eaves)


def evenly(length, spacing):
    """Places along a wall that leave a margin at its ends."""
    count = max(int((length - 1.2) / spacing), 1)
    return [length * ((i + 0.5) / count - 0.5) for i in range(count)]


def windows(blocks, y, width, depth, door):
    """Carves windows of a storey whose floor is at `y`; a door takes the place of the window nearest to the middle."""
    bottom, top = y + 0.9, y + 2.2
    across, along = evenly(width, 3.2), evenly(depth, 5.0)
    for side in (-1, 1):
        near, far = sorted((side * depth / 2, side * (depth / 2 - WALL)))
        for x in across:
            if door and side > 0 and x == min(across, key=abs):
                blocks.carve((x - 0.55, y, near), (x + 0.55, y + 2.15, far))
                continue
            blocks.carve((x - 0.55, bottom, near), (x + 0.55, top, far))
            if door and side > 0:
                blocks.fill("trim", (x - 0.03, bottom, near + 0.07), (x + 0.03, top, far - 0.07))
        near, far = sorted((side * width / 2, side * (width / 2 - WALL)))
        for z in along:
            blocks.carve((near, bottom, z - 0.45), (far, top, z + 0.45))


def shell(width, depth, storeys):
    """Walls, floors, ceilings and ledges of a house that faces +Z."""
    blocks, top = Blocks(), storeys * STOREY + GROUND_FLOOR
    x, z = width / 2, depth / 2
    blocks.fill("plaster", (-x, -0.3, -z), (x, top, z))
    for s in range(1, storeys):
        y = s * STOREY + GROUND_FLOOR
        blocks.fill("trim", (-x - 0.08, y - 0.2, -z - 0.08), (x + 0.08, y, z + 0.08))
    blocks.fill("lining", (-x + WALL / 2, 0, -z + WALL / 2), (x - WALL / 2, top - 0.1, z - WALL / 2))
    for s in range(storeys):
        y = s * STOREY + GROUND_FLOOR
        low, high = (-x + WALL, y, -z + WALL), (x - WALL, y + STOREY - SLAB, z - WALL)
        blocks.fill("boards", (low[0], y - 0.05, low[2]), (high[0], y, high[2]))
        blocks.carve(low, high)
    return blocks


def house(width, depth, storeys, roof="tiles"):
    blocks, top = shell(width, depth, storeys), storeys * STOREY + GROUND_FLOOR
    x, z = width / 2, depth / 2
    for s in range(storeys):
        y = s * STOREY + GROUND_FLOOR
        ceiling = y + STOREY - SLAB
        at = 0.12 * width
        blocks.fill("paint", (at, y, -z + WALL), (at + INNER, ceiling, z - WALL))
        blocks.carve((at, y, 0.3), (at + INNER, y + 2.1, 1.2))
        blocks.fill("lining", (-x + WALL, y, -1.2), (at, ceiling, -1.2 + INNER))
        blocks.carve((-1.6, y, -1.2), (-0.7, y + 2.1, -1.2 + INNER))
        windows(blocks, y, width, depth, s == 0)
    if roof == "flat":
        blocks.fill("plaster", (-x, top, -z), (x, top + 0.8, z))
        blocks.carve((-x + WALL, top, -z + WALL), (x - WALL, top + 0.8, z - WALL))
        return blocks.shapes()
    rise = 0.35 * depth
    return merged(*((m, shape, (0, 0, 0)) for m, shape in blocks.shapes().items()),
                  (roof, gable(width, depth, rise), (0, top - 0.06, 0)))


# The stair house: flights along z on both sides of a low wall, each half a turn, in a stairwell without windows.
STAIR_WIDTH, STAIR_DEPTH, STAIR_STOREYS, STEPS = 8.0, 7.6, 4, 15


def stair_house():
    blocks = shell(STAIR_WIDTH, STAIR_DEPTH, STAIR_STOREYS)
    x, z, run, rise = STAIR_WIDTH / 2, STAIR_DEPTH / 2, 0.27, STOREY / STEPS
    inner, middle, start = -0.2, -2.0, -2.0  # the stairwell's wall, the middle of the stairwell, the lowest step of the first flight
    for s in range(STAIR_STOREYS):
        y = s * STOREY + GROUND_FLOOR
        blocks.fill("paint", (inner, y, -z + WALL), (inner + INNER, y + STOREY - SLAB, z - WALL))
        blocks.carve((inner, y, -3.3), (inner + INNER, y + 2.1, -2.3))
        for side, depth in itertools.product((-1, 1), evenly(STAIR_DEPTH, 3.6)):  # of the rooms, on three sides
            near, far = sorted((side * z, side * (z - WALL)))
            blocks.carve((1.2, y + 0.9, near), (2.3, y + 2.2, far))
            blocks.carve((x - WALL, y + 0.9, depth - 0.45), (x, y + 2.2, depth + 0.45))
    for s in range(STAIR_STOREYS - 1):
        y, odd = s * STOREY + GROUND_FLOOR, s % 2
        low, high = (middle + 0.05, inner) if odd else (-x + WALL, middle - 0.05)
        end = start + STEPS * run
        blocks.carve((low, y + STOREY - SLAB, start), (high, y + STOREY, end))
        blocks.fill("paint", (middle - 0.05, y, start), (middle + 0.05, y + 1.1, end))
        for i in range(STEPS - 1):  # the last rise is that to the floor
            near = end - (i + 1) * run if odd else start + i * run
            step = y + (i + 1) * rise
            blocks.fill("stone", (low, max(step - 0.4, y), near), (high, step, near + run))
    blocks.carve((-3.5, GROUND_FLOOR, z - WALL), (-2.4, GROUND_FLOOR + 2.1, z))
    top = STAIR_STOREYS * STOREY + GROUND_FLOOR
    return merged(*((m, shape, (0, 0, 0)) for m, shape in blocks.shapes().items()),
                  ("slate", gable(STAIR_WIDTH, STAIR_DEPTH, 2.6), (0, top - 0.06, 0)))


# The court: 30 m x 18 m x 12 m inside, with two storeys of arcades around an open middle of 22 m x 10 m.
COURT = (15.0, 12.0, 9.0)
LOWER, UPPER = 5.5, 11.2  # undersides of the arcades' ceilings


def court():
    blocks = Blocks()
    x, y, z = COURT
    blocks.fill("stone", (-x - WALL, -0.3, -z - WALL), (x + WALL, y, z + WALL))
    blocks.fill("cream", (-x - WALL / 2, 0, -z - WALL / 2), (x + WALL / 2, y - 0.1, z + WALL / 2))
    blocks.carve((-x, GROUND_FLOOR, -z), (x, y, z))
    for level in (LOWER, UPPER):
        blocks.fill("trim", (-x, level, -z), (x, level + 0.3, z))
        blocks.fill("trim", (-11.5, level - 0.5, -5.5), (11.5, level, 5.5))
    blocks.carve((-11.05, LOWER - 0.5, -5.05), (11.05, y, 5.05))
    floor = LOWER + 0.3
    blocks.fill("stone", (-11.35, floor, -5.35), (11.35, floor + 0.9, 5.35))
    blocks.carve((-11.2, floor, -5.2), (11.2, floor + 0.9, 5.2))
    for at in evenly(2 * x, 3.7):
        for side in (-1, 1):
            near, far = sorted((side * z, side * (z + WALL)))
            blocks.carve((at - 0.6, floor + 0.9, near), (at + 0.6, floor + 3, far))
    blocks.carve((-1.4, GROUND_FLOOR, z), (1.4, 3.4, z + WALL))
    blocks.carve((-x - WALL, GROUND_FLOOR, -1.2), (-x, 3.2, 1.2))
    return blocks.shapes()


def column(radius, height):
    """From 5 cm below its floor to 5 cm above its end, with a base and a capital."""
    wide = 2.5 * radius
    return merged(("stone", shapes.cylinder(radius, height + 0.1, 16), (0, -0.05, 0)),
                  ("stone", shapes.box((wide, 0.35, wide), None), (0, -0.05, 0)),
                  ("stone", shapes.box((wide, 0.27, wide), None), (0, height - 0.25, 0)))


def add_court(town, x, z):
    town.place("court", court, (x, 0, z))
    across = [round(-11.27 + i * 2.8175, 4) for i in range(9)]
    ring = [(a, side) for a in across for side in (-5.27, 5.27)]
    ring += [(side, b) for side in (-11.27, 11.27) for b in (-2.635, 0, 2.635)]
    for a, b in ring:
        town.place("column", lambda: column(0.28, LOWER - 0.5 - GROUND_FLOOR), (x + a, GROUND_FLOOR, z + b))
        town.place("upper column", lambda: column(0.2, UPPER - LOWER - 0.8), (x + a, LOWER + 0.3, z + b))
    cloth = shapes.box((1.9, 2.6, 0.03), None)
    for i, color in enumerate(("red", "green", "blue", "red", "yellow", "green")):
        side = -5.27 if i % 2 else 5.27
        town.place("curtain", single("red", cloth), (x - 9.861 + 2.8175 * (i + (i > 2)), 8.13, z + side), red=color)
    for a, b in ((-13, -7), (13, 7), (0, -7.2)):
        town.place("hanging lantern", single("lantern", shapes.box((0.35, 0.5, 0.35), None)), (x + a, 3.6, z + b))
        town.place("rod", single("iron", shapes.box((0.04, 1.45, 0.04), None)), (x + a, 4.07, z + b))
    town.glb.point_light("arcade lamp", (x - 13, 8.6, z - 7), (1, 0.75, 0.45), 10.0, range=25)


def stall():
    """Four posts of 6 cm, a table with goods, and a cloth of 2 cm that slopes to the front (+Z)."""
    parts = [("wood", shapes.box((0.06, 2.1 if b > 0 else 2.6, 0.06), None), (a, -0.02, b))
             for a in (-1.2, 1.2) for b in (-0.8, 0.8)]
    parts += [("wood", shapes.box((2.2, 0.06, 0.9), None), (0, 0.84, 0.1))]
    parts += [("wood", shapes.box((0.06, 0.9, 0.06), None), (a, -0.02, 0.1 + b)) for a in (-1.0, 1.0) for b in (-0.38, 0.38)]
    parts += [("cloth", prism([(-1.0, 2.64), (1.15, 1.97), (1.15, 1.99), (-1.0, 2.66)], 2.7), (0, 0, 0))]
    for i in range(4):
        parts += [("goods", shapes.box((0.4, 0.1 + 0.05 * i, 0.6), None), (-0.75 + 0.5 * i, 0.89, 0.1))]
        parts += [("fruit", shapes.icosphere(0.09, 0), (-0.75 + 0.5 * i, 1.06 + 0.05 * i, 0.1 + 0.2 * k)) for k in (-1, 0, 1)]
    return merged(*parts)


def basin():
    profile = [(0.0, -0.05), (2.0, -0.05), (2.0, 0.5), (2.1, 0.52), (2.1, 0.62), (1.8, 0.62), (1.8, 0.35), (0.3, 0.35), (0.25, 1.5),
               (0.9, 1.7), (0.95, 1.85), (0.0, 1.8)]
    return {"stone": shapes.lathe(profile, 32)}


def tree():
    return merged(("wood", shapes.cylinder(0.16, 2.6, 10), (0, -0.1, 0)), ("leaves", shapes.icosphere(1.3, 2), (0, 3.2, 0)),
                  ("leaves", shapes.icosphere(0.9, 2), (0.7, 2.7, 0.4)))


def street_lamp():
    return merged(("iron", shapes.cylinder(0.06, 3.5, 10), (0, -0.1, 0)), ("lantern", shapes.box((0.3, 0.4, 0.3), None), (0, 3.38, 0)),
                  ("iron", shapes.box((0.4, 0.06, 0.4), None), (0, 3.77, 0)))


def bell_tower():
    blocks = Blocks()
    blocks.fill("stone", (-2.5, -0.3, -2.5), (2.5, 18, 2.5))
    for low, high in ((GROUND_FLOOR, 5), (5.2, 12), (12.2, 17.7)):
        blocks.carve((-2.3, low, -2.3), (2.3, high, 2.3))
    for a, b in ((-2.5, -2.3), (2.3, 2.5)):
        blocks.carve((-1.2, 13.5, a), (1.2, 16.8, b))
        blocks.carve((a, 13.5, -1.2), (b, 16.8, 1.2))
    blocks.carve((-0.6, GROUND_FLOOR, 2.3), (0.6, 2.4, 2.5))
    return merged(*((m, shape, (0, 0, 0)) for m, shape in blocks.shapes().items()),
                  ("slate", prism([(-2.9, 0), (2.9, 0), (2.9, 0.2), (0, 4.2), (-2.9, 0.2)], 5.8), (0, 17.94, 0)))


HOUSES = {"A": (10, 9, 2, "tiles"), "B": (12, 10, 2, "tiles"), "C": (8, 9, 3, "slate"), "D": (9, 8, 1, "tiles"), "E": (11, 10, 3, "flat")}
PLASTERS, PAINTS = ("cream", "rose", "white", "ochre", "sky blue"), ("red", "white", "green", "yellow", "blue")
ALLEY = 1.4


def add_row(town, kinds, start, front, faces, seed=0):
    """Houses from x = `start`, with their fronts at z = `front`; `faces` is 1 towards +Z and -1 towards -Z."""
    x = start
    for i, kind in enumerate(kinds):
        width, depth, *_ = HOUSES[kind]
        number = seed + 3 * i + len(kinds)
        town.place(f"house {kind}", lambda k=kind: house(*HOUSES[k]), (x + width / 2, 0, front - faces * depth / 2),
                   0 if faces > 0 else 180, plaster=PLASTERS[number % 5], paint=PAINTS[(number + i) % 5])
        x += width + ALLEY


def add_square(town):
    """South of the main street, x from -50 to -17."""
    for i, (x, z, turn) in enumerate(((-44, 10, 0), (-39, 10.4, 0), (-34, 10, 0), (-46, 17, 90), (-46, 22, 90), (-24, 27, 180),
                                      (-29, 27.4, 180), (-34, 27, 180), (-20, 18, -90))):
        town.place("stall", stall, (x, 0, z), turn, cloth=PAINTS[i % 5], goods=PLASTERS[i % 5], fruit=PAINTS[(i + 2) % 5])
    town.place("basin", basin, (-33, 0, 18.5))
    for x, z in ((-22, 9), (-27, 12), (-41, 27.5)):
        town.place("tree", tree, (x, 0, z), 40 * (x % 7))
    town.place("bell tower", bell_tower, (-47, 0, 29.5), 180)


INTERIOR, STAIRS, COURT_AT = (-12.0, -10.0), (-24.0, -8.8), (21.0, -14.5)  # x and z of the middle


def add_interior(town):
    """Furniture and a lamp on the other side of the painted wall."""
    x, z = INTERIOR
    for size, place, material in (((1.6, 0.06, 0.9), (-3.2, 0.8, 2.2), "wood"), ((1.0, 0.75, 0.4), (-5.2, 0.08, -0.7), "wood"),
                                  ((0.5, 0.5, 0.5), (-1.4, 0.08, 3.4), "blue"), ((2.0, 0.5, 1.0), (4.2, 0.08, -3.9), "red")):
        town.place(f"{material} furniture {size[0]}", single(material, shapes.box(size, None)), (x + place[0], place[1], z + place[2]))
    for a, b in itertools.product((-3.9, -2.5), (1.85, 2.55)):
        town.place("table leg", single("wood", shapes.box((0.06, 0.76, 0.06), None)), (x + a, 0.06, z + b))
    town.place("globe", single("lantern", shapes.icosphere(0.14, 2)), (x + 3.6, 2.2, z + 0.9))
    town.glb.point_light("interior lamp", (x + 3.6, 1.9, z + 0.9), (1, 0.8, 0.55), 9.0, range=25)


def build():
    town = Town()
    glb = town.glb
    town.place("ground and wall", ground_and_wall, (0, 0, 0))
    add_row(town, "ACE", -60.5, -5, 1)
    town.place("stair house", stair_house, (STAIRS[0], 0, STAIRS[1]), plaster="white", paint="rose")
    add_row(town, "B", INTERIOR[0] - 6, -5, 1, 1)
    add_row(town, "AD", 38, -5, 1, 2)
    add_court(town, *COURT_AT)
    add_row(town, "DADD", -59.5, -27, -1, 3)
    add_row(town, "BADDEADADDD", -59.5, -38, 1, 1)
    add_row(town, "AEDBAC", -14, 5, -1, 4)
    add_row(town, "DBDDDD", -14, 22, -1, 2)
    add_row(town, "DDCDDDBADDD", -59.5, 36, -1, 0)
    add_square(town)
    add_interior(town)
    glb.point_light("stair lamp", (STAIRS[0] - 1.2, 2 * STOREY + 1.5, STAIRS[1] + 2.5), (1, 0.85, 0.6), 15.0, range=25)
    for x, z in ((-12, -4.2), (4, 4.2), (28, -4.2), (-38, 6)):
        town.place("street lamp", street_lamp, (x, 0, z))
    for name, place, color in (("square lamp", (-33, 3.0, 23), (1, 0.7, 0.4)), ("south lamp", (20, 2.2, 10), (1, 0.85, 0.6)),
                               ("upper lamp", (-9, 5.4, -11), (0.7, 0.8, 1))):
        glb.point_light(name, place, color, 8.0, range=20)

    nodes = figure.add(glb, town.materials["blue"])
    figure.walk(glb, "walk", nodes, 16, (6.4, 0.0), (-12.8, 0.0), 16)
    glb.camera("street", (9.5, 1.7, 1.8), (-8, 2.0, -0.6), 55)
    cx, cz = COURT_AT
    glb.camera("court", (cx + 10.7, 1.8, cz - 1.4), (cx - 6, 4.6, cz + 0.4), 68)
    ix, iz = INTERIOR
    glb.camera("interior", (ix - 5.5, 1.65, iz - 0.35), (ix - 2.5, 1.5, iz + 2.65), 77)
    sx, sz = STAIRS
    glb.camera("stairs", (sx - 2.9, STOREY + 1.7, sz - 3.3), (sx - 1.6, STOREY + 2.2, sz + 1), 70)
    glb.directional_light("sun", (-0.55, -1.0, -0.6), (1.0, 0.93, 0.8), round(1.3 * math.pi, 6))
    return glb
