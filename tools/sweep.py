#!/usr/bin/env python3
"""Settings x scenes x drivers -> times and errors, in one sweep.json (docs/sweep.md).

Each point is a fresh process of `vct render --timings`, whose pictures are what the errors are of. Ctrl-C stops it; the
same command continues where it was. A point that fails is kept as failed, with what the program said.
"""
from __future__ import annotations

import argparse
import datetime
import shutil
import sys
import time
from pathlib import Path
from typing import Any

import files
import program
from references import SAME_PICTURE, still_scenes
from sweep import measures
from sweep.run import run
from sweep.settings import MODES, SETTINGS, Point, Values, points, values_of_presets
from sweep.store import Store

METRICS_SOURCE = Path(measures.metrics.__file__)


def arguments() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scenes", help="names in assets/ or paths, with commas (default: all of assets/ that stand still)")
    for setting in SETTINGS:
        usual = "; ".join([",".join(map(str, setting.default)), *(f"{preset}: {','.join(map(str, values))}"
                                                                  for preset, values in setting.of_preset.items())])
        parser.add_argument(setting.option, dest=setting.name, help=f"{setting.help} (default: {usual})")
    parser.add_argument("--modes", default="gi,gi-cone-shadow,ao", help="default: %(default)s")
    parser.add_argument("--out", type=Path, default=Path("out/sweep"), help="default: %(default)s")
    parser.add_argument("--references", type=Path, default=files.ROOT / "references",
                        help="folder of tools/references.py (default: references)")
    program.add_option(parser)
    parser.add_argument("--timeout", type=float, default=600, help="seconds for one point (default: %(default)g)")
    parser.add_argument("--quick", action="store_true", help="cornell alone, small; what is given still counts")
    return parser


def scene_paths(text: str | None, quick: bool) -> list[Path]:
    """Scenes by name or by path, relative where they are the repository's, as sweep.json shows them."""
    if text is None and not quick:
        return still_scenes()
    paths = [Path(name) if name.endswith((".glb", ".gltf")) else files.ROOT / "assets" / f"{name}.glb"
             for name in (text or "cornell").split(",")]
    if missing := [str(path) for path in paths if not path.exists()]:
        raise SystemExit(f"error: no such scene: {', '.join(missing)}")
    return paths


def asked(options: argparse.Namespace) -> list[Point]:
    """The points of the command line."""
    given: Values = {}
    for setting in SETTINGS:
        text = getattr(options, setting.name)
        try:
            if text:
                given[setting.name] = tuple(setting.parse(part) for part in text.split(","))
        except ValueError:
            raise SystemExit(f"error: {setting.option} {text}: not {setting.help}") from None
    modes = tuple(options.modes.split(","))
    if unknown := set(modes) - set(MODES):
        raise SystemExit(f"error: unknown mode {', '.join(sorted(unknown))}; there are {', '.join(MODES)}")
    return points(scene_paths(options.scenes, options.quick), values_of_presets(given, options.quick), modes, SAME_PICTURE)


