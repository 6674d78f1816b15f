"""Swimming: how much the light that a surface point receives changes from frame to frame of a slow camera.

Diffuse light does not depend on the view, so the right answer is none, but for what sampling a frame between its pixels
adds: the floor, which is the same computation on a field that is known not to change.
"""
from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np

from motion.geometry import MOVES, Seen, View, amount_for, carry, field, relative_change, sampled
from motion.renderer import Renderer
from truth.exr import read_exr
from truth.first_hits import TrueGeometry
from truth.scene import Scene, load_scene, unit

PIXELS_A_FRAME = 1.3
DARKEST_ALBEDO = 0.02  # of all channels: darker ones tell nothing of what they receive


def first_view(scene: Scene, size: tuple[int, int]) -> View:
    """The scene's camera, level."""
    back = scene.camera.axes[2]
    right = unit(np.cross(np.array([0.0, 1.0, 0.0]), back))
    return View(scene.camera.eye, np.stack([right, np.cross(back, right), back]), scene.camera.vertical_fov_rad, size)


def camera_option(view: View, scene: Scene) -> str:
    """The view as `vct render --camera` takes it."""
    eye = view.eye * scene.side_world + scene.centre_world
    target = eye - view.axes[2] * scene.side_world

    def text(values: np.ndarray) -> str:
        return ",".join(f"{value:.12g}" for value in values)
    return f"eye={text(eye)},target={text(target)},fov={math.degrees(view.vertical_fov_rad):.12g}"


def halves(values: np.ndarray) -> np.ndarray:
    return values.astype(np.float16).astype(np.float64)


class Frame:
    """What a view shows: the true surfaces, the light that they receive in the renderer's picture, and the field that
    does not change, through the same albedo and the same rounding."""

    def __init__(self, what: str, renderer: Renderer, scene: Scene, geometry: TrueGeometry, preset: str, view: View) -> None:
        # Glossy materials would take their share from the albedo, which its debug view does not show.
        folder = renderer.render(what, scene.path, "--preset", preset, "--mode", "phong", "--light-parts", "--debug-views",
                                 "--specular", "none", "--camera", camera_option(view, scene))
        light, albedo = (read_exr(folder / name).astype(np.float64)
                         for name in ("indirect_light.exr", "debug_views/g_buffer_albedo.exr"))
        position, normal, valid = geometry(view.eye, view.directions())
        bright = (albedo >= DARKEST_ALBEDO).all(-1)
        self.seen = Seen(view, position, normal, valid & bright)
        divisor = np.where(bright[..., None], halves(albedo), 1)
        self.received = np.where(self.seen.valid[..., None], light / divisor, 0)
        self.field = halves(field(self.seen) * divisor) / divisor
        self.surfaces = int(valid.sum())


def lengths_mean(values: np.ndarray, valid: np.ndarray) -> float:
    return float(np.linalg.norm(values[valid], axis=-1).mean()) if valid.any() else 0.0


def changes(new: Frame, old: Frame) -> tuple[np.ndarray, np.ndarray, float]:
    """Of every point that could be carried: the light's change and the field's; and the share of points that could."""
    carried = carry(new.seen, old.seen)
    found = []
    for values, before in ((new.received, old.received), (new.field, old.field)):
        mean = lengths_mean(values, new.seen.valid)
        found.append(relative_change(values[carried.mask], sampled(before, carried), mean))
    return found[0], found[1], float(carried.mask.sum() / max(new.surfaces, 1))


def summary(parts: list[np.ndarray]) -> dict[str, float]:
    """Root mean square and 99th percentile."""
    values = np.concatenate(parts)
    if len(values) == 0:
        return {"rms": 0.0, "p99": 0.0}
    return {"rms": float(np.sqrt(np.mean(values**2))), "p99": float(np.percentile(values, 99))}


def swim(renderer: Renderer, path: Path, preset: str, frames: int) -> dict[str, Any]:
    """Root mean square and 99th percentile over all points, frames and moves, the floor's beside them."""
    scene = load_scene(path, renderer.size)
    geometry = TrueGeometry(scene)

    def frame(what: str, view: View) -> Frame:
        return Frame(f"{path.stem}, {preset}, swim{what}", renderer, scene, geometry, preset, view)
    start = frame("", first_view(scene, renderer.size))
    light: dict[str, list[np.ndarray]] = {name: [] for name in MOVES}
    floor: dict[str, list[np.ndarray]] = {name: [] for name in MOVES}
    shares = []
    for name, move in MOVES.items():
        amount = amount_for(move, start.seen, PIXELS_A_FRAME)
        old = start
        for number in range(1, frames + 1):
            new = frame(f": {name}, frame {number} of {frames}", move(start.seen.view, number * amount))
            of_light, of_field, share = changes(new, old)
            light[name].append(of_light)
            floor[name].append(of_field)
            shares.append(share)
            old = new
    return {**summary(sum(light.values(), [])), "floor": summary(sum(floor.values(), [])),
            "moves": {name: {**summary(light[name]), "floor": summary(floor[name])} for name in MOVES},
            "carried": float(np.mean(shares)), "frames": frames, "pixels_a_frame": PIXELS_A_FRAME}
