#!/usr/bin/env python3
"""A contact sheet of an animation: moments of it as an app shows them, each beside a still picture of that moment alone.

    .venv/bin/python tools/sequence.py --out out/sequence

The animation plays at 30 frames a second, with the memory that received light has; a still picture's light has
converged. Writes DIR/sequence.json, {scene, preset, mode, fps, frames: [{time_s, picture, indirect_light, flip}]}: the
pictures' names in DIR, and the mean FLIP of the picture against the still one. DIR/sheet.png has them side by side, the
indirect light below. Ends with 1 where the first moment, whose light has converged too, is not the still picture.
"""
from __future__ import annotations

import argparse
import json
import shutil
import statistics
import subprocess
import sys
from pathlib import Path
from typing import Any

from PIL import Image, ImageDraw

sys.path.insert(0, str(Path(__file__).resolve().parent))

import metrics  # noqa: E402
from sweep.identity import ROOT, shown, write_beside  # noqa: E402
from truth.exr import read_exr  # noqa: E402

MODE, PRESET = "gi", "mobile"
FPS = 30
LARGEST_FIRST_FLIP = 1e-4
SHOWN = 240  # pixels along a side, of the sheet


def rendered(program: Path, scene: Path, out: Path, *arguments: str) -> None:
    done = subprocess.run([str(program), "render", str(scene), "--out", str(out), "--preset", PRESET, "--mode", MODE,
                           *arguments], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise SystemExit(f"error: {shown(scene)} is not rendered: {done.stderr.strip()}")


def flip(picture: Path, still: Path) -> float:
    return float(metrics.flip_map(read_exr(picture), read_exr(still)).mean(dtype=float))


def moments(program: Path, scene: Path, out: Path, count: int, seconds: float) -> list[dict[str, Any]]:
    every = max(round(seconds * FPS / count), 1)
    played = out / "played"
    rendered(program, scene, played, "--frames", str((count - 1) * every + 1), "--fps", str(FPS))
    frames = []
    for i in range(count):
        still, name, light = out / f"static_{i:04}", f"{MODE}_{i * every:04}", f"indirect_light_{i * every:04}.png"
        rendered(program, scene, still, "--time", str(i * every / FPS), "--light-parts")
        shutil.copyfile(still / "indirect_light.png", out / light)
        shutil.copyfile(played / f"{name}.png", out / f"{name}.png")
        frames.append({"time_s": i * every / FPS, "picture": f"{name}.png", "indirect_light": light,
                       "flip": flip(played / f"{name}.exr", still / f"{MODE}.exr")})
    shutil.rmtree(played)
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
        {"version": 2, "scene": shown(options.scene), "preset": PRESET, "mode": MODE, "fps": FPS, "frames": frames}, indent=1) + "\n")
    mean = statistics.fmean(frame["flip"] for frame in frames)
    print(f"{len(frames)} moments differ from still pictures by a mean FLIP of {mean:.4f}: {shown(options.out / 'sheet.png')}")
    return 0 if frames[0]["flip"] <= LARGEST_FIRST_FLIP else 1


if __name__ == "__main__":
    sys.exit(main())
