"""Time against error, both logarithmic: of each scene for the report, of all together for tools/pareto.py."""
from __future__ import annotations

import base64
import io
from dataclasses import dataclass
from typing import Any

from matplotlib import rcParams, ticker
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from sweep.measures import Measure
from sweep.usual import light_ms

# They must stand on white.
COLOURS = {"thesis": "#c8641e", "mobile": "#3b7fc4", "quality": "#0a7f5d"}
ACROSS = 3
rcParams["svg.fonttype"] = "none"


@dataclass(frozen=True)
class Dot:
    scene: str
    preset: str
    grid: int
    ms: float
    error: float


def dot(entry: dict[str, Any], measure: str, mode: str) -> Dot | None:
    """None where the point has no time or no error."""
    error = entry.get("errors", {}).get(measure, {}).get("relmse")
    if not error or not entry["modes"].get(mode):
        return None
    return Dot(entry["scene"], entry["settings"]["preset"], entry["grid"], light_ms(entry["modes"][mode])[0], error)


def logarithmic(axes: Axes, digits: tuple[int, ...] = (1, 2, 5)) -> None:
    axes.set(xscale="log", yscale="log")
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(ticker.LogLocator(subs=digits))
        axis.set_major_formatter(ticker.FormatStrFormatter("%g"))
        axis.set_minor_locator(ticker.NullLocator())
    axes.grid(color="#e4e4e4")
    axes.set_axisbelow(True)
    axes.spines[["top", "right"]].set_visible(False)


def front(found: list[Dot]) -> list[Dot]:
    """Those that nothing else beats both in time and in error, the fastest first."""
    return sorted((a for a in found if not any(b.ms <= a.ms and b.error <= a.error and b != a for b in found)), key=lambda a: a.ms)


def of_scenes(found: list[Dot], measure: Measure) -> str:
    """A picture as an address that holds it: one plot for each scene, the Pareto front as a line."""
    scenes = sorted({one.scene for one in found})
    down = -(-len(scenes) // ACROSS)
    figure = Figure(figsize=(13, 3.6 * down), layout="constrained")
    for axes, scene in zip(figure.subplots(down, ACROSS, squeeze=False).flat, [*scenes, *[None] * (down * ACROSS - len(scenes))]):
        mine = [one for one in found if one.scene == scene]
        axes.set_axis_off() if not mine else logarithmic(axes, (1, 3))
        best = front(mine)
        axes.step([one.ms for one in best], [one.error for one in best], where="post", color="#aaaaaa", linewidth=1)
        for one in mine:
            axes.scatter(one.ms, one.error, 50, COLOURS.get(one.preset, "#777777"))
            axes.annotate(f"{one.preset} {one.grid}³", (one.ms, one.error), (0, 6), textcoords="offset points", ha="center", fontsize=8)
        axes.set_title(scene, fontsize=10)
        axes.margins(0.15)
    figure.supxlabel(f"mode {measure.mode}: milliseconds of voxels, irradiance and cones", fontsize=10)
    figure.supylabel("relMSE", fontsize=10)
    out = io.BytesIO()
    figure.savefig(out, format="svg", metadata={"Creator": None, "Date": None, "Format": None, "Type": None})
    return "data:image/svg+xml;base64," + base64.b64encode(out.getvalue()).decode()
