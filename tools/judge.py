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
import hashlib
import json
import re
import sys
import tempfile
import time
import urllib.parse
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

import metrics
import program
import still
from files import file_sha256, path_tracer_sha256, program_sha256, write_whole
from mali.compiler import CompilerError
from mali.frames import bounds_ms
from mali.loops import LoopError
from references import parse_samples, parse_size
from report.html import document, image, table, tag
from report.pictures import error_png, error_scale_png, exposure_for, picture_png
from sweep.usual import PRESETS
from tables import markdown
from truth.exr import read_exr, write_exr
from truth.gltf_file import GltfError, GltfFile
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
MALI_MEANING = (("Mali-T880", "milliseconds below which no Mali-T880 of 12 cores can draw that frame, by the words that Mesa's compiler "
                              "makes of the shaders (docs/mali.md): arithmetic alone, no memory and no waiting"),)


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
        path.parent.mkdir(parents=True, exist_ok=True)
        rest = sum(self.seconds) / len(self.seconds) * (self.count - self.at + 1) if self.seconds else None
        print(f"[{self.at}/{self.count}] {what}" + (f", about {rest:.0f} s to go" if rest else ""), file=sys.stderr, flush=True)
        start = time.monotonic()
        result = maker()
        self.seconds.append(time.monotonic() - start)
        write_whole(path, json.dumps({"key": key, "result": result}, indent=1) + "\n")
        return result


def scene_sha256(path: Path) -> str:
    """Of the file and of the files that it names."""
    digest = hashlib.sha256(path.read_bytes())
    document = GltfFile(path).json
    for one in [*document.get("buffers", []), *document.get("images", [])]:
        uri = one.get("uri", "data:")
        named = path.parent / urllib.parse.unquote(uri)
        if not uri.startswith("data:") and named.is_file():
            digest.update(uri.encode() + b"\0" + named.read_bytes())
    return digest.hexdigest()


class Countdown:
    """Says every few seconds how much of something is done, and how long the rest may take."""

    EVERY_S = 4.0

    def __init__(self, of: int) -> None:
        self.of, self.done = of, 0
        self.start = self.told = time.monotonic()

    def tell(self, count: int) -> None:
        self.done += count
        now = time.monotonic()
        if now - self.told < self.EVERY_S or self.done >= self.of:
            return
        self.told = now
        left = (now - self.start) * (self.of - self.done) / self.done
        print(f"  {100 * self.done // self.of} %, about {left:.0f} s to go", file=sys.stderr, flush=True)


def trace(options: argparse.Namespace, view: dict[str, Any], folder: Path) -> dict[str, Any]:
    """Writes reference.exr: all bounces of light."""
    from truth.asked import lit_by, seen_by
    from truth.drawing import draw, make_world
    from truth.scene import load_scene
    scene = lit_by(seen_by(load_scene(options.scene, options.size), view), options.light, options.sky, options.environment,
                   options.emission)
    drawn = draw(make_world(scene), scene, "full", options.size, options.spp, 0, Countdown(options.spp).tell)
    if not np.isfinite(drawn.image).all():
        raise program.Failed("the path-traced picture has values that are not finite")
    write_exr(folder / "reference.exr", drawn.image)
    return {"noise": metrics.noise_of_halves(*drawn.halves)}


def mali_bounds(options: argparse.Namespace, camera: str, lighting: Sequence[str]) -> dict[str, Any]:
    """By preset, in ms, for a Mali-T880: of a frame of mode gi while the camera moves, and of one in which all changes."""
    with tempfile.TemporaryDirectory() as name:
        done = program.run(options.program, "shaders", options.scene, "--out", name, "--size", size_text(options), "--preset",
                           ",".join(options.presets), "--camera", camera, *lighting)
        if done.returncode != 0:
            raise program.Failed(program.last_words(done.stderr))
        manifest = json.loads((Path(name) / "manifest.json").read_text())
        bounds = bounds_ms(manifest, Path(name), options.mali_compiler, "gi")
    return {preset: {"camera_ms": ms["render_data"] + ms["trace"], "changing_ms": sum(ms.values())} for preset, ms in bounds.items()}


