"""Meshes as plain lists. Counter-clockwise is front, normals are unit length, uv (0, 0) is the upper left."""
import math
from dataclasses import dataclass, field


@dataclass
class Shape:
    positions: list = field(default_factory=list)
    normals: list = field(default_factory=list)
    uvs: list = field(default_factory=list)
    indices: list = field(default_factory=list)

    def append(self, other, by=(0, 0, 0)):
        """Adds another shape, moved; texture coordinates are not taken."""
        self.indices += [len(self.positions) + i for i in other.indices]
        self.positions += [tuple(c + o for c, o in zip(p, by)) for p in other.positions]
        self.normals += other.normals


def unit(v):
    length = math.sqrt(sum(x * x for x in v))
    return tuple(x / length for x in v)


def add_quad(shape, origin, u, v, uv_size=None):
    """The parallelogram origin, +u, +u+v, +v; its normal is u x v. `uv_size`: texture repeats along u and v."""
    corners = [(0, 0), (1, 0), (1, 1), (0, 1)]
    normal = unit((u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]))
    first = len(shape.positions)
    for a, b in corners:
        shape.positions.append(tuple(o + a * p + b * q for o, p, q in zip(origin, u, v)))
        shape.normals.append(normal)
        if uv_size:
            shape.uvs.append((a * uv_size[0], (1 - b) * uv_size[1]))
    shape.indices += [first + i for i in (0, 1, 2, 0, 2, 3)]


def quads(*parallelograms):
    """Each of (origin, u, v)."""
    shape = Shape()
    for origin, u, v in parallelograms:
        add_quad(shape, origin, u, v)
    return shape


def room(half):
    """The six sides of a cube around the origin, facing inwards."""
    h, w = half, 2 * half
    return quads(((-h, -h, h), (w, 0, 0), (0, 0, -w)), ((-h, h, -h), (w, 0, 0), (0, 0, w)), ((-h, -h, -h), (w, 0, 0), (0, w, 0)),
                 ((h, -h, h), (-w, 0, 0), (0, w, 0)), ((-h, -h, h), (0, 0, -w), (0, w, 0)), ((h, -h, -h), (0, 0, w), (0, w, 0)))


def box(size, metres_per_repeat):
    """A closed box, centred on x and z, on y = 0. `metres_per_repeat`: size of its texture, None for no texture."""
    w, h, d = size
    x, z = w / 2, d / 2
    shape = Shape()
    for origin, u, v, lengths in (
            ((-x, 0, z), (w, 0, 0), (0, h, 0), (w, h)), ((x, 0, -z), (-w, 0, 0), (0, h, 0), (w, h)),
            ((x, 0, z), (0, 0, -d), (0, h, 0), (d, h)), ((-x, 0, -z), (0, 0, d), (0, h, 0), (d, h)),
            ((-x, h, z), (w, 0, 0), (0, 0, -d), (w, d)), ((-x, 0, -z), (w, 0, 0), (0, 0, d), (w, d))):
        add_quad(shape, origin, u, v, [s / metres_per_repeat for s in lengths] if metres_per_repeat else None)
    return shape


def icosphere(radius, subdivisions):
    """An icosahedron with a vertex at each pole (so that it touches what it rests on), subdivided."""
    y, r = 1 / math.sqrt(5), 2 / math.sqrt(5)
    ring = [(math.cos(k * math.pi / 5), math.sin(k * math.pi / 5)) for k in range(10)]
    points = [(0, 1, 0)] + [(r * ring[2 * k][0], y, -r * ring[2 * k][1]) for k in range(5)]
    points += [(r * ring[2 * k + 1][0], -y, -r * ring[2 * k + 1][1]) for k in range(5)] + [(0, -1, 0)]
    triangles = []
    for k in range(5):
        a, b, c, d = 1 + k, 1 + (k + 1) % 5, 6 + k, 6 + (k + 1) % 5
        triangles += [(0, a, b), (a, c, b), (b, c, d), (c, 11, d)]
    for _ in range(subdivisions):
        middles, finer = {}, []

        def middle(i, j):
            key = (min(i, j), max(i, j))
            if key not in middles:
                middles[key] = len(points)
                points.append(unit([p + q for p, q in zip(points[i], points[j])]))
            return middles[key]

        for a, b, c in triangles:
            ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
            finer += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
        triangles = finer
    return Shape([tuple(radius * x for x in p) for p in points], points, [], [i for t in triangles for i in t])


