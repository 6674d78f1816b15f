"""Draws pictures of products beside path tracing: a sphere, a cube and a bottle on a plane under a sky, of steel, gold and plastic
with each roughness from 0 to 1.

    tools/eval.py products                                         FLIP over the pixels that show the products
    tools/eval.py products --sheet docs/images/products.jpg        and a sheet of all pictures

The noise of path tracing is the FLIP between two halves of its samples, divided by two.
"""
import argparse
import hashlib
import io
from pathlib import Path
from statistics import fmean
from typing import Any

import numpy as np
from PIL import Image, ImageDraw, ImageFont

import metrics
import program
from files import ROOT, file_sha256, write_whole
from scenes import products
from tables import fraction, markdown
from truth.exr import read_exr, write_exr

from . import options
from .pictures import shown
from .store import Result, Store, Task

ROUGHNESSES = [step / 10 for step in range(11)]
SKY = ROOT / "assets/patio.hdr"
SAMPLES = 4  # per pixel, of the renderer
CELL, LABEL = 160, 22  # of the sheet, in its pixels


def add_arguments(parser: argparse.ArgumentParser) -> None:
    options.add_store(parser)
    options.add_presets(parser, ["mobile"])
    parser.add_argument("--size", type=options.size, default=(512, 512), help="WIDTHxHEIGHT (default: 512x512)")
    parser.add_argument("--spp", type=options.samples, default=256, help="samples per pixel of path tracing (default: 256)")
    parser.add_argument("--materials", type=options.names(products.MATERIALS, "material"), default=list(products.MATERIALS),
                        help=f"with commas (default: {','.join(products.MATERIALS)})")
    parser.add_argument("--sheet", type=Path, metavar="FILE.jpg", help="draw all pictures beside path tracing")


def scene_in(folder: Path, material: str, roughness: float, ground: bool = True) -> Path:
    path = folder / "scene.glb"
    path.write_bytes(products.build(material, roughness, ground).to_bytes())
    path.with_suffix(".hdr").write_bytes(SKY.read_bytes())
    return path


def traced(kind: str, size: tuple[int, int], samples: int, **scene: Any) -> Task:
    """Path tracing of one scene; `full` and its noise, or the `coverage` of the products."""
    def measure(folder: Path) -> Result:
        from truth.drawing import draw, make_world  # loading Mitsuba takes seconds
        from truth.scene import load_scene
        loaded = load_scene(scene_in(folder, **scene), size)
        found = draw(make_world(loaded), loaded, kind, size, samples, 0)
        write_exr(folder / "traced.exr", found.image)
        for number, half in enumerate(found.halves):
            write_exr(folder / f"half{number}.exr", half)
        return {"kind": kind, **scene}
    content = hashlib.sha256(products.build(**scene).to_bytes()).hexdigest()
    return Task("products", f"{kind}-{scene['material']}-{scene['roughness']}-traced",
                {"scene": content, "sky": file_sha256(SKY), "size": size, "samples": samples, "kind": kind}, measure, "traced",
                uses_program=False)


def flip_over(mask: np.ndarray, a: np.ndarray, b: np.ndarray) -> float:
    return metrics.flip_mean(a, b, mask, 1.0)


def drawn(preset: str, material: str, roughness: float, size: tuple[int, int], reference: Path, coverage: Path) -> Task:
    def measure(folder: Path) -> Result:
        scene = scene_in(folder, material, roughness)
        program.render(scene, folder, "--preset", preset, "--mode", "gi", "--size", f"{size[0]}x{size[1]}", "--samples", SAMPLES,
                       "--exposure", 1, "--environment", scene.with_suffix(".hdr"))
        mask = read_exr(coverage / "traced.exr").min(axis=2) > 0.999
        picture, right = read_exr(folder / "gi.exr"), read_exr(reference / "traced.exr")
        halves = [read_exr(reference / f"half{number}.exr") for number in (0, 1)]
        return {"preset": preset, "material": material, "roughness": roughness, "reference": reference.name,
                "bias": float(picture[mask].mean() / right[mask].mean() - 1),
                "flip": flip_over(mask, picture, right), "noise": 0.5 * flip_over(mask, *halves)}
    key = {"reference": file_sha256(reference / "traced.exr"), "samples": SAMPLES, "metrics": file_sha256(Path(metrics.__file__))}
    return Task("products", f"{material}-{roughness}-{preset}", key, measure, preset)


def table(results: list[Result]) -> str:
    rows = []
    for preset, material in dict.fromkeys((one["preset"], one["material"]) for one in results):
        of = [one for one in results if (one["preset"], one["material"]) == (preset, material)]
        flips = [one["flip"] for one in of]
        rows.append([f"{preset}, {material}", *(fraction(flip, 3) for flip in flips), fraction(fmean(flips), 3),
                     fraction(max(flips), 3), fraction(fmean(one["noise"] for one in of), 3)])
    names = [f"{roughness:g}" for roughness in ROUGHNESSES]
    return markdown(["FLIP, roughness", *names, "mean", "largest", "noise of path tracing"], rows)


def sheet(store: Store, results: list[Result]) -> bytes:
    """A JPEG: a column for each roughness; for each material a row of ours and one of path tracing."""
    materials = list(dict.fromkeys(one["material"] for one in results))
    canvas = Image.new("RGB", (LABEL + CELL * len(ROUGHNESSES), LABEL + 2 * CELL * len(materials)), "white")
    draw, font = ImageDraw.Draw(canvas), ImageFont.load_default(14)
    for column, roughness in enumerate(ROUGHNESSES):
        draw.text((LABEL + CELL * (column + 0.5), 3), f"roughness {roughness:g}", "black", font, anchor="ma")
    for row, (material, text) in enumerate((material, text) for material in materials for text in (material, "path traced")):
        label = Image.new("RGB", (CELL, LABEL), "white")
        ImageDraw.Draw(label).text((CELL / 2, 3), text, "black", font, anchor="ma")
        canvas.paste(label.rotate(90, expand=True), (0, LABEL + CELL * row))
    for one in results:
        column, row = ROUGHNESSES.index(one["roughness"]), 2 * materials.index(one["material"])
        for below, path in enumerate((store.pictures_of(one) / "gi.exr", store.pictures(one["reference"]) / "traced.exr")):
            picture = shown(read_exr(path), 1.0).resize((CELL, CELL), Image.Resampling.BOX)
            canvas.paste(picture, (LABEL + CELL * column, LABEL + CELL * (row + below)))
    out = io.BytesIO()
    canvas.save(out, "JPEG", quality=85, optimize=True)
    return out.getvalue()


def run(asked: argparse.Namespace) -> int:
    store = Store(asked.out)
    pairs = [(material, roughness) for material in asked.materials for roughness in ROUGHNESSES]
    coverage = traced("coverage", asked.size, 16, material=asked.materials[0], roughness=1.0, ground=False)
    references = [traced("full", asked.size, asked.spp, material=material, roughness=roughness) for material, roughness in pairs]
    store.run([coverage, *references])
    tasks = [drawn(preset, *pair, asked.size, store.pictures(reference.identity), store.pictures(coverage.identity))
             for preset in asked.presets for pair, reference in zip(pairs, references)]
    results = store.run(tasks)
    print(table(results), end="")
    if asked.sheet:
        write_whole(asked.sheet, sheet(store, [one for one in results if one["preset"] == asked.presets[0]]))
    store.say_failures([coverage, *references, *tasks])
    return 1 if store.failures([coverage, *references, *tasks]) else 0
