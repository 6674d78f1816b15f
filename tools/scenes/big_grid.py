"""A rolling landscape of as many triangles as wanted, written without Python loops."""

from __future__ import annotations

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
    slope = np.stack(
        [-1.2 * np.cos(0.4 * x) * np.cos(0.3 * z), np.ones_like(x), 0.9 * np.sin(0.4 * x) * np.sin(0.3 * z)], -1
    )
    normals = slope / np.linalg.norm(slope, axis=-1, keepdims=True)

    glb = Glb("tools/hard_cases.py")
    attributes = {
        "POSITION": _accessor(glb, np.stack([x, y, z], -1).reshape(-1, 3).astype("<f4"), FLOAT, "VEC3"),
        "NORMAL": _accessor(glb, normals.reshape(-1, 3).astype("<f4"), FLOAT, "VEC3"),
    }
    corner = (np.arange(side - 1)[:, None] * side + np.arange(side - 1)).reshape(-1)
    a, b, c, d = corner, corner + 1, corner + side, corner + side + 1  # c and d are one row nearer to +Z
    indices = np.stack([a, c, d, a, d, b], -1).reshape(-1, 1).astype("<u4")
    material = glb.material("earth", (0.5, 0.45, 0.35))
    primitive = {
        "attributes": attributes,
        "material": material,
        "mode": TRIANGLES,
        "indices": _accessor(glb, indices, U32, "SCALAR"),
    }
    glb.node("land", mesh=glb.mesh("land", primitive))
    glb.camera("camera", (25, 45, 70), (0, 0, 0), 45)
    glb.directional_light("sun", (-0.5, -1.0, -0.3), (1, 1, 1), round(math.pi, 6))
    return glb.to_bytes()


def _accessor(glb: Glb, rows: np.ndarray, component: int, kind: str) -> int:
    target = ELEMENT_ARRAY_BUFFER if kind == "SCALAR" else ARRAY_BUFFER
    return glb._append(
        "accessors",
        {
            "bufferView": glb._view(rows.tobytes(), target),
            "componentType": component,
            "count": len(rows),
            "type": kind,
            "min": rows.min(axis=0).tolist(),
            "max": rows.max(axis=0).tolist(),
        },
    )
