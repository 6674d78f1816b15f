#!/usr/bin/env python3
"""Makes docs/images/headline.png: the courtyard by the preset `mobile` beside the same view by path tracing.

    .venv/bin/python tools/headline_picture.py

Both pictures have all bounces of light, a sun of 5 degrees and the sky of assets/patio.hdr, the same exposure and the same
tone mapping. `vct render --samples` and the path tracer average several samples per pixel, so edges are smooth in both.
The path tracer takes about five minutes on two cores; `--spp 32` gives a noisy draft in half a minute.
"""
from __future__ import annotations

import argparse
import tempfile
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw, ImageFont

import metrics
import program
from evaluation import options
from evaluation.pictures import png, shown
from files import ROOT, Failed, write_whole
from truth.asked import lit_by, seen_by
from truth.drawing import draw, make_world
from truth.exr import read_exr
from truth.scene import load_scene

SCENE = ROOT / "assets/courtyard.glb"
ENVIRONMENT = ROOT / "assets/patio.hdr"
CAMERA = "eye=2.03,1.5,2.95,target=0.42,1.2,-2.5,fov=62"
LIGHT = "direction=-0.7,-0.6,0.25,color=1,0.85,0.65,intensity=6"
EXPOSURE = 1.4
SIZE = (796, 498)  # of each of the two pictures, pixels
GAP = 8
SAMPLES = 16  # per pixel of `vct render`


def rendered() -> np.ndarray:
    """Returns the picture of `mobile`, mode gi-cone-shadow, linear RGB."""
    with tempfile.TemporaryDirectory() as folder:
        program.render(SCENE, Path(folder), "--preset", "mobile", "--mode", "gi-cone-shadow", "--size", "{}x{}".format(*SIZE),
                       "--camera", CAMERA, "--light", LIGHT, "--environment", ENVIRONMENT, "--samples", SAMPLES, "--exposure", "1")
        return read_exr(Path(folder) / "gi-cone-shadow.exr")


def path_traced(spp: int) -> np.ndarray:
    """Returns the same view by path tracing, linear RGB: all bounces, with the sun's disc in place of a point for direct light."""
    scene = seen_by(load_scene(SCENE, SIZE), program.camera(SCENE, SIZE, "--camera", CAMERA))
    scene = lit_by(scene, LIGHT, None, ENVIRONMENT, 1.0)
    world = make_world(scene)
    direct_spp = min(spp, 128)  # there is little noise in direct light
    full, direct, sun = (draw(world, scene, kind, SIZE, count, 0).image
                         for kind, count in (("full", spp), ("direct", direct_spp), ("sun", direct_spp)))
    return full - direct + sun


def labelled(linear: np.ndarray, label: str) -> Image.Image:
    image = shown(linear, EXPOSURE)
    draw, font = ImageDraw.Draw(image), ImageFont.load_default(20)
    left, top, right, bottom = draw.textbbox((14, 12), label, font=font)
    draw.rectangle((left - 6, top - 5, right + 6, bottom + 5), fill=(24, 24, 28))
    draw.text((14, 12), label, "white", font)
    return image


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=Path, default=ROOT / "docs/images/headline.png", help="PNG (default: docs/images/headline.png)")
    parser.add_argument("--spp", type=options.samples, default=512, help="samples per pixel of the path tracer (default: %(default)s)")
    asked = parser.parse_args()
    try:
        mobile, truth = rendered(), path_traced(asked.spp)
    except Failed as error:
        raise SystemExit(f"error: {error}") from None
    canvas = Image.new("RGB", (2 * SIZE[0] + GAP, SIZE[1]), "white")
    canvas.paste(labelled(mobile, "mobile, in real time"), (0, 0))
    canvas.paste(labelled(truth, f"path tracing, {asked.spp} samples per pixel"), (SIZE[0] + GAP, 0))
    write_whole(asked.out, png(canvas))
    errors = metrics.compare(mobile, truth, exposure=EXPOSURE)
    print(f"{asked.out}: relMSE {errors['relmse']:.4f}, FLIP {errors['flip']:.3f}")


if __name__ == "__main__":
    main()
