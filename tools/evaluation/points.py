"""Path-traced irradiance at points in the air and on surfaces of rooms, which tests compare the library's look-up with.

    tools/eval.py points            references/points/SCENE.exr of each room
    tools/eval.py points cornell    one of them

Half of the points lie on surfaces, evenly by area, with the normal of their triangle's front. The others lie in the air, evenly
in the scene's bounds, with a normal in any direction. Only points from which all that can be seen are fronts are taken, so none is
inside of an object or beneath it.

A picture has a row for each point: its position (world space), its normal, and its irradiance over pi, linear RGB. The
irradiance has all bounces, emitters and the sky, and is without the direct light of lights that have no size. The noise is
printed as the relMSE of the mean, as `references` does.
"""
import argparse

import numpy as np

from files import ROOT, find_scene
from metrics import noise_of_halves
from truth.exr import write_exr
from truth.scene import load_scene

from .progress import say

ROOMS = ("cornell", "corridor", "lamp", "night", "patio")
POINTS, SAMPLES, SEED = 1000, 16384, 0
MOST_HIDDEN = 40  # candidates for each point


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("rooms", nargs="*", default=ROOMS, metavar="SCENE", help=f"a name in assets/ (default: {', '.join(ROOMS)})")


def on_surfaces(scene, count: int, random) -> tuple[np.ndarray, np.ndarray]:
    corners = scene.positions
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    area = np.linalg.norm(across, axis=-1)
    chosen = random.choice(len(area), count, p=area / area.sum())
    root, b = np.sqrt(random.random(count)), random.random(count)
    weights = np.stack([1 - root, root * (1 - b), root * b], -1)
    return np.einsum("nk,nkd->nd", weights, corners[chosen]), (across / area[:, None])[chosen]


def in_air(scene, count: int, random) -> tuple[np.ndarray, np.ndarray]:
    low, high = scene.positions.min((0, 1)), scene.positions.max((0, 1))
    normals = random.normal(size=(count, 3))
    return low + (high - low) * random.random((count, 3)), normals / np.linalg.norm(normals, axis=-1, keepdims=True)


def seen(tracer, positions: np.ndarray, normals: np.ndarray) -> np.ndarray:
    """Positions and normals of the first points that are not hidden: (2, POINTS / 2, 3)."""
    chosen = np.flatnonzero(tracer.sees_fronts(positions, normals))[:POINTS // 2]
    return np.stack([positions[chosen], normals[chosen]]).astype(np.float32)


def make(room: str) -> None:
    from truth.points_traced import Tracer  # loading Mitsuba takes seconds
    scene = load_scene(find_scene(room))
    random, tracer = np.random.default_rng(SEED), Tracer(scene)
    positions, normals = np.concatenate([seen(tracer, *place(scene, MOST_HIDDEN * POINTS, random)) for place in (on_surfaces, in_air)], 1)
    halves = [tracer.irradiance(positions, normals, SAMPLES // 2, seed) for seed in (2 * SEED, 2 * SEED + 1)]
    say(f"{room}: noise {noise_of_halves(*(half[None] for half in halves)):.2g}")
    world = positions.astype(np.float64) * scene.side_world + scene.centre_world
    out = ROOT / "references" / "points"
    out.mkdir(exist_ok=True)
    write_exr(out / f"{room}.exr", np.stack([world, normals, 0.5 * (halves[0] + halves[1])], 1), np.float32)


def run(asked: argparse.Namespace) -> int:
    for room in asked.rooms:
        make(room)
    return 0