def described(one: dict[str, Any], bounds: dict[str, Any]) -> list[str]:
    """A row of the table."""
    row = [f"{one['preset']}, {one['grid']}^3", f"{one['camera_ms']:.1f}", f"{one['changing_ms']:.1f}", f"{one['relmse']:.4f}",
           f"{one['bias'] * 100:+.1f} %", f"{one['flip']:.3f}"]
    bound = bounds.get(one["preset"])
    return row + [f"{bound['camera_ms']:.2f}", f"{bound['changing_ms']:.2f}"] if bound else row


HEAD = ("preset, voxels", "camera moving, ms", "all changing, ms", "relMSE", "bias", "FLIP")
MALI_HEAD = ("Mali-T880, camera moving, ms", "Mali-T880, all changing, ms")


def head(bounds: dict[str, Any]) -> tuple[str, ...]:
    return HEAD + (MALI_HEAD if bounds else ())


def size_text(options: argparse.Namespace) -> str:
    return f"{options.size[0]}x{options.size[1]}"


def page(options: argparse.Namespace, view: dict[str, Any], notes: Sequence[str], results: list[dict[str, Any]],
         missing: Sequence[str], truth: dict[str, Any] | None, bounds: dict[str, Any]) -> str:
    """Writes the pictures too, all by one exposure."""
    folder, figures, exposure = options.out, [], 1.0
    if truth:
        reference = read_exr(folder / "reference.exr")
        exposure = exposure_for(reference)
        write_whole(folder / "reference.png", picture_png(reference, exposure))
        write_whole(folder / "error_scale.png", error_scale_png())
        for one in results:
            picture = read_exr(folder / one["preset"] / "gi.exr")
            write_whole(folder / f"{one['preset']}.png", picture_png(picture, exposure))
            write_whole(folder / f"{one['preset']}_error.png", error_png(picture, reference))
            figures.append(tag("figure", image(f"{one['preset']}.png", one["preset"]), image(f"{one['preset']}_error.png", "error"),
                               image("error_scale.png", "colours of errors", "scale"), tag("figcaption", tag("b", one["preset"]), ": the picture, and where it is too bright (red, yellow) or too dark "
                                   "(blue, cyan), in shares of the light that should be there")))
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
        table(head(bounds), [described(one, bounds) for one in results]),
        tag("dl", *(tag("div", tag("dt", name), tag("dd", meaning)) for name, meaning in (*MEANINGS, *(MALI_MEANING if bounds else ())))),
        *figures, tag("h2", "As seen"), tag("p", tag("code", f"--camera {view['option']}")), *(tag("p", note) for note in notes))


def notes_of(said: str) -> list[str]:
    """What `vct` chose, what it ignored, and which grid it advises (with --grid auto)."""
    lines = said.splitlines()
    return [line for line in lines if line.startswith(("note: ", "warning: "))] + [
        f"hint: the scene wants --{line}" for line in lines if line.startswith("grid ")]


