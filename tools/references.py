#!/usr/bin/env python3
"""Path-traced references of glTF scenes, by Mitsuba 3, for the scene's first camera (or the view that `vct`
chooses, where it has none) and all its lights.

    scripts/python.sh && .venv/bin/python tools/references.py                 all scenes of assets/
    .venv/bin/python tools/references.py my.glb --size 400x400 --out out/ref  one, elsewhere
    .venv/bin/python tools/references.py --check                              are the stored ones still what comes out?

Kinds, all linear RGB without tone mapping, box filter, Lambert surfaces of the base colour (but for `full` and
`glossy`). The sky is black, or the picture SCENE.hdr beside the scene's file (equirectangular, its centre towards +X),
and then behind the scene in `indirect` and `full`:

coverage    share of the pixel in which the camera sees a surface
direct      emission of what the camera sees + albedo E/pi n.l where nothing lies between it and a light: the sun, which
            is the first directional light (as a point), and all others of KHR_lights_punctual
indirect    albedo x the cosine-weighted mean over the hemisphere of the `direct` of what is seen there: light that
            leaves a surface once more, the emission of other surfaces included, the seen surface's own not
one-bounce  direct + indirect, exactly
full        all bounces, ended by Russian roulette from the fourth on. A surface of roughness below 1 is glossy where
            the camera sees it, and a Lambert one wherever else light meets it: what a point sun throws off metal onto
            walls is noise to a path tracer, and the renderer under test has no such light
glossy      the part of `full` that such surfaces reflect specularly, but of the sun and the
            other lights without a size; only of scenes that have any
ao          cosine-weighted share of the hemisphere free of surfaces nearer than 0.045 of the voxel volume's side
sun         direct, of a sun of 5 degrees full opening and the same irradiance E on a surface that faces it, and of the
            other lights as they are
shadow      share of that sun's disc that the surface sees; 0 where n.l <= 0

A node whose `extras.opening` holds two vectors is a parallelogram from its origin through which a room gets its light: paths
of `indirect` and `full` are sent there more often, which lessens the noise and leaves the mean.

n is the interpolated vertex normal; nothing arrives from behind a triangle. ao, shadow and coverage count the sky's
part of a pixel as 0. Surfaces with an alpha mask have holes for every ray. A single-sided back is black, stops light,
and is not there for the camera.

`reference.json` beside the pictures: settings and, for each kind, `noise_relmse`, the relMSE of the stored mean as
estimated from its two halves of different seeds: mean(((a - b) / 2)^2 / (((a + b) / 2)^2 + 0.01)).

Two runs on one machine give the same bytes. So do other x86 processors, but for rays on the edge between two
triangles, which Embree decides differently with AVX2 and AVX-512: `--check` then names the relMSE, far below the noise.
"""
import argparse
import json
import pathlib
import sys
import tempfile
import time

import numpy as np

from files import ROOT, file_sha256, write_whole
from metrics import automatic_exposures, noise_of_halves, relmse
from truth.exr import PictureError, read_exr, write_exr
from truth.gltf_file import GltfError
from truth.hdr import SkyError
from truth.scene import sky_file

# Samples per pixel; even. For noise well below the errors to be judged (relMSE of 0.0005 and more).
SAMPLES = {"coverage": 256, "direct": 256, "indirect": 4096, "full": 1024, "glossy": 1024, "ao": 512,
           "sun": 256, "shadow": 512}
# So many times as many: what glows in a sky is met by chance alone.
UNDER_A_SKY = {"full": 4, "glossy": 4}
# Light that comes through an opening is weak and noisy, also where paths are sent there on purpose.
THROUGH_AN_OPENING = {"full": 8}
KINDS = ("coverage", "direct", "indirect", "one-bounce", "full", "ao", "sun", "shadow")
GLOSSY = "glossy"  # of scenes with glossy materials
INTEGRATORS = {"coverage": "camera rays", "direct": "shadow ray to each light",
               "indirect": "one cosine-distributed ray and one emitter, power heuristic; shadow ray to each light",
               "one-bounce": "direct + indirect", "full": "path tracing, power heuristic, Russian roulette",
               "glossy": "a visible normal of GGX, then path tracing as full",
               "ao": "one cosine-distributed ray", "sun": "one shadow ray into the disc",
               "shadow": "one shadow ray into the disc"}
SEED = 0
# Scenes that are another one scaled, and so have its picture: their references are its references.
SAME_PICTURE = {"cornell_1mm": "cornell", "cornell_10km": "cornell"}
ANIMATED = {"moving", "walker"}  # not one picture, so there is none to compare with


def still_scenes() -> list[pathlib.Path]:
    return [path for path in sorted((ROOT / "assets").glob("*.glb")) if path.stem not in ANIMATED]


def reference_folder(scene: pathlib.Path, root: pathlib.Path = ROOT / "references") -> pathlib.Path:
    """Where the references of a scene file lie."""
    return root / SAME_PICTURE.get(scene.stem, scene.stem)


def factor_of(scene, kind: str) -> int:
    """Returns the factor by which the scene needs more samples than SAMPLES says."""
    sky = UNDER_A_SKY.get(kind, 1) if scene.sky is not None else 1
    return sky * (THROUGH_AN_OPENING.get(kind, 1) if len(scene.openings) else 1)