def torus(major, minor, around, across):
    """A torus about the y axis. Vertices are shared all around, so the surface is closed."""
    shape = Shape()
    for i in range(around):
        a = 2 * math.pi * i / around
        for j in range(across):
            b = 2 * math.pi * j / across
            shape.positions.append(((major + minor * math.cos(b)) * math.cos(a), minor * math.sin(b),
                                    -(major + minor * math.cos(b)) * math.sin(a)))
            shape.normals.append((math.cos(b) * math.cos(a), math.sin(b), -math.cos(b) * math.sin(a)))
            k, n = (i + 1) % around, (j + 1) % across
            p, q, r, s = i * across + j, k * across + j, k * across + n, i * across + n
            shape.indices += [p, q, r, p, r, s]
    return shape


def lathe(profile, segments):
    """A surface of revolution. `profile`: (radius, y) from the bottom up, for a surface that faces outwards."""
    shape = Shape()
    for row, (radius, y) in enumerate(profile):
        below, above = profile[max(row - 1, 0)], profile[min(row + 1, len(profile) - 1)]
        slope = unit((above[1] - below[1], below[0] - above[0]))  # the profile's tangent, turned outward
        for i in range(segments + 1):
            a = 2 * math.pi * i / segments
            c, s = math.cos(a), -math.sin(a)
            shape.positions.append((radius * c, y, radius * s))
            shape.normals.append((slope[0] * c, slope[1], slope[0] * s))
            shape.uvs.append((i / segments, 1 - row / (len(profile) - 1)))
    for row in range(len(profile) - 1):
        for i in range(segments):
            p = row * (segments + 1) + i
            q = p + segments + 1
            # A row on the axis is a point: one of the two triangles is empty there.
            shape.indices += [p, p + 1, q + 1] if profile[row][0] > 0 else []
            shape.indices += [p, q + 1, q] if profile[row + 1][0] > 0 else []
    return shape


def tube_strip(radius, height, segments, repeats):
    """The side of a cylinder on y = 0, as one triangle strip with an index for each corner."""
    shape = Shape()
    for i in range(segments + 1):
        a = 2 * math.pi * i / segments
        c, s = math.cos(a), -math.sin(a)
        for y, v in ((height, 0.0), (0.0, 1.0)):
            shape.positions.append((radius * c, y, radius * s))
            shape.normals.append((c, 0, s))
            shape.uvs.append((repeats * i / segments, v * 2))
    shape.indices = list(range(2 * (segments + 1)))
    return shape


def disc_fan(radius, y, segments):
    """A disc that faces up, as a triangle fan without indices."""
    shape = Shape([(0, y, 0)], [(0, 1, 0)], [(0.5, 0.5)])
    for i in range(segments + 1):
        a = 2 * math.pi * i / segments
        shape.positions.append((radius * math.cos(a), y, -radius * math.sin(a)))
        shape.normals.append((0, 1, 0))
        shape.uvs.append((0.5 + 0.5 * math.cos(a), 0.5 - 0.5 * math.sin(a)))
    return shape


def cylinder(radius, height, segments):
    """A closed cylinder about the y axis, on y = 0. The side is smooth, the two ends are flat."""
    shape = Shape()
    ring = [(math.cos(2 * math.pi * i / segments), -math.sin(2 * math.pi * i / segments)) for i in range(segments + 1)]
    for c, s in ring:
        shape.positions += [(radius * c, 0, radius * s), (radius * c, height, radius * s)]
        shape.normals += [(c, 0, s)] * 2
    for i in range(0, 2 * segments, 2):
        shape.indices += [i, i + 2, i + 3, i, i + 3, i + 1]
    for y, up in ((0, -1), (height, 1)):
        middle = len(shape.positions)
        shape.positions += [(0, y, 0)] + [(radius * c, y, radius * s) for c, s in ring]
        shape.normals += [(0, up, 0)] * (segments + 2)
        for i in range(1, segments + 1):
            shape.indices += [middle, middle + i, middle + i + 1] if up > 0 else [middle, middle + i + 1, middle + i]
    return shape
