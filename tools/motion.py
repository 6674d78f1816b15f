#!/usr/bin/env python3
"""What the light does over frames, per scene and preset: DIR/motion.json, and tables on stdout.

    .venv/bin/python tools/motion.py --out out/motion
    .venv/bin/python tools/motion.py --parts swim --scenes cornell --presets mobile

swim  a slow camera (sideways, forward, turning; 1.3 pixels a frame): the change from frame to frame of the light
      that the same surface points receive, carried by the true geometry; it should be none. The floor is that of
      a field that is known not to change
lag   a sun that goes once around in 10 s, and moving objects (`moving`, the hundred `balls`, the `walker`), at 30
      frames a second: each frame against the still picture of its moment

Entries of the same program stay in the file, so that several runs can share one; another program's are dropped. Ends with
1 where a run failed.
"""
from __future__ import annotations

import argparse
import json
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import program
from files import ROOT, commit, program_sha256, shown, write_whole
from motion import changed_scenes, lag, swim, tables
from motion.renderer import Renderer
from references import SAME_PICTURE, parse_size, still_scenes
from scenes import balls, moving, walker

VERSION = 1
DARK = {"lone_plane"}  # no light comes from other surfaces there: nothing that could lag
OBJECTS = {"moving": moving.SECONDS, "balls": balls.SECONDS, "walker": walker.SECONDS}  # the length of the animation, seconds


def arguments() -> argparse.Namespace:
    names = [path.stem for path in still_scenes() if path.stem not in SAME_PICTURE] + list(OBJECTS)
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--parts", default=",".join(tables.PARTS), help="default: %(default)s")
    parser.add_argument("--scenes", default=",".join(names), help="default: %(default)s")
    parser.add_argument("--presets", default="mobile,quality", help="default: %(default)s")
    parser.add_argument("--size", type=parse_size, default=(256, 256), help="WIDTHxHEIGHT (default: 256x256)")
    parser.add_argument("--frames", type=int, default=6, help="of each move of the camera (default: %(default)s)")
    parser.add_argument("--lag-frames", type=int, default=300, help="of a sequence at most (default: %(default)s)")
    parser.add_argument("--every", type=int, default=10, help="the frames of it that are judged (default: every %(default)s)")
    parser.add_argument("--out", type=Path, default=ROOT / "out/motion", help="default: out/motion")
    program.add_option(parser)
    options = parser.parse_args()
    options.parts, options.presets = options.parts.split(","), options.presets.split(",")
    if unknown := [part for part in options.parts if part not in tables.PARTS]:
        parser.error(f"unknown part '{unknown[0]}'; choose from {', '.join(tables.PARTS)}")
    options.scenes = options.scenes.split(",")
    if unknown := [name for name in options.scenes if name not in OBJECTS and not asset(name).is_file()]:
        parser.error(f"no such scene: {unknown[0]}; choose from {', '.join(names)}")
    if min(options.frames, options.lag_frames, options.every) < 1:
        parser.error("--frames, --lag-frames and --every are 1 or more")
    return options


def asset(name: str) -> Path:
    return ROOT / "assets" / f"{name}.glb"


class Motion:
    """One run of the command."""

    def __init__(self, options: argparse.Namespace, temporary: Path) -> None:
        self.options, self.temporary = options, temporary
        self.renderer = Renderer(options.program, temporary / "pictures", options.size)
        self.file = options.out / "motion.json"
        self.data = self.begun()
        self.failures: list[str] = []

    def begun(self) -> dict[str, Any]:
        """The file of an earlier run, where that was of the same program and size."""
        facts = {"version": VERSION, "program_sha256": program_sha256(self.options.program), "commit": commit(),
                 "size": list(self.options.size)}
        if self.file.is_file():
            known = json.loads(self.file.read_text())
            if all(known.get(fact) == facts[fact] for fact in ("version", "program_sha256", "size")):
                return known | facts
        return facts

    def keep(self, part: str, name: str, preset: str, measure: Callable[[], dict[str, Any]]) -> None:
        """Measures, and stores it or why it failed."""
        try:
            entry = measure()
        except program.Failed as why:
            entry = {"failed": str(why)}
            self.failures.append(f"{part} {name} {preset}: {why}")
        self.data.setdefault(part, {}).setdefault(name, {})[preset] = entry
        write_whole(self.file, json.dumps(self.data, indent=1) + "\n")

    def swim(self, name: str, preset: str) -> None:
        if name not in OBJECTS:
            self.keep("swim", name, preset, lambda: swim.swim(self.renderer, asset(name), preset, self.options.frames))

    def moving_scene(self, name: str) -> tuple[Path, int] | None:
        """A scene in which something moves, and its number of frames; None where nothing could."""
        if name in OBJECTS:
            frames = min(self.options.lag_frames, int(OBJECTS[name] * lag.FPS))
            if name != "balls":
                return asset(name), frames
            path = self.temporary / "balls.glb"
            path.write_bytes(balls.build(moving=balls.COUNT).to_bytes())
            return path, frames
        if name in DARK or not changed_scenes.has_sun(asset(name)):
            return None
        frames = min(self.options.lag_frames, int(changed_scenes.ONCE_AROUND_S * lag.FPS))
        return changed_scenes.light_once_around(asset(name), self.temporary / f"{name}_around.glb"), frames

    def lag(self, name: str, preset: str) -> None:
        if found := self.moving_scene(name):
            scene, frames = found
            what = name if name in OBJECTS else f"{name}, sun"
            self.keep("lag", what, preset, lambda: lag.lag(self.renderer, what, scene, preset, frames, self.options.every))

    def run(self) -> int:
        for part in self.options.parts:
            for name in self.options.scenes:
                for preset in self.options.presets:
                    getattr(self, part)(name, preset)
        print(tables.page(self.data))
        for failure in self.failures:
            print(f"error: {failure}", file=sys.stderr)
        print(f"motion: {shown(self.file)}", file=sys.stderr)
        return 1 if self.failures else 0


def main() -> int:
    with tempfile.TemporaryDirectory() as folder:
        return Motion(arguments(), Path(folder)).run()


if __name__ == "__main__":
    sys.exit(main())
