"""Path-traced references of glTF scenes, by Mitsuba 3: for the scene's first camera (or the view that `vct` chooses, where it
has none), or those of `--cameras`, and all its lights.

    tools/eval.py references                                        every static scene of assets/
    tools/eval.py references my.glb --size 400x400 --out out/ref    one scene, elsewhere
    tools/eval.py references town --cameras court,stairs            references/town-court and references/town-stairs
    tools/eval.py references --check                                do the stored ones come out again?

Kinds, all linear RGB without tone mapping, box filter, Lambert surfaces of the base colour (except for `full` and `glossy`).
The sky is black, or the picture SCENE.hdr beside the scene's file (equirectangular, its centre towards +X). It is then also
the background of `indirect` and `full`.

coverage    share of the pixel in which the camera sees a surface
direct      emission of the seen surface + albedo E/pi n.l where nothing lies between it and a light: the sun, which is the
            first directional light (as a point), and all other lights of KHR_lights_punctual
indirect    albedo x the cosine-weighted mean over the hemisphere of the `direct` of the surfaces seen there: one bounce. It
            includes the emission of other surfaces, and excludes that of the seen surface
full        all bounces, ended by Russian roulette from the fourth on. A metal, or a surface of roughness below 1, is glossy where the
            camera sees it, and a Lambert surface for all other light: light that metal reflects from a point sun onto walls
            is noise to a path tracer, and the renderer under test has no such light
glossy      the part of `full` that glossy surfaces reflect specularly, without the sun and the other lights that have no
            size; only for scenes with glossy surfaces
ao          cosine-weighted share of the hemisphere free of surfaces nearer than 0.045 of the voxel volume's side
sun         direct, with a sun of 5 degrees full opening and the same irradiance E on a surface that faces it
shadow      share of that sun's disc that the surface sees; 0 where n.l <= 0

A node whose `extras.opening` holds two vectors is a parallelogram, from the node's origin, through which a room gets its
light. Paths of `indirect` and `full` are sent there more often, which lowers the noise and keeps the mean.

n is the interpolated vertex normal; nothing arrives from behind a triangle. ao, shadow and coverage count the sky's part of a
pixel as 0. Surfaces with an alpha mask have holes for every ray. A single-sided back is black, stops light, and is invisible
to the camera.

`reference.json` holds the settings and, for each kind, `noise_relmse`: the relMSE of the stored mean, estimated from two halves
with different seeds as mean(((a - b) / 2)^2 / (((a + b) / 2)^2 + 0.01)).

Two runs on one machine give the same bytes. So do other x86 processors, except for rays on the edge between two triangles,
which Embree decides differently with AVX2 and AVX-512: `--check` then prints a relMSE far below the noise.
"""
import argparse
import itertools
import json
import tempfile
from pathlib import Path

import numpy as np

import program
from files import ROOT, Failed, file_sha256, find_scene, reference_folder, static_scenes, write_whole
from metrics import noise_of_halves, relmse
from truth.asked import seen_by
from truth.exr import read_exr, write_exr
from truth.scene import load_scene, sky_file

from . import options
from .progress import Countdown, begin, say

# Samples per pixel, even numbers, so that the noise is well below the errors to be judged (relMSE of 0.0005 and more).
SAMPLES = {"coverage": 256, "direct": 256, "indirect": 4096, "full": 1024, "glossy": 1024, "ao": 512,
           "sun": 256, "shadow": 512}
# Factors on these numbers: bright parts of a sky are met by chance alone, and light through an opening is weak.
SKY_FACTORS = {"full": 4, "glossy": 4}
OPENING_FACTORS = {"full": 8}
KINDS = ("coverage", "direct", "indirect", "full", "ao", "sun", "shadow")
GLOSSY = "glossy"  # only for scenes with glossy materials
INTEGRATORS = {"coverage": "camera rays", "direct": "shadow ray to each light",
               "indirect": "one cosine-distributed ray and one emitter, power heuristic; shadow ray to each light",
               "full": "path tracing, power heuristic, Russian roulette",
               "glossy": "a visible normal of GGX, then path tracing as full",
               "ao": "one cosine-distributed ray", "sun": "one shadow ray into the disc",
               "shadow": "one shadow ray into the disc"}
SEED = 0


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("scenes", nargs="*", metavar="SCENE", help=".glb or .gltf, or a name in assets/ (default: all)")
    options.add_cameras(parser)
    parser.add_argument("--size", type=options.size, default=(256, 256), help="WIDTHxHEIGHT (default: 256x256)")
    parser.add_argument("--spp", type=options.samples, help="samples per pixel of every kind (default: depends on the kind)")
    parser.add_argument("--kinds", type=options.names((*KINDS, GLOSSY), "kind"), default=list(KINDS),
                        help=f"with commas (default: {','.join(KINDS)})")
    parser.add_argument("--out", type=Path, default=ROOT / "references",
                        help="folder; a scene's references go into OUT/NAME or OUT/NAME-CAMERA (default: references)")
    parser.add_argument("--check", action="store_true", help="make them again, compare with the stored ones, write nothing")


