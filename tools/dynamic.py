#!/usr/bin/env python3
"""What a frame costs by what changes in it: a room with a hundred balls, of which none, one or all move, or the light.

    .venv/bin/python tools/dynamic.py --out out/dynamic

Prints a Markdown table for each preset: the medians of each step in milliseconds, and what voxelizing and mipmapping took
over a frame that makes everything anew. Cases take turns, so that a machine that slows down meanwhile slows all of them.
"""
from __future__ import annotations

import argparse
import json
import math
import statistics
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

from scenes import shapes  # noqa: E402
from scenes.glb import Glb, axis_angle  # noqa: E402

ROOT = Path(__file__).resolve().parent.parent
STEPS = ("shadow_map", "render_data", "voxelize", "mipmap", "irradiance", "trace", "total")
SECONDS = 2
ALONG_A_SIDE = 10


def ball_room(moving: int = 0, turn_light: bool = False, turn_camera: bool = False) -> Glb:
    """4 m x 3 m x 4 m, open at +Z. `moving`: how many of the balls slide by 0.2 m."""
    glb = Glb("tools/dynamic.py")
    white, red = (glb.material(name, color) for name, color in (("white", (0.7,) * 3), ("red", (0.7, 0.1, 0.1))))
    walls = (((-2, 0, 2), (4, 0, 0), (0, 0, -4)), ((-2, 0, -2), (4, 0, 0), (0, 3, 0)),
             ((2, 0, -2), (0, 0, 4), (0, 3, 0)), ((-2, 0, 2), (0, 0, -4), (0, 3, 0)))
    for i, wall in enumerate(walls):
        shape = shapes.Shape()
        shapes.add_quad(shape, *wall)
        glb.node(f"wall {i}", mesh=glb.mesh(f"wall {i}", glb.primitive(shape, white)))
    ball = glb.mesh("ball", glb.primitive(shapes.icosphere(0.1, 2), red))
    for i in range(ALONG_A_SIDE ** 2):
        place = (-1.7 + 0.37 * (i % ALONG_A_SIDE), 0.12, -1.7 + 0.37 * (i // ALONG_A_SIDE))
        node = glb.node(f"ball {i}", mesh=ball, translation=list(place))
        # From the middle of the room on, in the order of the nodes.
        if (i + ALONG_A_SIDE ** 2 // 2) % ALONG_A_SIDE ** 2 < moving:
            glb.animate("run", node, "translation", [0, SECONDS],
                        [place, (place[0] + 0.2, place[1] + 0.1, place[2])])
    turned = ((0, 1, 0), [0, 20])
    glb.camera("front", (0, 2.2, 5.5), (0, 1.0, 0), 45)
    camera = len(glb.json["nodes"]) - 1
    glb.directional_light("sun", (-0.4, -1.0, -0.6), (1, 1, 1), round(math.pi, 6))
    for node, turns in ((camera, turn_camera), (camera + 1, turn_light)):
        if turns:
            rotation = glb.json["nodes"][node]["rotation"]
            axis, degrees = turned
            glb.animate("run", node, "rotation", [0, SECONDS],
                        [rotation, product(axis_angle(axis, degrees[1]), rotation)])
    return glb


def product(a: list[float], b: list[float]) -> list[float]:
    ax, ay, az, aw = a
    bx, by, bz, bw = b
    return [aw * bx + ax * bw + ay * bz - az * by, aw * by - ax * bz + ay * bw + az * bx,
            aw * bz + ax * by - ay * bx + az * bw, aw * bw - ax * bx - ay * by - az * bz]


CASES: dict[str, tuple[Callable[[], Glb], list[str]]] = {
    "everything anew (`--revoxelize`)": (lambda: ball_room(turn_camera=True), ["--revoxelize"]),
    "the camera moves": (lambda: ball_room(turn_camera=True), []),
    "the light moves": (lambda: ball_room(turn_light=True), []),
    "one ball of a hundred moves": (lambda: ball_room(moving=1), []),
    "all balls move": (lambda: ball_room(moving=ALONG_A_SIDE ** 2), []),
}


def measured(program: Path, scene: Path, preset: str, folder: Path, frames: int, flags: list[str]) -> dict[str, float]:
    timings = folder / "timings.json"
    subprocess.run([str(program), "render", str(scene), "--out", str(folder), "--mode", "gi-cone-shadow", "--preset", preset,
                    "--frames", str(frames), "--fps", str(frames / SECONDS), "--timings", str(timings), *flags],
                   check=True, capture_output=True)
    steps = json.loads(timings.read_text())["steps"]
    return {step: steps[step]["median"] for step in STEPS}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=Path, default=ROOT / "build/desktop/vct")
    parser.add_argument("--out", type=Path, default=ROOT / "out/dynamic")
    parser.add_argument("--presets", default="thesis,mobile")
    parser.add_argument("--frames", type=int, default=24)
    parser.add_argument("--repeat", type=int, default=3)
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    scenes = {}
    for i, (case, (build, _)) in enumerate(CASES.items()):
        scenes[case] = options.out / f"case_{i}.glb"
        scenes[case].write_bytes(build().to_bytes())
    for preset in options.presets.split(","):
        runs: dict[str, list[dict[str, float]]] = {case: [] for case in CASES}
        for _ in range(options.repeat):
            for case, (_, flags) in CASES.items():
                runs[case].append(measured(options.program, scenes[case], preset,
                                           options.out / f"{preset}_{scenes[case].stem}", options.frames, flags))
        print(f"| `{preset}`: what changes | shadow map | G-buffer | voxelize | mipmap | irradiance | trace | frame "
              "| voxelize + mipmap, of all |\n|---|---|---|---|---|---|---|---|---|")
        whole = 0.0
        for case in CASES:
            step = {name: statistics.median(run[name] for run in runs[case]) for name in STEPS}
            voxels = step["voxelize"] + step["mipmap"]
            whole = whole or voxels
            print(f"| {case} | " + " | ".join(f"{step[name]:.1f}" for name in STEPS) + f" | {voxels / whole:.1%} |")
        print()


if __name__ == "__main__":
    main()
