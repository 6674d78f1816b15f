"""Times and errors of one preset's picture of one scene.

A picture is drawn twice: with converged light, as while only the camera moves, and with everything rebuilt in each frame. Each
error stands beside the time of the frame that it was measured on.
"""
import json
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

import metrics
import program
from files import ROOT, SCALED, Failed, file_sha256, reference_folder, scene_sha256, shown, view_name
from truth.exr import read_exr
from truth.scene import sky_file

from .store import Result, Task

Picture = np.ndarray  # (height, width, 3), linear RGB


@dataclass(frozen=True)
class Measure:
    picture: str  # of vct render
    references: tuple[str, ...]  # kinds that are added up; "-kind" is subtracted
    mode: str
    is_share: bool = False  # values of 0 to 1 that are not light, judged by RMSE


MEASURES = {
    "gi": Measure("gi", ("full",), "gi"),
    "indirect": Measure("indirect_light", ("indirect",), "gi"),
    "soft": Measure("gi-cone-shadow", ("sun", "full", "-direct"), "gi-cone-shadow"),
    "shadow": Measure("cone_shadow", ("shadow",), "gi-cone-shadow", is_share=True),
    "ao": Measure("ambient_occlusion", ("ao",), "ao", is_share=True),
}
STILL_SAMPLES = 16  # per pixel, of pictures whose errors docs/comparison.md has beside those of other renderers
STATES = {"camera": [], "changing": ["--revoxelize"]}  # options of vct render


class References:
    """Path-traced pictures in references/, of a scene or of one of its cameras."""

    def __init__(self, scene: Path, root: Path = ROOT / "references", camera: str | None = None) -> None:
        self.folder = reference_folder(scene, root, camera)
        about = self.folder / "reference.json"
        remedy = f"run: tools/eval.py references {shown(scene)}" + (f" --cameras {camera}" if camera else "")
        if not about.is_file():
            raise Failed(f"{view_name(scene, camera)} has no references in {shown(self.folder)}; {remedy}")
        self.about = json.loads(about.read_text())
        if scene.stem not in SCALED and self.about["scene_sha256"] != file_sha256(scene):
            raise Failed(f"{shown(self.folder)} was made from another version of {scene.name}; {remedy}")
        self.size = tuple(self.about["size"])

    def picture(self, kinds: Sequence[str]) -> Picture:
        return sum((-1 if kind.startswith("-") else 1) * read_exr(self.folder / f"{kind.removeprefix('-')}.exr") for kind in kinds)

    def noise(self, kinds: Sequence[str]) -> float:
        """The noise of the noisiest of the kinds, as relMSE."""
        return max(self.about["kinds"][kind.removeprefix("-")]["noise_relmse"] for kind in kinds)

    def key(self) -> dict[str, str]:
        return {path.name: file_sha256(path) for path in sorted(self.folder.iterdir())}


def averaged_down(reference: Picture, size: tuple[int, int]) -> Picture:
    """Averages whole boxes of pixels, as a box filter would have done at the smaller size."""
    width, height = size
    factor = reference.shape[0] // height
    if factor == 0 or reference.shape[:2] != (factor * height, factor * width):
        raise Failed(f"a reference of {reference.shape[1]}x{reference.shape[0]} pixels cannot be averaged to {width}x{height}: "
                     f"choose a --size of which it is a whole multiple")
    return reference.reshape(height, factor, width, factor, 3).mean(axis=(1, 3))


def measured(scene: Path, preset: str, size: tuple[int, int], names: Sequence[str], reference: Callable[[Measure], Picture],
             folder: Path, options: Sequence[str] = (), pixels: metrics.Pixels = ...,
             exposure: float | None = None, samples: int = 1) -> Result:
    """Renders into `folder` and compares these pixels, with FLIP at this exposure. With several `samples` per pixel, the errors
    while only the camera moves are those of a still picture; times are of single frames."""
    chosen = {name: MEASURES[name] for name in names}
    modes = list(dict.fromkeys(measure.mode for measure in chosen.values()))
    parts = [] if set(names) <= {"gi", "soft"} else ["--light-parts"]
    result: dict[str, Any] = {"scene": scene.stem, "preset": preset, "size": list(size)}
    for state, flags in STATES.items():
        out = folder if state == "camera" else folder / state
        timings = program.render_timed(scene, out, "--preset", preset, "--mode", ",".join(modes), "--size", f"{size[0]}x{size[1]}",
                                       "--exposure", exposure or 1, *parts, *options, *flags)
        result |= {"grid": timings["settings"]["grid"], "cascades": timings["settings"]["cascades"],
                   "driver": timings["driver"]["renderer"], "cpu": timings["machine"]["cpu"]}
        if samples > 1 and state == "camera":
            program.render(scene, out, "--preset", preset, "--mode", ",".join(modes), "--size", f"{size[0]}x{size[1]}",
                           "--exposure", exposure or 1, *parts, *options, "--samples", samples)
        result[state] = {
            "ms": {mode: timings["modes"][mode]["steps"]["total"]["median"] for mode in modes},
            "errors": {name: metrics.compare(read_exr(out / f"{measure.picture}.exr"), averaged_down(reference(measure), size),
                                             not measure.is_share, pixels, exposure) for name, measure in chosen.items()}}
    return result


def voxels(one: Result) -> str:
    """64³, or 64³, 5 cascades. Results of an earlier version of this program have no cascades."""
    count = one.get("cascades", 1)
    return f"{one['grid']}³" + (f", {count} cascades" if count > 1 else "")


def task(scene: Path, preset: str, names: Sequence[str], size: tuple[int, int] | None, grid: str | None,
         camera: str | None = None, cascades: int = 1, samples: int = 1) -> Task:
    """One preset's picture of a scene that has references."""
    references, name = References(scene, camera=camera), view_name(scene, camera)
    size, sky = size or references.size, sky_file(scene)
    given = {"--camera": camera, "--grid": grid, "--cascades": str(cascades) if cascades > 1 else None}
    options = [*(("--environment", str(sky)) if sky else program.NO_SKY),
               *(word for option, value in given.items() if value for word in (option, value))]

    def measure(folder: Path) -> Result:
        result = measured(scene, preset, size, names, lambda one: references.picture(one.references), folder, options,
                          samples=samples)
        return result | {"scene": name, "reference": shown(references.folder / "full.exr"),
                         "noise": {name: references.noise(MEASURES[name].references) for name in names}}
    return Task("render", f"{name}-{preset}" + (f"-{grid}" if grid else "") + (f"-{cascades}-cascades" if cascades > 1 else ""),
                {"scene": scene_sha256(scene), "references": references.key(), "measures": sorted(names), "size": size,
                 "metrics": file_sha256(Path(metrics.__file__)), **({"samples": samples} if samples > 1 else {})}, measure, preset)
