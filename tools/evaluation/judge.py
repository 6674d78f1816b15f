"""Judges a scene of yours: each preset's picture, its times and its error against path tracing, on one page.

    scripts/judge.sh my.glb
    scripts/judge.sh my.glb --camera eye=0,1.6,4,target=0,1,0,fov=50 --environment sky.hdr --presets mobile,quality

Camera, light and sky are written as for `vct render`, and the path tracer takes them too. Errors are means over the pixels in
which the camera sees a surface. The page shows the pictures at the exposure that `vct render` would choose for the path-traced
one, and FLIP compares what the page shows. Writes OUT/index.html with its pictures beside it, and prints the same table. If a
preset fails, the page has the others and says why. If all fail, the page of an earlier run stays as it is.
"""
import argparse
import re
import tempfile
from pathlib import Path
from typing import Any

import program
from files import Failed, file_sha256, path_tracer_sha256, scene_sha256

from . import options
from .progress import Countdown, begin, say
from .store import Result, Store, Task

# Packages of .venv are imported in functions, so that --help needs none of them.
REFERENCE = "pictures/reference-path-traced"  # in the store's folder
COVERAGE_SAMPLES = 64  # per pixel, to find the pixels in which the camera sees a surface


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("scene", type=Path, metavar="SCENE", help=".glb or .gltf")
    parser.add_argument("--out", type=Path, help="folder (default: out/judge/ and the scene's name)")
    options.add_presets(parser)
    parser.add_argument("--size", type=options.size, default=(256, 256), help="WIDTHxHEIGHT (default: 256x256)")
    parser.add_argument("--spp", type=options.samples, default=512, help="samples per pixel of path tracing (default: %(default)s)")
    voxels = parser.add_mutually_exclusive_group()
    voxels.add_argument("--grid", help="voxels along a side, or auto (default: each preset's)")
    voxels.add_argument("--voxel-size", type=options.length, metavar="METRES",
                        help="largest voxels around the camera, as for vct render")
    parser.add_argument("--camera", help="eye=X,Y,Z,target=X,Y,Z,fov=DEG, or one of the scene's, by name or number")
    parser.add_argument("--light", help="direction=X,Y,Z,color=R,G,B,intensity=LUX instead of the scene's sun")
    sky = parser.add_mutually_exclusive_group()
    sky.add_argument("--sky", help="radiance R,G,B from everywhere outside the scene, or one number")
    sky.add_argument("--environment", type=Path, help="a picture of the sky, .hdr or .exr")
    parser.add_argument("--emission", type=float, default=1.0, help="scales what all surfaces emit; 0 switches it off")


def trace(asked: argparse.Namespace, view: dict[str, Any], folder: Path) -> Result:
    """Draws the reference of all bounces and its coverage, and returns its noise."""
    import numpy as np

    from metrics import noise_of_halves
    from truth.asked import lit_by, lit_by_room_light, numbers, seen_by
    from truth.drawing import draw, make_world
    from truth.exr import write_exr
    from truth.scene import load_scene
    scene = lit_by(seen_by(load_scene(asked.scene, asked.size), view), asked.light, asked.sky, asked.environment,
                   asked.emission)
    if asked.room_light:
        candela, place = asked.room_light
        scene = lit_by_room_light(scene, float(candela), numbers(place))
    world = make_world(scene)
    coverage = draw(world, scene, "coverage", asked.size, COVERAGE_SAMPLES, 0).image
    if not coverage.any():
        raise Failed("the camera sees no surface: choose another view with --camera")
    drawn = draw(world, scene, "full", asked.size, asked.spp, 0, Countdown(asked.spp).advance)
    if not np.isfinite(drawn.image).all():
        raise Failed("the path-traced picture has values that are not finite")
    write_exr(folder / "coverage.exr", coverage)
    write_exr(folder / "full.exr", drawn.image)
    return {"noise": noise_of_halves(*(half[coverage[..., 0] > 0] for half in drawn.halves))}


def voxel_options(asked: argparse.Namespace) -> list[str]:
    """The options of `vct render` that were given for the voxels."""
    return [*(["--grid", asked.grid] if asked.grid else []), *(["--voxel-size", asked.voxel_size] if asked.voxel_size else [])]


def hint(grid: str) -> str:
    """The option that gives all presets the voxels that `vct --grid auto` chose: "grid 64, 3 cascades: voxels of 4 cm around"."""
    nested = re.match(r"grid \d+, \d+ cascades: voxels of (\S+) (\S+) around", grid)
    if not nested:
        return f"hint: the scene wants --{grid}"
    metres = 1.01 * float(nested[1]) * {"km": 1e3, "m": 1, "cm": 1e-2, "mm": 1e-3}[nested[2]]  # it was rounded
    return f"hint: the scene wants --voxel-size {metres:.3g} ({grid})"


