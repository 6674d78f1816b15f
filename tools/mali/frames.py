"""What the compiler says of each stage of a manifest of `vct shaders`, and what a frame runs of them."""
from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

from mali.bound import stage_cost
from mali.compiler import G57, T880, Gpu, Stage, compile_shaders
from mali.loops import LoopError
from mali.page import PASSES, Preset, Program, StageOfFrame, of_pass
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
    """Every program of a manifest, and the frames of all modes."""
    presets = []
    for entry in manifest["presets"]:
        print(f"mali: {entry['name']}, {len(entry['programs'])} programs", file=sys.stderr, flush=True)
        programs = [Program(about, {gpu: compiled(about, folder, compiler, gpu) for gpu in (T880, G57)})
                    for about in entry["programs"]]
        frames = {mode: frame(programs, mode, counts, manifest["vertices"])
                  for mode, counts in entry["counts"].items()}
        presets.append(Preset(entry["name"], entry["grid"], programs, frames))
    return presets


def bounds_ms(manifest: dict[str, Any], folder: Path, compiler: Path, mode: str) -> dict[str, dict[str, float]]:
    """By preset and pass, below which time no Mali-T880 draws a frame of one mode."""
    bounds = {}
    for entry in manifest["presets"]:
        run = [about for about in entry["programs"] if mode in about["modes"]]
        print(f"mali: {entry['name']}, {len(run)} programs", file=sys.stderr, flush=True)
        stages = frame([Program(about, {T880: compiled(about, folder, compiler, T880)}) for about in run], mode,
                       entry["counts"][mode], manifest["vertices"])
        bounds[entry["name"]] = {name: of_pass(stages, name) for name in PASSES}
    return bounds
