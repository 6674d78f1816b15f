#!/usr/bin/env python3
"""One picture of time against error for all presets, from a sweep: docs/images/pareto.png.

    .venv/bin/python tools/pareto.py --sweep out/sweep/sweep.json

Small marks are scenes, large ones the geometric means over them. Time is that of mode 4's voxels, irradiance and cones,
the error relMSE of the indirect light. Left out: the furnace and the lone plane, which are truths and not scenes.
"""
from __future__ import annotations

import argparse
import io
from dataclasses import dataclass
from pathlib import Path
from statistics import geometric_mean
from typing import Any

from matplotlib import rcParams, ticker
from matplotlib.figure import Figure

from files import shown, write_whole
from references import SAME_PICTURE
from sweep import store
from sweep.usual import USUAL, light_ms

TRUTHS = {"furnace", "lone_plane"}
# The report's, a little darker: they must stand on white.
COLOURS = {"thesis": "#c8641e", "mobile": "#3b7fc4", "quality": "#0a7f5d"}
MARKS = "osD^vPX*"


@dataclass(frozen=True)
class Dot:
    scene: str
    preset: str
    grid: int
    ms: float
    error: float


def dots(sweep: dict[str, Any]) -> list[Dot]:
    found = []
    for entry in sweep["points"]:
        settings = entry["settings"]
        error = entry.get("errors", {}).get("indirect", {}).get("relmse")
        if (error and entry["scene"] not in TRUTHS | SAME_PICTURE.keys() and settings["grid"] != "auto"
                and settings["cone_angle_deg"] == USUAL["cone_angle_deg"]):
            found.append(Dot(entry["scene"], settings["preset"], settings["grid"], light_ms(entry["modes"]["gi"])[0], error))
    return found


def means(found: list[Dot]) -> list[Dot]:
    """Over the scenes, of each preset and grid that has all of them."""
    groups: dict[tuple[str, int], list[Dot]] = {}
    for dot in found:
        groups.setdefault((dot.preset, dot.grid), []).append(dot)
    scenes = {dot.scene for dot in found}
    return [Dot("", preset, grid, geometric_mean(dot.ms for dot in group), geometric_mean(dot.error for dot in group))
            for (preset, grid), group in sorted(groups.items()) if {dot.scene for dot in group} == scenes]


def is_usual(dot: Dot) -> bool:
    """Not another grid of the thesis's preset."""
    return dot.preset != "thesis" or dot.grid == USUAL["grid"]


def footnote(sweep: dict[str, Any]) -> str:
    entry = next(entry for entry in sweep["points"] if "driver" in entry)
    driver = entry["driver"]["renderer"].split(" (")[0]
    return (f"Large: geometric mean of the scenes. {driver}{', a software driver' if driver == 'llvmpipe' else ''}; mode 4; "
            f"times and errors of the same frames of {entry['settings']['size']} pixels.")


def draw(found: list[Dot], note: str) -> bytes:
    rcParams["font.size"] = 16
    figure = Figure(figsize=(16, 8.6), dpi=100, layout="constrained")
    axes = figure.subplots()
    for mark, scene in zip(MARKS, sorted({dot.scene for dot in found})):
        mine = [dot for dot in found if dot.scene == scene and is_usual(dot)]
        axes.scatter([dot.ms for dot in mine], [dot.error for dot in mine], 120, [COLOURS[dot.preset] for dot in mine],
                     marker=mark, edgecolors="white")
        axes.scatter([], [], 120, "#777777", marker=mark, label=scene.replace("_", " "))
    middle = means(found)
    thesis = [dot for dot in middle if dot.preset == "thesis"]
    axes.plot([dot.ms for dot in thesis], [dot.error for dot in thesis], color=COLOURS["thesis"])
    for dot in middle:
        axes.scatter(dot.ms, dot.error, 700 if is_usual(dot) else 250, COLOURS[dot.preset])
        axes.annotate(f"{dot.preset} {dot.grid}³", (dot.ms, dot.error), (0, 20), textcoords="offset points", ha="center",
                      color=COLOURS[dot.preset], fontsize=20 if is_usual(dot) else 14)
    axes.set(xscale="log", yscale="log", xlabel="milliseconds a frame: voxels, irradiance and cones",
             ylabel="error of the indirect light, relMSE")
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(ticker.LogLocator(subs=(1, 2, 5)))
        axis.set_major_formatter(ticker.FormatStrFormatter("%g"))
        axis.set_minor_locator(ticker.NullLocator())
    axes.grid(color="#e4e4e4")
    axes.set_axisbelow(True)
    axes.spines[["top", "right"]].set_visible(False)
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
