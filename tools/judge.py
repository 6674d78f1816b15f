#!/usr/bin/env python3
"""Judges a scene of yours: each preset's picture, its time and its error against path tracing.

    scripts/judge.sh my.glb
    scripts/judge.sh my.glb --camera eye=0,1.6,4,target=0,1,0,fov=50 --environment sky.hdr --presets mobile,quality

Writes OUT/index.html with pictures beside it, and prints the same table. Camera, light and sky are written as for `vct
render`, and reach the path tracer too. A second run makes anew only what changed: scene, options, program or shaders. Ctrl-C
keeps what is done. Exit status: 0 all is there, 1 something failed, 130 stopped.
"""
from __future__ import annotations

import argparse
import dataclasses
import hashlib
import json
import re
import sys
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

import metrics
import program
import still
from files import program_sha256, write_whole
from references import parse_samples, parse_size
from report.html import document, image, table, tag
from report.pictures import error_png, exposure_for, picture_png
from sweep.usual import PRESETS
from tables import markdown
from truth.exr import read_exr, write_exr
from truth.gltf_file import GltfError
from truth.hdr import SkyError

# What a reader must know, where it stands.
MEANINGS = (
    ("camera moving", "milliseconds of a frame of the picture while only the camera moves: the light stands still"),
    ("all changing", "milliseconds of a frame in which light, objects and camera all change, so that everything is made anew"),
    ("relMSE", "squared error relative to each pixel's brightness, (x - r)^2 / (r^2 + 0.01), averaged over the picture: 0 is perfect"),
    ("bias", "how much too bright (+) or too dark (-) the picture is as a whole"),
    ("FLIP", "how different the two look to a person who flips between them, 0 to 1; one sample per pixel without smooth edges "
             "alone costs .02 to .04"),
)


class Work:
    """Says what is made, how far it is, and how long the rest may take by what ran before."""

    def __init__(self, count: int) -> None:
        self.count, self.at, self.seconds = count, 0, []

    def make(self, what: str, key: dict[str, Any], path: Path, maker) -> dict[str, Any]:
        """The result that stands in `path` if it is of the same key; else makes it, and writes it when it is whole."""
        self.at += 1
        try:
            stored = json.loads(path.read_text())
            if stored["key"] == key:
                print(f"[{self.at}/{self.count}] {what}: unchanged", file=sys.stderr, flush=True)
                return stored["result"]
        except (OSError, ValueError, KeyError, TypeError):
            pass
        path.unlink(missing_ok=True)  # its pictures are about to change
        rest = sum(self.seconds) / len(self.seconds) * (self.count - self.at + 1) if self.seconds else None
        print(f"[{self.at}/{self.count}] {what}" + (f", about {rest:.0f} s to go" if rest else ""), file=sys.stderr, flush=True)
        start = time.monotonic()
        result = maker()
        self.seconds.append(time.monotonic() - start)
        write_whole(path, json.dumps({"key": key, "result": result}, indent=1) + "\n")
        return result


def scene_sha256(path: Path) -> str:
    """Of the file and, of a .gltf, of the files that it names."""
    digest = hashlib.sha256(path.read_bytes())
    if path.suffix == ".gltf":
        for uri in re.findall(r'"uri"\s*:\s*"((?!data:)[^"]+)"', path.read_text(errors="replace")):
            named = path.parent / uri
            digest.update(uri.encode() + b"\0" + (named.read_bytes() if named.is_file() else b""))
    return digest.hexdigest()


def numbers(text: str) -> np.ndarray:
    return np.array([float(x) for x in text.split(",")])


def lit_as_asked(scene, light: str | None, sky: str | None, environment: Path | None):
    """The path tracer's scene with what was given in place of its own. As in `vct`, a scene without lights has no sun under a
    sky that is given."""
    from truth.gltf_file import GltfFile
    from truth.hdr import read_sky
    from truth.scene import Sun, unit
    if (sky or environment) and not GltfFile(scene.path).json.get("extensions", {}).get("KHR_lights_punctual"):
        scene = dataclasses.replace(scene, sun=Sun(scene.sun.towards, np.zeros(3)))
    if light is not None:
        given = dict(re.findall(r"(\w+)=([^=]*?)(?=,\w+=|$)", light))
        color = numbers(given.get("color", "1,1,1"))
        lux = float(given["intensity"]) if "intensity" in given else float(scene.sun.irradiance.max()) or np.pi
        towards = unit(-numbers(given["direction"])) if "direction" in given else scene.sun.towards
        scene = dataclasses.replace(scene, sun=Sun(towards, color * lux))
    if environment is not None:
        return dataclasses.replace(scene, sky=read_sky(environment))
    return dataclasses.replace(scene, sky=None if sky is None else np.tile(numbers(sky), (2, 4, 1)))