def draw_kinds(scene, kinds: list[str], size: tuple[int, int], samples: int | None) -> dict:
    """Kind -> (Drawn, samples). One-bounce brings direct and indirect with it."""
    from truth.drawing import Drawn, draw, make_world  # after the arguments are checked: loading takes a while
    world, drawn = make_world(scene), {}
    wanted = set(kinds) | ({"direct", "indirect"} if "one-bounce" in kinds else set())
    for kind in SAMPLES:
        if kind in wanted:
            count = samples or SAMPLES[kind] * factor_of(scene, kind)
            print(f"{scene.path.name} {kind}: {count} samples, ", end="", flush=True)
            start = time.monotonic()
            drawn[kind] = draw(world, scene, kind, size, count, SEED), count
            print(f"{time.monotonic() - start:.1f} s", flush=True)
    if "one-bounce" in kinds:
        (a, count_a), (b, count_b) = drawn["direct"], drawn["indirect"]
        halves = tuple(x + y for x, y in zip(a.halves, b.halves))
        drawn["one-bounce"] = Drawn(a.image + b.image, halves), max(count_a, count_b)
    return {kind: drawn[kind] for kind in kinds}


def describe(scene, drawn: dict, size: tuple[int, int]) -> dict:
    from truth import engine
    lit = [drawn[kind] for kind in ("one-bounce", "full") if kind in drawn and drawn[kind][0].image.max() > 0]
    brightest = (lit or list(drawn.values()))[0]
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
        "hdr_flip_exposures": automatic_exposures(brightest[0].image),
        "kinds": {kind: {"spp": count, "seed": SEED, "integrator": INTEGRATORS[kind],
                         "noise_relmse": float(f"{noise_of_halves(*result.halves):.3g}")}
                  for kind, (result, count) in drawn.items()},
    }


def rounded(value):
    """Nine significant digits: short to read."""
    if isinstance(value, float):
        return float(f"{value:.9g}")
    if isinstance(value, dict):
        return {k: rounded(v) for k, v in value.items()}
    return [rounded(v) for v in value] if isinstance(value, list) else value


def make(path: pathlib.Path, out: pathlib.Path, kinds: list[str], size: tuple[int, int], samples: int | None,
         seconds: float | None) -> None:
    from truth.scene import load_scene
    scene = load_scene(path, size, seconds)
    if kinds == list(KINDS) and any(scene.materials[i].glossy for i in set(scene.material_of.tolist())):
        kinds = [*kinds, GLOSSY]
    drawn = draw_kinds(scene, kinds, size, samples)
    for kind, (result, _) in drawn.items():
        if not np.isfinite(result.image).all():
            sys.exit(f"error: {path}: the reference {kind} has values that are not finite")
    out.mkdir(parents=True, exist_ok=True)
    for kind, (result, _) in drawn.items():
        write_exr(out / f"{kind}.exr", result.image)
    write_whole(out / "reference.json", json.dumps(rounded(describe(scene, drawn, size)), indent=1) + "\n")


def differing(stored: pathlib.Path, made: pathlib.Path) -> list[str]:
    """Files that are not the same bytes, pictures with the relMSE between the two."""
    found = []
    for new in sorted(made.iterdir()):
        old = stored / new.name
        if not old.is_file():
            found.append(f"{new.name} (not stored)")
        elif old.read_bytes() != new.read_bytes():
            try:
                error = f" (relMSE {relmse(read_exr(new), read_exr(old)):.1e})" if new.suffix == ".exr" else ""
            except (PictureError, ValueError):
                error = " (the stored one is of another size, or not readable)"
            found.append(new.name + error)
    return found


def parse_size(text: str) -> tuple[int, int]:
    parts = text.split("x")
    if len(parts) != 2 or not all(p.isdigit() and 0 < int(p) <= 8192 for p in parts):
        raise argparse.ArgumentTypeError(f"'{text}' is not a size such as 256x256")
    return int(parts[0]), int(parts[1])


def parse_samples(text: str) -> int:
    if not text.isdigit() or int(text) < 2 or int(text) % 2:
        raise argparse.ArgumentTypeError(f"'{text}' is not an even number of samples, 2 or more")
    return int(text)


def arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="*", type=pathlib.Path, metavar="SCENE", help=".glb or .gltf (default: assets/)")
    parser.add_argument("--size", type=parse_size, default=(256, 256), help="WIDTHxHEIGHT (default: 256x256)")
    parser.add_argument("--spp", type=parse_samples, help="samples per pixel of every kind (default: each its own)")
    parser.add_argument("--kinds", default=",".join(KINDS), help=f"with commas (default: {','.join(KINDS)})")
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "references",
                        help="folder; a scene's references go into <out>/<its name> (default: references)")
    parser.add_argument("--time", type=float, metavar="SECONDS", help="of the scene's first animation, as `vct render --time` "
                        "takes it (default: at rest)")
    parser.add_argument("--check", action="store_true", help="make anew, compare with what is stored, write nothing")
    args = parser.parse_args()
    args.kinds = args.kinds.split(",")
    unknown = [k for k in args.kinds if k not in (*KINDS, GLOSSY)]
    if unknown:
        parser.error(f"unknown kind '{unknown[0]}'; choose from {', '.join((*KINDS, GLOSSY))}")
    if not args.scenes:
        args.scenes = [p for p in still_scenes() if p.stem not in SAME_PICTURE]
    return args


def main() -> int:
    args, bad = arguments(), 0
    for path in args.scenes:
        out = reference_folder(path, args.out)
        try:
            if not args.check:
                make(path, out, args.kinds, args.size, args.spp, args.time)
                continue
            with tempfile.TemporaryDirectory() as folder:
                make(path, pathlib.Path(folder), args.kinds, args.size, args.spp, args.time)
                changed = differing(out, pathlib.Path(folder))
        except (GltfError, SkyError) as error:
            sys.exit(f"error: {error}")
        print(f"{path.name}: {'differs: ' + ', '.join(changed) if changed else 'the same, bit for bit'}")
        bad += bool(changed)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