def judge(options: argparse.Namespace) -> int:
    vct, folder = options.program, options.out
    given = [word for name in ("light", "sky", "environment") if (value := getattr(options, name)) is not None
             for word in (f"--{name}", str(value))]
    camera = ["--camera", options.camera] if options.camera else []
    size = size_text(options)
    done = program.run(vct, "info", options.scene, "--print-camera", "--size", size, *camera)
    if done.returncode != 0:
        raise program.Failed(program.last_words(done.stderr))
    view = json.loads(done.stdout)
    # A small picture says what the program chooses where the scene is silent, and which grid it wants.
    with tempfile.TemporaryDirectory() as probe:
        said = program.render(vct, options.scene, "--mode", "phong", "--size", "16x16", "--exposure", "1", "--grid", "auto",
                              "--out", probe, "--camera", view["option"], "--emission", options.emission, *given)
    notes = notes_of(said)
    chosen = re.search(r"as with --light (\S+) --sky (\S+)", said)
    if chosen and not (options.light or options.sky or options.environment):
        options.light, options.sky = chosen.groups()
        given += ["--light", options.light, "--sky", options.sky]
    if options.grid:
        given += ["--grid", options.grid]

    shown = {"scene": scene_sha256(options.scene), "size": size, "camera": view["option"], "light": options.light, "sky": options.sky,
             "environment": options.environment and hashlib.sha256(options.environment.read_bytes()).hexdigest(), "emission": options.emission}
    traced = {**shown, "spp": options.spp, "path_tracer": path_tracer_sha256()}
    of_program = {**traced, "grid": options.grid, "program": program_sha256(vct)}
    work, results, status = Work(1 + len(options.presets) + bool(options.mali_compiler)), [], 0
    bounds: dict[str, Any] = {}
    truth: dict[str, Any] | None = None
    try:
        truth = work.make(f"path tracing, {options.spp} samples per pixel", traced, folder / "reference.json",
                          lambda: trace(options, view, folder))
        reference = read_exr(folder / "reference.exr")
        for preset in options.presets:
            try:
                results.append(work.make(preset, of_program, folder / preset / "judged.json", lambda: still.judged(
                    vct, options.scene, preset, reference, folder / preset, ["--camera", view["option"], "--emission", str(options.emission), *given])))
            except program.Failed as failed:
                print(f"error: {preset}: {failed}", file=sys.stderr)
                status = 1
        if options.mali_compiler:
            key = {**of_program, "presets": options.presets, "compiler": file_sha256(options.mali_compiler)}
            try:
                bounds = work.make("bounds for a Mali-T880", key, folder / "mali.json", lambda: mali_bounds(options, view["option"], given))
            except (program.Failed, CompilerError, LoopError) as failed:
                print(f"error: bounds for a Mali-T880: {failed}", file=sys.stderr)
                status = 1
    except KeyboardInterrupt:
        status = 130
    if truth and results and truth["noise"] > 0.2 * min(one["relmse"] for one in results):
        notes.append(f"note: the path-traced picture's own noise, relMSE {truth['noise']:.1e}, is part of the errors; "
                     f"--spp {4 * options.spp} takes four times as long and has a quarter of it")
    missing = [preset for preset in options.presets if preset not in {one["preset"] for one in results}]
    write_whole(folder / "index.html", page(options, view, notes, results, missing if truth else ["the reference", *missing], truth, bounds))
    print(markdown(head(bounds), [described(one, bounds) for one in results]), end="")
    print(*notes, f"camera: --camera {view['option']}", f"Open {folder / 'index.html'}", sep="\n")
    return status


def emission(text: str) -> float:
    value = float(text)
    if not 0 <= value <= 1e6:
        raise argparse.ArgumentTypeError("a factor from 0 to 1000000")
    return value


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
    parser.add_argument("--environment", type=Path, help="a picture of the sky, .hdr or .exr")
    parser.add_argument("--emission", type=emission, default=1.0, help="scales what all surfaces emit; 0 switches lamps off")
    parser.add_argument("--mali-compiler", type=Path, metavar="COMPILER",
                        help="Mesa's compiler for Mali, as tools/mali.py --help describes it: adds below which time no Mali-T880 can be")
    program.add_option(parser)
    options = parser.parse_args()
    options.presets = options.presets.split(",")
    if unknown := [preset for preset in options.presets if preset not in PRESETS]:
        parser.error(f"unknown preset '{unknown[0]}'; choose from {', '.join(PRESETS)}")
    if options.sky and options.environment:
        parser.error("--sky and --environment exclude each other")
    for file in (options.scene, options.environment, options.mali_compiler):
        if file and not file.is_file():
            parser.error(f"{file} is not there")
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
    except KeyboardInterrupt:
        print("stopped", file=sys.stderr)
        return 130


if __name__ == "__main__":
    sys.exit(main())