def trace(options: argparse.Namespace, view: dict[str, Any], folder: Path) -> dict[str, Any]:
    """Writes reference.exr: all bounces of light."""
    from truth.drawing import draw, make_world
    from truth.scene import load_scene
    scene = load_scene(options.scene, options.size)
    axes, eye = np.array(view["right_up_back"]), np.array(view["eye_world"])
    camera = dataclasses.replace(scene.camera, axes=axes, eye_world=eye, eye=(eye - scene.centre_world) / scene.side_world,
                                 vertical_fov_rad=view["vertical_fov_rad"])
    scene = lit_as_asked(dataclasses.replace(scene, camera=camera), options.light, options.sky, options.environment)
    drawn = draw(make_world(scene), scene, "full", options.size, options.spp, 0)
    if not np.isfinite(drawn.image).all():
        raise program.Failed("the path-traced picture has values that are not finite")
    write_exr(folder / "reference.exr", drawn.image)
    return {"noise": metrics.noise_of_halves(*drawn.halves)}


def described(one: dict[str, Any]) -> list[str]:
    """A row of the table."""
    return [f"{one['preset']}, {one['grid']}^3", f"{one['camera_ms']:.1f}", f"{one['changing_ms']:.1f}", f"{one['relmse']:.4f}",
            f"{one['bias'] * 100:+.1f} %", f"{one['flip']:.3f}"]


HEAD = ("preset, voxels", "camera moving, ms", "all changing, ms", "relMSE", "bias", "FLIP")


def page(options: argparse.Namespace, view: dict[str, Any], notes: Sequence[str], results: list[dict[str, Any]],
         missing: Sequence[str], truth: dict[str, Any] | None) -> str:
    """Writes the pictures too, all by one exposure."""
    folder, figures, exposure = options.out, [], 1.0
    if truth:
        reference = read_exr(folder / "reference.exr")
        exposure = exposure_for(reference)
        write_whole(folder / "reference.png", picture_png(reference, exposure))
        for one in results:
            picture = read_exr(folder / one["preset"] / "gi.exr")
            write_whole(folder / f"{one['preset']}.png", picture_png(picture, exposure))
            write_whole(folder / f"{one['preset']}_error.png", error_png(picture, reference))
            figures.append(tag("figure", image(f"{one['preset']}.png", one["preset"]), image(f"{one['preset']}_error.png", "error"),
                               tag("figcaption", tag("b", one["preset"]), ": the picture, and where it is too bright (red, yellow) or too dark "
                                   "(blue, cyan): full colour at an error as large as the light itself")))
        figures.insert(0, tag("figure", image("reference.png", "path traced"), tag("figcaption", tag("b", "path traced"),
                       f": the truth, {options.spp} samples per pixel; its own noise has a relMSE of {truth['noise']:.1e}")))
    driver = results[0]["driver"] if results else None
    return document(
        f"{options.scene.name}, judged",
        tag("p", f"{options.size[0]}x{options.size[1]} pixels of mode gi, one sample per pixel, against path tracing with all bounces of light. "
            f"Pictures shown at an exposure of {exposure:.3g}, sRGB."),
        tag("p", f"Times on {driver}." + (" It runs on the CPU: compare its times with each other only." if "llvmpipe" in driver else ""))
        if driver else None,
        tag("p", tag("b", "Missing: "), ", ".join(missing), ". The same command continues.", class_="failed") if missing else None,
        table(HEAD, map(described, results)),
        tag("dl", *(tag("div", tag("dt", name), tag("dd", meaning)) for name, meaning in MEANINGS)),
        *figures, tag("h2", "As seen"), tag("p", tag("code", f"--camera {view['option']}")), *(tag("p", note) for note in notes))


def notes_of(said: str) -> list[str]:
    """What `vct` chose, and what it ignored."""
    return [line for line in said.splitlines() if line.startswith(("note: ", "warning: "))]


