"""A figure of 1.75 m that can walk: a mesh with a skin, and the joints that move it.

It stands on y = 0 and faces -X. Its parts are tubes about their bones. Near a knee, an elbow and the waist vertices follow the
two joints on both sides, smoothly.
"""
import math

from .glb import axis_angle
from .shapes import Shape, unit

# Joint: its parent, and its position in metres in the standing pose.
JOINTS = {
    "pelvis": (None, (0, 0.95, 0)),
    "chest": ("pelvis", (0, 1.15, 0)),
    "head": ("chest", (0, 1.5, 0)),
    **{f"{side} {name}": (f"{side} {parent}" if parent not in ("pelvis", "chest") else parent, (0, y, sign * z))
       for side, sign in (("left", 1), ("right", -1))
       for name, parent, y, z in (("hip", "pelvis", 0.9, 0.1), ("knee", "hip", 0.48, 0.1), ("ankle", "knee", 0.08, 0.1),
                                  ("shoulder", "chest", 1.4, 0.23), ("elbow", "shoulder", 1.12, 0.23))},
}
NAMES = list(JOINTS)


def smooth(x):
    """0 below 0, 1 above 1, a spline between."""
    x = min(max(x, 0), 1)
    return x * x * (3 - 2 * x)


class Body:
    def __init__(self):
        self.shape, self.joints, self.weights = Shape(), [], []

    def tube(self, centre, radii, profile, segments, upper, lower=None, middle=0.0, reach=0.1):
        """Adds a tube about a vertical line through `centre` (x, z). `profile`: (y, factor of `radii` (x, z)), upwards. Above
        `middle` the tube follows the joint `upper`, below it `lower`, and within `reach` of it both."""
        first, rows = len(self.shape.positions), len(profile)
        for row, (y, share) in enumerate(profile):
            below, above = profile[max(row - 1, 0)], profile[min(row + 1, rows - 1)]
            rise, growth = above[0] - below[0], above[1] - below[1]
            weight = smooth((y - middle) / (2 * reach) + 0.5) if lower else 1
            for k in range(segments):
                angle = 2 * math.pi * k / segments
                c, s = math.cos(angle), math.sin(angle)
                self.shape.positions.append((centre[0] + share * radii[0] * c, y, centre[1] + share * radii[1] * s))
                self.shape.normals.append(unit((rise * c / radii[0], -growth, rise * s / radii[1])))
                self.joints.append((NAMES.index(upper), NAMES.index(lower or upper), 0, 0))
                self.weights.append((weight, 1 - weight, 0, 0))
        for row in range(rows - 1):
            for k in range(segments):
                a, b = first + row * segments + k, first + row * segments + (k + 1) % segments
                self.shape.indices += [a, a + segments, b + segments, a, b + segments, b]


def rounded(low, high, low_share, high_share, rows, cap):
    """A profile with round ends of `cap` metres, and `rows` between them."""
    ends = [0.02, 0.38, 0.71, 0.92]
    profile = [(low + cap * (1 - math.sqrt(1 - e * e)), low_share * e) for e in ends]
    for row in range(rows + 1):
        t = row / rows
        profile.append((low + cap + t * (high - low - 2 * cap), low_share + t * (high_share - low_share)))
    return profile + [(high - cap * (1 - math.sqrt(1 - e * e)), high_share * e) for e in reversed(ends)]


def body():
    result = Body()
    result.tube((0, 0), (0.115, 0.17), rounded(0.84, 1.5, 0.95, 1.05, 14, 0.08), 20, "chest", "pelvis", 1.08, 0.12)
    result.tube((0, 0), (0.05, 0.05), rounded(1.42, 1.6, 1, 1, 3, 0.02), 12, "head", "chest", 1.48, 0.04)
    result.tube((-0.01, 0), (0.1, 0.085), rounded(1.52, 1.77, 0.9, 1, 6, 0.1), 20, "head")
    for side, z in (("left", 1), ("right", -1)):
        result.tube((0, 0.1 * z), (0.085, 0.08), rounded(0.05, 0.93, 0.6, 1.05, 22, 0.05), 16, f"{side} hip", f"{side} knee", 0.48)
        result.tube((-0.06, 0.1 * z), (0.14, 0.05), rounded(0.0, 0.09, 1, 0.8, 2, 0.03), 16, f"{side} ankle")
        result.tube((0, 0.23 * z), (0.05, 0.05), rounded(0.78, 1.46, 0.7, 1.1, 16, 0.04), 14, f"{side} shoulder", f"{side} elbow",
                    1.12, 0.07)
    return result


def add(glb, material):
    """Adds the joints as nodes, standing, and the skinned mesh. Returns the joints by name."""
    figure, nodes = body(), {}
    for name, (parent, place) in JOINTS.items():
        above = JOINTS[parent][1] if parent else (0, 0, 0)
        nodes[name] = glb.node(name, nodes.get(parent), translation=[round(p - a, 6) for p, a in zip(place, above)])
    skin = glb.skin("figure", list(nodes.values()), [place for _, place in JOINTS.values()])
    primitive = glb.primitive(figure.shape, material)
    glb.follow_joints(primitive, figure.joints, figure.weights)
    glb.node("figure", mesh=glb.mesh("figure", primitive), skin=skin)
    return nodes


def walk(glb, animation, nodes, seconds, start, way, steps):
    """Animates `steps` double steps while the pelvis moves from `start` by `way`, both (x, z)."""
    keys = 8 * steps
    times = [seconds * k / keys for k in range(keys + 1)]
    phases = [2 * math.pi * k / 8 for k in range(keys + 1)]
    height = JOINTS["pelvis"][1][1]
    glb.animate(animation, nodes["pelvis"], "translation", times,
                [(start[0] + way[0] * t / seconds, height - 0.025 * (1 - math.cos(2 * p)) / 2, start[1] + way[1] * t / seconds)
                 for t, p in zip(times, phases)])

    def swing(joint, degrees):
        glb.animate(animation, nodes[joint], "rotation", times, [axis_angle((0, 0, 1), degrees(p)) for p in phases])

    for side, offset in (("left", 0.0), ("right", math.pi)):
        swing(f"{side} hip", lambda p, o=offset: -27 * math.sin(p + o))
        swing(f"{side} knee", lambda p, o=offset: 8 + 40 * max(math.cos(p + o), 0))
        swing(f"{side} shoulder", lambda p, o=offset: 22 * math.sin(p + o))
        swing(f"{side} elbow", lambda p, o=offset: -20 + 10 * math.sin(p + o))
    swing("chest", lambda p: 2 * math.sin(2 * p))
