"""Computes the time below which the GPU of a phone cannot draw a frame, for each preset, mode and pass, without a phone.

    tools/eval.py mali --compiler FILE [--gpu t880,g72,g52,g57,a630] [--size 960x540 --window 1920x1080] [--changes light]

Nothing runs on a phone. `vct shaders` writes the shaders of a phone (ESSL 3.10, mediump as 16 bits) and counts how often each stage
and each loop runs in a frame that rebuilds everything, or (--changes) in which only objects or only the light change. Mesa's
compiler counts the words of each pipe, such as A (arithmetic), LS (load/store) and T (texture) of a Mali-T880. The bound of a stage
on a Mali-T880 MP12 (12 cores at 850 MHz, each with 3 arithmetic pipes) is

    words of all invocations / 12 cores, max(A/3, LS, T) / 850 MHz

It is a lower bound of the shaders' work: no memory, no rasterizer, no waiting. On the other hand both sides of every branch
count, and fragments are counted before the depth test. The thesis's own program took 3.4 times its bound on the phone, so a frame
is expected between the bound and that.

Memory is given as a range, for the memory of a phone with this GPU at its full rate. The least is what fragments put out (8 bytes
for each target, 4 for depth), written once and read once. The most is that every fetch, load, store and atomic goes to memory for
32 bits. The limit is the larger one of shaders and memory; between the two, the share of the accesses that caches have to spare
is named. Writes OUT/bounds.md and OUT/bounds.json.
"""
import argparse
import json
import re
import tempfile
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import program
from files import ROOT, Failed, find_scene, read_json, write_whole
from tables import STEPS, markdown

from . import options
from .gpus import GPUS, Gpu
from .mali_compiler import HOW, Stage, compile_shaders, passing_vertex_shader
from .mali_loops import Loop, match_loops
from .progress import say
from .store import Result

PASSES = [step for step in STEPS if step != "total"] + ["present"]
HEADS = {**STEPS, "present": "present"}
FULL_SCREEN = "passes/full_screen.vert"
MEASURED_PER_BOUND = 3.4  # the thesis's cones: 533 ms, and a bound of 159 ms
CHANGES = ["everything", "objects", "light"]  # of `vct shaders`
VERSION = 1


@dataclass
class Cost:
    """Of all invocations of a stage in a frame."""
    step: str
    shader: str
    invocations: int
    bound_ms: float
    memory_ms: tuple[float, float]  # least and most
    pipe: str  # the busiest one
    registers: str
    spills: str


def words_of(stage: Stage, invocations: int, loops: Sequence[Loop]) -> Counter:
    """Words of all invocations of a stage in a frame. `loops`: those of its source, with iterations."""
    sources = match_loops(loops, [loop.depth for loop in stage.loops], invocations)
    instances = Counter(loops[source]["place"] for source in sources)  # calls of the loop's function that the compiler kept
    words = Counter({pipe: number * invocations for pipe, number in stage.outside.items()})
    for compiled, source in zip(stage.loops, sources):
        iterations = loops[source]["iterations"] / instances[loops[source]["place"]]
        words.update({pipe: number * iterations for pipe, number in compiled.words.items()})
    return words


def bound_ms(words: Counter, gpu: Gpu) -> tuple[float, str]:
    """Milliseconds, and the pipe that takes them."""
    cycles, pipe = max((words[pipe] / rate, pipe) for pipe, rate in gpu.per_cycle.items())
    return cycles / gpu.cores / gpu.clock_hz * 1e3, pipe


def memory_ms(words: Counter, gpu: Gpu, written: float) -> tuple[float, float]:
    """Milliseconds of memory at least and at most. `written`: bytes that fragments put out."""
    accesses = 4 * (words[gpu.texture] + words[gpu.access])
    return 2 * written / gpu.bytes_per_s * 1e3, (written + max(accesses, written)) / gpu.bytes_per_s * 1e3


def limit(bound: float, least: float, most: float) -> str:
    if most <= bound:
        return "shaders"
    if least >= bound:
        return "memory"
    return f"shaders, if caches spare {(most - bound) / (most - least):.0%} of the accesses".replace("%", " %")


def output_bytes(source: str) -> int:
    """At most, of a fragment: targets of half floats, and depth."""
    return 8 * len(re.findall(r"^layout\(location = \d+\) out ", source, re.MULTILINE)) + 4


