"""Runs `vct render` on a generated scene and reads its pictures; nothing here knows what is right."""
from __future__ import annotations

import json
import subprocess
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

import program
from truth.exr import read_exr

TIMEOUT_S = 300.0
SEED = 7  # any but 0


class Unacceptable(Exception):
    """Crash, hang, GL error, NaN or infinity, dependence on the order of triangles."""


@dataclass
class Measured:
    value: float  # distance from the right answer: 0 is right
    picture: Path | None = None
    note: str = ""


@dataclass
class Answer:
    """What one run gave. Images are linear, (height, width, 3), row 0 at the top."""

    folder: Path
    images: dict[str, np.ndarray] = field(default_factory=dict)
    active_voxels: int = 0  # of the finest level

    def __getitem__(self, name: str) -> np.ndarray:
        return self.images[name]

    def measured(self, value: float, picture: str = "gi", note: str = "") -> Measured:
        return Measured(float(value), self.folder / f"{picture}.png", note)


class Vct:
    def __init__(self, vct: Path, out: Path, preset: str = "thesis") -> None:
        self.vct, self.out, self.preset, self.check_order = vct, out, preset, True
        self._known: dict[tuple, Answer] = {}

    def command(self, scene: Path, folder: Path, options: list[str]) -> subprocess.CompletedProcess[str]:
        try:
            return program.run(self.vct, "render", scene, "--out", folder, "--preset", self.preset, *options,
                               timeout_s=TIMEOUT_S)
        except program.Failed as why:
            raise Unacceptable(f"{scene.stem}: {why}") from None

    def scene_file(self, name: str, scene: bytes) -> Path:
        path = self.out / "scenes" / f"{name}.glb"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(scene)
        return path

    def render(self, name: str, scene: bytes, mode: str = "gi", grid: int = 64, size: int = 128, count_voxels: bool = False,
               options: tuple[str, ...] = (), check_order: bool = True) -> Answer:
        """One picture, and the same with shuffled triangles, which must be equal in every bit of the EXRs."""
        asked = (hash(scene), mode, grid, size, count_voxels, options)
        if asked in self._known:
            return self._known[asked]
        path = self.scene_file(name, scene)
        flags = ["--mode", mode, "--grid", str(grid), "--size", f"{size}x{size}", "--light-parts", *options]
        timings = self.out / name / "timings.json"
        if count_voxels:
            timings.parent.mkdir(parents=True, exist_ok=True)
            flags += ["--timings", str(timings)]
        answer = self._read(path, self.out / name, flags)
        if count_voxels:
            answer.active_voxels = json.loads(timings.read_text())["active_voxels"][0]
        if self.check_order and check_order:
            shuffled = self._read(path, self.out / name / "shuffled", [*flags, "--seed-order", str(SEED)])
            for picture, image in answer.images.items():
                if different := share_different(image, shuffled[picture], 0.0):
                    raise Unacceptable(f"{name}: {different:.2%} of the pixels of {picture} differ when the triangles are shuffled")
        self._known[asked] = answer
        return answer

    def _read(self, scene: Path, folder: Path, flags: list[str]) -> Answer:
        done = self.command(scene, folder, flags)
        if done.returncode != 0:
            raise Unacceptable(f"{scene.stem}: exit code {done.returncode}: {program.last_words(done.stderr)}")
        answer = Answer(folder)
        for path in sorted(folder.glob("*.exr")):
            image = answer.images[path.stem] = read_exr(path)
            if wrong := int((~np.isfinite(image)).any(axis=2).sum()):
                raise Unacceptable(f"{scene.stem}: {wrong} pixels of {path.stem} are not finite")
            if (image < 0).any():
                raise Unacceptable(f"{scene.stem}: {path.stem} has negative light")
        return answer

    def difference(self, name: str, scene: bytes, other_name: str, other: bytes, pictures: tuple[str, ...] = ("gi",),
                   note: str = "", **how: object) -> Measured:
        """How much light the pictures of two scenes that must look alike differ in, where they differ most."""
        answer, expected = self.render(name, scene, **how), self.render(other_name, other, **how)
        return answer.measured(max(mean_difference(answer[p], expected[p]) for p in pictures), pictures[0], note)


def mean_difference(a: np.ndarray, b: np.ndarray) -> float:
    """Mean |a - b| over the mean of b: 0 where the pictures are the same, 1 where all light differs."""
    return float(np.abs(a - b).mean() / max(float(b.mean()), 1e-9))


def share_different(a: np.ndarray, b: np.ndarray, tolerance: float) -> float:
    """Share of the pixels with a channel that differs by more than `tolerance`."""
    return float((np.abs(a - b) > tolerance).any(axis=2).mean())
