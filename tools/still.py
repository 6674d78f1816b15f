"""A preset's still picture of a scene, with the time of its frame and its errors against path tracing."""
from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

import metrics
import program
from truth.exr import read_exr


def frame(vct: Path, scene: Path, preset: str, size: str, folder: Path, options: Sequence[str]) -> dict[str, Any]:
    """Renders mode gi into a folder; timings.json. The exposure is given, as finding one takes another picture."""
    program.render(vct, scene, "--preset", preset, "--mode", "gi", "--size", size, "--exposure", "1", "--tone-map", "none",
                   "--out", folder, "--timings", folder / "timings.json", *options)
    return json.loads((folder / "timings.json").read_text())


def judged(vct: Path, scene: Path, preset: str, reference: np.ndarray, folder: Path, options: Sequence[str] = ()) -> dict[str, Any]:
    """Writes folder/gi.exr, of the converged light. The medians, in ms, are those of a frame of that picture while only the
    camera moves, and of one in which light, objects and camera all change. `reference`: (height, width, 3), linear RGB."""
    size = f"{reference.shape[1]}x{reference.shape[0]}"
    still = frame(vct, scene, preset, size, folder, options)
    changing = frame(vct, scene, preset, size, folder / "changing", [*options, "--revoxelize"])
    errors = metrics.compare(read_exr(folder / "gi.exr"), reference, flip=True)
    camera_ms, changing_ms = (timings["modes"]["gi"]["steps"]["total"]["median"] for timings in (still, changing))
    return {"preset": preset, "grid": still["settings"]["grid"], "camera_ms": camera_ms, "changing_ms": changing_ms,
            "driver": still["driver"]["renderer"], **{name: errors[name] for name in ("relmse", "bias", "flip")}}
