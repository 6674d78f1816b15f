"""The page's JSON: everything it shows but the pictures themselves."""
from __future__ import annotations

import datetime
import json
from pathlib import Path
from typing import Any

import files
from motion.tables import tables
from report.pictures import Album, error_palette, small_png
from report.sweep_data import add_pictures, point
from sweep.measures import MEASURES
from sweep.settings import MODES, SETTINGS
from sweep.usual import usual_settings

METRICS = (
    ("relmse", "relMSE", "relMSE", "Mean of (x − r)² / (r² + 0.01): how wrong, dark parts weighted like bright ones."),
    ("bias", "bias", "|bias|", "mean(x) / mean(r) − 1: too bright or too dark over the whole picture."),
    ("flip", "FLIP", "FLIP", "What a person sees when flipping the two, 0 to 1 (sRGB, 67 pixels per degree); light above 1 is white."),
    ("hdr_flip", "HDR-FLIP", "HDR-FLIP", "The same at every exposure, worst kept; the exposures are fixed per scene."),
    ("p999", "99.9 %", "99.9th percentile of the error", "The 99.9th percentile of the absolute error: leaks, fireflies."),
    ("rmse", "RMSE", "RMSE", "Root of the mean squared error."),
)
FILE_VERSION = 1  # of the JSON of vct bench and of tools/motion.py
LABELS = {"backend": "driver", "cone_angle_deg": "cone angle"}
SOFTWARE = ("llvmpipe", "softpipe", "lavapipe", "swrast")


def metric_rows(entries: list[dict[str, Any]]) -> list[dict[str, str]]:
    """The metrics that the sweep has."""
    held = {name for entry in entries for error in entry.get("errors", {}).values() for name in error}
    return [{"name": name, "label": label, "axis": axis, "what": what} for name, label, axis, what in METRICS
            if name in held or not held]


def setting_rows(entries: list[dict[str, Any]]) -> list[dict[str, Any]]:
    rows = []
    for setting in SETTINGS:
        values = sorted({entry["settings"][setting.name] for entry in entries}, key=lambda value: (isinstance(value, str), value))
        rows.append({"name": setting.name, "label": LABELS.get(setting.name, setting.name), "values": values,
                     "changes": sorted(setting.changes) if setting.changes else None})
    return rows


def scene_rows(sweep: dict[str, Any], entries: list[dict[str, Any]]) -> dict[str, Any]:
    rows = {}
    for name in sorted({entry["scene"] for entry in entries}):
        kinds = sweep["scenes"][name]["reference"].get("kinds", {})
        triangles = next((e["triangles"] for e in entries if e["scene"] == name and "triangles" in e), 0)
        rows[name] = {"triangles": triangles, "noise": {kind: about["noise_relmse"] for kind, about in kinds.items()}}
    return rows


def joined(values: Any) -> str:
    """Each once, in order."""
    return "; ".join(dict.fromkeys(str(value) for value in values)) or "unknown"


def facts(sweep: dict[str, Any], entries: list[dict[str, Any]]) -> list[tuple[str, str]]:
    """Driver, machine, commit, method: without them a time says nothing."""
    done = [entry for entry in entries if entry["status"] == "done"]
    days = sorted(entry["started"] for entry in entries)
    failed = len(entries) - len(done)
    return [
        ("Driver", joined(f"{e['driver']['renderer']}, {e['driver']['version']} ({e['driver']['backend']})"
                          for e in done)),
        ("Machine", joined(f"{e['machine']['cpu']}, {e['machine']['threads']} threads, {e['machine']['system']}"
                           for e in done)),
        ("Program", f"commit {joined(run['commit'] for run in sweep['runs'])}"),
        ("Measured", f"{days[0][:16].replace('T', ' ')} to {days[-1][:16].replace('T', ' ')} UTC"),
        ("Timing", joined(f"{e['method']['clock']}; median of {e['method']['frames']} frames after "
                          f"{e['method']['warm_up_frames']} to warm up" for e in done)),
        ("Points", f"{len(done)} done, {failed} failed, in {len(sweep['runs'])} run(s)"),
        ("Page", f"made {datetime.datetime.now(datetime.timezone.utc):%Y-%m-%d %H:%M} UTC at {files.commit()}"),
    ]


