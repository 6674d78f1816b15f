"""Draws small generated scenes whose right answer is known, and measures how far the picture is from it.

    tools/eval.py cases
    tools/eval.py cases thin-wall sliver-wall

Every measured value is a distance from the right answer: 0 is right, and a case passes at or below its bar. The walls are known
failures of the thesis's algorithm (preset thesis). Exit status 1: a case failed that is not a known failure, or its picture has
values that are negative or not finite, or vct ended with an error.
"""
import argparse
import math
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

import program
from files import Failed, file_sha256
from scenes import cornell, shapes, thin_wall
from scenes.glb import Glb
from tables import markdown
from truth.exr import read_exr

from . import options
from .store import Result, Store, Task

# Lengths are in voxels of a 64^3 grid: vct pads the longest extent by 2.5 voxels on each side (jni/engine/volume.h), so a scene of
# 59 units has voxels of 1 unit and voxel boundaries at whole coordinates around its centre.
HALF = 59.0 / 2
Vector = tuple[float, float, float]
Part = tuple[shapes.Shape, Vector, dict[str, Any]]  # shape, colour, glTF node properties
GREY, RED = (0.6, 0.6, 0.6), (0.6, 0.05, 0.05)
SUN = (-0.5, -1.0, -0.3)  # the direction in which its light travels


def moved(p: Vector, by: Vector) -> Vector:
    return tuple(c + o for c, o in zip(p, by))


def scene_of(*parts: Part, travels: Vector = SUN, lux: float = round(math.pi, 6), offset: Vector = (0, 0, 0)) -> bytes:
    """The parts on a floor. `offset` moves all vertices and the camera, and is not in any node."""
    glb = Glb("tools/eval.py")
    floor = shapes.quads(((-HALF, 0, HALF), (2 * HALF, 0, 0), (0, 0, -2 * HALF)))
    for i, (shape, color, place) in enumerate([(floor, GREY, {}), *parts]):
        shape.positions = [moved(p, offset) for p in shape.positions]
        glb.part(f"part {i}", shape, glb.material(f"material {i}", color), **place)
    glb.camera("camera", moved((25, 45, 70), offset), moved((0, 5, 0), offset), 45)
    glb.directional_light("sun", travels, (1, 1, 1), lux)
    return glb.to_bytes()


def box(size: Vector, *place: float) -> Part:
    return shapes.box(size, None), RED, {"translation": list(place)} if place else {}


def towers() -> list[Part]:
    return [box((12, 19, 12), 6.3, 0, 2.3), (shapes.icosphere(6, 2), GREY, {"translation": [-12.2, 9.7, -3.1]})]


def draw(scene: bytes, preset: str, folder: Path, grid: int = 64) -> dict[str, np.ndarray]:
    """Linear pictures by name."""
    path = folder / "scene.glb"
    path.write_bytes(scene)
    program.render(path, folder, "--preset", preset, "--mode", "gi,gi-cone-shadow", "--grid", grid, "--size", "128x128",
                   "--light-parts", *program.NO_SKY)
    found = {name: read_exr(folder / f"{name}.exr") for name in ("gi", "gi-cone-shadow", "indirect_light")}
    for name, image in found.items():
        if not np.isfinite(image).all() or (image < 0).any():
            raise Failed(f"the picture {name} has values that are negative or not finite")
    return found


def leak(thickness_m: float, preset: str, folder: Path) -> float:
    """Mean indirect light of the dark half of a room over that of its lit half. A voxel is 33 mm."""
    light = draw(thin_wall.build(thickness_m).to_bytes(), preset, folder, grid=128)["indirect_light"]
    middle, margin = len(light) // 2, 4 + int(len(light) * thickness_m / 4)  # the wall's edge, which faces the camera
    return float(light[:, :middle - margin].mean() / light[:, middle + margin:].mean())


# Each returns two scenes whose light must be the same, and the factor between the two.
def sliver_wall() -> tuple[bytes, bytes, float]:
    slivers = [((-15, i * 0.025, -5.5), (30, 0, 0), (0, 0.025, 0)) for i in range(840)]
    walls = [shapes.quads(*slivers), shapes.quads(((-15, 0, -5.5), (30, 0, 0), (0, 21, 0)))]
    return *(scene_of((wall, RED, {}), travels=(0.3, -1, -0.8)) for wall in walls), 1.0


def mirrored() -> tuple[bytes, bytes, float]:
    scale, move, color = (1.7, -0.9, 0.6), (2.3, 14.2, 1.15), (0.6, 0.3, 0.1)
    shape = shapes.box((10, 4, 6), None)
    for other, by in ((shapes.box((4, 12, 5), None), (-3, 0, 0.3)), (shapes.icosphere(2.5, 2), (3.2, 6.4, 0.9))):
        shape.append(other, by)
    turned = [i for a, b, c in zip(*[iter(shape.indices)] * 3) for i in (a, c, b)]
    baked = shapes.Shape([tuple(s * c + m for s, c, m in zip(scale, p, move)) for p in shape.positions],
                         [shapes.unit(tuple(c / s for s, c in zip(scale, n))) for n in shape.normals], [], turned)
    return scene_of((shape, color, {"translation": list(move), "scale": list(scale)})), scene_of((baked, color, {})), 1.0


