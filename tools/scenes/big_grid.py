"""A rolling landscape of as many triangles as wanted, written without Python loops."""
import math

import numpy as np

from .glb import ARRAY_BUFFER, ELEMENT_ARRAY_BUFFER, FLOAT, TRIANGLES, Glb

U32 = 5125


def build(triangles: int) -> bytes:
    """At least `triangles` of them on 59 x 59 units, hills of 6 units."""
    side = math.ceil(math.sqrt(triangles / 2)) + 1  # vertices along an edge
    line = np.linspace(-29.5, 29.5, side, dtype=np.float32)
    x, z = np.meshgrid(line, line)
    y = 3.0 * np.sin(0.4 * x) * np.cos(0.3 * z)
    slope = np.stack([-1.2 * np.cos(0.4 * x) * np.cos(0.3 * z), np.ones_like(x), 0.9 * np.sin(0.4 * x) * np.sin(0.3 * z)], -1)
    normals = slope / np.linalg.norm(slope, axis=-1, keepdims=True)
    corner = (np.arange(side - 1)[:, None] * side + np.arange(side - 1)).reshape(-1)
    a, b, c, d = corner, corner + 1, corner + side, corner + side + 1  # c and d are one row nearer to +Z
    indices = np.stack([a, c, d, a, d, b], -1)

    glb = Glb("tools/hard_cases.py")
    primitive = {"attributes": {"POSITION": _stored(glb, np.stack([x, y, z], -1), "<f4", 3), "NORMAL": _stored(glb, normals, "<f4", 3)},
                 "material": glb.material("earth", (0.5, 0.45, 0.35)), "mode": TRIANGLES, "indices": _stored(glb, indices, "<u4", 1)}
    glb.node("land", mesh=glb.mesh("land", primitive))
    glb.camera("camera", (25, 45, 70), (0, 0, 0), 45)
    glb.directional_light("sun", (-0.5, -1.0, -0.3), (1, 1, 1), round(math.pi, 6))
    return glb.to_bytes()


def _stored(glb: Glb, values: np.ndarray, kind: str, width: int) -> int:
    """An accessor of vectors, or of indices where the width is 1."""
    rows = values.reshape(-1, width).astype(kind)
    component, name, target = ((U32, "SCALAR", ELEMENT_ARRAY_BUFFER) if width == 1 else (FLOAT, "VEC3", ARRAY_BUFFER))
    return glb.accessor(glb._view(rows.tobytes(), target), component, len(rows), name, rows.min(axis=0).tolist(),
                        rows.max(axis=0).tolist())