def judge(options: argparse.Namespace) -> int:
    vct, folder = options.program, options.out
    given = [word for name in ("light", "sky", "environment", "grid") if (value := getattr(options, name)) is not None
             for word in (f"--{name}", str(value))]
    camera = ["--camera", options.camera] if options.camera else []
    size = f"{options.size[0]}x{options.size[1]}"
    done = program.run(vct, "info", options.scene, "--print-camera", "--size", size, *camera)
    if done.returncode != 0:
        raise program.Failed(program.last_words(done.stderr))
    view = json.loads(done.stdout)
    # A small picture says what the program chooses where the scene is silent.
    notes = notes_of(program.render(vct, options.scene, "--mode", "phong", "--size", "16x16", "--exposure", "1", "--out", folder / "probe",
                                    "--camera", view["option"], *given))
    chosen = re.search(r"as with --light (\S+) --sky (\S+)", "\n".join(notes))
    if chosen and not (options.light or options.sky or options.environment):
        options.light, options.sky = chosen.groups()
        given += ["--light", options.light, "--sky", options.sky]

    shown = {"scene": scene_sha256(options.scene), "size": size, "camera": view["option"], "light": options.light, "sky": options.sky,
             "environment": options.environment and hashlib.sha256(options.environment.read_bytes()).hexdigest(), "spp": options.spp}
    of_program = {**shown, "grid": options.grid, "program": program_sha256(vct)}
    work, results, status = Work(1 + len(options.presets)), [], 0
    truth: dict[str, Any] | None = None
    try:
        truth = work.make(f"path tracing, {options.spp} samples per pixel", shown, folder / "reference.json",
                          lambda: trace(options, view, folder))
        reference = read_exr(folder / "reference.exr")
        for preset in options.presets:
            try:
                results.append(work.make(preset, of_program, folder / preset / "judged.json", lambda: still.judged(
                    vct, options.scene, preset, reference, folder / preset, ["--camera", view["option"], *given])))
            except program.Failed as failed:
                print(f"error: {preset}: {failed}", file=sys.stderr)
                status = 1
    except KeyboardInterrupt:
        status = 130
    if truth and results and truth["noise"] > 0.2 * min(one["relmse"] for one in results):
        notes.append(f"note: the path-traced picture's own noise, relMSE {truth['noise']:.1e}, is part of the errors; "
                     f"--spp {4 * options.spp} takes four times as long and has a quarter of it")
    missing = [preset for preset in options.presets if preset not in {one["preset"] for one in results}]
    write_whole(folder / "index.html", page(options, view, notes, results, missing if truth else ["the reference", *missing], truth))
    print(markdown(HEAD, map(described, results)), end="")
    print(*notes, f"camera: --camera {view['option']}", f"Open {folder / 'index.html'}", sep="\n")
    return status


def arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scene", type=Path, metavar="SCENE", help=".glb or .gltf")
    parser.add_argument("--out", type=Path, help="folder (default: out/judge/<the scene's name>)")
    parser.add_argument("--presets", default=",".join(PRESETS), help="with commas (default: %(default)s)")
    parser.add_argument("--size", type=parse_size, default=(256, 256), help="WIDTHxHEIGHT (default: 256x256)")
    parser.add_argument("--spp", type=parse_samples, default=512, help="samples per pixel of the path tracer (default: %(default)s)")
    parser.add_argument("--grid", help="voxels along a side, or auto (default: each preset's)")
    parser.add_argument("--camera", help="eye=X,Y,Z,target=X,Y,Z,fov=DEG; or one of the scene's, by name or number")
    parser.add_argument("--light", help="direction=X,Y,Z,color=R,G,B,intensity=LUX in place of the scene's sun")
    parser.add_argument("--sky", help="radiance R,G,B from everywhere outside the scene")
    parser.add_argument("--environment", type=Path, help="a picture of the sky, .hdr")
    program.add_option(parser)
    options = parser.parse_args()
    options.presets = options.presets.split(",")
    if unknown := [preset for preset in options.presets if preset not in PRESETS]:
        parser.error(f"unknown preset '{unknown[0]}'; choose from {', '.join(PRESETS)}")
    if options.sky and options.environment:
        parser.error("--sky and --environment exclude each other")
    if not options.scene.is_file():
        parser.error(f"{options.scene} is not there")
    options.out = options.out or Path("out/judge") / options.scene.stem
    return options


def main() -> int:
    options = arguments()
    program.require(options.program)
    try:
        return judge(options)
    except (program.Failed, GltfError, SkyError, OSError) as error:
        print(f"error: {options.scene}: {error}", file=sys.stderr)
        return 1


if __name__ == "__main__":
    sys.exit(main())
