"""Buildings of axis-aligned boxes, which are filled and carved in order. The surface of the result is closed: it has no seams, no
faces inside and no vertex in the middle of an edge."""
import itertools

from .shapes import Shape


class Blocks:
    def __init__(self):
        self.boxes = []

    def fill(self, material, low, high):
        """`material`: any name; faces get that of the block behind them."""
        self.boxes.append((material, *([round(c, 6) for c in corner] for corner in (low, high))))

    def carve(self, low, high):
        self.fill(None, low, high)

    def shapes(self):
        """Material -> Shape."""
        cuts = [sorted({corner[axis] for _, *corners in self.boxes for corner in corners}) for axis in range(3)]
        places = [{cut: i for i, cut in enumerate(line)} for line in cuts]
        cells = {}
        for material, low, high in self.boxes:
            spans = [range(place[a], place[b]) for place, a, b in zip(places, low, high)]
            for cell in itertools.product(*spans):
                cells[cell] = material
        solid = {cell: material for cell, material in cells.items() if material is not None}
        faces = [face for axis in range(3) for side in (0, 1) for face in rectangles(solid, axis, side)]
        corners = {corner for _, _, _, border in faces for corner in border}
        result = {}
        for material, axis, side, border in faces:
            add_face(result.setdefault(material, Shape()), axis, side, border, corners, cuts)
        return result


def rectangles(solid, axis, side):
    """Joins the faces towards one direction to rectangles: (material, axis, side, four corners as indices of cuts)."""
    u, v = (axis + 1) % 3, (axis + 2) % 3
    open_faces = {}
    for cell, material in solid.items():
        beside = list(cell)
        beside[axis] += 1 if side else -1
        if tuple(beside) not in solid:
            open_faces[cell[axis] + side, cell[u], cell[v]] = material
    result = []
    for plane, a, b in sorted(open_faces):
        material = open_faces.get((plane, a, b))
        if material is None:
            continue
        wide, high = 1, 1
        while open_faces.get((plane, a, b + wide)) == material:
            wide += 1
        while all(open_faces.get((plane, a + high, b + i)) == material for i in range(wide)):
            high += 1
        for i, k in itertools.product(range(high), range(wide)):
            open_faces[plane, a + i, b + k] = None
        border = []
        for i, k in ((a, b), (a + high, b), (a + high, b + wide), (a, b + wide)):
            corner = [0, 0, 0]
            corner[axis], corner[u], corner[v] = plane, i, k
            border.append(tuple(corner))
        result.append((material, axis, side, border))
    return result


def add_face(shape, axis, side, border, corners, cuts):
    """Adds a rectangle with a vertex at every corner of other rectangles that lies on its border."""
    loop = []
    for start, end in zip(border, border[1:] + border[:1]):
        along = next(i for i in range(3) if start[i] != end[i])
        step = 1 if end[along] > start[along] else -1
        for i in range(start[along], end[along], step):
            point = tuple(i if k == along else c for k, c in enumerate(start))
            if point == start or point in corners:
                loop.append(point)
    points = [tuple(cuts[k][c] for k, c in enumerate(corner)) for corner in loop]
    first, count = len(shape.positions), len(points)
    turns = [(i, (i + 1) % count) for i in range(count)] if side else [((i + 1) % count, i) for i in range(count)]
    if count == 4:
        shape.indices += [first + i for i in ((0, 1, 2, 0, 2, 3) if side else (0, 2, 1, 0, 3, 2))]
    else:
        low, high = (tuple(cuts[k][c] for k, c in enumerate(border[i])) for i in (0, 2))
        points.append(tuple((a + b) / 2 for a, b in zip(low, high)))
        for i, k in turns:
            shape.indices += [first + count, first + i, first + k]
    normal = tuple((1 if side else -1) if k == axis else 0 for k in range(3))
    shape.positions += points
    shape.normals += [normal] * len(points)
