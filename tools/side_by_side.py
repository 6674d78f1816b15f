#!/usr/bin/env python3
"""One picture of the presets beside path tracing, with each one's time and error written under it.

    .venv/bin/python tools/side_by_side.py --scenes cornell,courtyard --out out/demo

Renders each scene of assets/ by each preset (mode gi: light of all bounces but thesis, which has one) at the size of its
reference in references/, and writes OUT/presets.png, OUT/presets.json and the pictures' folders. Prints the same table.
"""
from __future__ import annotations

import argparse
import io
import json
import sys
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image, ImageDraw, ImageFont

import metrics
import program
import still
from files import ROOT, write_whole
from sweep.usual import PRESETS
from tables import markdown
from truth.exr import read_exr

SCALE, GAP, TEXT, HEAD = 2, 16, 84, 40  # pixels; a pixel of a picture is SCALE of them
TRUTH = "path traced"


def judged(vct: Path, scene: str, preset: str, out: Path) -> dict[str, Any]:
    """tools/still.py's figures and `picture`, (height, width, 3), linear RGB."""
    folder = out / f"{scene}-{preset}"
    reference = read_exr(ROOT / "references" / scene / "full.exr")
    figures = still.judged(vct, ROOT / "assets" / f"{scene}.glb", preset, reference, folder)
    return {"scene": scene, **figures, "picture": read_exr(folder / "gi.exr")}


def words(one: dict[str, Any]) -> tuple[str, str]:
    """The two lines under a picture."""
    return (f"{one['camera_ms']:.0f} ms, camera moving; {one['changing_ms']:.0f} ms, all changing",
            f"relMSE {one['relmse']:.4f}   bias {one['bias'] * 100:+.0f} %   FLIP {one['flip']:.2f}")


def sheet(rows: dict[str, list[dict[str, Any]]]) -> bytes:
    """The PNG: a row for each scene, a column for each preset, and the path-traced picture last."""
    columns = [*PRESETS, TRUTH]
    pictures = {scene: [one["picture"] for one in row] + [read_exr(ROOT / "references" / scene / "full.exr")]
                for scene, row in rows.items()}
    cell = SCALE * max(picture.shape[1] for row in pictures.values() for picture in row) + GAP
    heights = [SCALE * row[0].shape[0] + TEXT for row in pictures.values()]
    canvas = Image.new("RGB", (cell * len(columns) + GAP, sum(heights) + HEAD), "white")
    draw = ImageDraw.Draw(canvas)
    large, small = ImageFont.load_default(26), ImageFont.load_default(18)
    for column, name in enumerate(columns):
        draw.text((GAP + column * cell, 6), name, "black", large)
    top = HEAD
    for (scene, row), height in zip(rows.items(), heights):
        for column, linear in enumerate(pictures[scene]):
            bytes_ = (metrics.srgb_from_linear(linear) * 255 + 0.5).astype(np.uint8)
            shown = Image.fromarray(bytes_).resize((SCALE * linear.shape[1], SCALE * linear.shape[0]), Image.Resampling.NEAREST)
            canvas.paste(shown, (GAP + column * cell, top))
            lines = words(row[column]) if column < len(row) else (f"{scene}: the reference, Mitsuba 3", "all bounces of light")
            for line, text in enumerate(lines):
                draw.text((GAP + column * cell, top + height - TEXT + 8 + 26 * line), text, "black", small)
        top += height
    data = io.BytesIO()
    canvas.save(data, "PNG", optimize=True)
    return data.getvalue()


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scenes", default="cornell,courtyard", help="of assets/, with commas (default: %(default)s)")
    parser.add_argument("--out", type=Path, default=Path("out/presets"), help="folder (default: %(default)s)")
    program.add_option(parser)
    options = parser.parse_args()
    program.require(options.program)
    scenes = options.scenes.split(",")
    for scene in scenes:
        if not (ROOT / "references" / scene / "full.exr").is_file():
            raise SystemExit(f"error: references/{scene}/full.exr is missing: tools/references.py makes it")
    rows: dict[str, list[dict[str, Any]]] = {}
    for scene in scenes:
        for preset in PRESETS:
            print(f"{scene} with {preset}", file=sys.stderr, flush=True)
            try:
                rows.setdefault(scene, []).append(judged(options.program, scene, preset, options.out))
            except program.Failed as error:
                raise SystemExit(f"error: {scene} with {preset}: {error}") from None
    every = [one for row in rows.values() for one in row]
    write_whole(options.out / "presets.png", sheet(rows))
    write_whole(options.out / "presets.json", json.dumps(
        {"version": 1, "pictures": [{key: one[key] for key in one if key != "picture"} for one in every]}, indent=1) + "\n")
    print(f"Frames of mode 4 on {every[0]['driver']}; errors against path tracing, all bounces:\n")
    print(markdown(["scene", "preset", "camera moving, ms", "all changing, ms", "relMSE", "bias", "FLIP"],
                   ([one["scene"], f"{one['preset']}, {one['grid']}^3", f"{one['camera_ms']:.1f}", f"{one['changing_ms']:.1f}",
                     f"{one['relmse']:.4f}", f"{one['bias'] * 100:+.0f} %", f"{one['flip']:.2f}"] for one in every)), end="")
    return 0


if __name__ == "__main__":
    sys.exit(main())
