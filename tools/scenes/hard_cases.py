"""Small scenes in code for tools/hard_cases.py: parts, one light, one camera, and an optional node around all.

Lengths are in voxels of a 64^3 grid where the scene is FRAME wide: vct pads the longest extent by 2.5 voxels on each
side, so that a scene of 59 units has voxels of 1 unit and voxel boundaries at whole coordinates around its centre.
"""
from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any

from . import shapes
from .glb import Glb

FRAME = 59.0  # voxels: 64 - 2 * 2.5 (jni/engine/volume.h)
HALF = FRAME / 2
Vector = tuple[float, float, float]
GREY, RED = (0.6, 0.6, 0.6), (0.6, 0.05, 0.05)
SUN = (-0.5, -1.0, -0.3)  # the direction in which its light travels


@dataclass
class Part:
    shape: shapes.Shape
    color: Vector = GREY
    emits: Vector | None = None
    double_sided: bool = False
    place: dict[str, Any] = field(default_factory=dict)  # glTF node properties


@dataclass
class View:
    eye: Vector
    target: Vector = (0.0, 0.0, 0.0)
    fov_deg: float = 40.0  # vertical


OVERVIEW = View((25, 45, 70), (0, 5, 0), 45)
INSIDE = View((12, 8, 24), (-6, -5, -28), 75)  # of `room`


def make(parts: list[Part], travels: Vector = SUN, view: View = OVERVIEW, lux: float = round(math.pi, 6),
         root: dict[str, Any] | None = None) -> bytes:
    """`root`: glTF properties of a node above everything, camera and light too."""
    glb = Glb("tools/hard_cases.py")
    for i, part in enumerate(parts):
        material = glb.material(f"material {i}", part.color, emissive=(part.emits, 1, None) if part.emits else None)
        if part.double_sided:
            glb.json["materials"][material]["doubleSided"] = True
        glb.part(f"part {i}", part.shape, material, **part.place)
    glb.camera("camera", view.eye, view.target, view.fov_deg)
    glb.directional_light("sun", travels, (1, 1, 1), lux)
    return wrapped(glb, root).to_bytes()


def wrapped(glb: Glb, root: dict[str, Any] | None) -> Glb:
    """Everything of the scene under one more node."""
    if root:
        children = glb.json["scenes"][0]["nodes"]
        glb.json["scenes"][0]["nodes"] = []
        glb.json["nodes"][glb.node("root of all", **root)]["children"] = children
    return glb


def floor(half: float = HALF, y: float = 0.0) -> shapes.Shape:
    return shapes.quads(((-half, y, half), (2 * half, 0, 0), (0, 0, -2 * half)))


def room() -> shapes.Shape:
    return shapes.room(HALF)


def box(size: Vector) -> shapes.Shape:
    return shapes.box(size, None)


def triangles(corners: list[tuple[Vector, Vector, Vector]]) -> shapes.Shape:
    """With normals straight up, wherever they face."""
    positions = [p for triangle in corners for p in triangle]
    return shapes.Shape(positions, [(0, 1, 0)] * len(positions), [], list(range(len(positions))))


def frame_markers() -> Part:
    """Two small triangles that fix the volume to [-32, 32]^3, whatever else is in it."""
    h, s = HALF, 0.5
    return Part(triangles([((-h, -h, -h), (-h + s, -h, -h), (-h, -h, -h + s)), ((h, h, h), (h - s, h, h), (h, h, h - s))]),
                (0.0, 0.0, 0.0))


def rotated(shape: shapes.Shape, axis: int, degrees: float) -> shapes.Shape:
    """Turned about a coordinate axis; written into the vertices."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    i, j = (axis + 1) % 3, (axis + 2) % 3

    def turn(p: Vector) -> Vector:
        q = list(p)
        q[i], q[j] = c * p[i] - s * p[j], s * p[i] + c * p[j]
        return tuple(q)
    return shapes.Shape([turn(p) for p in shape.positions], [turn(n) for n in shape.normals], [], shape.indices)