def probe(asked: argparse.Namespace, view: dict[str, Any], given: list[str]) -> list[str]:
    """Draws a quick picture, which checks the options, to learn what `vct` chooses where the scene and the options are silent.
    Returns its notes."""
    with tempfile.TemporaryDirectory() as folder:
        said = program.render(asked.scene, Path(folder), "--mode", "phong", "--size", "{}x{}".format(*asked.size),
                              "--exposure", "1", "--camera", view["option"], *(voxel_options(asked) or ["--grid", "auto"]), *given)
    if asked.sky and re.search("[#a-df-z]", asked.sky):
        raise Failed(f"--sky {asked.sky}: the path tracer takes radiance as R,G,B or one number; write it so")
    chosen = re.search(r"as with (?:--light (\S+) )?--sky ([^\s;]+)", said)
    room_light = re.search(r"adds a point light of (\S+) cd at (\S+)\. ", said)
    asked.room_light = room_light and room_light.groups()
    if chosen:
        light, asked.sky = chosen.groups()
        given += ["--sky", asked.sky]
        if light:
            asked.light = light
            given += ["--light", light]
    lines = said.splitlines()
    # The quick picture reads no voxels, unlike those of the page.
    notes = [line for line in lines if re.match("note: (?!--grid |--voxel-size )|warning: ", line)]
    return notes + [hint(line) for line in lines if line.startswith("grid ") and not voxel_options(asked)]


def noise_notes(results: list[Result], spp: int) -> list[str]:
    """Tells how much of the errors is the noise of the reference, if that is more than a fifth."""
    noisy = [f"{100 * share:.0f} % of the relMSE of {one['preset']}" for one in results
             if (share := min(one["noise"]["gi"] / max(one["camera"]["errors"]["gi"]["relmse"], 1e-30), 1.0)) > 0.2]
    return [f"warning: the noise of the path-traced picture is {' and '.join(noisy)}; --spp {4 * spp} makes it a quarter"] if noisy else []


def tasks_of(asked: argparse.Namespace, store: Store, view: dict[str, Any], given: list[str]) -> tuple[Task, list[Task]]:
    """The reference, and each preset's picture, which is compared with it."""
    import metrics
    from truth.exr import read_exr

    from .measures import measured
    shared = {"scene": scene_sha256(asked.scene), "size": asked.size, "spp": asked.spp, "camera": view["option"],
              "light": asked.light, "sky": asked.sky, "room_light": asked.room_light, "emission": asked.emission,
              "path_tracer": path_tracer_sha256(),
              "environment": asked.environment and file_sha256(asked.environment), "kinds": ["coverage", "full"]}
    flags = ["--camera", view["option"], *voxel_options(asked), *given]

    def measure(preset: str, folder: Path) -> Result:
        reference = read_exr(asked.out / REFERENCE / "full.exr")
        surface = read_exr(asked.out / REFERENCE / "coverage.exr")[..., 0] > 0
        exposure = metrics.automatic_exposure(reference[surface])
        result = measured(asked.scene, preset, asked.size, ["gi"], lambda _: reference, folder, flags, surface, exposure)
        return result | {"reference": f"{REFERENCE}/full.exr", "exposure": exposure, "surface": float(surface.mean()),
                         "noise": {"gi": store.results_of("reference")[0]["noise"]}}

    key = {**shared, "grid": asked.grid, "voxel_size": asked.voxel_size, "metrics": file_sha256(Path(metrics.__file__))}
    return (Task("reference", "path-traced", shared, lambda folder: trace(asked, view, folder), uses_program=False),
            [Task("render", f"{asked.scene.stem}-{preset}", key, lambda folder, preset=preset: measure(preset, folder), preset)
             for preset in asked.presets])


def run(asked: argparse.Namespace) -> int:
    from . import report
    from .render import machine, table
    for file in (asked.scene, asked.environment):
        if file and not file.is_file():
            raise Failed(f"there is no file {file}")
    begin("reading the scene")
    asked.out = asked.out or Path("out/judge") / asked.scene.stem
    view = program.camera(asked.scene, asked.size, *(["--camera", asked.camera] if asked.camera else []))
    given = [word for name in ("light", "sky", "environment") if (value := getattr(asked, name)) is not None
             for word in (f"--{name}", str(value))]
    given += ["--emission", str(asked.emission)] if asked.emission != 1 else []
    notes = [*probe(asked, view, given), f"camera: --camera {view['option']}"]
    try:
        asked.out.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise Failed(f"cannot write into the folder {asked.out}: {error.strerror}; choose another folder with --out") from None
    store = Store(asked.out)
    reference, renders = tasks_of(asked, store, view, given)
    if not store.run([reference]):
        return 1  # the error is the last line
    if results := store.run(renders):
        notes.append("The pictures are shown at --exposure {exposure:g}, and FLIP is taken there. The errors are means over the "
                     "{share:.0f} % of the pixels that show a surface.".format(**results[0], share=100 * results[0]["surface"]))
        print(machine(results))
        notes += noise_notes(results, asked.spp)
        print(table(results), end="")
        print(*notes, sep="\n")
    else:
        say(f"no page is written, because {', '.join(store.failures(renders))} failed")
        return 1
    store.keep_only([reference, *renders])  # the rest may be of another view or light
    store.keep_failures_only(renders)
    store.data["notes"] = notes
    store.save()
    report.write(store, f"{asked.scene.name}, judged")
    print(f"Open {asked.out / 'index.html'}", flush=True)
    store.say_failures(renders)
    return 1 if store.failures(renders) else 0
