"""Pictures of a scene by kind: box filter over the pixel, the pixel grid of the renderer under test.

Each pixel's samples are added in a fixed order by one lane, so that threads cannot change a bit.
"""
import dataclasses
import math
from collections.abc import Callable

import numpy as np

from .engine import dr, mi
from .kinds import ESTIMATORS, SHOWS_SKY, World
from .points import pixel_offsets, point
from .scene import Scene
from .surfaces import unit_vector

SAMPLES_PER_PASS = 32


@dataclasses.dataclass
class Drawn:
    image: np.ndarray  # (height, width, 3) float64, mean of the halves
    halves: tuple[np.ndarray, np.ndarray]  # with one seed each


def camera_rays(scene: Scene, size: tuple[int, int], pixel, across, down):
    """glTF 3.10: -Z forward, `yfov` over the whole height, square pixels; row 0 is the top."""
    width, height = size
    x, y = mi.Float(pixel % width) + across, mi.Float(pixel // width) + down
    half = math.tan(0.5 * scene.camera.vertical_fov_rad)
    right, up, back = (mi.Vector3f(axis.tolist()) for axis in scene.camera.axes)
    direction = (right * ((2 * x / width - 1) * half * width / height) + up * ((1 - 2 * y / height) * half) - back)
    return mi.Point3f(scene.camera.eye.tolist()), unit_vector(direction)


@dr.syntax
def sum_of_pass(world, scene, kind: str, size: tuple[int, int], seed: int, first: int, count: int):
    """The sum of samples [first, first + count) of every pixel, as a wavefront of pixels."""
    estimate, shows_sky = ESTIMATORS[kind], kind in SHOWS_SKY
    pixel = dr.arange(mi.UInt32, size[0] * size[1])
    offsets = pixel_offsets(pixel, dr.opaque(mi.UInt32, seed))
    state, stream = mi.sample_tea_32(pixel, dr.opaque(mi.UInt32, seed ^ (first * 0x85EBCA6B & 0xFFFFFFFF)))
    random = mi.PCG32(initstate=mi.UInt64(state), initseq=mi.UInt64(stream))
    total, sample = mi.Color3f(0), mi.UInt32(dr.opaque(mi.UInt32, first))
    end = sample + dr.opaque(mi.UInt32, count)
    while sample < end:
        numbers = point(offsets, sample)
        origin, direction = camera_rays(scene, size, pixel, numbers[0], numbers[1])
        hit = world.surfaces.meet(origin, direction, mi.Bool(True), camera=True)
        surface = world.surfaces.surface(hit, direction)
        value = estimate(world, surface, numbers, random, hit.valid)
        behind = world.sky.radiance(direction, ~hit.valid) if shows_sky else mi.Color3f(0)
        total += dr.select(hit.valid, value, behind)
        sample += 1
    return total


def draw_half(world: World | None, scene: Scene, kind: str, size: tuple[int, int], samples: int, seed: int,
              tell: Callable[[int], None]) -> np.ndarray:
    total = np.zeros((size[1], size[0], 3))
    for done in range(0, samples if world else 0, SAMPLES_PER_PASS):
        count = min(SAMPLES_PER_PASS, samples - done)
        part = np.array(sum_of_pass(world, scene, kind, size, seed, done, count), np.float64)
        total += part.T.reshape(total.shape)
        tell(count)
    return total / samples


def draw(world: World | None, scene: Scene, kind: str, size: tuple[int, int], samples: int, seed: int,
         tell: Callable[[int], None] = lambda count: None) -> Drawn:
    """`samples` per pixel, an even number: half with the seed 2 seed, half with 2 seed + 1. `tell` is called after every pass
    with the number of samples that it drew."""
    halves = tuple(draw_half(world, scene, kind, size, samples // 2, 2 * seed + i, tell) for i in (0, 1))
    return Drawn(0.5 * (halves[0] + halves[1]), halves)


def make_world(scene: Scene) -> World | None:
    """None for a scene without triangles: its pictures are black."""
    return World(scene) if len(scene.positions) else None
