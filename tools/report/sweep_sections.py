"""What the page shows of a sweep: summary, time against error, pictures, tables."""
from __future__ import annotations

from pathlib import Path
from typing import Any

from references import SAME_PICTURE
from report import pictures, plots
from report.html import Html, details, image, join, table, tag
from sweep.measures import MEASURES, Measure, NoReference, References, pair
from sweep.settings import MODES, SETTINGS
from sweep.usual import closeness, usual_settings
from tables import STEPS
from truth.exr import PictureError

METRICS = {
    "relmse": ("relMSE", "Mean of (x − r)² / (r² + 0.01): how wrong, dark parts weighted like bright ones. “At the floor”: the "
               "error cannot be told from the reference's own noise, so its number says nothing."),
    "bias": ("bias", "mean(x) / mean(r) − 1: too bright or too dark over the whole picture."),
    "flip": ("FLIP", "What a person sees when flipping the two, 0 to 1 (sRGB, 67 pixels per degree); light above 1 is white."),
    "hdr_flip": ("HDR-FLIP", "The same at every exposure, worst kept; the exposures are fixed per scene."),
    "p999": ("99.9 %", "The 99.9th percentile of the absolute error: leaks, fireflies."),
    "rmse": ("RMSE", "Root of the mean squared error."),
}
SUMMARY = {"indirect": ("relmse", "bias", "flip"), "gi-full": ("relmse", "bias", "flip"), "soft-full": ("relmse", "bias"),
           "shadow": ("rmse",), "ao": ("rmse",)}
Entry = dict[str, Any]


def number(value: float | None) -> str:
    return "–" if value is None else f"{value:.3g}"


def error_text(errors: dict[str, Any], measure: str, metric: str) -> str:
    error = errors.get(measure, {})
    if metric == "relmse" and error.get("at_noise_floor"):
        return "at the floor"
    value = error.get(metric)
    return f"{100 * value:+.1f} %" if metric == "bias" and value is not None else number(value)


def total_ms(entry: Entry, mode: str) -> str:
    return number(entry["modes"][mode]["total"]["median"]) if entry["modes"].get(mode) else "–"


def settings_text(settings: dict[str, Any]) -> str:
    """`thesis, 256x256, 256³, 5°`; the driver where it is not the usual one."""
    backend = [] if settings["backend"] == "egl" else [settings["backend"]]
    return ", ".join([settings["preset"], settings["size"], f"{settings['grid']}³", f"{settings['cone_angle_deg']:g}°", *backend])


