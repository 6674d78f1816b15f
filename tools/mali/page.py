"""docs/mali.md out of what the compiler and the counting frames gave."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from mali.bound import CLOCK_HZ, CORES, Cost
from mali.compiler import G57, T880, Gpu, Stage
from mali.loops import match_loops
from tables import markdown

PASSES = {"shadow_map": "shadow map", "render_data": "G-buffer", "voxelize": "voxelize", "mipmap": "mipmap",
          "inject": "inject", "irradiance": "irradiance", "trace": "trace"}
MODES = ("ao", "gi", "gi-cone-shadow")

# C. Wahlén's published shaders through the same compiler, at 256^3 and 400x400: words per step, and the iterations that
# the thesis's cones make where nothing stops them.
PUBLISHED_A = {"diffuse step": 100, "shadow step": 191}
PUBLISHED_TRIPS = {"diffuse step": 6 * 7, "shadow step": 137}
PUBLISHED_MEASURED_MS = {"shadow_map": 1.93, "render_data": 2.53, "voxelize": 301.0, "mipmap": 17.5, "trace": 533.0}

INTRODUCTION = """\
# What the shaders cost on a Mali, without a phone

Made by `tools/mali.py` with Mesa's panfrost compiler; do not edit by hand. Nothing is run on a Mali: the compiler counts
the words of each pipe, `vct shaders` counts how often each stage and each loop runs in a frame of {scene} at
{width}x{height}, and both give the time below which no Mali-T880 MP12 (the thesis's phone: {cores} cores at {mhz:.0f} MHz,
each with 3 arithmetic pipes, 1 load/store and 1 texture pipe) can draw it:

    words of all invocations / {cores} cores, max(A/3, LS, T) / {mhz:.0f} MHz

