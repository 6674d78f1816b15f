"""What is judged against what: pictures of vct, added up, against kinds of reference, added up."""
from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

import metrics
from files import file_sha256
from references import reference_folder
from truth.exr import PictureError, read_exr

Picture = np.ndarray


@dataclass(frozen=True)
class Measure:
    name: str
    what: str  # for people
    pictures: tuple[str, ...]  # of vct render
    references: tuple[str, ...]  # kinds, of tools/references.py; "-kind" is taken off
    mode: str  # whose time it is shown with
    one_bounce: bool = False  # says nothing of a picture that holds all bounces
    share: bool = False  # 0 to 1, not light: FLIP, of what light looks like, says nothing of it


MEASURES: tuple[Measure, ...] = (
    Measure("indirect", "indirect light alone, against one bounce", ("indirect_light",), ("indirect",), "gi"),
    Measure("gi-one-bounce", "mode gi against direct light and one bounce, which is what the thesis models: the algorithm's "
            "error", ("gi",), ("one-bounce",), "gi", one_bounce=True),
    Measure("gi-full", "mode gi against the light of all bounces: the algorithm's error and the model's", ("gi",),
            ("full",), "gi"),
    Measure("soft", "mode gi-cone-shadow against a sun of 5 degrees and one bounce",
            ("gi-cone-shadow",), ("sun", "indirect"), "gi-cone-shadow", one_bounce=True),
    Measure("soft-full", "mode gi-cone-shadow against a sun of 5 degrees and all bounces of a point sun's light",
            ("gi-cone-shadow",), ("sun", "full", "-direct"), "gi-cone-shadow"),
    Measure("shadow", "the soft shadow alone, against the visible share of a sun of 5 degrees", ("cone_shadow",),
            ("shadow",), "gi-cone-shadow", share=True),
    Measure("ao", "ambient occlusion alone, at the same distance", ("ambient_occlusion",), ("ao",), "ao", share=True),
)


# Presets whose modes gi and gi-cone-shadow hold the first bounce alone.
ONE_BOUNCE = frozenset({"thesis"})


class NoReference(Exception):
    """Says why a measure has no number."""


class References:
    """A scene's path-traced references, as tools/references.py describes them."""

    def __init__(self, folder: Path, scene: str) -> None:
        self.folder = reference_folder(Path(scene), folder)
        self.about: dict[str, Any] = {}
        self._images: dict[str, Picture] = {}
        about = self.folder / "reference.json"
        if about.exists():
            self.about = json.loads(about.read_text())

    def sha256(self) -> str:
        """Of every picture and of the description: a new one means that errors are measured again."""
        return "".join(file_sha256(path)[:16] for path in sorted(self.folder.glob("*")) if path.is_file())

    def image(self, kind: str) -> Picture:
        if kind.startswith("-"):
            return -self.image(kind[1:])
        if kind not in self._images:
            path = self.folder / f"{kind}.exr"
            if not path.exists():
                raise NoReference(f"no reference {kind}")
            self._images[kind] = read_exr(path)
        return self._images[kind]

    def check_scene(self, scene: str, sha256: str) -> None:
        """A picture of the scene as it is now says nothing against a reference of how it was."""
        if self.folder.name == scene and self.about.get("scene_sha256", sha256) != sha256:
            raise NoReference("the reference is of another state of the scene: tools/references.py")

    def noise(self, kinds: tuple[str, ...]) -> float | None:
        """The references' own, as relMSE. Of a sum, the noisiest part's."""
        known = self.about.get("kinds", {})
        return max((known[kind]["noise_relmse"] for kind in (kind.removeprefix("-") for kind in kinds) if kind in known),
                   default=None)

    def exposures(self) -> dict[str, Any] | None:
        """HDR-FLIP's, the same for all light of a scene."""
        return self.about.get("hdr_flip_exposures")


def same_grid(image: Picture, side: tuple[int, int]) -> Picture:
    """Averages whole boxes of pixels: what a box filter would have given at the smaller size."""
    height, width = side
    rows, columns = image.shape[0] // height, image.shape[1] // width
    if (rows * height, columns * width) != image.shape[:2] or rows != columns:
        raise NoReference(f"a reference of {image.shape[1]}x{image.shape[0]} pixels is none for a picture of {width}x{height}: "
                          f"tools/references.py --size {width}x{height}")
    return image.reshape(height, rows, width, columns, -1).mean(axis=(1, 3))


def pair(measure: Measure, folder: Path, references: References) -> tuple[Picture, Picture]:
    """vct's picture and its reference, both linear and on the picture's pixel grid.

    A picture is never averaged down: that would hide noise that is seen in the frame whose time stands beside it.
    """
    image = sum(read_exr(folder / f"{name}.exr") for name in measure.pictures)
    reference = sum(references.image(kind) for kind in measure.references)
    return image, same_grid(reference, image.shape[:2])


def measurable(entry: dict[str, Any]) -> list[Measure]:
    """Those that fit the preset's bounces, and whose mode is among the point's, so that none is shown without a time."""
    return [measure for measure in MEASURES if measure.mode in entry["modes"]
            and (entry["settings"]["preset"] in ONE_BOUNCE or not measure.one_bounce)]


def errors(entry: dict[str, Any], folder: Path, references: References) -> dict[str, Any]:
    """Per measure its metrics, or `missing`: why there are none."""
    found: dict[str, Any] = {}
    for measure in measurable(entry):
        try:
            references.check_scene(entry["scene"], entry["scene_sha256"])
            image, reference = pair(measure, folder, references)
            found[measure.name] = metrics.compare(image, reference, references.exposures(),
                                                  references.noise(measure.references), flip=not measure.share)
        except (NoReference, PictureError) as why:
            found[measure.name] = {"missing": str(why)}
    return found