class SweepSections:
    """One sweep's points by scene, those of usual settings first."""

    def __init__(self, sweep: dict[str, Any], folder: Path, references: Path, album: pictures.Album) -> None:
        self.folder, self.references, self.album = folder, references, album
        self.points: list[Entry] = sweep["points"]
        self.usual = usual_settings(self.points)
        self.done = sorted((entry for entry in self.points if entry["status"] == "done"),
                           key=lambda entry: (entry["scene"], closeness(entry, self.usual)))
        self.scenes = list(dict.fromkeys(entry["scene"] for entry in self.done))
        self.modes = [mode for mode in MODES if any(mode in entry["modes"] for entry in self.points)]

    def of(self, scene: str) -> list[Entry]:
        return [entry for entry in self.done if entry["scene"] == scene]

    def usual_of(self, scene: str) -> list[Entry]:
        return [entry for entry in self.of(scene) if closeness(entry, self.usual) == 0]

    def summary(self) -> Html:
        columns = [(measure, metric) for measure, metrics in SUMMARY.items() for metric in metrics]
        head = ["scene", "preset", *(f"{mode}, ms" for mode in self.modes),
                *(f"{measure}: {METRICS[metric][0]}" for measure, metric in columns)]
        rows = [[scene, entry["settings"]["preset"], *(total_ms(entry, mode) for mode in self.modes),
                 *(error_text(entry["errors"], *column) for column in columns)]
                for scene in self.scenes for entry in self.usual_of(scene)]
        failed = [tag("li", f"{entry['scene']}: {settings_text(entry['settings'])}", tag("pre", entry["message"]))
                  for entry in self.points if entry["status"] == "failed"]
        usual = "; ".join(settings_text(settings) for settings in self.usual.values())
        return join([tag("p", f"At {usual}. Times are medians of a frame; errors are of linear light."), table(head, rows),
                     tag("div", tag("strong", f"{len(failed)} failed"), tag("ul", *failed), class_="failed") if failed else None])

    def time_against_error(self) -> Html:
        parts = []
        for measure in MEASURES:
            dots = [plots.dot(entry, measure.name, measure.mode) for entry in self.done if entry["scene"] not in SAME_PICTURE]
            if found := [dot for dot in dots if dot]:
                plot = image(plots.of_scenes(found, measure), f"Time against the error of {measure.name}, one plot for each scene")
                parts.append(details(f"{measure.name}: {measure.what}", plot, opened=measure is MEASURES[0]))
        return join([tag("p", "Down and to the left is better. The line is the Pareto front: nothing measured is both faster and "
                              "nearer to the truth."), *parts])

    def compared(self, scene: str, measure: Measure) -> Html | None:
        """Each preset's picture over the reference, and its error; None where there are none."""
        references = References(self.references, scene)
        kinds = ("full",) if measure.name.startswith(("gi", "soft")) else measure.references
        figures, address = [], None
        for entry in (entry for entry in self.usual_of(scene) if measure.name in entry["errors"]):
            try:
                picture, reference = pair(measure, self.folder / entry["folder"], references)
                exposure = 1.0 if measure.share else pictures.exposure_for(sum(references.image(kind) for kind in kinds))
            except (NoReference, PictureError):
                continue
            address = address or self.album.address(lambda: pictures.picture_png(reference, exposure))
            shown = self.album.address(lambda: pictures.picture_png(picture, exposure))
            error = self.album.address(lambda: pictures.error_png(picture, reference))
            if address and shown and error:
                metric = "rmse" if measure.share else "relmse"
                what = (f"{entry['settings']['preset']}: {METRICS[metric][0]} {error_text(entry['errors'], measure.name, metric)}, "
                        f"frame {total_ms(entry, measure.mode)} ms")
                figures.append(tag("figure", tag("div", tag("div", image(shown, f"vct, {what}"), class_="over"), class_="compare"),
                                   image(error, "error"), tag("figcaption", what)))
        return tag("div", *figures, style=f"--reference: url({address})") if figures else None

    def pictures(self) -> Html:
        parts = [tag("p", "On the left vct over the path-traced reference: pull its lower right corner. On the right the error, the "
                          "difference over √(reference² + 0.01), whose mean square is relMSE: red to yellow too bright, blue to cyan "
                          "too dark. Exposures are the same for all presets. The pictures of other settings lie in the sweep's folder.")]
        for measure in MEASURES:
            for scene in self.scenes:
                if scene not in SAME_PICTURE and (figures := self.compared(scene, measure)):
                    parts.append(details(f"{scene}, {measure.name}: {measure.what}", figures, opened=len(parts) == 1))
        return join(parts)

    def tables(self) -> Html:
        return join(details(scene, tag("h3", "Steps, milliseconds"), self.step_table(scene), tag("h3", "Errors"),
                            self.error_table(scene), tag("h3", "Active voxels of each level, finest first; bytes on the GPU"),
                            self.voxel_table(scene)) for scene in self.scenes)

    def step_table(self, scene: str) -> Html:
        return table(["settings", "mode", *STEPS.values(), "frame, min to max"], (
            [settings_text(entry["settings"]), mode, *(number(steps[step]["median"]) for step in STEPS),
             f"{number(steps['total']['min'])} to {number(steps['total']['max'])}"]
            for entry in self.of(scene) for mode, steps in entry["modes"].items()))

    def error_table(self, scene: str) -> Html:
        return table(["settings", "judged", *(label for label, _ in METRICS.values()), ""], (
            [settings_text(entry["settings"]), measure, *(error_text(entry["errors"], measure, metric) for metric in METRICS),
             error.get("missing", "")] for entry in self.of(scene) for measure, error in entry["errors"].items()))

    def voxel_table(self, scene: str) -> Html:
        return table(["settings", "triangles", "active voxels", "share of level 0", "MB", "largest resources"], (
            [settings_text(entry["settings"]), f"{entry['triangles']:,}", ", ".join(f"{count:,}" for count in entry["active_voxels"]),
             f"{entry['active_voxels'][0] / entry['grid'] ** 3:.2%}", f"{sum(one['bytes'] for one in entry['resources']) / 1e6:.1f}",
             ", ".join(f"{one['name']} {one['bytes'] / 1e6:.1f}"
                       for one in sorted(entry["resources"], key=lambda one: -one["bytes"])[:3])]
            for entry in self.of(scene)))
