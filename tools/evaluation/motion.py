"""Measures what happens over frames, with the light's history that an app has.

    tools/eval.py motion
    tools/eval.py motion lag --scenes walker,sun --presets mobile
    tools/eval.py motion dynamic --presets thesis,mobile

lag      moving objects (`moving`, `walker`, a `door`, a hundred `balls`) and a `sun` that turns by 36 degrees a second, at 30 frames a
         second: each frame against the converged picture of its moment
dynamic  time of each step by what changes in a room with a hundred balls: camera, light, one ball, all balls, or everything rebuilt
"""
import argparse
import statistics
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import metrics
import program
from files import ROOT, Failed, file_sha256, files_sha256
from scenes import balls, door, moving, walker
from tables import STEPS, fraction, markdown
from truth.exr import read_exr

from . import options
from .progress import Countdown
from .store import Result, Store, Task

TITLES = {"lag": "Light that follows a change", "dynamic": "Time by what changes"}
# For lag: the scene, and the length of its animation in seconds.
SCENES = {
    "moving": (moving.build, moving.SECONDS),
    "walker": (walker.build, walker.SECONDS),
    "door": (door.build, door.SECONDS),
    "balls": (lambda: balls.build(moving=balls.COUNT), balls.SECONDS),
    "sun": (lambda: balls.build(turn_light=36 * balls.SECONDS), balls.SECONDS),
}
FPS = 30.0
FIRST_FRAMES = 16  # of a sequence, which starts converged: left out of the means
# For dynamic: arguments of balls.build and options of vct render.
CHANGES: dict[str, tuple[dict[str, Any], list[str]]] = {
    "everything rebuilt (`--revoxelize`)": ({"turn_camera": 20}, ["--revoxelize"]),
    "the camera moves": ({"turn_camera": 20}, []),
    "the light moves": ({"turn_light": 20}, []),
    "one ball of a hundred moves": ({"moving": 1}, []),
    "all balls move": ({"moving": balls.COUNT}, []),
}


def add_arguments(parser: argparse.ArgumentParser) -> None:
    options.add_store(parser)
    options.add_presets(parser, ("mobile", "quality"))
    parser.add_argument("parts", nargs="*", metavar="PART", help="lag, dynamic (default: both)")
    parser.add_argument("--scenes", type=options.names(SCENES, "scene"), default=list(SCENES), help="of lag (default: %(default)s)")
    parser.add_argument("--size", type=options.size, default=(256, 256), help="WIDTHxHEIGHT (default: 256x256)")
    parser.add_argument("--frames", type=options.count, help="frames of a sequence (default: lag plays the animation, dynamic 24)")
    parser.add_argument("--every", type=options.count, default=10, help="lag compares every N-th frame (default: %(default)s)")
    parser.add_argument("--repeat", type=options.count, default=3, help="runs of each of dynamic's changes (default: %(default)s)")


def lag(name: str, preset: str, asked: argparse.Namespace, folder: Path) -> Result:
    """Errors of every so many frames, and their means without the first frames."""
    build, seconds = SCENES[name]
    numbers = list(range(0, min(asked.frames or 1000, int(seconds * FPS)), asked.every))
    countdown, path = Countdown(len(numbers) + 1), folder / "scene.glb"
    path.write_bytes(build().to_bytes())
    common = ("--preset", preset, "--mode", "gi", "--size", f"{asked.size[0]}x{asked.size[1]}", *program.NO_SKY)
    program.render(path, folder, *common, "--frames", numbers[-1] + 1, "--fps", f"{FPS:g}")
    countdown.advance(1)
    found = []
    for number in numbers:
        program.render(path, folder / "converged", *common, "--time", f"{number / FPS:.9g}")
        errors = metrics.compare(read_exr(folder / f"gi_{number:04}.exr"), read_exr(folder / "converged/gi.exr"))
        found.append({"frame": number, "relmse": errors["relmse"], "flip": errors["flip"]})
        countdown.advance(1)
    late = [one for one in found if one["frame"] >= FIRST_FRAMES] or found
    return {"moves": name, "preset": preset, "frames": found,
            "mean": {metric: statistics.fmean(one[metric] for one in late) for metric in ("relmse", "flip")},
            "largest_flip": max(one["flip"] for one in late)}


