#!/usr/bin/env python3
"""One picture of time against error for all presets, from a sweep: docs/images/pareto.png.

    .venv/bin/python tools/pareto.py --sweep out/sweep/sweep.json

Small marks are scenes, large ones the geometric means over them. Time is that of mode 4's voxels, irradiance and cones,
the error relMSE of the indirect light. Left out: the furnace and the lone plane, which are truths and not scenes.
"""
from __future__ import annotations

import argparse
import io
from pathlib import Path
from statistics import geometric_mean
from typing import Any

from matplotlib import rcParams
from matplotlib.figure import Figure

from files import shown, write_whole
from references import SAME_PICTURE
from report.plots import COLOURS, Dot, dot, logarithmic
from sweep import store
from sweep.usual import USUAL

TRUTHS = {"furnace", "lone_plane"}
MARKS = "osD^vPX*"


def dots(sweep: dict[str, Any]) -> list[Dot]:
    usual = (dot(entry, "indirect", "gi") for entry in sweep["points"]
             if entry["scene"] not in TRUTHS | SAME_PICTURE.keys()
             and entry["settings"]["cone_angle_deg"] == USUAL["cone_angle_deg"])
    return [one for one in usual if one]


def means(found: list[Dot]) -> list[Dot]:
    """Over the scenes, of each preset and grid that has all of them."""
    groups: dict[tuple[str, int], list[Dot]] = {}
    for one in found:
        groups.setdefault((one.preset, one.grid), []).append(one)
    scenes = {one.scene for one in found}
    return [Dot("", preset, grid, geometric_mean(one.ms for one in group), geometric_mean(one.error for one in group))
            for (preset, grid), group in sorted(groups.items()) if {one.scene for one in group} == scenes]


def is_usual(one: Dot) -> bool:
    """Not another grid of the thesis's preset."""
    return one.preset != "thesis" or one.grid == USUAL["grid"]


def footnote(sweep: dict[str, Any]) -> str:
    entry = next(entry for entry in sweep["points"] if "driver" in entry)
    driver = entry["driver"]["renderer"].split(" (")[0]
    return (f"Large: geometric mean of the scenes. {driver}{', a software driver' if driver == 'llvmpipe' else ''}; mode 4; "
            f"times and errors of the same frames of {entry['settings']['size']} pixels.")


def draw(found: list[Dot], note: str) -> bytes:
    rcParams["font.size"] = 16
    figure = Figure(figsize=(16, 8.6), dpi=100, layout="constrained")
    axes = figure.subplots()
    for mark, scene in zip(MARKS, sorted({one.scene for one in found})):
        mine = [one for one in found if one.scene == scene and is_usual(one)]
        axes.scatter([one.ms for one in mine], [one.error for one in mine], 120, [COLOURS[one.preset] for one in mine],
                     marker=mark, edgecolors="white")
        axes.scatter([], [], 120, "#777777", marker=mark, label=scene.replace("_", " "))
    middle = means(found)
    thesis = [one for one in middle if one.preset == "thesis"]
    axes.plot([one.ms for one in thesis], [one.error for one in thesis], color=COLOURS["thesis"])
    for one in middle:
        axes.scatter(one.ms, one.error, 700 if is_usual(one) else 250, COLOURS[one.preset])
        axes.annotate(f"{one.preset} {one.grid}³", (one.ms, one.error), (0, 20), textcoords="offset points", ha="center",
                      color=COLOURS[one.preset], fontsize=20 if is_usual(one) else 14)
    logarithmic(axes)
    axes.set(xlabel="milliseconds a frame: voxels, irradiance and cones", ylabel="error of the indirect light, relMSE")
    axes.set_title("Lower left is better", loc="left")
    axes.legend(loc="lower right", bbox_to_anchor=(1, 1), ncols=len(MARKS), frameon=False, columnspacing=0.8, handletextpad=0)
    figure.supxlabel(note, fontsize=13, color="#777777")
    out = io.BytesIO()
    figure.savefig(out, format="png")
    return out.getvalue()


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sweep", type=Path, default=Path("out/sweep/sweep.json"), help="default: %(default)s")
    parser.add_argument("--out", type=Path, default=Path("docs/images/pareto.png"), help="default: %(default)s")
    options = parser.parse_args()
    sweep = store.read(options.sweep)
    found = dots(sweep)
    if not found:
        raise SystemExit(f"error: {options.sweep} has no errors of the indirect light")
    write_whole(options.out, draw(found, footnote(sweep)))
    print(shown(options.out))


if __name__ == "__main__":
    main()
