"""What is shown first of a sweep: each preset at its usual settings, and the time that makes its light."""
from __future__ import annotations

import statistics
from typing import Any

from references import SAME_PICTURE

PRESETS = ("thesis", "mobile", "quality")
# All but the shadow map and the G-buffer, which are the same with every preset.
LIGHT = ("voxelize", "inject", "mipmap", "irradiance", "trace")
USUAL = {"grid": 256, "cone_angle_deg": 5.0}


def light_ms(steps: dict[str, Any]) -> list[float]:
    """Median, smallest and largest over the frames."""
    frames = [sum(parts) for parts in zip(*(steps[step]["samples"] for step in LIGHT))]
    return [statistics.median(frames), min(frames), max(frames)]


def usual_settings(points: list[dict[str, Any]]) -> dict[str, dict[str, Any]]:
    """By preset, the settings that the summary shows: the thesis's where they were swept, else the first point's."""
    found: dict[str, dict[str, Any]] = {}
    for preset in dict.fromkeys(entry["settings"]["preset"] for entry in points):
        mine = [entry["settings"] for entry in points if entry["settings"]["preset"] == preset]
        found[preset] = mine[0] | {name: value for name, value in USUAL.items()
                                   if any(settings.get(name) == value for settings in mine)}
    return found


def closeness(entry: dict[str, Any], usual: dict[str, dict[str, Any]]) -> int:
    """How many settings differ from the preset's usual: whose pictures come first."""
    return sum(entry["settings"].get(name) != value for name, value in usual[entry["settings"]["preset"]].items())


def usual_points(sweep: dict[str, Any]) -> dict[str, dict[str, dict[str, Any]]]:
    """Scene -> preset -> the point at the preset's usual settings; a scene that is another one scaled is left out."""
    usual = usual_settings(sweep["points"])
    found: dict[str, dict[str, dict[str, Any]]] = {}
    for entry in sweep["points"]:
        if entry["scene"] not in SAME_PICTURE and closeness(entry, usual) == 0:
            found.setdefault(entry["scene"], {})[entry["settings"]["preset"]] = entry
    return found
