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
from typing import Any

import program
from files import ROOT, shown, write_whole
from mali.bound import stage_cost
from mali.compiler import G57, HOW, T880, CompilerError, Gpu, Stage, compile_shaders
from mali.loops import LoopError
from mali.page import Preset, Program, StageOfFrame, page
from mali.varyings import passing_vertex_shader


def compiled(entry: dict[str, Any], folder: Path, compiler: Path, gpu: Gpu) -> dict[str, Stage]:
    """Of a manifest's program. A vertex shader before a geometry shader is left out: it cannot be linked."""
    files = {stage["stage"]: folder / stage["file"] for stage in entry["stages"]}
    geometry = files.pop("geometry", None)
    if geometry is None:
        return compile_shaders(compiler, gpu, list(files.values()))
    passing = geometry.with_name("passing.vert")
    passing.write_text(passing_vertex_shader(geometry.read_text()))
    stages = compile_shaders(compiler, gpu, [passing, files["fragment"]])
    return {"fragment": stages["fragment"]}


def frame(programs: list[Program], mode: str, counts: dict[str, Any], vertices: int) -> list[StageOfFrame]:
    """What a frame of a mode runs. Of several variants of one shader, whose counts are one, the costliest counts."""
    stages: dict[str, StageOfFrame] = {}
    for one in programs:
        if mode not in one.entry["modes"]:
            continue
        for source in one.entry["stages"]:
            stage = one.stages[T880].get(source["stage"])
            shader = source["shader"]
            if stage is None:
                continue
            if source["stage"] == "vertex":
                count = {"invocations": 3 if shader == "passes/full_screen.vert" else vertices, "loops": []}
            elif shader in counts:
                count = counts[shader]
            else:
                raise LoopError(f"{shader} runs in mode {mode} but was not counted: jni/lab/shader_counters.cpp")
            try:
                cost = stage_cost(stage, count["invocations"], count["loops"])
            except LoopError as why:
                raise LoopError(f"{one.title()}, {shader}, mode {mode}: {why}") from why
            key = shader if source["stage"] != "vertex" else f"{shader} {one.entry['name']}"
            if key not in stages or cost.bound_ms() > stages[key].cost.bound_ms():
                stages[key] = StageOfFrame(one, stage, cost, count["loops"])
    return list(stages.values())


def measured(manifest: dict[str, Any], folder: Path, compiler: Path) -> list[Preset]:
    presets = []
    for entry in manifest["presets"]:
        print(f"mali: {entry['name']}, {len(entry['programs'])} programs", file=sys.stderr, flush=True)
        programs = [Program(about, {gpu: compiled(about, folder, compiler, gpu) for gpu in (T880, G57)})
                    for about in entry["programs"]]
        frames = {mode: frame(programs, mode, counts, manifest["vertices"])
                  for mode, counts in entry["counts"].items()}
        presets.append(Preset(entry["name"], entry["grid"], programs, frames))
    return presets


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