class Sweep:
    """One run of the command: what it found before, and what it adds."""

    def __init__(self, options: argparse.Namespace) -> None:
        self.options = options
        self.points = asked(options)
        program.require(options.program)
        self.program_sha256 = files.program_sha256(options.program)
        self.scene_sha256 = {point.scene: files.file_sha256(point.scene) for point in self.points}
        self.references = {point.scene.stem: measures.References(options.references, point.scene.stem)
                           for point in self.points}
        self.store = Store(options.out / "sweep.json")
        scenes = {scene.stem: sha256 for scene, sha256 in self.scene_sha256.items()}
        if dropped := self.store.drop_stale(self.program_sha256, scenes):
            say(f"{dropped} points of another program or of changed scenes dropped")
        self.run_number = max((entry["run"] for entry in self.store.entries.values()), default=0) + 1
        self.describe()

    def describe(self) -> None:
        """All of sweep.json but the points."""
        runs = self.store.data.setdefault("runs", [])
        runs.append({"run": self.run_number, "started": now(), "commit": files.commit(),
                     "program_sha256": self.program_sha256})
        known = self.store.data.setdefault("scenes", {})
        for scene, sha256 in self.scene_sha256.items():
            known[scene.stem] = {"path": files.shown(scene), "sha256": sha256,
                                 "reference": self.references[scene.stem].about}

    def key(self, point: Point) -> str:
        return point.key({"program": self.program_sha256, "scene_sha256": self.scene_sha256[point.scene]})

    def measure(self, entry: dict[str, Any]) -> None:
        """Fills in the errors, from the pictures in the point's folder."""
        references = self.references[entry["scene"]]
        entry["errors"] = measures.errors(entry, self.options.out / entry["folder"], references)
        entry["measured_with"] = self.measured_with(entry["scene"])

    def measured_with(self, scene: str) -> dict[str, str]:
        return {"references": self.references[scene].sha256(), "metrics": files.file_sha256(METRICS_SOURCE),
                "measures": files.file_sha256(Path(measures.__file__))}

    def render(self, point: Point, key: str) -> dict[str, Any]:
        """The point's entry, done or failed."""
        folder = self.options.out / "points" / key
        shutil.rmtree(folder, ignore_errors=True)  # Pictures of a run that was stopped.
        entry = {"key": key, "scene": point.scene.stem, "settings": point.settings, "run": self.run_number,
                 "scene_sha256": self.scene_sha256[point.scene], "program_sha256": self.program_sha256,
                 "folder": f"points/{key}", "started": now(), "status": "done", "message": ""}
        try:
            entry |= run(point, self.options.program, folder, self.options.timeout)
            if files.program_sha256(self.options.program) != self.program_sha256:
                raise SystemExit("error: the program or its shaders changed meanwhile; run the sweep again")
            self.measure(entry)
        except program.Failed as why:
            entry |= {"status": "failed", "message": str(why), "modes": {mode: {} for mode in point.modes}}
        return entry

    def outcome(self, point: Point) -> str:
        """Does what is left to do for the point and says what that was."""
        key = self.key(point)
        entry = self.store.finished(key)
        if entry and entry["measured_with"] == self.measured_with(entry["scene"]):
            return "kept"
        if entry and (self.options.out / entry["folder"]).is_dir():
            self.measure(entry)
            self.store.put(entry)
            return "kept, errors measured anew"
        entry = self.render(point, key)
        self.store.put(entry)
        if entry["status"] == "failed":
            return f"FAILED: {entry['message']}"
        return ", ".join(f"{mode} {steps['total']['median']:.0f} ms" for mode, steps in entry["modes"].items())

    def run(self) -> int:
        """All points; the exit status."""
        left = [not self.store.finished(self.key(point)) for point in self.points]
        say(f"{len(self.points)} points, {sum(left)} to render")
        start = time.monotonic()
        for number, point in enumerate(self.points, 1):
            print(f"[{number}/{len(self.points)}] {point.name}: {self.outcome(point)} ({since(start)} so far)",
                  file=sys.stderr, flush=True)
        self.store.save()
        failed = [point for point in self.points if self.store.entries[self.key(point)]["status"] == "failed"]
        say(f"{len(self.points) - len(failed)} points done, {len(failed)} failed, "
            f"{since(start)}: {files.shown(self.store.path)}")
        return 1 if failed else 0


def since(start: float) -> datetime.timedelta:
    return datetime.timedelta(seconds=round(time.monotonic() - start))


def now() -> str:
    return datetime.datetime.now(datetime.timezone.utc).isoformat(timespec="seconds")


def say(text: str) -> None:
    print(f"sweep: {text}", file=sys.stderr, flush=True)


def main() -> int:
    sweep = Sweep(arguments().parse_args())
    try:
        return sweep.run()
    except KeyboardInterrupt:
        sweep.store.save()
        say("stopped; the same command continues here")
        return 130


if __name__ == "__main__":
    sys.exit(main())
