"""Lag and noise: each frame of a sequence, with the memory that the light has, against the still picture of its moment."""
from __future__ import annotations

import statistics
from pathlib import Path
from typing import Any

from motion.renderer import Renderer, errors
from truth.exr import read_exr

FPS = 30.0
FIRST_FRAMES = 16  # the sequence starts converged: those are not what an app shows for long


def lag(renderer: Renderer, name: str, scene: Path, preset: str, frames: int, every: int) -> dict[str, Any]:
    """Errors of every so many frames, and their means after the first ones."""
    what = f"{name}, {preset}, lag"
    numbers = list(range(0, frames, every))
    shown = renderer.sequence(what, scene, preset, FPS, numbers)
    found = []
    for number in numbers:
        folder = renderer.render(f"{what}: moment {number} of {frames}", scene, "--preset", preset, "--mode", "gi", "--time",
                                 f"{number / FPS:.9g}")
        found.append({"frame": number, "time_s": number / FPS, **errors(shown[number], read_exr(folder / "gi.exr"))})
    late = [one for one in found if one["frame"] >= FIRST_FRAMES] or found
    return {"frames": found, "fps": FPS, "after": FIRST_FRAMES,
            "mean": {kind: statistics.fmean(one[kind] for one in late) for kind in ("relmse", "flip")},
            "worst": {kind: max(one[kind] for one in late) for kind in ("relmse", "flip")}}