def method(sweep: dict[str, Any], entries: list[dict[str, Any]]) -> list[str]:
    drivers = joined(entry["driver"]["renderer"] for entry in entries if "driver" in entry)
    said = [
        "Every point is one fresh process of vct render. Each step of a frame lies between two glFinish, timed by the "
        "CPU's steady clock; 2 frames warm up, 5 count, and the voxels are made anew in each. The times here are "
        "medians; the smallest and largest are shown where there is room. docs/timings.md says more.",
        "The references are path traced by Mitsuba 3 from the same file, camera and light (tools/references.py). "
        "The reference of the soft shadow is a sun of 5 degrees: cones of other angles are judged against that one too.",
        "Errors are of the frames that were timed, with their one sample in each pixel. A pixel of a reference is the "
        "mean of many samples, so a part of every error is the steps at edges. A reference larger than the picture is "
        "averaged down to it.",
        "A setting that a mode does not feel is not varied for it: the cone angle changes the shadow of "
        "gi-cone-shadow alone, so the other modes are rendered at one angle.",
    ]
    if any(name in drivers.lower() for name in SOFTWARE):
        said.insert(1, f"{drivers} is a software driver: its times are only comparable with others of the same run on "
                       "the same machine, and say nothing of a phone.")
    if len(sweep["runs"]) > 1:
        said.insert(2, f"The points come from {len(sweep['runs'])} runs of the sweep: compare times across them "
                       "with care.")
    return said


def hard_cases(path: Path | None, album: Album) -> list[dict[str, Any]] | None:
    if path is None:
        return None
    rows = json.loads(path.read_text())
    for row in rows:
        picture = path.parent / row["picture"] if row.get("picture") else None
        name = f"hard {row['name']}"
        if picture and picture.is_file() and album.add(name, lambda: small_png(picture, 320)):
            row["image"] = name
    return rows


def motion(path: Path | None) -> list[dict[str, Any]] | None:
    """What tools/motion.py measured, as tables."""
    return [vars(table) for table in tables(json_file(path, "size"))] if path else None


def json_file(path: Path, needs: str) -> dict[str, Any]:
    """`needs`: what the file must hold beside its version."""
    data = json.loads(path.read_text())
    if data.get("version") != FILE_VERSION or needs not in data:
        raise SystemExit(f"error: {path} has version {data.get('version')}, {'with' if needs in data else 'without'} {needs}; "
                         f"this program reads version {FILE_VERSION} with {needs}")
    return data


def presets(path: Path | None) -> dict[str, Any] | None:
    if path is None:
        return None
    data = json_file(path, "presets")
    note = (f"Milliseconds; {data['method']['statistic']}. {data['driver']['renderer']}, {data['machine']['cpu']}. The last "
            "rows: how many times the first preset's.")
    return {"scene": data["scene"], "note": note, "presets": data["presets"], "ratios": data["ratios"]}


def bench(path: Path | None) -> dict[str, Any] | None:
    if path is None:
        return None
    data = json_file(path, "tables")
    note = (f"Milliseconds; {data['method']['statistic']}. {data['driver']['renderer']}, {data['machine']['cpu']}. The "
            "thesis's rows are its own, on its own scene.")
    return {"scene": data["scene"], "note": note, "tables": data["tables"]}


def page_data(sweep: dict[str, Any], sweep_folder: Path, references: Path, hard: Path | None, tables: Path | None,
              beside: Path | None, moving: Path | None, album: Album) -> dict[str, Any]:
    """All of it; the pictures go into the album, whose part they name."""
    entries = sweep["points"]
    usual = usual_settings(entries)
    hard_rows = hard_cases(hard, album)
    pictures = add_pictures(entries, usual, sweep_folder, references, album)
    colours = error_palette()
    asked = {mode for entry in entries for mode in entry["modes"]}
    return {
        "facts": facts(sweep, entries), "method": method(sweep, entries), "usual": usual,
        "modes": [mode for mode in MODES if mode in asked], "metrics": metric_rows(entries),
        "settings": setting_rows(entries), "scenes": scene_rows(sweep, entries),
        "measures": [{"name": m.name, "what": m.what, "mode": m.mode} for m in MEASURES],
        "points": [point(entry) for entry in entries], "pictures": pictures,
        "hard": hard_rows, "motion": motion(moving), "bench": bench(tables), "presets": presets(beside), "album": album.pictures,
        "error_colours": [f"rgb({r},{g},{b})" for r, g, b in zip(colours[::3], colours[1::3], colours[2::3])],
    }