def dynamic(preset: str, asked: argparse.Namespace, folder: Path) -> Result:
    """Medians of each step in ms. The changes take turns, so that a machine that slows down meanwhile slows all of them."""
    runs: dict[str, list[dict[str, float]]] = {change: [] for change in CHANGES}
    countdown, path = Countdown(asked.repeat * len(CHANGES)), folder / "scene.glb"
    frames, size = asked.frames or 24, f"{asked.size[0]}x{asked.size[1]}"
    for _ in range(asked.repeat):
        for change, (moves, flags) in CHANGES.items():
            path.write_bytes(balls.build(**moves).to_bytes())
            timings = program.render_timed(path, folder, "--mode", "gi-cone-shadow", "--preset", preset, "--size", size,
                                           "--frames", frames, "--fps", frames / balls.SECONDS, *program.NO_SKY, *flags)
            steps = timings["modes"]["gi-cone-shadow"]["steps"]
            runs[change].append({step: steps[step]["median"] for step in STEPS})
            countdown.advance(1)
    return {"preset": preset, "steps": {change: {step: statistics.median(run[step] for run in found) for step in STEPS}
                                        for change, found in runs.items()}}


def lag_table(results: Sequence[Result]) -> str:
    return (f"Each frame after the first {FIRST_FRAMES} against the converged picture of its moment:\n\n"
            + markdown(["what moves", "preset", "mean relMSE", "mean FLIP", "largest FLIP"],
                       ([one["moves"], one["preset"], fraction(one["mean"]["relmse"], 5), fraction(one["mean"]["flip"], 3),
                         fraction(one["largest_flip"], 3)] for one in results)))


def dynamic_table(results: Sequence[Result]) -> str:
    text = "Medians in milliseconds; share: voxelize + inject + mipmap over those of a frame that rebuilds everything\n\n"
    for one in results:
        voxels = {change: steps["voxelize"] + steps["inject"] + steps["mipmap"] for change, steps in one["steps"].items()}
        everything = next(iter(voxels.values()))
        text += markdown([f"`{one['preset']}`: what changes", *STEPS.values(), "share"],
                         ([change, *(f"{ms:.1f}" for ms in steps.values()), f"{voxels[change] / everything:.1%}"]
                          for change, steps in one["steps"].items()))
    return text


def table(part: str, results: Sequence[Result]) -> str:
    return {"lag": lag_table, "dynamic": dynamic_table}[part](results)


def tasks_of(part: str, asked: argparse.Namespace) -> list[Task]:
    key = {"frames": asked.frames, "size": asked.size, "scenes": files_sha256(b"", (ROOT / "tools/scenes").glob("*.py"))}
    if part == "dynamic":
        return [Task(part, preset, key | {"repeat": asked.repeat}, lambda folder, preset=preset: dynamic(preset, asked, folder),
                     preset, keeps_pictures=False) for preset in asked.presets]
    key |= {"every": asked.every, "metrics": file_sha256(Path(metrics.__file__))}
    return [Task(part, f"{name}-{preset}", key, lambda folder, name=name, preset=preset: lag(name, preset, asked, folder),
                 preset, keeps_pictures=False) for name in asked.scenes for preset in asked.presets]


def run(asked: argparse.Namespace) -> int:
    parts = asked.parts or list(TITLES)
    if unknown := [part for part in parts if part not in TITLES]:
        raise Failed(f"unknown part '{unknown[0]}'; choose from {', '.join(TITLES)}")
    tasks = [task for part in parts for task in tasks_of(part, asked)]
    store = Store(asked.out)
    store.run(tasks)
    for part in parts:
        if results := store.results_of(part):
            print(table(part, results))
    store.say_failures(tasks)
    return 1 if store.failures(tasks) else 0
