"""Runs the panfrost compiler over GLSL ES files and reads its counts."""
from __future__ import annotations

import re
import subprocess
from dataclasses import dataclass, field
from pathlib import Path

HOW = """\
--compiler names a program that compiles GLSL ES for Mali without a phone: Mesa's panfrost driver built with
-Dtools=panfrost,drm-shim, loaded over its no-op kernel driver (libpanfrost_noop_drm_shim.so) with PAN_GPU_ID, and run
with MIDGARD_MESA_DEBUG=shaderdb and BIFROST_MESA_DEBUG=shaderdb. Called as `COMPILER GPU a.vert b.frag` (GPU: 880, 9093)
it links the shaders and prints Mesa's SHADER-DB line of each stage, followed by the words of each pipe outside loops and,
for each loop, per iteration."""


class CompilerError(Exception):
    """Says which shader or which compiler, and why."""


@dataclass(frozen=True)
class Gpu:
    name: str
    number: int
    pipes: tuple[str, ...]  # as the compiler names them


T880 = Gpu("Mali-T880", 880, ("A", "LS", "T"))
G57 = Gpu("Mali-G57", 9093, ("fma", "cvt", "sfu", "v", "ls", "t"))

Words = dict[str, int]


@dataclass
class Loop:
    depth: int
    words: Words  # per iteration, those of the loops inside not among them
    head: str = ""  # the block that it begins with
    inside: tuple[str, ...] = ()  # the heads of all loops inside


@dataclass
class Stage:
    name: str  # "fragment"
    registers: int | None  # None where the compiler does not say (G57)
    threads: int  # of 4 (T880) or 2 (G57): how full the core can be
    spills: int
    fills: int
    outside: Words = field(default_factory=dict)  # per invocation
    loops: list[Loop] = field(default_factory=list)  # a nested one after the one around it


def _words(text: str, gpu: Gpu) -> Words:
    found = {key: int(value) for key, value in re.findall(r"(\w+)=(\d+)", text)}
    return {pipe: found.get(pipe, 0) for pipe in gpu.pipes}


def _fold_write_out(stage: Stage, declared: int, bundles: int) -> None:
    """Midgard writes several colour targets by jumps backwards, which look like loops and run once.

    Those of three and more targets overlap: their words are then the same ones.
    """
    folded = []
    while len(stage.loops) > declared:
        top = max(index for index, loop in enumerate(stage.loops) if loop.depth == 0)
        jump = stage.loops.pop(top)
        folded.append(jump.words)
        for loop in stage.loops:
            loop.depth -= loop.head in jump.inside
    elsewhere = [stage.outside, *(loop.words for loop in stage.loops)]
    for once in (folded, folded[:1]):
        if sum(sum(words.values()) for words in [*elsewhere, *once]) == bundles:
            stage.outside = {pipe: sum(words[pipe] for words in [stage.outside, *once]) for pipe in stage.outside}
            return
    raise CompilerError(f"the words of the {stage.name} stage's loops do not add up to its {bundles} bundles")


def parse(output: str, gpu: Gpu) -> dict[str, Stage]:
    """The stages of the compiler's output by name."""
    stages: dict[str, Stage] = {}
    heads: dict[str, dict[str, int]] = {}
    stage: Stage | None = None
    for line in output.splitlines():
        if head := re.match(r"SHADER-DB: MESA_SHADER_(\w+) shader: (.*)", line):
            counts = {name: int(number) for number, name in re.findall(r"(\d+) (registers|threads|loops|bundles)\b", head[2])}
            spills = re.search(r"(\d+):(\d+) spills:fills", head[2])
            if not spills:
                raise CompilerError(f"no spills in the compiler's line: {line}")
            stage = Stage(head[1].lower(), counts.get("registers"), counts["threads"], int(spills[1]), int(spills[2]))
            stages[stage.name] = stage
            heads[stage.name] = counts
        elif stage and (outside := re.match(r"\s+outside loops: (.*)", line)):
            stage.outside = _words(outside[1], gpu)
        elif stage and (loop := re.match(r"\s+loop@(b\d+) depth (\d+) .*?exclusive per iteration ([^;]*)(.*)",
                                        line)):
            stage.loops.append(Loop(int(loop[2]), _words(loop[3], gpu), loop[1], tuple(re.findall(r"'(b\d+)'", loop[4]))))
    for stage in stages.values():
        head = heads[stage.name]
        if len(stage.loops) > head["loops"]:
            _fold_write_out(stage, head["loops"], head["bundles"])
    return stages


def compile_shaders(compiler: Path, gpu: Gpu, shaders: list[Path]) -> dict[str, Stage]:
    """Links the files, whose endings name the stages, and returns what each stage costs."""
    try:
        run = subprocess.run([str(compiler), str(gpu.number), *map(str, shaders)], capture_output=True, text=True,
                             timeout=300)
    except (OSError, subprocess.TimeoutExpired) as why:
        raise CompilerError(f"{compiler} cannot be run: {why}\n{HOW}") from why
    output = run.stdout + run.stderr
    failed = re.search(r"^(COMPILE .*|LINK): FAILED(\n.*)*", output, re.MULTILINE)
    if failed:
        raise CompilerError(f"{gpu.name} does not take {', '.join(map(str, shaders))}:\n{failed[0]}")
    stages = parse(output, gpu)
    if not stages or "LINK: ok" not in output:
        raise CompilerError(f"{compiler} printed no counts for {shaders[-1]}:\n{output[-2000:]}\n{HOW}")
    return stages
