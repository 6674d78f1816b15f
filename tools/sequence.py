#!/usr/bin/env python3
"""A contact sheet of an animation: moments of it in one run of vct, each beside a fresh run of that moment alone.

    .venv/bin/python tools/sequence.py --out out/sequence

Writes DIR/sequence.json, {scene, preset, mode, frames: [{time_s, picture, indirect_light, largest_difference}]}: the
pictures' names in DIR, and by how much a channel of a pixel differs from the fresh run at most, over the largest of the
picture. DIR/sheet.png has them side by side, the indirect light below. Ends with 1 where a picture differs by more than
a thousandth.
"""
from __future__ import annotations

import argparse
import json
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image, ImageDraw

sys.path.insert(0, str(Path(__file__).resolve().parent))

from sweep.identity import ROOT, shown, write_beside  # noqa: E402
from truth.exr import read_exr  # noqa: E402

MODE, PRESET = "gi", "mobile"
LARGEST_DIFFERENCE = 1e-3
SHOWN = 240  # pixels along a side, of the sheet


def rendered(program: Path, scene: Path, out: Path, *arguments: str) -> None:
    done = subprocess.run([str(program), "render", str(scene), "--out", str(out), "--preset", PRESET, "--mode", MODE,
                           *arguments], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise SystemExit(f"error: {shown(scene)} is not rendered: {done.stderr.strip()}")


def difference(picture: Path, fresh: Path) -> float:
    a, b = read_exr(picture), read_exr(fresh)
    return float(np.abs(a - b).max() / max(float(b.max()), 1e-6))


def moments(program: Path, scene: Path, out: Path, count: int, seconds: float) -> list[dict[str, Any]]:
    rate = count / seconds
    rendered(program, scene, out, "--frames", str(count), "--fps", str(rate))
    frames = []
    for i in range(count):
        fresh = out / f"fresh_{i:04}"
        rendered(program, scene, fresh, "--time", str(i / rate), "--light-parts")
        light = f"indirect_light_{i:04}.png"
        shutil.copyfile(fresh / "indirect_light.png", out / light)
        frames.append({"time_s": i / rate, "picture": f"{MODE}_{i:04}.png", "indirect_light": light,
                       "largest_difference": difference(out / f"{MODE}_{i:04}.exr", fresh / f"{MODE}.exr")})
    return frames


def sheet(frames: list[dict[str, Any]], folder: Path) -> Image.Image:
    image = Image.new("RGB", (SHOWN * len(frames), 2 * SHOWN))
    for column, frame in enumerate(frames):
        for row, kind in enumerate(("picture", "indirect_light")):
            with Image.open(folder / frame[kind]) as picture:
                image.paste(picture.convert("RGB").resize((SHOWN, SHOWN), Image.Resampling.BOX),
                            (column * SHOWN, row * SHOWN))
        ImageDraw.Draw(image).text((column * SHOWN + 6, 6), f"{frame['time_s']:.2f} s", fill="white")
    return image


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=Path, default=ROOT / "build/desktop/vct", help="default: build/desktop/vct")
    parser.add_argument("--scene", type=Path, default=ROOT / "assets/moving.glb", help="default: assets/moving.glb")
    parser.add_argument("--out", type=Path, default=ROOT / "out/sequence", help="default: out/sequence")
    parser.add_argument("--frames", type=int, default=6, help="how many moments (default: %(default)s)")
    parser.add_argument("--seconds", type=float, default=4.0, help="over which they are spread (default: %(default)g)")
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    frames = moments(options.program, options.scene, options.out, options.frames, options.seconds)
    sheet(frames, options.out).save(options.out / "sheet.png")
    write_beside(options.out / "sequence.json", json.dumps(
        {"version": 1, "scene": shown(options.scene), "preset": PRESET, "mode": MODE, "frames": frames}, indent=1) + "\n")
    worst = max(frame["largest_difference"] for frame in frames)
    print(f"{len(frames)} moments differ from fresh renders by {worst:.1e} at most: {shown(options.out / 'sheet.png')}")
    return 0 if worst <= LARGEST_DIFFERENCE else 1


if __name__ == "__main__":
    sys.exit(main())
