"""The renderer under test over frames, and how far its pictures are from others."""
from __future__ import annotations

import shutil
import sys
import time
from pathlib import Path

import numpy as np

import metrics
import program
from truth.exr import read_exr


class Renderer:
    """Each run has the folder to itself, which is emptied before."""

    def __init__(self, vct: Path, folder: Path, size: tuple[int, int]) -> None:
        program.require(vct)
        self.vct, self.folder, self.size = vct.resolve(), folder, size
        self.said = time.monotonic()

    def render(self, what: str, scene: Path, *arguments: str) -> Path:
        """The folder with the pictures. `what` is said where nothing has been for two seconds."""
        if time.monotonic() - self.said > 2:
            self.said = time.monotonic()
            print(f"motion: {what}", file=sys.stderr, flush=True)
        shutil.rmtree(self.folder, ignore_errors=True)
        try:
            program.render(self.vct, scene, "--out", self.folder, "--size", f"{self.size[0]}x{self.size[1]}", *arguments)
        except program.Failed as why:
            raise program.Failed(f"{scene.name} {' '.join(arguments)}: {why}") from None
        return self.folder

    def sequence(self, what: str, scene: Path, preset: str, rate: float, numbers: list[int]) -> dict[int, np.ndarray]:
        """Those frames of a run that plays the scene from its beginning, with the memory that an app has."""
        folder = self.render(what, scene, "--preset", preset, "--mode", "gi", "--frames", str(max(numbers) + 1), "--fps",
                             f"{rate:g}")
        return {number: read_exr(folder / f"gi_{number:04}.exr") for number in numbers}


def errors(picture: np.ndarray, truth: np.ndarray) -> dict[str, float | None]:
    """relMSE, bias and FLIP of the two as sRGB; and FLIP's 99th percentile, which sees a ghost that the mean does not."""
    found, flip = metrics.compare(picture, truth, flip=False), metrics.flip_map(picture, truth)
    return {"relmse": found["relmse"], "bias": found["bias"], "flip": float(flip.mean(dtype=float)),
            "flip_p99": float(np.percentile(flip, 99))}
