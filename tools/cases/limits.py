"""Too much, too little: a full voxel list, ten million triangles, an empty scene."""
from __future__ import annotations

import re
from functools import partial
from pathlib import Path

from scenes import big_grid, cornell
from scenes.glb import Glb
from scenes.hard_cases import SUN, Part, View, floor, make

from .case import LIGHT, Case
from .run import Measured, Unacceptable, Vct, mean_difference


def _refusal(vct: Vct, name: str, scene: Path, options: list[str], must_say: str) -> tuple[float, str]:
    """0 where vct says in one line what is wrong, exits with an error and leaves no file; else the faults in that."""
    folder = vct.out / name
    done = vct.command(scene, folder, ["--grid", "64", "--size", "64x64", *options])
    if done.returncode < 0:
        raise Unacceptable(f"{name}: ended by signal {-done.returncode}")
    errors = [line for line in done.stderr.splitlines() if "error" in line.lower()]
    faults = [done.returncode == 0, len(errors) != 1, must_say not in done.stderr,
              folder.exists() and any(path.is_file() for path in folder.rglob("*"))]
    return float(sum(faults)), done.stderr.strip().split("\n")[-1].replace(str(vct.out), "DIR")


def list_full(vct: Vct) -> Measured:
    """Refuses with the size that it needs, and renders with exactly that."""
    data = cornell.build().to_bytes()
    scene = vct.scene_file("list_full", data)
    faults, said = _refusal(vct, "list_full_refused", scene, ["--active-voxels", "1000"], "make room for")
    wanted = re.search(r"make room for (\d+) active voxels", said)
    if not wanted:
        return Measured(faults + 1, None, said)
    exact = vct.render("list_full", data, options=("--active-voxels", wanted[1]))
    roomy = vct.render("list_roomy", data, check_order=False)
    return exact.measured(faults + mean_difference(exact["gi"], roomy["gi"]), note=said)


def empty_scene(vct: Vct) -> Measured:
    glb = Glb("tools/hard_cases.py")
    glb.camera("camera", (0, 0, 3), (0, 0, 0), 40)
    glb.directional_light("sun", SUN, (1, 1, 1), 3.0)
    for key in ("meshes", "materials", "accessors", "bufferViews"):
        del glb.json[key]
    faults, said = _refusal(vct, "empty_scene", vct.scene_file("empty_scene", glb.to_bytes()), [], "no triangles")
    return Measured(faults, None, said)


def nothing_in_view(vct: Vct) -> Measured:
    """A scene that the camera turns its back to is a picture of the sky."""
    scene = make([Part(floor())], SUN, View((0, 5, 40), (0, 5, 80), 45))
    answer = vct.render("nothing_in_view", scene, options=("--sky", "0.25,0.5,0.75"))
    return answer.measured(abs(answer["gi"] - (0.25, 0.5, 0.75)).max())


def many_triangles(triangles: int, vct: Vct) -> Measured:
    """Against the same land of 20,000 triangles: hills of 20 units are smooth in both."""
    coarse = vct.render("land_coarse", big_grid.build(20_000), grid=128, size=256, check_order=False)
    name = f"land_{triangles}"
    fine = vct.render(name, big_grid.build(triangles), grid=128, size=256, check_order=triangles <= 1_000_000)
    (vct.out / "scenes" / f"{name}.glb").unlink()  # a quarter of a gigabyte
    return fine.measured(mean_difference(fine["gi"], coarse["gi"]))


CASES = [
    Case("voxel-list-full", "room for 1000 active voxels where more are needed",
         "refused in one line that names the size needed; with that size the usual picture", "faults", 0.0, list_full),
    Case("empty-scene", "a glTF file without meshes", "refused in one line; no files", "faults", 0.0, empty_scene),
    Case("nothing-in-view", "the camera looks away from the scene", "the sky, exactly", "largest difference", 5e-4,
         nothing_in_view),
    Case("triangles-300-thousand", "land of 300,000 triangles, 20 to a voxel", "the picture of 20,000 triangles", LIGHT, 0.02,
         partial(many_triangles, 300_000), quick=False),
    Case("triangles-10-million", "land of 10,000,000 triangles, 600 to a voxel", "the picture of 20,000 triangles", LIGHT, 0.02,
         partial(many_triangles, 10_000_000), quick=False),
]
