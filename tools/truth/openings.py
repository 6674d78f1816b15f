"""Small openings between rooms, through which paths are sent on purpose.

A room that gets all its light through a small hole is noise to a path tracer: of 1000 directions one meets the hole. Where
a scene names its openings, a share of the directions goes to points on them, and each direction is weighted by the density
that both ways of choosing it give together (the balance heuristic), so the mean stays the same.
"""
import math

import numpy as np

from .engine import dr, mi
from .scene import Scene
from .surfaces import Surface

SHARE = 0.3  # of the directions, of surfaces in front of all openings
# Rays start a little off their surface, so some whose direction just misses an opening pass it. An opening counts as larger
# by this share of its sides, as such a ray would have a large weight.
MARGIN = 0.01


class Openings:
    """The parallelograms of one scene. Surfaces on the side of a parallelogram's normal get light through it."""

    def __init__(self, scene: Scene):
        larger = [(p - MARGIN * (u + v), (1 + 2 * MARGIN) * u, (1 + 2 * MARGIN) * v) for p, u, v in scene.openings]
        self._corners = [(mi.Point3f(p.tolist()), mi.Vector3f(u.tolist()), mi.Vector3f(v.tolist()),
                          mi.Vector3f(np.cross(u, v).tolist()), float(np.linalg.norm(np.cross(u, v)) ** 2))
                         for p, u, v in larger]

    def __bool__(self) -> bool:
        return bool(self._corners)

    def _densities(self, position, direction):
        """Returns the density per solid angle of directions towards uniform points of uniformly chosen openings, and the share
        of the openings that the position is in front of."""
        total, before = mi.Float(0), mi.Float(0)
        for corner, u, v, normal, area2 in self._corners:
            height = dr.dot(position - corner, normal)
            along = -dr.dot(direction, normal)
            distance = height / dr.maximum(along, 1e-12)
            at = position + distance * direction - corner
            a, b = dr.dot(dr.cross(at, v), normal) / area2, dr.dot(dr.cross(u, at), normal) / area2
            # Rounding must not move a point of the edge outside, as it would then have a large weight.
            inside = (a > -1e-5) & (a < 1 + 1e-5) & (b > -1e-5) & (b < 1 + 1e-5)
            meets = (height > 0) & (along > 0) & inside
            # |normal| is the area A, so the density d^2 / (A cos) is d^2 / |direction . normal|.
            total += dr.select(meets, dr.square(distance) / dr.maximum(along, 1e-12), 0)
            before += dr.select(height > 0, 1.0, 0.0)
        return total / len(self._corners), before / len(self._corners)

    def redirect(self, surface: Surface, direction, cosine_pdf, choice, a, b):
        """Returns `direction`, which is cosine-distributed with the density `cosine_pdf`, or one towards an opening in its
        place; its cosine density; the weight of the light that comes along it; and whether it crosses an opening."""
        chosen = mi.UInt32(choice * (len(self._corners) / SHARE))  # beyond the last one: the given direction
        for index, (corner, u, v, normal, _) in enumerate(self._corners):
            way = corner + a * u + b * v - surface.position
            taken = (chosen == index) & (dr.dot(surface.position - corner, normal) > 0)
            direction = dr.select(taken, way / dr.maximum(dr.sqrt(dr.squared_norm(way)), 1e-12), direction)
            cosine = dr.select(dr.dot(surface.facing, direction) > 0, dr.maximum(dr.dot(surface.normal, direction), 0), 0)
            cosine_pdf = dr.select(taken, cosine / math.pi, cosine_pdf)
        density, before = self._densities(surface.position, direction)
        both = SHARE * density + (1 - SHARE * before) * cosine_pdf
        return direction, cosine_pdf, dr.select(both > 0, cosine_pdf / dr.maximum(both, 1e-12), 0), density > 0
