#!/usr/bin/env python3
"""Measures each known defect of the published implementation alone, with and without, and writes docs/defects.md.

Sweeps the experiments over some scenes (tools/sweep.py; A and B in turn), and renders variants of two scenes. Needs the
desktop build and the Python of scripts/python.sh.
"""
from __future__ import annotations

import argparse
import json
import subprocess
import sys
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parent))

import metrics  # noqa: E402
from study import tables, variants  # noqa: E402
from sweep import measures  # noqa: E402
from sweep.identity import ROOT, file_sha256, write_beside  # noqa: E402
from sweep.run import run  # noqa: E402
from sweep.settings import SETTINGS, Point  # noqa: E402

SCENES = "cornell,contact,corridor,thin_wall"
MODES = ("gi", "gi-cone-shadow", "ao")


def usual_settings(grid: int) -> dict[str, Any]:
    """Of a point that changes nothing."""
    return ({setting.name: setting.default[0] for setting in SETTINGS}
            | {"grid": grid, "cone_angle_deg": 5.0})


def swept(options: argparse.Namespace) -> dict[str, Any]:
    """The sweep of the experiments; points that are done are kept from an earlier run."""
    command = [sys.executable, str(ROOT / "tools/sweep.py"), "--scenes", SCENES, "--presets", "thesis",
               "--grids", str(options.grid), "--cone-angles", "5", "--experiments", ",".join(tables.TEXTS),
               "--modes", ",".join(MODES), "--out", str(options.out / "sweep"), "--program", str(options.program)]
    subprocess.run(command, check=True)
    return json.loads((options.out / "sweep/sweep.json").read_text())


def red_bias(options: argparse.Namespace, plain: Path) -> dict[str, float]:
    """How far the indirect light depends on which channel is called red. `plain`: folder of the unchanged scene."""
    scene = variants.edit_glb(ROOT / "assets/cornell.glb", options.out / "cornell_swapped.glb",
                              variants.swap_red_and_blue)
    run(Point(scene, usual_settings(options.grid), MODES), options.program, options.out / "swapped", 600)
    swapped = metrics.read_exr(options.out / "swapped/indirect_light.exr")[:, :, ::-1]
    image = metrics.read_exr(plain / "indirect_light.exr")
    channels = image.mean(axis=(0, 1)) / swapped.mean(axis=(0, 1)) - 1
    return {"relmse": metrics.relmse(image, swapped), **dict(zip(("red", "green", "blue"), map(float, channels)))}


def solid_objects(options: argparse.Namespace) -> dict[str, dict[str, Any]]:
    """The contact scene as it is and filled, judged against the same references."""
    found = {}
    for name, edit in (("hollow", lambda document: None), ("solid", variants.fill_objects)):
        scene = variants.edit_glb(ROOT / "assets/contact.glb", options.out / f"contact_{name}.glb", edit)
        folder = options.out / name
        entry = run(Point(scene, usual_settings(options.grid), MODES), options.program, folder, 600)
        # What is inside the objects is in no reference's way.
        entry |= {"scene": "contact", "scene_sha256": file_sha256(ROOT / "assets/contact.glb")}
        entry["errors"] = measures.errors(entry, folder, measures.References(ROOT / "references", "contact"))
        found[name] = entry
    return found


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--grid", type=int, default=256, help="voxels along a side (default: %(default)s)")
    parser.add_argument("--program", type=Path, default=ROOT / "build/desktop/vct", help="default: build/desktop/vct")
    parser.add_argument("--out", type=Path, default=ROOT / "out/defects", help="pictures and JSON (default: out/defects)")
    parser.add_argument("--page", type=Path, default=ROOT / "docs/defects.md", help="default: docs/defects.md")
    options = parser.parse_args()
    sweep = swept(options)
    plain = next(entry for entry in sweep["points"] if entry["scene"] == "cornell" and entry["status"] == "done"
                 and entry["settings"]["experiment"] == "none")
    print("defects: variants of scenes", file=sys.stderr, flush=True)
    red = red_bias(options, options.out / "sweep" / plain["folder"])
    solid = solid_objects(options)
    write_beside(options.page, tables.page(sweep, list(tables.TEXTS), red, solid))
    print(f"defects: {options.page}", file=sys.stderr)
    return 0


if __name__ == "__main__":
    sys.exit(main())
