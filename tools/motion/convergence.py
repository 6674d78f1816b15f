"""Convergence: how many frames the light takes from nothing, and after its source has moved by 30 degrees."""
from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

import metrics
from motion.lag import FPS
from motion.renderer import Renderer, errors
from sweep.measures import References
from truth.exr import read_exr

FRAMES = (1, 2, 4, 8, 16, 32)
SMOOTH = 0.3  # of the middle's value: how much a pixel's neighbours in the reference may differ
# What counts as converged: what is left to change is so much of the converged picture's own error, and moves the mean so far.
CLOSE_RELMSE, CLOSE_BIAS = 0.1, 0.03


def smooth_pixels(reference: np.ndarray) -> np.ndarray:
    """(height, width): those without an edge or the border of a shadow in the 3x3 pixels around.

    A frame has one sample in a pixel and the reference many: at edges all frames are as wrong as the converged one, and
    hide there what changes.
    """
    light = np.pad(reference @ metrics.LUMINANCE, 1, mode="edge")
    around = np.lib.stride_tricks.sliding_window_view(light, (3, 3))
    return np.ptp(around, axis=(-1, -2)) <= SMOOTH * around[..., 1, 1] + 0.01


def to_truth(picture: np.ndarray, reference: np.ndarray) -> dict[str, float | None]:
    """relMSE and bias, of the pixels in which a frame can be right."""
    mask = smooth_pixels(reference)
    found = metrics.compare(picture, reference, mask=mask, flip=False) if mask.any() else {"relmse": 0.0, "bias": None}
    return {"relmse": found["relmse"], "bias": found["bias"]}


def judged(picture: np.ndarray, converged: np.ndarray, reference: np.ndarray | None) -> dict[str, Any]:
    """Against the converged still, and against the path-traced picture where there is one."""
    found: dict[str, Any] = {"to_converged": errors(picture, converged)}
    if reference is not None:
        found["to_truth"] = to_truth(picture, reference)
    return found


def frames_until(steps: list[dict[str, Any]], converged: dict[str, float | None]) -> int | None:
    """From how many frames on the light stays as good as converged; None where it does not within those measured.

    Told by the distance to the converged picture, not by two distances to the truth, of which the earlier may be the smaller
    one by chance.
    """
    good: int | None = None
    for step in reversed(steps):
        left = step["to_converged"]
        if left["relmse"] > CLOSE_RELMSE * converged["relmse"] or abs(left["bias"] or 0.0) > CLOSE_BIAS:
            break
        good = step["frames"]
    return good


def steps_of(pictures: dict[int, np.ndarray], converged: np.ndarray, reference: np.ndarray | None) -> dict[str, Any]:
    """By number of frames, and when it is as good as converged."""
    found: dict[str, Any] = {"steps": [{"frames": count, **judged(picture, converged, reference)}
                                       for count, picture in pictures.items()]}
    if reference is not None:
        found["converged"] = to_truth(converged, reference)
        found["frames_until"] = frames_until(found["steps"], found["converged"])
    return found


def reference_of(references: References, kind: str, shape: tuple[int, ...]) -> np.ndarray | None:
    """None where there is no such picture, or only one of another size."""
    path = references.folder / f"{kind}.exr"
    found = references.image(kind) if path.is_file() else None
    return found if found is not None and found.shape == shape else None


def still(renderer: Renderer, what: str, scene: Path, preset: str, *more: str) -> dict[str, np.ndarray]:
    folder = renderer.render(what, scene, "--preset", preset, "--mode", "gi", "--light-parts", *more)
    return {name: read_exr(folder / f"{name}.exr") for name in ("gi", "indirect_light")}


def from_nothing(renderer: Renderer, scene: Path, preset: str, references: References) -> dict[str, Any]:
    """`gi`: all light against all bounces; `indirect_light`: the indirect light alone against one bounce."""
    what = f"{scene.stem}, {preset}, convergence from nothing"
    converged = still(renderer, what, scene, preset)
    steps = {count: still(renderer, f"{what}: {count} frames", scene, preset, "--light-frames", str(count))
             for count in FRAMES}
    return {name: steps_of({count: pictures[name] for count, pictures in steps.items()}, converged[name],
                           reference_of(references, kind, converged[name].shape))
            for name, kind in (("gi", "full"), ("indirect_light", "indirect"))}


def after_a_jump(renderer: Renderer, name: str, scene: Path, preset: str, references: References) -> dict[str, Any]:
    """`scene`: its light jumps between the first frame and the second, to where the references have it."""
    what = f"{name}, {preset}, convergence after the light has moved"
    shown = renderer.sequence(what, scene, preset, FPS, list(FRAMES))
    converged = still(renderer, what, scene, preset, "--time", "1")["gi"]
    return {"gi": steps_of(shown, converged, reference_of(references, "full", converged.shape))}
