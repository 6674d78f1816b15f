"""Runs Mesa's compilers for Mali and Adreno over GLSL ES files and reads their counts."""
import os
import re
import subprocess
from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path

from files import Failed

from .gpus import Gpu

HOW = """\
The compiler is a program that compiles GLSL ES without a phone, by Mesa's panfrost (Mali) or freedreno (Adreno). Debian's arm64
package libgl1-mesa-dri has both; QEMU runs them over Mesa's no-op kernel drivers (lib{panfrost,freedreno}_noop_drm_shim.so, with
PAN_GPU_ID or FD_GPU_ID), with MIDGARD_MESA_DEBUG and BIFROST_MESA_DEBUG=shaders,shaderdb, or IR3_SHADER_DEBUG=fs,cs,disasm and
FD_MESA_DEBUG=serialc. Called as `COMPILER 880 a.vert b.frag` (880, 6221, 7212 and 9093 are Mali-T880, G72, G52 and G57, a630 is
an Adreno) it links the shaders and prints a line of statistics of each stage ("SHADER-DB: MESA_SHADER_FRAGMENT shader: ..."),
followed by the words of each pipe outside of loops ("  outside loops: A=44 LS=10 T=3") and, for each loop, per iteration
("  loop@b4 depth 1 (7 blocks): exclusive per iteration A=39 LS=0 T=3")."""
Words = dict[str, int]  # by pipe


@dataclass
class CompiledLoop:
    depth: int
    words: Words  # per iteration, without those of inner loops
    head: str = ""  # the block that it begins with
    inner_heads: tuple[str, ...] = ()


@dataclass
class Stage:
    outside: Words = field(default_factory=dict)  # per invocation
    loops: list[CompiledLoop] = field(default_factory=list)  # an inner one after the one around it
    registers: str = ""  # how many it has, or how many threads they leave room for
    spills: str = ""  # "1:8", stores and loads of registers that did not fit


def parse_words(text: str, pipes: Iterable[str]) -> Words:
    found = {key: int(value) for key, value in re.findall(r"(\w+)=(\d+)", text)}
    return {pipe: found.get(pipe, 0) for pipe in pipes}


def fold_write_out(stage: Stage, declared: int, bundles: int) -> None:
    """Moves the code that writes several colour targets out of the loops.

    Midgard writes them by backward jumps, which look like loops and run once. With three or more targets these overlap, and list
    the same words more than once.
    """
    folded = []
    while len(stage.loops) > declared:
        last = max(index for index, loop in enumerate(stage.loops) if loop.depth == 0)
        jump = stage.loops.pop(last)
        folded.append(jump.words)
        for loop in stage.loops:
            loop.depth -= loop.head in jump.inner_heads
    elsewhere = [stage.outside, *(loop.words for loop in stage.loops)]
    for once in (folded, folded[:1]):
        if sum(sum(words.values()) for words in [*elsewhere, *once]) == bundles:
            stage.outside = {pipe: sum(words[pipe] for words in [stage.outside, *once]) for pipe in stage.outside}
            return
    raise Failed(f"the words of a stage's loops do not add up to its {bundles} bundles")


def parse(output: str, gpu: Gpu) -> dict[str, Stage]:
    """The stages of the compiler's output, by name."""
    stages: dict[str, Stage] = {}
    counts: dict[str, dict[str, int]] = {}
    stage: Stage | None = None
    for line in output.splitlines():
        if head := re.match(r"SHADER-DB: MESA_SHADER_(\w+) shader: (.*)", line):
            stage = stages[head[1].lower()] = Stage()
            counts[head[1].lower()] = {name: int(number) for number, name in re.findall(r"(\d+) (loops|bundles)\b", head[2])}
            registers = re.search(r"\d+ registers", head[2]) or re.search(r"\d+ threads", head[2])
            spills = re.search(r"(\d+:\d+) spills:fills", head[2])
            stage.registers, stage.spills = registers[0] if registers else "", spills[1] if spills else ""
        elif stage and (outside := re.match(r"\s+outside loops: (.*)", line)):
            stage.outside = parse_words(outside[1], gpu.per_cycle)
        elif stage and (loop := re.match(r"\s+loop@(b\d+) depth (\d+) .*?exclusive per iteration ([^;]*)(.*)", line)):
            stage.loops.append(CompiledLoop(int(loop[2]), parse_words(loop[3], gpu.per_cycle), loop[1],
                                            tuple(re.findall(r"'(b\d+)'", loop[4]))))
    for name, stage in stages.items():
        if len(stage.loops) > counts[name]["loops"] and "bundles" in counts[name]:
            fold_write_out(stage, counts[name]["loops"], counts[name]["bundles"])
    return stages


def compile_shaders(compiler: Path, gpu: Gpu, shaders: list[Path]) -> dict[str, Stage]:
    """Links the files, whose endings name the stages."""
    try:
        # Arm's own driver of the T880 has the extension, Mesa's has not, though its compiler knows what it adds.
        run = subprocess.run([str(compiler), gpu.number, *map(str, shaders)], capture_output=True, text=True, timeout=300,
                             check=False, env={**os.environ, "MESA_EXTENSION_OVERRIDE": "+GL_OES_sample_variables"})
    except (OSError, subprocess.TimeoutExpired) as why:
        raise Failed(f"{compiler} cannot be run: {why}\n{HOW}") from why
    output = run.stdout + run.stderr
    if failed := re.search(r"^(COMPILE .*|LINK): FAILED(\n.*)*", output, re.MULTILINE):
        raise Failed(f"a {gpu.name} does not take {', '.join(map(str, shaders))}:\n{failed[0]}")
    stages = parse(output, gpu)
    if not stages or "LINK: ok" not in output:
        raise Failed(f"{compiler} printed no counts for {shaders[-1]}:\n{output[-2000:]}\n{HOW}")
    return stages


def passing_vertex_shader(geometry: str) -> str:
    """A vertex shader in place of a vertex and a geometry shader, which panfrost cannot compile.

    It writes each output that the geometry shader's source declares, from an attribute. Preprocessor lines stay, so that each
    variant passes what its own fragment shader reads.
    """
    preamble = geometry[:geometry.index("#line")]  # version, precisions and the variant's defines
    head = [line for line in preamble.splitlines() if not line.startswith("#extension")]
    body = geometry[geometry.index("layout(triangles) in;"):]
    declarations, statements = [], []
    for number, line in enumerate(body[:body.index("void main()")].splitlines(), 1):
        if line.startswith("#"):
            declarations.append(line)
            statements.append(line)
        elif output := re.match(r"^(flat )?out (?P<type>float|vec[234]) (?P<name>\w+);", line):
            declarations.append(line)
            # No two values are the same, or the linker would merge them.
            statements.append(f"    {output['name']} = {output['type']}(vertex * {number}.5);")
    return "\n".join([*head, "layout(location = 0) in vec4 vertex;", *declarations, "void main() {",
                      "    gl_Position = vertex;", *statements, "}", ""])
