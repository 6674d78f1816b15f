#!/usr/bin/env python3
"""The README's tables of errors, as Markdown, from a sweep: each cell thesis / mobile / quality, at their usual settings.

    .venv/bin/python tools/summary.py --sweep out/sweep/sweep.json
"""
from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parent))

from bars import PRESETS, usual_points  # noqa: E402
from sweep import store  # noqa: E402

# Column -> measure of tools/sweep/measures.py and metric of tools/metrics.py.
INDIRECT = {"relMSE": ("indirect", "relmse"), "bias": ("indirect", "bias"), "FLIP": ("indirect", "flip")}
REST = {"occlusion": ("ao", "rmse"), "soft shadow": ("shadow", "rmse"), "mode 4 against all bounces: bias": ("gi-full", "bias"),
        "FLIP": ("gi-full", "flip")}


# Furnace and lamp have no sun; the furnace's bounces are brighter than FLIP's white.
SAYS_NOTHING = {("furnace", "shadow", "rmse"), ("furnace", "gi-full", "flip"), ("lamp", "shadow", "rmse")}


def number(value: float | None, metric: str) -> str:
    """.0185, +11 %, .21"""
    if value is None:
        return "–"
    if metric == "bias":
        return f"{value * 100:+.0f} %".replace("-", "−").replace("+0 %", "0 %").replace("−0 %", "0 %")
    text = f"{value:.{ {'relmse': 4, 'rmse': 3, 'flip': 2}[metric]}f}"
    return text.removeprefix("0")


def cell(scene: str, points: dict[str, dict[str, Any]], measure: str, metric: str) -> str:
    if (scene, measure, metric) in SAYS_NOTHING:
        return "–"
    found = [points.get(preset, {}).get("errors", {}).get(measure, {}).get(metric) for preset in PRESETS]
    return " / ".join(number(value, metric) for value in found)


def table(scenes: dict[str, dict[str, dict[str, Any]]], columns: dict[str, tuple[str, str]]) -> str:
    lines = ["| scene | " + " | ".join(columns) + " |", "|---" * (len(columns) + 1) + "|"]
    lines += [f"| {scene.replace('_', ' ')} | " + " | ".join(cell(scene, points, *what) for what in columns.values()) + " |"
              for scene, points in sorted(scenes.items())]
    return "\n".join(lines) + "\n"


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sweep", type=Path, default=Path("out/sweep/sweep.json"), help="default: %(default)s")
    scenes = usual_points(store.read(parser.parse_args().sweep))
    print(table(scenes, INDIRECT))
    print(table(scenes, REST), end="")
    return 0


if __name__ == "__main__":
    sys.exit(main())
