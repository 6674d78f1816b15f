"""Runs one point in processes of its own and reads what they wrote."""
from __future__ import annotations

import json
import subprocess
import time
from pathlib import Path
from typing import Any

from sweep.identity import ROOT
from sweep.settings import Point

TIMINGS_VERSION = 2
# From timings.json into the point's entry, as they are.
COPIED = ("driver", "machine", "method", "triangles", "active_voxels", "resources")


class PointFailed(Exception):
    """The message is what sweep.json keeps of the failure."""


def last_words(text: str) -> str:
    """What a failed program said: its error, or the end of its output; without this machine's folders."""
    lines = [line.replace(f"{ROOT}/", "") for line in text.strip().splitlines() if line.strip()]
    errors = [line for line in lines if "error" in line.lower()]
    return "\n".join(errors[-3:] or lines[-5:]) or "it said nothing"


def step_medians(timings: dict[str, Any], modes: tuple[str, ...]) -> dict[str, Any]:
    """Per mode its steps, whether the file holds one mode or several."""
    if timings.get("version") != TIMINGS_VERSION:
        raise PointFailed(f"timings.json has version {timings.get('version')}, not {TIMINGS_VERSION}")
    if "steps" in timings:
        return {timings["mode"]: timings["steps"]}
    found = {name: mode["steps"] for name, mode in timings["modes"].items()}
    if set(found) != set(modes):
        raise PointFailed(f"timings.json holds {', '.join(found)}, not {', '.join(modes)}")
    return found


def render(program: Path, arguments: list[str], timeout_s: float) -> str:
    """What it said on stderr."""
    try:
        done = subprocess.run([str(program), "render", *arguments], capture_output=True, text=True, timeout=timeout_s,
                              check=False)
    except subprocess.TimeoutExpired:
        raise PointFailed(f"stopped after {timeout_s:g} s") from None
    except OSError as error:
        raise PointFailed(f"could not be started: {error.strerror}") from None
    if done.returncode != 0:
        how = f"signal {-done.returncode}" if done.returncode < 0 else f"exit {done.returncode}"
        raise PointFailed(f"{how}: {last_words(done.stderr)}")
    return done.stderr


def run(point: Point, program: Path, folder: Path, timeout_s: float) -> dict[str, Any]:
    """Renders into `folder`; returns the part of the point's entry that the renderer knows.

    One process both times and draws, so that no time stands beside the error of another picture.
    """
    folder.mkdir(parents=True, exist_ok=True)
    start = time.monotonic()
    said = render(program, [str(point.scene), "--out", str(folder), "--mode", ",".join(point.modes), *point.arguments(),
                            "--light-parts", "--revoxelize", "--timings", str(folder / "timings.json")], timeout_s)
    try:
        timings = json.loads((folder / "timings.json").read_text())
    except (OSError, ValueError) as error:
        raise PointFailed(f"timings.json cannot be read: {error}") from None
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
