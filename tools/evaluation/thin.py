"""Compares the light along ten thin things with path tracing: a chair leg, a table top, a column, a window bar, a curtain, a shelf
board, a kerb, a rod, a railing and a wire, in a room that follows the axes and in one that is turned.

    tools/eval.py thin
    tools/eval.py thin --things rod,wire --presets mobile,quality

The error of a thing is that of its brightness along its length: of means over its width, for each of a number of lengths. It is
the root of the mean square, relative to the mean brightness; 0 is right. The noise is the same between the halves of the path
tracer's samples, divided by two.
"""
import argparse
import hashlib
from pathlib import Path

import numpy as np

import metrics
import program
from files import file_sha256, path_tracer_sha256
from scenes import thin_things
from tables import fraction, markdown
from truth.exr import read_exr, write_exr

from . import options
from .store import Result, Store, Task

TURNS = (0, 30)  # degrees
LENGTHS = 64
SAMPLES = 4  # per pixel, of the renderer
BAR = 0.12
SKY = "1,1,1"
THINGS = {thing.name: thing for thing in thin_things.THINGS}


def add_arguments(parser: argparse.ArgumentParser) -> None:
    options.add_store(parser)
    options.add_presets(parser, ["mobile"])
    parser.add_argument("--spp", type=options.samples, default=512, help="samples per pixel of path tracing (default: %(default)s)")
    parser.add_argument("--things", type=options.names(THINGS, "thing"), default=list(THINGS),
                        help=f"with commas (default: {','.join(THINGS)})")


def traced(name: str, turn: int, samples: int) -> Task:
    """Path tracing of one thing, and the `coverage` of its pixels."""
    size = thin_things.picture_size(THINGS[name])

    def measure(folder: Path) -> Result:
        from truth.asked import lit_by, seen_by
        from truth.drawing import draw, make_world  # loading Mitsuba takes seconds
        from truth.scene import load_scene
        for kind, only, count in (("coverage", name, 16), ("full", None, samples)):
            path = folder / "scene.glb"
            path.write_bytes(thin_things.build(turn, only).to_bytes())
            view = program.camera(path, size, "--camera", name)
            scene = lit_by(seen_by(load_scene(path, size), view), None, SKY, None, 1.0)
            found = draw(make_world(scene), scene, kind, size, count, 0)
            write_exr(folder / f"{kind}.exr", found.image)
        for number, half in enumerate(found.halves):
            write_exr(folder / f"half{number}.exr", half)
        return {"thing": name, "turn": turn}
    content = hashlib.sha256(thin_things.build(turn).to_bytes()).hexdigest()
    return Task("thin", f"{name}-{turn}-traced", {"scene": content, "size": size, "samples": samples, "sky": SKY,
                                                  "path_tracer": path_tracer_sha256()}, measure, "traced", uses_program=False)


def along(picture: np.ndarray, coverage: np.ndarray, axis: int) -> np.ndarray:
    """The mean brightness of a thing's pixels at each length."""
    shows = coverage.min(axis=2) > 0.999
    rows = 0 if axis == 1 else 1  # of the picture, that lie across the thing
    place = np.indices(shows.shape)[rows][shows] * LENGTHS // shows.shape[rows]
    count, total = (np.bincount(place, weights, LENGTHS) for weights in (None, picture.mean(axis=2)[shows]))
    return total[count > 0] / count[count > 0]


def error(light: np.ndarray, right: np.ndarray) -> float:
    return float(np.sqrt(np.mean((light - right) ** 2)) / right.mean())


def drawn(preset: str, name: str, turn: int, reference: Path) -> Task:
    thing = THINGS[name]
    size = thin_things.picture_size(thing)

    def measure(folder: Path) -> Result:
        path = folder / "scene.glb"
        path.write_bytes(thin_things.build(turn).to_bytes())
        program.render(path, folder, "--preset", preset, "--mode", "gi", "--size", f"{size[0]}x{size[1]}", "--samples", SAMPLES,
                       "--exposure", 1, "--sky", SKY, "--camera", name)
        mine, right, *halves = (along(read_exr(file), read_exr(reference / "coverage.exr"), thing.axis) for file in
                                (folder / "gi.exr", *(reference / f"{part}.exr" for part in ("full", "half0", "half1"))))
        return {"preset": preset, "thing": name, "turn": turn, "error": error(mine, right), "noise": 0.5 * error(*halves),
                "bias": float(mine.mean() / right.mean() - 1)}
    key = {"reference": file_sha256(reference / "full.exr"), "samples": SAMPLES, "source": file_sha256(Path(__file__))}
    return Task("thin", f"{name}-{turn}-{preset}", key, measure, preset)


def table(results: list[Result]) -> str:
    found = {(one["preset"], one["turn"], one["thing"]): one for one in results}
    names = list(dict.fromkeys(one["thing"] for one in results))
    rows = [[f"{preset}, {turn}°, {what}", *(fraction(one[what], 3) if (one := found.get((preset, turn, name))) else "–"
                                            for name in names)]
            for preset, turn in dict.fromkeys(key[:2] for key in found) for what in ("error", "bias", "noise")]
    return markdown(["turned by", *names], rows)


def run(asked: argparse.Namespace) -> int:
    store = Store(asked.out)
    pairs = [(name, turn) for turn in TURNS for name in asked.things]
    references = [traced(*pair, asked.spp) for pair in pairs]
    store.run(references)
    tasks = [drawn(preset, *pair, store.pictures(reference.identity)) for preset in asked.presets
             for pair, reference in zip(pairs, references)]
    results = store.run(tasks)
    print(table(results), end="")
    above = [f"{one['thing']} at {one['turn']}° with {one['preset']}" for one in results if one["error"] > BAR]
    print(f"above the bar of {BAR:g}: {', '.join(above) or 'none'}")
    store.say_failures([*references, *tasks])
    return 1 if store.failures([*references, *tasks]) else 0
