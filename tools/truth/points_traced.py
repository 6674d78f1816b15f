"""Traces paths from points with normals, on surfaces or in the air. Positions are in trace space (scene.py)."""
import numpy as np

from .engine import dr, mi
from .kinds import World, lambert_full
from .points import pixel_offsets, point
from .scene import Scene
from .surfaces import RAY_OFFSET, Surface

RAYS = 64  # that look for the backs of surfaces around a point
SAMPLES_PER_PASS = 256


@dr.syntax
def sum_of_pass(world, positions, normals, seed: int, first: int, count: int):
    """The sum of samples [first, first + count) of every point."""
    index = dr.arange(mi.UInt32, dr.width(positions))
    offsets = pixel_offsets(index, dr.opaque(mi.UInt32, seed))
    state, stream = mi.sample_tea_32(index, dr.opaque(mi.UInt32, seed ^ (first * 0x85EBCA6B & 0xFFFFFFFF)))
    random = mi.PCG32(initstate=mi.UInt64(state), initseq=mi.UInt64(stream))
    surface = Surface(positions, normals, normals, mi.Color3f(1), mi.Color3f(0))
    direct = world.direct(surface, mi.Bool(True))
    total, sample = mi.Color3f(0), mi.UInt32(dr.opaque(mi.UInt32, first))
    end = sample + dr.opaque(mi.UInt32, count)
    while sample < end:
        total += lambert_full(world, surface, point(offsets, sample), random, mi.Bool(True)) - direct
        sample += 1
    return total


class Tracer:
    def __init__(self, scene: Scene):
        self._world = World(scene)

    def sees_fronts(self, positions: np.ndarray, normals: np.ndarray) -> np.ndarray:
        """True for points to which no surface around them, on the side of the normal, shows its back."""
        off = positions + RAY_OFFSET * normals
        origins, seen = mi.Point3f(np.ascontiguousarray(off.T.astype(np.float32))), np.ones(len(positions), bool)
        directions = np.random.default_rng(1).normal(size=(RAYS, 3))
        for direction in directions / np.linalg.norm(directions, axis=-1, keepdims=True):
            ray, above = mi.Vector3f(direction.tolist()), mi.Bool(normals @ direction > 0)
            seen &= ~np.array(self._world.surfaces.is_culled(self._world.surfaces.meet(origins, ray, above), ray))
        return seen

    def irradiance(self, positions: np.ndarray, normals: np.ndarray, samples: int, seed: int) -> np.ndarray:
        """Irradiance over pi, without the direct light of lights that have no size: (points, 3)."""
        place, facing = (kind(np.ascontiguousarray(values.T)) for kind, values in ((mi.Point3f, positions), (mi.Normal3f, normals)))
        total = np.zeros(positions.shape)
        for first in range(0, samples, SAMPLES_PER_PASS):
            total += np.array(sum_of_pass(self._world, place, facing, seed, first, SAMPLES_PER_PASS), np.float64).T
        return total / samples
