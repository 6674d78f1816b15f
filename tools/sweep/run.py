"""Runs one point in a process of its own and reads what it wrote."""
from __future__ import annotations

import json
import time
from pathlib import Path
from typing import Any

import program
from files import ROOT
from sweep.settings import Point

TIMINGS_VERSION = 4
# From timings.json into the point's entry, as they are.
COPIED = ("driver", "machine", "method", "triangles", "active_voxels", "resources")


def step_medians(timings: dict[str, Any], modes: tuple[str, ...]) -> dict[str, Any]:
    """Per mode its steps."""
    if timings.get("version") != TIMINGS_VERSION:
        raise program.Failed(f"timings.json has version {timings.get('version')}, not {TIMINGS_VERSION}")
    found = {name: mode["steps"] for name, mode in timings["modes"].items()}
    if set(found) != set(modes):
        raise program.Failed(f"timings.json holds {', '.join(found)}, not {', '.join(modes)}")
    return found


def run(point: Point, vct: Path, folder: Path, timeout_s: float) -> dict[str, Any]:
    """Renders into `folder`; returns the part of the point's entry that the renderer knows.

    One process both times and draws, so that no time stands beside the error of another picture.
    """
    folder.mkdir(parents=True, exist_ok=True)
    start = time.monotonic()
    said = program.render(vct, point.scene, "--out", folder, "--mode", ",".join(point.modes), *point.arguments(),
                          "--light-parts", "--revoxelize", "--timings", folder / "timings.json", timeout_s=timeout_s)
    try:
        timings = json.loads((folder / "timings.json").read_text())
    except (OSError, ValueError) as error:
        raise program.Failed(f"timings.json cannot be read: {error}") from None
    entry = {name: timings[name] for name in COPIED if name in timings}
    entry["grid"] = timings["settings"]["grid"]  # which the scene chose where "auto" was asked for
    entry["light_frames"] = timings["settings"]["light_frames"]
    entry["modes"] = step_medians(timings, point.modes)
    entry["wall_s"] = round(time.monotonic() - start, 2)
    entry["pictures"] = sorted(path.stem for path in folder.glob("*.exr"))
    entry["warnings"] = [line.replace(f"{ROOT}/", "") for line in said.splitlines() if line.startswith("warning")]
    for png in folder.glob("*.png"):  # The report makes its own from the EXR.
        png.unlink()
    return entry
