"""What the page needs of sweep.json, and the pictures of its points."""
from __future__ import annotations

from pathlib import Path
from typing import Any

from report import pictures
from report.pictures import Album
from sweep.measures import MEASURES, Measure, NoReference, References, pair
from sweep.usual import closeness, light_ms

STEPS = ("shadow_map", "render_data", "voxelize", "mipmap", "irradiance", "trace", "total")


def point(entry: dict[str, Any]) -> dict[str, Any]:
    """A point without samples and hashes."""
    modes = {mode: {step: [steps[step]["median"], steps[step]["min"], steps[step]["max"]] for step in STEPS}
             | {"light": light_ms(steps)} for mode, steps in entry["modes"].items() if steps}
    kept = ("key", "scene", "settings", "grid", "run", "status", "message", "active_voxels", "resources", "errors", "wall_s")
    return {name: entry[name] for name in kept if name in entry} | {"modes": modes, "asked_modes": list(entry["modes"])}


class ScenePictures:
    """One scene's pictures against its references."""

    def __init__(self, scene: str, sweep_folder: Path, references: Path, album: Album) -> None:
        self.scene, self.folder, self.album = scene, sweep_folder, album
        self.references = References(references, scene)
        self.exposures: dict[str, float] = {}

    def exposure(self, measure: Measure) -> float:
        """One per measure and scene, so that all its configurations can be compared by eye."""
        if measure.name not in self.exposures:
            kinds = ("full",) if measure.name.startswith(("gi", "soft")) else measure.references
            self.exposures[measure.name] = 1.0 if measure.share else pictures.exposure_for(
                sum(self.references.image(kind) for kind in kinds))
        return self.exposures[measure.name]

    def add(self, entry: dict[str, Any], measure: Measure, palette: bool) -> dict[str, Any] | None:
        """Names of the picture, the reference and the error picture; None where one is missing."""
        folder = self.folder / entry["folder"]
        try:
            picture, reference = pair(measure, folder, self.references)
            exposure = self.exposure(measure)
        except (NoReference, OSError):
            return None
        size = entry["settings"]["size"]
        names = {"picture": f"{entry['key']} {'+'.join(measure.pictures)} {exposure:.4g}",
                 "reference": f"{self.scene} {'+'.join(measure.references)} {exposure:.4g} {size}",
                 "error": f"{entry['key']} {measure.name} error"}
        made = (self.album.add(names["reference"], lambda: pictures.picture_png(reference, exposure, False))
                and self.album.add(names["picture"], lambda: pictures.picture_png(picture, exposure, palette))
                and self.album.add(names["error"], lambda: pictures.error_png(picture, reference)))
        return {**names, "exposure": exposure} if made else None


def add_pictures(entries: list[dict[str, Any]], usual: dict[str, dict[str, Any]], folder: Path, references: Path,
                 album: Album) -> dict[str, dict[str, Any]]:
    """By point and measure; the usual settings first, then those that differ in one, until the album is full."""
    scenes = {entry["scene"]: ScenePictures(entry["scene"], folder, references, album) for entry in entries}
    done = [entry for entry in entries if entry["status"] == "done"]
    found: dict[str, dict[str, Any]] = {}
    for measure_number, far, entry, measure in sorted(
            ((number, closeness(entry, usual), entry, measure) for entry in done
             for number, measure in enumerate(MEASURES)
             if measure.mode in entry["modes"]),
            key=lambda item: (min(item[1], 2), item[0])):
        names = scenes[entry["scene"]].add(entry, measure, palette=far > 0)
        if names:
            found.setdefault(entry["key"], {})[measure.name] = names
    return found
