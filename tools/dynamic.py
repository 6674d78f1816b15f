#!/usr/bin/env python3
"""What a frame costs by what changes in it: a room with a hundred balls, of which none, one or all move, or the light.

    .venv/bin/python tools/dynamic.py --out out/dynamic

Prints a Markdown table for each preset: the medians of each step in milliseconds, and what voxelizing, injecting light and
mipmapping took over a frame that rebuilds everything. Cases take turns, so that a machine that slows down meanwhile slows all of them.
"""
from __future__ import annotations

import argparse
import json
import statistics
from pathlib import Path

import program
from files import ROOT
from scenes import balls
from tables import STEPS, markdown

# What changes, as the scene is told, and the program.
CASES = {
    "everything anew (`--revoxelize`)": ({"turn_camera": True}, ["--revoxelize"]),
    "the camera moves": ({"turn_camera": True}, []),
    "the light moves": ({"turn_light": True}, []),
    "one ball of a hundred moves": ({"moving": 1}, []),
    "all balls move": ({"moving": balls.COUNT}, []),
}


def measured(vct: Path, scene: Path, preset: str, folder: Path, frames: int, flags: list[str]) -> dict[str, float]:
    timings = folder / "timings.json"
    program.render(vct, scene, "--out", folder, "--mode", "gi-cone-shadow", "--preset", preset, "--frames", frames, "--fps",
                   frames / balls.SECONDS, "--timings", timings, *flags)
    steps = json.loads(timings.read_text())["modes"]["gi-cone-shadow"]["steps"]
    return {step: steps[step]["median"] for step in STEPS}


def table(preset: str, runs: dict[str, list[dict[str, float]]]) -> str:
    medians = {case: {name: statistics.median(run[name] for run in found) for name in STEPS} for case, found in runs.items()}
    voxels = {case: step["voxelize"] + step["inject"] + step["mipmap"] for case, step in medians.items()}
    whole = next(iter(voxels.values()))
    return markdown([f"`{preset}`: what changes", *STEPS.values(), "voxelize + inject + mipmap, of all"],
                    ([case, *(f"{ms:.1f}" for ms in step.values()), f"{voxels[case] / whole:.1%}"]
                     for case, step in medians.items()))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    program.add_option(parser)
    parser.add_argument("--out", type=Path, default=ROOT / "out/dynamic")
    parser.add_argument("--presets", default="thesis,mobile")
    parser.add_argument("--frames", type=int, default=24)
    parser.add_argument("--repeat", type=int, default=3)
    options = parser.parse_args()
    program.require(options.program)
    options.out.mkdir(parents=True, exist_ok=True)
    scenes = {case: options.out / f"case_{i}.glb" for i, case in enumerate(CASES)}
    for case, (changes, _) in CASES.items():
        scenes[case].write_bytes(balls.build(**changes).to_bytes())
    for preset in options.presets.split(","):
        runs: dict[str, list[dict[str, float]]] = {case: [] for case in CASES}
        for _ in range(options.repeat):
            for case, (_, flags) in CASES.items():
                runs[case].append(measured(options.program, scenes[case], preset,
                                           options.out / f"{preset}_{scenes[case].stem}", options.frames, flags))
        print(table(preset, runs))


if __name__ == "__main__":
    main()
