#!/usr/bin/env python3
"""One self-contained HTML page from a sweep: opens from disk, asks for nothing from outside.

Time against error per scene, tables, pictures beside references and errors, voxels and memory, light over frames, hard
cases.
"""
from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path

import files
from report.page_data import page_data
from report.pictures import Album
from sweep import store

PAGE = Path(__file__).resolve().parent / "report" / "page"
SCRIPTS = ("base.js", "summary.js", "plots.js", "viewer.js", "tables.js", "motion.js", "hard.js")


def arguments() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sweep", type=Path, default=Path("out/sweep/sweep.json"), help="default: %(default)s")
    parser.add_argument("--hard-cases", type=Path, help="the JSON of tools/hard_cases.py")
    parser.add_argument("--bench", type=Path, help="the JSON of vct bench: the thesis's tables")
    parser.add_argument("--presets", type=Path, help="the JSON of vct bench --preset thesis,mobile,quality")
    parser.add_argument("--motion", type=Path, help="the JSON of tools/motion.py: what the light does over frames")
    parser.add_argument("--references", type=Path, default=files.ROOT / "references", help="default: references")
    parser.add_argument("--out", type=Path, default=Path("out/report/index.html"), help="default: %(default)s")
    parser.add_argument("--megabytes", type=float, default=13, help="of pictures at most (default: %(default)g)")
    return parser


def build_page(data: dict) -> str:
    """The template with style, scripts and data in it."""
    page = (PAGE / "page.html").read_text()
    parts = {"/*STYLE*/": (PAGE / "style.css").read_text(),
             "/*SCRIPTS*/": "\n".join((PAGE / script).read_text() for script in SCRIPTS),
             # "</script>" inside the data would end it.
             "/*DATA*/": json.dumps(data, separators=(",", ":"), allow_nan=False).replace("<", "\\u003c")}
    for mark, text in parts.items():
        page = page.replace(mark, text, 1)
    return page


def main() -> int:
    options = arguments().parse_args()
    for path in (options.sweep, options.hard_cases, options.bench, options.presets, options.motion):
        if path is not None and not path.is_file():
            raise SystemExit(f"error: {path}: no such file")
    sweep = store.read(options.sweep)
    if not sweep["points"]:
        raise SystemExit(f"error: {options.sweep} has no points")
    album = Album(int(options.megabytes * 1e6))
    data = page_data(sweep, options.sweep.parent, options.references, options.hard_cases, options.bench, options.presets,
                     options.motion, album)
    page = build_page(data)
    files.write_whole(options.out, page)
    left_out = f", {album.refused} left out to stay below {options.megabytes:g} MB" if album.refused else ""
    print(f"report: {len(data['points'])} points, {len(album.pictures)} pictures{left_out}, {len(page) / 1e6:.1f} MB",
          file=sys.stderr)
    print(files.shown(options.out))
    return 0


if __name__ == "__main__":
    sys.exit(main())
