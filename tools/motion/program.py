"""Runs `vct render`, and what is said meanwhile."""
from __future__ import annotations

import shutil
import subprocess
import sys
import time
from pathlib import Path

import numpy as np

import metrics
from sweep.identity import ROOT
from sweep.progress import duration
from sweep.run import last_words
from truth.exr import read_exr


class Failed(Exception):
    """The message says which run, and what it said."""


class Progress:
    """A line on stderr whenever two seconds have passed since the last."""

    def __init__(self) -> None:
        self.start = self.said = time.monotonic()

    def __call__(self, text: str) -> None:
        now = time.monotonic()
        if now - self.said > 2:
            self.said = now
            print(f"motion: {text} ({duration(now - self.start)} so far)", file=sys.stderr, flush=True)


class Program:
    """The renderer under test. Each run has the folder to itself, which is emptied before."""

    def __init__(self, path: Path, folder: Path, size: tuple[int, int]) -> None:
        if not path.exists():
            raise SystemExit(f"error: {path} is not built: scripts/build.sh desktop vct")
        self.path, self.folder, self.size, self.progress = path.resolve(), folder, size, Progress()
        self.options = subprocess.run([str(self.path), "render", "--help"], capture_output=True, text=True, check=False).stdout

    def has(self, option: str) -> bool:
        return option in self.options

    def render(self, what: str, scene: Path, *arguments: str) -> Path:
        """The folder with the pictures. `what` is said while it runs, and how many pictures there are."""
        shutil.rmtree(self.folder, ignore_errors=True)
        command = [str(self.path), "render", str(scene), "--out", str(self.folder), "--size",
                   f"{self.size[0]}x{self.size[1]}", *arguments]
        with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) as running:
            while True:
                try:
                    _, said = running.communicate(timeout=2)
                    break
                except subprocess.TimeoutExpired:
                    count = len(list(self.folder.glob("*.exr"))) if self.folder.is_dir() else 0
                    self.progress(f"{what}, {count} pictures" if count else what)
        if running.returncode != 0:
            raise Failed(f"{scene.name} {' '.join(arguments)}: {last_words(said)}".replace(f"{ROOT}/", ""))
        self.progress(what)
        return self.folder


def errors(picture: np.ndarray, truth: np.ndarray) -> dict[str, float | None]:
    """relMSE, bias and FLIP of the two as sRGB; and FLIP's 99th percentile, which sees a ghost that the mean does not."""
    found, flip = metrics.compare(picture, truth, flip=False), metrics.flip_map(picture, truth)
    return {"relmse": found["relmse"], "bias": found["bias"], "flip": float(flip.mean(dtype=float)),
            "flip_p99": float(np.percentile(flip, 99))}


def sequence(program: Program, what: str, scene: Path, preset: str, rate: float, numbers: list[int]) -> dict[int, np.ndarray]:
    """Those frames of a run that plays the scene from its beginning, with the memory that an app has."""
    folder = program.render(what, scene, "--preset", preset, "--mode", "gi", "--frames", str(max(numbers) + 1), "--fps",
                            f"{rate:g}")
    return {number: read_exr(folder / f"gi_{number:04}.exr") for number in numbers}
