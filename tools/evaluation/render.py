"""Draws each preset's picture of scenes that have references, and prints its times and errors as a Markdown table.

    tools/eval.py render --headline                          the README's table: cornell, all presets in one run, with the errors
                                                             of 16 samples per pixel, as docs/comparison.md has
    tools/eval.py render cornell night --measures all        also soft shadow and ambient occlusion
    tools/eval.py render                                     every scene of assets/
    tools/eval.py render cornell corridor --grids 64,128     how time and error follow the number of voxels
    tools/eval.py render cornell courtyard --sheet out/presets.png
    tools/eval.py render town --cameras court,stairs --cascades 1,5 --measures gi --presets mobile

The measure `gi` is that mode's picture, `indirect` one bounce of light alone, and `soft` mode gi-cone-shadow under a sun of 5
degrees. As root mean square errors, `shadow` is the visible share of that sun and `ao` ambient occlusion. Compare times of a
software driver within one run only. The T880 column of the headline appears after `eval.py mali` with the same build of vct.
"""
import argparse
from collections.abc import Sequence
from pathlib import Path

from files import ROOT, find_scene, static_scenes, write_whole
from tables import fraction, markdown, milliseconds, percent

from . import mali, options, pictures
from .measures import MEASURES, STILL_SAMPLES, task, voxels
from .progress import say
from .store import Result, Store

GRIDS = ("64", "128", "256", "512")
MEANINGS = """\
camera moving        time of a frame while only the camera moves: light and voxels are kept
everything changing  time of a frame that rebuilds shadow map, voxels and light
relMSE, FLIP         errors of the converged picture, mode gi, against path tracing with all bounces: squared error relative to
                     each pixel's brightness, and how different the two look (0 to 1). 0 is perfect
bias                 how much too bright (+) or too dark (-) the mean is"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.epilog = MEANINGS
    options.add_store(parser)
    options.add_presets(parser)
    parser.add_argument("scenes", nargs="*", metavar="SCENE", help="names in assets/, or files (default: all that have references)")
    options.add_cameras(parser)
    parser.add_argument("--cascades", type=options.counts, default=[1], metavar="COUNTS",
                        help="numbers of nested cubes of voxels, with commas (default: 1; not with the preset thesis)")
    parser.add_argument("--size", type=options.size, help="WIDTHxHEIGHT (default: that of the references)")
    parser.add_argument("--measures", type=options.names([*MEASURES, "all"], "measure"), default=["gi", "indirect"],
                        help=f"of {','.join(MEASURES)}, or all (default: gi,indirect)")
    parser.add_argument("--grids", type=options.names(GRIDS, "grid"), default=[None],
                        help=f"voxels along a side, with commas, of {','.join(GRIDS)} (default: each preset's)")
    parser.add_argument("--headline", action="store_true", help="measure again and print the README's table (default: cornell)")
    parser.add_argument("--sheet", type=Path, metavar="FILE.png", help="draw the presets' pictures beside path tracing")


def table(results: Sequence[Result]) -> str:
    """One row for each picture."""
    others = list(dict.fromkeys(name for one in results for name in one["camera"]["errors"] if name != "gi"))
    metric = {name: "rmse" if MEASURES[name].is_share else "relmse" for name in others}
    rows = [[one["scene"], f"{one['preset']}, {voxels(one)}", milliseconds(one["camera"]["ms"]["gi"]),
             milliseconds(one["changing"]["ms"]["gi"]), *gi_errors(one),
             *(fraction(one["camera"]["errors"].get(name, {}).get(metric[name]), 4) for name in others)] for one in results]
    return markdown(["scene", "preset, voxels", "camera moving", "everything changing", "relMSE", "bias", "FLIP",
                     *(f"{name}: {'RMSE' if MEASURES[name].is_share else 'relMSE'}" for name in others)], rows)


def gi_errors(one: Result) -> list[str]:
    errors = one["camera"]["errors"]["gi"]
    return [fraction(errors["relmse"], 4), percent(errors["bias"]), fraction(errors["flip"], 3)]


def noise_note(results: Sequence[Result]) -> str:
    """Tells where the noise of a reference is a large part of an error."""
    noisy = {one["scene"] for one in results if one["noise"]["gi"] > 0.2 * one["camera"]["errors"]["gi"]["relmse"]}
    return f"note: in {', '.join(sorted(noisy))} more than a fifth of a relMSE is the reference's own noise\n" if noisy else ""


def headline(results: Sequence[Result]) -> str:
    bounds = mali.bounds_of_this_build(ROOT / "out/mali/bounds.json")
    if not bounds:
        say("no T880 column: run tools/eval.py mali --compiler FILE first")
    rows = []
    for one in results:
        relmse, _, flip = gi_errors(one)
        bound = [milliseconds(sum(bounds[one["preset"]]["gi-cone-shadow"].values()))] if one["preset"] in bounds else []
        rows.append([f"`{one['preset']}`, {one['grid']}³", milliseconds(one["camera"]["ms"]["gi"]),
                     milliseconds(one["changing"]["ms"]["gi"]), relmse, flip, *bound])
    return markdown(["preset, voxels", "camera moving", "everything changing", "relMSE", "FLIP",
                     *(["a Mali-T880, at least"] if bounds else [])], rows)


def machine(results: Sequence[Result]) -> str:
    one = results[0]
    return f"Mode gi, {one['size'][0]}x{one['size'][1]} pixels, on {one['driver']}, {one['cpu']}:\n"


def run(asked: argparse.Namespace) -> int:
    if asked.headline and not asked.scenes:
        asked.scenes = ["cornell"]
    measures = list(MEASURES) if "all" in asked.measures else list(dict.fromkeys(["gi", *([] if asked.headline else asked.measures)]))
    scenes = [find_scene(scene) for scene in asked.scenes] or static_scenes()
    samples = STILL_SAMPLES if asked.headline else 1
    tasks = [task(scene, preset, measures, asked.size, grid, camera, cascades, samples) for scene in scenes
             for camera in asked.cameras for preset in asked.presets for grid in asked.grids for cascades in asked.cascades]
    store = Store(asked.out)
    if results := store.run(tasks, again=asked.headline):  # times of one table are of one run
        print(f"{machine(results)}\n{(headline if asked.headline else table)(results)}{noise_note(results)}", end="")
        if asked.sheet:
            write_whole(asked.sheet, pictures.stacked(list(pictures.sheets(store, results).values())))
    store.say_failures(tasks)
    return 1 if store.failures(tasks) else 0
