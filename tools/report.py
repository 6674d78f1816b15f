#!/usr/bin/env python3
"""One self-contained HTML page from a sweep: opens from disk, asks for nothing from outside, has no script.

Summary, time against error per scene, pictures over their references and their errors, tables of steps, errors, voxels and
memory, light over frames, hard cases.
"""
from __future__ import annotations

import argparse
import sys
from pathlib import Path

import files
from report.page import page
from report.pictures import Album
from sweep import store

GIVEN = {"hard_cases": "the JSON of tools/hard_cases.py", "bench": "the JSON of vct bench: the thesis's tables",
         "presets": "the JSON of vct bench --preset thesis,mobile,quality",
         "motion": "the JSON of tools/motion.py: what the light does over frames"}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sweep", type=Path, default=Path("out/sweep/sweep.json"), help="default: %(default)s")
    for name, what in GIVEN.items():
        parser.add_argument(f"--{name.replace('_', '-')}", type=Path, help=what)
    parser.add_argument("--references", type=Path, default=files.ROOT / "references", help="default: references")
    parser.add_argument("--out", type=Path, default=Path("out/report/index.html"), help="default: %(default)s")
    parser.add_argument("--megabytes", type=float, default=13, help="of pictures at most (default: %(default)g)")
    options = parser.parse_args()
    given = {name: getattr(options, name) for name in GIVEN}
    for path in (options.sweep, *given.values()):
        if path is not None and not path.is_file():
            raise SystemExit(f"error: {path}: no such file")
    sweep = store.read(options.sweep)
    if not sweep["points"]:
        raise SystemExit(f"error: {options.sweep} has no points")
    album = Album(int(options.megabytes * 1e6))
    text = page(sweep, options.sweep.parent, options.references, album, given)
    files.write_whole(options.out, text)
    left_out = f", {album.refused} left out to stay below {options.megabytes:g} MB" if album.refused else ""
    print(f"report: {len(sweep['points'])} points, {album.kept} pictures{left_out}, {len(text) / 1e6:.1f} MB", file=sys.stderr)
    print(files.shown(options.out))


if __name__ == "__main__":
    main()
