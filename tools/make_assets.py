#!/usr/bin/env python3
"""Writes the scenes in assets/ and their skies. Needs only Python; the bytes are the same on every machine.

    python3 tools/make_assets.py [--out DIR]
"""
import argparse
import pathlib
import sys

sys.dont_write_bytecode = True  # a test runs this program inside the source tree

from scenes import (contact, cornell, corridor, courtyard, dim_room, furnace, glossy, lamp, lone_plane,  # noqa: E402
                    moving, night, patio, studio, thin_wall, town, walker)

MODULES = (contact, cornell, corridor, courtyard, dim_room, furnace, glossy, lamp, lone_plane, moving, night, patio, studio,
           thin_wall, town, walker)
SCENES = {module.__name__.removeprefix("scenes."): module.build for module in MODULES}
SCENES |= {"cornell_10km": lambda: cornell.build(5000.0), "cornell_1mm": lambda: cornell.build(0.0005)}
SKIES = {"patio": patio.sky, "town": town.sky}  # the sky of the scene of that name
ROOT = pathlib.Path(__file__).resolve().parent.parent


def main():
    parser = argparse.ArgumentParser(description="Write the scenes in assets/.")
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "assets", help="folder (default: assets)")
    out = parser.parse_args().out
    out.mkdir(parents=True, exist_ok=True)
    for name, build in SCENES.items():
        scene = build()
        data = scene.to_bytes()
        path = out / f"{name}.glb"
        path.write_bytes(data)
        print(f"{path}: {len(data)} bytes, {scene.triangle_count()} triangles")
    for name, build in SKIES.items():
        path = out / f"{name}.hdr"
        path.write_bytes(build())
        print(f"{path}: {path.stat().st_size} bytes")


if __name__ == "__main__":
    main()
