"""Time against error, one picture for all scenes."""
import io
from collections.abc import Sequence
from statistics import geometric_mean

from matplotlib import rcParams, ticker
from matplotlib.figure import Figure

from .measures import voxels
from .store import Result

COLOURS = {"thesis": "#c8641e", "mobile": "#3b7fc4", "quality": "#0a7f5d"}  # legible on white
MARKS = "osD^vPX*hp"
ANALYTIC = {"furnace", "lone_plane"}  # scenes with a closed-form answer, which nobody would look at
Dot = tuple[float, float]  # milliseconds, relMSE


def dots(results: Sequence[Result]) -> dict[tuple[str, int, str], dict[str, Dot]]:
    """(preset, grid, voxels in words) -> scene -> frame that rebuilds everything, and the error of its indirect light."""
    found: dict[tuple[str, int, str], dict[str, Dot]] = {}
    for one in results:
        error = one["changing"]["errors"]["indirect"]["relmse"]
        if one["scene"] not in ANALYTIC and error > 0:
            found.setdefault((one["preset"], one["grid"], voxels(one)), {})[one["scene"]] = (one["changing"]["ms"]["gi"], error)
    return found


def mean(scenes: dict[str, Dot]) -> Dot:
    return geometric_mean(ms for ms, _ in scenes.values()), geometric_mean(error for _, error in scenes.values())


def draw(results: Sequence[Result]) -> bytes:
    """Small marks are scenes, large ones the geometric means over all scenes, joined for each preset. The PNG's bytes."""
    rcParams["font.size"] = 16
    figure = Figure(figsize=(16, 8.6), dpi=100, layout="constrained")
    axes, found = figure.subplots(), dots(results)
    scenes = sorted({scene for group in found.values() for scene in group})
    marks = {scene: MARKS[i % len(MARKS)] for i, scene in enumerate(scenes)}
    for (preset, _, _), group in found.items():
        for scene, (ms, error) in group.items():
            axes.scatter(ms, error, 120, COLOURS[preset], marker=marks[scene], edgecolors="white")
    for preset in COLOURS:
        means = [(words, *mean(group)) for (name, _, words), group in sorted(found.items())
                 if name == preset and len(group) == len(scenes)]
        axes.plot([ms for _, ms, _ in means], [error for _, _, error in means], color=COLOURS[preset])
        for words, ms, error in means:
            axes.scatter(ms, error, 600, COLOURS[preset])
            axes.annotate(f"{preset} {words}", (ms, error), (0, 20), textcoords="offset points", ha="center",
                          color=COLOURS[preset])
    for scene in scenes:
        axes.scatter([], [], 120, "#777777", marker=marks[scene], label=scene.replace("_", " "))
    axes.set(xscale="log", yscale="log", xlabel="milliseconds of a frame that rebuilds everything",
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
    figure.supxlabel(f"Large marks: geometric mean of the scenes. {results[0]['driver']}", fontsize=13, color="#777777")
    out = io.BytesIO()
    figure.savefig(out, format="png")
    return out.getvalue()