def compiled(entry: dict[str, Any], folder: Path, compiler: Path, gpu: Gpu) -> dict[str, Stage]:
    """The stages of one program of the manifest. A vertex shader before a geometry shader is left out."""
    shaders = {stage["stage"]: folder / stage["file"] for stage in entry["stages"]}
    geometry = shaders.pop("geometry", None)
    if geometry is None:
        return compile_shaders(compiler, gpu, list(shaders.values()))
    passing = geometry.with_name("passing.vert")
    passing.write_text(passing_vertex_shader(geometry.read_text()))
    return {"fragment": compile_shaders(compiler, gpu, [passing, shaders["fragment"]])["fragment"]}


def cost(stage: Stage, gpu: Gpu, count: dict[str, Any], step: str, shader: str, outputs: int) -> Cost:
    words = words_of(stage, count["invocations"], count["loops"])
    milliseconds, pipe = bound_ms(words, gpu)
    return Cost(step, shader, count["invocations"], milliseconds, memory_ms(words, gpu, outputs * count["invocations"]), pipe,
                stage.registers, stage.spills)


def frame(programs: list[tuple[dict[str, Any], dict[str, Stage]]], gpu: Gpu, mode: str, vertices: int, folder: Path) -> list[Cost]:
    """The stages of a frame of a mode."""
    stages = []
    for entry, found in programs:
        for source in entry["stages"] if mode in entry["modes"] else []:
            name, shader = source["stage"], source["shader"]
            if name not in found:
                continue
            if name == "vertex":
                count = {"invocations": 3 if shader == FULL_SCREEN else vertices, "loops": []}
            else:
                count = entry["counts"][mode]
            outputs = output_bytes((folder / source["file"]).read_text()) if name == "fragment" else 0
            try:
                stages.append(cost(found[name], gpu, count, entry["pass"], shader, outputs))
            except Failed as why:
                raise Failed(f"{entry['name']}, {shader}, mode {mode}: {why}") from None
    return stages


def presenting(compiler: Path, gpu: Gpu, preamble: str, folder: Path, size: tuple[int, int], window: tuple[int, int]) -> list[Cost]:
    """The passes that show a frame in the app's window (jni/app/presenter.h)."""
    def resolved(path: str) -> str:
        return re.sub(r'^#include "(.*)"$', lambda found: resolved(found[1]), (ROOT / "shaders" / path).read_text(), flags=re.MULTILINE)
    costs = []
    for name, pixels in {"tone_map": size, "smooth": size, "scale": window}.items():
        shaders = [folder / "full_screen.vert", folder / f"{name}.frag"]
        for shader, path in zip(shaders, ["passes/full_screen.vert", f"app/{name}.frag"]):
            shader.write_text(preamble + resolved(path))
        stage = compile_shaders(compiler, gpu, shaders)["fragment"]
        # The targets have 8 bits per channel.
        costs.append(cost(stage, gpu, {"invocations": pixels[0] * pixels[1], "loops": []}, "present", f"app/{name}.frag", 4))
    return costs


