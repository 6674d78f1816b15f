#!/usr/bin/env python3
"""The README's table of errors, as Markdown, from a sweep: each cell thesis / mobile / quality, at their usual settings.

    .venv/bin/python tools/summary.py --sweep out/sweep/sweep.json
"""
from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

from sweep import store
from sweep.usual import PRESETS, usual_points
from tables import markdown

# Column, measure of tools/sweep/measures.py, metric of tools/metrics.py.
COLUMNS = (("relMSE", "indirect", "relmse"), ("bias", "indirect", "bias"), ("FLIP", "indirect", "flip"),
           ("occlusion", "ao", "rmse"), ("mode 4: relMSE", "gi-full", "relmse"), ("bias", "gi-full", "bias"),
           ("FLIP", "gi-full", "flip"), ("soft shadow", "shadow", "rmse"))
DIGITS = {"relmse": 4, "rmse": 3, "flip": 2}
# The furnace's bounces are brighter than FLIP's white.
SAYS_NOTHING = {("furnace", "gi-full", "flip")}


def number(value: float | None, metric: str) -> str:
    """.0185, +11 %, .21"""
    if value is None:
        return "–"
    if metric == "bias":
        return f"{value * 100:+.0f} %".replace("-", "−").replace("+0 %", "0 %").replace("−0 %", "0 %")
    return f"{value:.{DIGITS[metric]}f}".removeprefix("0")


def cell(scene: str, points: dict[str, dict[str, Any]], measure: str, metric: str) -> str:
    found = [points.get(preset, {}).get("errors", {}).get(measure, {}).get(metric) for preset in PRESETS]
    if (scene, measure, metric) in SAYS_NOTHING or found == [None] * len(PRESETS):
        return "–"
    return " / ".join(number(value, metric) for value in found)


def table(scenes: dict[str, dict[str, dict[str, Any]]]) -> str:
    return markdown(["scene", *(column for column, _, _ in COLUMNS)], (
        [scene.replace("_", " "), *(cell(scene, points, measure, metric) for _, measure, metric in COLUMNS)]
        for scene, points in sorted(scenes.items())))


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sweep", type=Path, default=Path("out/sweep/sweep.json"), help="default: %(default)s")
    print(table(usual_points(store.read(parser.parse_args().sweep))), end="")