It is a lower bound of the shader's work alone: no memory, no rasterizer, no waiting; a pipe that is never idle. On the
other hand both sides of every branch count as run, also loops that the compiler unrolled inside one. `T x2` is the bound
if every texture fetch took two cycles, as those of 3D textures may. Fragments are counted before the depth test. Sources
are those of a phone: ESSL 3.10, mediump as 16 bits. It is Mesa's compiler, not Arm's.
"""


def published_bound_ms(pixels: int = 400 * 400) -> float:
    words = sum(PUBLISHED_A[step] * PUBLISHED_TRIPS[step] for step in PUBLISHED_A)
    return Cost(pixels, {"A": words * pixels, "LS": 0, "T": 0}).bound_ms()


@dataclass
class Program:
    """One variant: a manifest's entry and what each GPU's compiler says of its stages."""

    entry: dict[str, Any]
    stages: dict[Gpu, dict[str, Stage]]

    def title(self) -> str:
        # Those with a value are the preset's constants, or the mode in the name.
        defines = [define.removeprefix("VCT_").lower().replace("_", " ") for define in self.entry["defines"]
                   if " " not in define]
        return self.entry["name"] + (f" ({', '.join(defines)})" if defines else "")


@dataclass
class StageOfFrame:
    program: Program
    stage: Stage
    cost: Cost
    loops: list[dict[str, Any]]  # of the source, with iterations


@dataclass
class Preset:
    name: str
    grid: int
    programs: list[Program]
    frames: dict[str, list[StageOfFrame]]  # per mode, T880


def number(value: float) -> str:
    return f"{value:,.0f}" if value >= 100 else f"{value:.3g}"


def of_pass(stages: list[StageOfFrame], name: str, texture_cycles: int = 1) -> float:
    return sum(s.cost.bound_ms(texture_cycles) for s in stages if s.program.entry["pass"] == name)


def bounds(presets: list[Preset], mode: str) -> str:
    """A row per preset, a column per pass."""
    rows = []
    if mode == "gi-cone-shadow":
        trace = published_bound_ms()
        rows.append(["published program, 256³: bound of its cones' arithmetic", *[""] * (len(PASSES) - 1), number(trace)])
        rows.append(["published program, 256³: measured on the phone",
                     *(number(PUBLISHED_MEASURED_MS[name]) if name in PUBLISHED_MEASURED_MS else "" for name in PASSES)])
    for preset in presets:
        stages = preset.frames[mode]
        rows.append([f"`{preset.name}`, {preset.grid}³: bound", *(number(of_pass(stages, name)) for name in PASSES)])
        rows.append([f"`{preset.name}`, {preset.grid}³: T x2", *(number(of_pass(stages, name, 2)) for name in PASSES)])
    return f"## Mode `{mode}`: bound in ms per pass, T880\n\n" + markdown(["", *PASSES.values()], rows)


def stage_rows(preset: Preset, mode: str) -> list[list[str]]:
    rows = []
    for s in preset.frames[mode]:
        cost = s.cost
        rows.append([s.program.title(), s.stage.name, f"{cost.invocations:,}",
                     *(number(cost.per_invocation(pipe)) for pipe in T880.pipes), cost.bottleneck(),
                     number(cost.bound_ms()), str(s.stage.registers), f"{s.stage.spills}:{s.stage.fills}"])
    return rows


def loop_rows(preset: Preset) -> list[list[str]]:
    """Each loop that the compiler left, in the mode that runs the most of them."""
    rows = []
    for s in preset.frames["gi-cone-shadow"]:
        which = match_loops(s.loops, [loop.depth for loop in s.stage.loops])
        for compiled, source in zip(s.stage.loops, which):
            loop = s.loops[source]
            rows.append([s.program.title(), ("in it: " if loop["depth"] else "") + loop["name"],
                         *(str(compiled.words[pipe]) for pipe in T880.pipes), f"{loop['iterations']:,.0f}",
                         number(loop["iterations"] / s.cost.invocations), *published(loop["name"])])
        for index, loop in enumerate(s.loops):
            if index not in which:
                rows.append([s.program.title(), loop["name"], "unrolled", "", "", f"{loop['iterations']:,.0f}",
                             number(loop["iterations"] / s.cost.invocations), *published(loop["name"])])
    return rows


def published(loop: str) -> list[str]:
    return [str(PUBLISHED_A.get(loop, "")), str(PUBLISHED_TRIPS.get(loop, ""))]


def words(stage: Stage, gpu: Gpu) -> str:
    """Outside loops, then per iteration of each."""
    parts = [stage.outside, *(loop.words for loop in stage.loops)]
    return " + ".join("/".join(str(part[pipe]) for pipe in gpu.pipes) for part in parts)


def variant_rows(preset: Preset) -> list[list[str]]:
    rows = []
    for program in preset.programs:
        for name in ("fragment", "compute"):
            if name not in program.stages[T880]:
                continue
            t880, g57 = program.stages[T880][name], program.stages[G57][name]
            rows.append([program.title(), words(t880, T880), str(t880.registers), str(t880.threads),
                         f"{t880.spills}:{t880.fills}", words(g57, G57), str(g57.threads),
                         f"{g57.spills}:{g57.fills}"])
    return rows


def page(manifest: dict[str, Any], presets: list[Preset]) -> str:
    parts = [INTRODUCTION.format(scene=manifest["scene"], width=manifest["width"], height=manifest["height"],
                                 cores=CORES, mhz=CLOCK_HZ / 1e6)]
    parts += [bounds(presets, mode) for mode in reversed(MODES)]
    for preset in presets:
        head = ["program", "stage", "invocations", "A", "LS", "T", "most", "bound ms", "registers", "spills:fills"]
        parts.append(f"## Preset `{preset.name}`, mode `gi-cone-shadow`: words per invocation, loops included\n\n" +
                     markdown(head, stage_rows(preset, "gi-cone-shadow")))
        head = ["program", "loop", "A", "LS", "T", "iterations in the frame", "per invocation", "published: A", "iterations"]
        parts.append("Its loops, words per iteration without those of the loops inside:\n\n" +
                     markdown(head, loop_rows(preset)))
        head = ["program", "T880: A/LS/T", "registers", "threads of 4", "spills:fills",
                "G57: " + "/".join(G57.pipes).upper(), "threads of 2", "spills:fills"]
        parts.append(f"### Every variant of `{preset.name}`, fragment and compute stages\n\n"
                     "Words (T880) and instructions (G57) outside loops + per iteration of each loop.\n\n" +
                     markdown(head, variant_rows(preset)))
    return "\n".join(parts)
