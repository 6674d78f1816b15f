"""Runs `vct render` on a generated scene and reads its pictures; nothing here knows what is right."""

from __future__ import annotations

import json
import subprocess
import time
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from truth.exr import read_exr

TIMEOUT_S = 300.0
SEED = 7  # any but 0


class Unacceptable(Exception):
    """Crash, hang, GL error, NaN or infinity, dependence on the order of triangles."""


@dataclass
class Answer:
    """What one run gave. Images are linear, (height, width, 3), row 0 at the top."""

    folder: Path
    images: dict[str, np.ndarray] = field(default_factory=dict)
    active_voxels: list[int] = field(default_factory=list)
    messages: str = ""
    seconds: float = 0.0

    def __getitem__(self, name: str) -> np.ndarray:
        return self.images[name]


class Vct:
    def __init__(self, program: Path, out: Path, preset: str = "thesis") -> None:
        self.program, self.out, self.preset, self.check_order = program, out, preset, True
        self._known: dict[tuple, Answer] = {}

    def command(self, scene: Path, folder: Path, options: list[str]) -> subprocess.CompletedProcess[str]:
        arguments = [
            str(self.program),
            "render",
            str(scene),
            "--out",
            str(folder),
            "--preset",
            self.preset,
            *options,
        ]
        try:
            return subprocess.run(arguments, capture_output=True, text=True, timeout=TIMEOUT_S, check=False)
        except subprocess.TimeoutExpired as error:
            raise Unacceptable(f"still running after {TIMEOUT_S:.0f} s") from error

    def help(self) -> str:
        return subprocess.run(
            [str(self.program), "render", "--help"], capture_output=True, text=True, check=False
        ).stdout

    def scene_file(self, name: str, scene: bytes) -> Path:
        path = self.out / "scenes" / f"{name}.glb"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(scene)
        return path

    def render(
        self,
        name: str,
        scene: bytes,
        mode: str = "gi",
        grid: int = 64,
        size: str = "128x128",
        parts: bool = True,
        count_voxels: bool = False,
        options: tuple[str, ...] = (),
        check_order: bool = True,
    ) -> Answer:
        """One picture, and the same with shuffled triangles, which must be equal in every bit of the EXRs."""
        asked = (hash(scene), mode, grid, size, parts, count_voxels, options)
        if asked in self._known:
            return self._known[asked]
        path = self.scene_file(name, scene)
        flags = ["--mode", mode, "--grid", str(grid), "--size", size, *options]
        if parts:
            flags.append("--light-parts")
        timings = self.out / name / "timings.json"
        if count_voxels:
            timings.parent.mkdir(parents=True, exist_ok=True)
            flags += ["--timings", str(timings)]
        answer = self._read(path, self.out / name, flags)
        if count_voxels:
            answer.active_voxels = json.loads(timings.read_text())["active_voxels"]
        if self.check_order and check_order:
            shuffled = self._read(path, self.out / name / "shuffled", [*flags, "--seed-order", str(SEED)])
            for picture, image in answer.images.items():
                different = int((image != shuffled.images[picture]).any(axis=2).sum())
                if different:
                    raise Unacceptable(
                        f"{name}: {picture} differs in {different} of {image.shape[0] * image.shape[1]} "
                        "pixels when the triangles are shuffled"
                    )
        self._known[asked] = answer
        return answer

    def _read(self, scene: Path, folder: Path, flags: list[str]) -> Answer:
        start = time.monotonic()
        done = self.command(scene, folder, flags)
        answer = Answer(folder, messages=done.stderr, seconds=time.monotonic() - start)
        if done.returncode != 0:
            raise Unacceptable(f"{scene.stem}: exit code {done.returncode}: {last_line(done.stderr)}")
        for path in sorted(folder.glob("*.exr")):
            image = read_exr(path)
            wrong = int((~np.isfinite(image)).any(axis=2).sum())
            if wrong:
                raise Unacceptable(f"{scene.stem}: {wrong} pixels of {path.stem} are not finite")
            if (image < 0).any():
                raise Unacceptable(f"{scene.stem}: {path.stem} has negative light")
            answer.images[path.stem] = image
        return answer


def last_line(text: str) -> str:
    lines = text.strip().splitlines()
    return lines[-1] if lines else "no message"


def mean_difference(a: np.ndarray, b: np.ndarray) -> float:
    """Mean |a - b| over the mean of b: 0 where the pictures are the same, 1 where all light differs."""
    return float(np.abs(a - b).mean() / max(float(b.mean()), 1e-9))


def share_different(a: np.ndarray, b: np.ndarray, tolerance: float) -> float:
    """Share of the pixels with a channel that differs by more than `tolerance`."""
    return float((np.abs(a - b) > tolerance).any(axis=2).mean())
