#!/usr/bin/env python3
"""Writes the scenes in assets/. Standard library only; the bytes are the same on every machine.

    python3 tools/make_assets.py [--out DIR]
"""
import argparse
import pathlib
import sys

sys.dont_write_bytecode = True  # a test runs this inside the source tree

from scenes import cornell, courtyard  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parent.parent


def main():
    parser = argparse.ArgumentParser(description="Write the scenes in assets/.")
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "assets", help="folder (default: assets)")
    out = parser.parse_args().out
    out.mkdir(parents=True, exist_ok=True)
    for name, scene in (("cornell.glb", cornell.build()), ("courtyard.glb", courtyard.build())):
        data = scene.to_bytes()
        (out / name).write_bytes(data)
        print(f"{out / name}: {len(data)} bytes, {scene.triangle_count()} triangles")


if __name__ == "__main__":
    main()
