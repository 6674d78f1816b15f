"""Computes the time below which a Mali-T880 cannot draw a frame, for each preset, mode and pass, without a phone.

    tools/eval.py mali --compiler FILE

Nothing runs on a Mali. `vct shaders` writes the shaders of a phone (ESSL 3.10, mediump as 16 bits) and counts how often each stage
and each loop runs in a frame that rebuilds everything. Mesa's compiler counts the words of each pipe: A (arithmetic), LS
(load/store) and T (texture). The bound of a stage on a Mali-T880 MP12 (12 cores at 850 MHz, each with 3 arithmetic pipes) is

    words of all invocations / 12 cores, max(A/3, LS, T) / 850 MHz

It is a lower bound of the shaders' work: no memory, no rasterizer, no waiting. On the other hand both sides of every branch
count, and fragments are counted before the depth test. Writes OUT/bounds.md and OUT/bounds.json.
"""
import argparse
import json
import tempfile
from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import program
from files import ROOT, Failed, find_scene, read_json, write_whole
from tables import STEPS, markdown

from . import options
from .mali_compiler import HOW, PIPES, Stage, compile_shaders, passing_vertex_shader
from .mali_loops import Loop, match_loops
from .progress import say
from .store import Result

CORES, CLOCK_HZ, ARITHMETIC_PIPES = 12, 850e6, 3
PASSES = [step for step in STEPS if step != "total"]
FULL_SCREEN = "passes/full_screen.vert"
VERSION = 1


def words_of(stage: Stage, invocations: int, loops: Sequence[Loop]) -> Counter:
    """Words of all invocations of a stage in a frame. `loops`: those of its source, with iterations."""
    sources = match_loops(loops, [loop.depth for loop in stage.loops])
    instances = Counter(sources)
    words = Counter({pipe: number * invocations for pipe, number in stage.outside.items()})
    for compiled, source in zip(stage.loops, sources):
        iterations = loops[source]["iterations"] / instances[source]
        words.update({pipe: number * iterations for pipe, number in compiled.words.items()})
    return words


def bound_ms(words: Counter) -> float:
    cycles = max(words[pipe] / (ARITHMETIC_PIPES if pipe == "A" else 1) for pipe in PIPES)
    return cycles / CORES / CLOCK_HZ * 1e3


def compiled(entry: dict[str, Any], folder: Path, compiler: Path) -> dict[str, Stage]:
    """The stages of one program of the manifest. A vertex shader before a geometry shader is left out."""
    shaders = {stage["stage"]: folder / stage["file"] for stage in entry["stages"]}
    geometry = shaders.pop("geometry", None)
    if geometry is None:
        return compile_shaders(compiler, list(shaders.values()))
    passing = geometry.with_name("passing.vert")
    passing.write_text(passing_vertex_shader(geometry.read_text()))
    return {"fragment": compile_shaders(compiler, [passing, shaders["fragment"]])["fragment"]}


def frame(programs: list[tuple[dict[str, Any], dict[str, Stage]]], mode: str, counts: dict[str, Any],
          vertices: int) -> dict[str, float]:
    """Milliseconds of each pass in a frame of a mode. Variants of one shader have one count, and the costliest variant counts."""
    stages: dict[str, tuple[str, float]] = {}
    for entry, found in programs:
        for source in entry["stages"] if mode in entry["modes"] else []:
            name, shader = source["stage"], source["shader"]
            if name not in found:
                continue
            if name == "vertex":
                count = {"invocations": 3 if shader == FULL_SCREEN else vertices, "loops": []}
            elif shader in counts:
                count = counts[shader]
            else:
                raise Failed(f"{shader} runs in mode {mode} but was not counted: jni/lab/shader_counters.cpp")
            try:
                bound = bound_ms(words_of(found[name], count["invocations"], count["loops"]))
            except Failed as why:
                raise Failed(f"{entry['name']}, {shader}, mode {mode}: {why}") from None
            key = f"{shader} {entry['name']}" if name == "vertex" else shader
            if key not in stages or bound > stages[key][1]:
                stages[key] = entry["pass"], bound
    return {name: sum(bound for of, bound in stages.values() if of == name) for name in PASSES}


def bounds(compiler: Path, scene: Path, size: tuple[int, int], presets: Sequence[str]) -> Result:
    """`presets`: preset -> mode -> pass -> milliseconds."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        program.run("shaders", scene, "--out", folder, "--size", f"{size[0]}x{size[1]}", "--preset", ",".join(presets))
        manifest = json.loads((folder / "manifest.json").read_text())
        found = {}
        for entry in manifest["presets"]:
            used = [one for one in entry["programs"] if one["modes"]]  # the compiler fails at a variant that other scenes need
            say(f"mali: {entry['name']}, {len(used)} programs")
            programs = [(one, compiled(one, folder, compiler)) for one in used]
            found[entry["name"]] = {mode: frame(programs, mode, counts, manifest["vertices"])
                                    for mode, counts in entry["counts"].items()}
    return {"scene": scene.name, "size": list(size), "presets": found}


def table(result: Result) -> str:
    rows = [[f"{preset}, {mode}", *(f"{milliseconds:.2g}" for milliseconds in (
        *(ms[name] for name in PASSES), ms["render_data"] + ms["trace"], sum(ms.values())))]
            for preset, modes in result["presets"].items() for mode, ms in modes.items()]
    return (f"{result['scene']}, {result['size'][0]}x{result['size'][1]}: milliseconds below which a Mali-T880 cannot draw\n\n"
            + markdown(["preset, mode", *(STEPS[name] for name in PASSES), "camera moving", "everything changing"], rows))


def bounds_of_this_build(path: Path) -> dict[str, Any]:
    """The presets of a bounds.json; none where there is no such file, or where it is of another build of vct."""
    found = read_json(path, presets=VERSION) if path.is_file() else {"build": ""}
    return found["presets"] if found["build"] == program.build_sha256() else {}


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.epilog = HOW
    parser.add_argument("--compiler", type=Path, required=True, metavar="FILE", help="Mesa's compiler for Mali; see below")
    parser.add_argument("--scene", default="cornell", help="a file, or a name in assets/ (default: cornell)")
    parser.add_argument("--size", type=options.size, default=(400, 400), help="WIDTHxHEIGHT (default: 400x400)")
    parser.add_argument("--out", type=Path, default=ROOT / "out/mali", help="folder (default: out/mali)")


def run(asked: argparse.Namespace) -> int:
    if not asked.compiler.is_file():
        raise Failed(f"there is no compiler {asked.compiler}\n{HOW}")
    result = bounds(asked.compiler, find_scene(asked.scene), asked.size, options.PRESETS)
    explanation = "\n".join(__doc__.split("\n\n", 2)[2].splitlines()[:-2])
    stored = {"version": VERSION, "build": program.build_sha256(), **result}
    write_whole(asked.out / "bounds.json", json.dumps(stored, indent=1) + "\n")
    write_whole(asked.out / "bounds.md", f"# Bounds for a Mali-T880\n\n{table(result)}\n{explanation}\n")
    print(table(result), end="")
    say(f"wrote {asked.out}/bounds.md and bounds.json")
    return 0
