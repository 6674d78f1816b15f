#!/usr/bin/env python3
"""What every shader of every preset costs on Arm Mali, without a phone, into docs/mali.md.

`vct shaders` writes the sources and counts how often they run; the panfrost compiler (--compiler) counts the words of
each pipe; both give a bound in ms per pass for a Mali-T880 MP12.
"""
from __future__ import annotations

import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import program
from files import ROOT, shown, write_whole
from mali.compiler import HOW, CompilerError
from mali.frames import measured
from mali.loops import LoopError
from mali.page import page


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter,
                                     epilog=HOW)
    parser.add_argument("--compiler", type=Path, required=True, help="the panfrost compiler's command; see below")
    parser.add_argument("--scene", type=Path, default=ROOT / "assets/cornell.glb", help="default: assets/cornell.glb")
    parser.add_argument("--size", default="400x400", help="picture (default: %(default)s)")
    program.add_option(parser)
    parser.add_argument("--page", type=Path, default=ROOT / "docs/mali.md", help="default: docs/mali.md")
    options = parser.parse_args()
    try:
        if not options.compiler.is_file():
            raise CompilerError(f"--compiler {options.compiler}: no such file\n{HOW}")
        program.require(options.program)
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            subprocess.run([str(options.program), "shaders", str(options.scene), "--out", name, "--size", options.size],
                           check=True)
            manifest = json.loads((folder / "manifest.json").read_text())
            presets = measured(manifest, folder, options.compiler)
    except subprocess.CalledProcessError as why:
        print("error: vct shaders failed, see above", file=sys.stderr)
        return why.returncode
    except (CompilerError, LoopError) as why:
        print(f"error: {why}", file=sys.stderr)
        return 1
    write_whole(options.page, page(manifest, presets))
    print(shown(options.page))
    return 0


if __name__ == "__main__":
    sys.exit(main())