def sample_factor(scene, kind: str) -> int:
    sky = SKY_FACTORS.get(kind, 1) if scene.sky is not None else 1
    return sky * (OPENING_FACTORS.get(kind, 1) if len(scene.openings) else 1)


def draw_kinds(scene, kinds: list[str], size: tuple[int, int], samples: int | None) -> dict:
    """Kind -> (Drawn, samples)."""
    from truth.drawing import draw, make_world  # after the arguments are checked, because loading Mitsuba takes seconds
    world, drawn = make_world(scene), {}
    for kind in kinds:
        count = samples or SAMPLES[kind] * sample_factor(scene, kind)
        say(f"{scene.path.name}: {kind}, {count} samples per pixel")
        begin(f"{scene.path.name}: {kind}")
        drawn[kind] = draw(world, scene, kind, size, count, SEED, Countdown(count).advance), count
    return drawn


def describe(scene, drawn: dict, size: tuple[int, int]) -> dict:
    from truth import engine
    return {
        "scene": scene.path.name,
        "scene_sha256": scene.sha256,
        **({"sky_sha256": file_sha256(sky_file(scene.path))} if scene.sky is not None else {}),
        "size": list(size),
        "mitsuba": engine.mi.__version__,
        "variant": engine.VARIANT,
        "camera": {"name": scene.camera.name, "eye_world": scene.camera.eye_world.tolist(),
                   "right_up_back": scene.camera.axes.tolist(), "vertical_fov_rad": scene.camera.vertical_fov_rad},
        "light": {"towards": scene.sun.towards.tolist(), "irradiance": scene.sun.irradiance.tolist(),
                  "sun_opening_deg": 5.0},
        **({"punctual_lights": len(scene.punctual)} if scene.punctual else {}),
        "volume_side_world": scene.side_world,
        "ao_distance_world": scene.ao_distance_world,
        "kinds": {kind: {"spp": count, "seed": SEED, "integrator": INTEGRATORS[kind],
                         "noise_relmse": float(f"{noise_of_halves(*result.halves):.3g}")}
                  for kind, (result, count) in drawn.items()},
    }


def rounded(value):
    """Rounds every number of a JSON value to nine significant digits."""
    if isinstance(value, float):
        return float(f"{value:.9g}")
    if isinstance(value, dict):
        return {key: rounded(inner) for key, inner in value.items()}
    return [rounded(inner) for inner in value] if isinstance(value, list) else value


def make(path: Path, camera: str | None, out: Path, asked: argparse.Namespace) -> None:
    scene, kinds = load_scene(path, asked.size), asked.kinds
    if camera:
        scene = seen_by(scene, program.camera(path, asked.size, "--camera", camera))
    if kinds == list(KINDS) and any(scene.materials[i].glossy for i in set(scene.material_of.tolist())):
        kinds = [*kinds, GLOSSY]
    drawn = draw_kinds(scene, kinds, asked.size, asked.spp)
    for kind, (result, _) in drawn.items():
        if not np.isfinite(result.image).all():
            raise Failed(f"{path}: the reference {kind} has values that are not finite")
    out.mkdir(parents=True, exist_ok=True)
    for kind, (result, _) in drawn.items():
        write_exr(out / f"{kind}.exr", result.image)
    write_whole(out / "reference.json", json.dumps(rounded(describe(scene, drawn, asked.size)), indent=1) + "\n")


def differing(stored: Path, made: Path) -> list[str]:
    """Names the files that are not the same bytes, pictures with the relMSE between the two."""
    found = []
    for new in sorted(made.iterdir()):
        old = stored / new.name
        if not old.is_file():
            found.append(f"{new.name} (not stored)")
        elif old.read_bytes() != new.read_bytes():
            try:
                error = f" (relMSE {relmse(read_exr(new), read_exr(old)):.1e})" if new.suffix == ".exr" else ""
            except (Failed, ValueError):
                error = " (the stored one is of another size, or not readable)"
            found.append(new.name + error)
    return found


def run(asked: argparse.Namespace) -> int:
    scenes = [find_scene(scene) for scene in asked.scenes] or static_scenes()
    different = False
    for path, camera in itertools.product(scenes, asked.cameras):
        out = reference_folder(path, asked.out, camera)
        if not asked.check:
            make(path, camera, out, asked)
            continue
        with tempfile.TemporaryDirectory() as folder:
            make(path, camera, Path(folder), asked)
            changed = differing(out, Path(folder))
        shown = f"{path.name} from {camera}" if camera else path.name
        print(f"{shown}: {'differs: ' + ', '.join(changed) if changed else 'the same, bit for bit'}", flush=True)
        different |= bool(changed)
    return 1 if different else 0