def scaled(scale: float) -> tuple[bytes, bytes, float]:
    return cornell.build(scale).to_bytes(), cornell.build().to_bytes(), 1.0


def far_node() -> tuple[bytes, bytes, float]:
    far = cornell.build()
    children, far.json["scenes"][0]["nodes"] = far.json["scenes"][0]["nodes"], []
    far.json["nodes"][far.node("far", translation=[1e6, 1e6, -1e6])]["children"] = children
    return far.to_bytes(), cornell.build().to_bytes(), 1.0


def far_vertices() -> tuple[bytes, bytes, float]:
    return scene_of(box((12, 19, 12)), offset=(1_000_000.0, 500_000.0, -1_000_000.0)), scene_of(box((12, 19, 12))), 1.0


def straight_down() -> tuple[bytes, bytes, float]:
    return *(scene_of(*towers(), travels=(x, -1, 0)) for x in (0, 1.7e-4)), 1.0


def bright_sun() -> tuple[bytes, bytes, float]:
    return scene_of(*towers(), lux=1e5), scene_of(*towers()), math.pi / 1e5


def difference(scenes: Callable[[], tuple[bytes, bytes, float]], preset: str, folder: Path) -> float:
    """Mean |a - b| over the mean of b, in the picture where it is largest."""
    first, second, factor = scenes()
    mine, others = draw(first, preset, folder), draw(second, preset, folder)
    return max(float(np.abs(mine[name] * factor - others[name]).mean() / max(float(others[name].mean()), 1e-9)) for name in mine)


@dataclass(frozen=True)
class Case:
    name: str
    what: str  # what is measured, of which 0 is right
    bar: float
    measure: Callable[[str, Path], float]  # of a preset, in a folder
    known: float = 0.0  # with the preset thesis a failure up to this size is known


def alike(name: str, what: str, bar: float, scenes: Callable[[], tuple[bytes, bytes, float]]) -> Case:
    return Case(name, f"difference of the light {what}", bar, lambda preset, folder: difference(scenes, preset, folder))


CASES = [
    Case("thin-wall", "light behind a wall of 2 mm (0.06 voxels) over light before it: the wall's sides share voxels", 0.01,
         lambda preset, folder: leak(0.002, preset, folder), 0.4),
    Case("thick-wall", "the same with 0.3 m (9 voxels): it falls between a wide cone's samples, and coarse levels mix both sides",
         0.01, lambda preset, folder: leak(0.3, preset, folder), 0.4),
    alike("sliver-wall", "of a wall of 1680 slivers and one of 2 triangles", 0.01, sliver_wall),
    alike("mirrored-and-stretched", "of a node of scale (1.7, -0.9, 0.6) and of such vertices", 0.005, mirrored),
    alike("scene-of-1-mm", "of Cornell and of Cornell 1 mm wide", 0.005, lambda: scaled(0.0005)),
    alike("scene-of-10-km", "of Cornell and of Cornell 10 km wide", 0.005, lambda: scaled(5000.0)),
    alike("node-at-10^6", "of Cornell and of Cornell 10^6 m from the origin on each axis", 0.005, far_node),
    alike("vertices-at-10^6", "of vertices near the origin and 10^6 units from it", 0.005, far_vertices),
    alike("light-straight-down", "of a sun in the zenith and 0.01 degrees beside it", 0.01, straight_down),
    alike("sun-of-100000-lux", "of a sun of pi lux and, scaled, of 100,000 lux", 0.002, bright_sun),
]


def measured(case: Case, preset: str, folder: Path) -> Result:
    value = case.measure(preset, folder)
    known = preset == "thesis" and value <= case.known
    return {"name": case.name, "what": case.what, "preset": preset, "bar": case.bar, "measured": float(f"{value:.4g}"),
            "status": "pass" if value <= case.bar else "known failure" if known else "fail"}


def table(results: Sequence[Result]) -> str:
    counts = Counter(one["status"] for one in results)
    return markdown(["case", "preset", "measured", "bar", "status", "what is measured"], (
        [one["name"], one["preset"], f"{one['measured']:.3g}", f"{one['bar']:.3g}", one["status"], one["what"]] for one in results)
    ) + "\n" + ", ".join(f"{number} {status}" for status, number in counts.items()) + "\n"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("cases", nargs="*", metavar="NAME", help="these cases only (default: all)")
    options.add_store(parser)
    parser.add_argument("--preset", choices=options.PRESETS, default="thesis", help="default: thesis")


def run(asked: argparse.Namespace) -> int:
    if unknown := set(asked.cases) - {case.name for case in CASES}:
        raise Failed(f"there is no case '{min(unknown)}'; choose from {', '.join(case.name for case in CASES)}")
    tasks = [Task("cases", f"{asked.preset}-{case.name}", {"source": file_sha256(Path(__file__))},
                  lambda folder, case=case: measured(case, asked.preset, folder), asked.preset, keeps_pictures=False)
             for case in CASES if not asked.cases or case.name in asked.cases]
    store = Store(asked.out)
    results = store.run(tasks)
    if results:
        print(table(results), end="")
    store.say_failures(tasks)
    return 1 if store.failures(tasks) or any(one["status"] == "fail" for one in results) else 0