def bounds(compiler: Path, scene: Path, changes: str, size: tuple[int, int], window: tuple[int, int] | None,
           presets: Sequence[str], gpus: Sequence[str]) -> Result:
    """`changes`: of `vct shaders`. `gpus`: GPU -> preset -> mode -> stages, and `presets`: preset -> mode -> pass -> milliseconds of the
    Mali-T880, of frames in which everything changes."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        program.run("shaders", scene, "--out", folder, "--size", f"{size[0]}x{size[1]}", "--preset", ",".join(presets),
                    "--changes", changes)
        manifest = json.loads((folder / "manifest.json").read_text())
        found: dict[str, Any] = {}
        for gpu in gpus:
            for entry in manifest["presets"]:
                used = entry["programs"]
                say(f"{gpu}: {entry['name']}, {len(used)} programs")
                programs = [(one, compiled(one, folder, compiler, GPUS[gpu])) for one in used]
                source = (folder / next(stage["file"] for stage in used[-1]["stages"] if stage["stage"] != "compute")).read_text()
                shown = presenting(compiler, GPUS[gpu], source[:source.index("#line")], folder, size, window) if window else []
                modes = dict.fromkeys(mode for one in used for mode in one["modes"])
                found.setdefault(gpu, {})[entry["name"]] = {
                    mode: [vars(one) for one in frame(programs, GPUS[gpu], mode, manifest["vertices"], folder) + shown]
                    for mode in modes}
    presets_of = {preset: {mode: by_pass(stages, "bound_ms") for mode, stages in modes.items()}
                  for preset, modes in found.get("t880", {}).items() if changes == CHANGES[0]}
    return {"scene": scene.name, "changes": changes, "size": list(size), "window": list(window or size), "presets": presets_of,
            "gpus": found}


def by_pass(stages: Sequence[dict[str, Any]], key: str) -> dict[str, float]:
    return {name: sum(stage[key] for stage in stages if stage["step"] == name) for name in PASSES
            if name != "present" or any(stage["step"] == name for stage in stages)}


def table(result: Result, gpu: str) -> str:
    rows = []
    for preset, modes in result["gpus"][gpu].items():
        for mode, stages in modes.items():
            ms = by_pass(stages, "bound_ms")
            least, most = (sum(stage["memory_ms"][end] for stage in stages) for end in (0, 1))
            whole = sum(ms.values())
            moving = ms["render_data"] + ms["trace"] + ms.get("present", 0)
            rows.append([f"{preset}, {mode}", *(f"{ms[name]:.2g}" for name in ms), f"{moving:.2g}",
                         f"{whole:.2g} to {MEASURED_PER_BOUND * whole:.2g}", f"{least:.2g} to {most:.2g}",
                         limit(whole, least, most)])
    names = [HEADS[name] for name in ms]
    width, height = result["window"]
    return (f"{result['scene']}, {result['size'][0]}x{result['size'][1]} in a window of {width}x{height}: milliseconds below which a "
            f"{GPUS[gpu].name} cannot draw\n\n"
            + markdown(["preset, mode", *names, "camera moving", f"{result['changes']} changing", "memory", "limit"], rows))


def stage_table(stages: Sequence[dict[str, Any]], of: str) -> str:
    rows = [[stage["shader"], STEPS.get(stage["step"], stage["step"]), f"{stage['invocations']:,}", stage["registers"] or "–",
             stage["spills"] or "–", stage["pipe"], f"{stage['bound_ms']:.2g}", "{:.2g} to {:.2g}".format(*stage["memory_ms"])]
            for stage in sorted(stages, key=lambda stage: -stage["bound_ms"]) if stage["bound_ms"] >= 0.01]
    return f"{of}\n\n" + markdown(["shader", "pass", "invocations", "registers or threads", "spills:fills", "busiest pipe", "ms",
                                    "memory, ms"], rows)


def bounds_of_this_build(path: Path) -> dict[str, Any]:
    """The presets of a bounds.json; none where there is no such file, or where it is of another build of vct."""
    found = read_json(path, "presets", VERSION) if path.is_file() else {"build": ""}
    return found["presets"] if found["build"] == program.build_sha256() else {}


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.epilog = HOW
    parser.add_argument("--compiler", type=Path, required=True, metavar="FILE", help="Mesa's compiler for phones; see below")
    parser.add_argument("--gpu", type=options.names(GPUS, "GPU"), default=["t880"], metavar="LIST",
                        help=f"{', '.join(GPUS)}, separated by commas (default: t880)")
    parser.add_argument("--preset", type=options.names(options.PRESETS, "preset"), default=options.PRESETS, metavar="LIST",
                        help="presets, separated by commas (default: all)")
    parser.add_argument("--scene", default="cornell", help="a file, or a name in assets/ (default: cornell)")
    parser.add_argument("--changes", choices=CHANGES, default=CHANGES[0],
                        help="what changes in the frame; objects needs a scene with an animation (default: everything)")
    parser.add_argument("--size", type=options.size, default=(400, 400), help="WIDTHxHEIGHT (default: 400x400)")
    parser.add_argument("--window", type=options.size, help="WIDTHxHEIGHT of the app's window; adds the passes that show a frame")
    parser.add_argument("--out", type=Path, default=ROOT / "out/mali", help="folder (default: out/mali)")


def run(asked: argparse.Namespace) -> int:
    if not asked.compiler.is_file():
        raise Failed(f"there is no compiler {asked.compiler}\n{HOW}")
    result = bounds(asked.compiler, find_scene(asked.scene), asked.changes, asked.size, asked.window, asked.preset, asked.gpu)
    explanation = "\n".join(__doc__.split("\n\n", 2)[2].splitlines()[:-1])
    stored = {"version": VERSION, "build": program.build_sha256(), **result}
    tables = "\n".join(table(result, gpu) for gpu in asked.gpu)
    stages = "\n".join(stage_table(modes[mode], f"{GPUS[gpu].name}, {preset}, {mode}") for gpu, presets in result["gpus"].items()
                       for preset, modes in presets.items() for mode in list(modes)[-1:])
    write_whole(asked.out / "bounds.json", json.dumps(stored, indent=1) + "\n")
    write_whole(asked.out / "bounds.md", f"# Bounds for phones\n\n{tables}\n{explanation}\n\n{stages}\n")
    print(tables, end="")
    say(f"wrote {asked.out}/bounds.md and bounds.json")
    return 0
