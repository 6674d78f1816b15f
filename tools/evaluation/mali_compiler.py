"""Runs Mesa's compiler for Mali over GLSL ES files and reads its counts."""
import re
import subprocess
from dataclasses import dataclass, field
from pathlib import Path

from files import Failed

HOW = """\
The compiler is a program that compiles GLSL ES for Mali without a phone: Mesa's panfrost driver built with
-Dtools=panfrost,drm-shim, loaded over its no-op kernel driver (libpanfrost_noop_drm_shim.so) with PAN_GPU_ID, and run with
MIDGARD_MESA_DEBUG=shaderdb. Called as `COMPILER 880 a.vert b.frag` it links the shaders and prints Mesa's SHADER-DB line of each
stage, followed by the words of each pipe outside of loops and, for each loop, per iteration."""
T880 = "880"
PIPES = ("A", "LS", "T")  # arithmetic, load/store, texture
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


def parse_words(text: str) -> Words:
    found = {key: int(value) for key, value in re.findall(r"(\w+)=(\d+)", text)}
    return {pipe: found.get(pipe, 0) for pipe in PIPES}


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
            stage.outside = {pipe: sum(words[pipe] for words in [stage.outside, *once]) for pipe in PIPES}
            return
    raise Failed(f"the words of a stage's loops do not add up to its {bundles} bundles")


def parse(output: str) -> dict[str, Stage]:
    """The stages of the compiler's output, by name."""
    stages: dict[str, Stage] = {}
    counts: dict[str, dict[str, int]] = {}
    stage: Stage | None = None
    for line in output.splitlines():
        if head := re.match(r"SHADER-DB: MESA_SHADER_(\w+) shader: (.*)", line):
            stage = stages[head[1].lower()] = Stage()
            counts[head[1].lower()] = {name: int(number) for number, name in re.findall(r"(\d+) (loops|bundles)\b", head[2])}
        elif stage and (outside := re.match(r"\s+outside loops: (.*)", line)):
            stage.outside = parse_words(outside[1])
        elif stage and (loop := re.match(r"\s+loop@(b\d+) depth (\d+) .*?exclusive per iteration ([^;]*)(.*)", line)):
            stage.loops.append(CompiledLoop(int(loop[2]), parse_words(loop[3]), loop[1], tuple(re.findall(r"'(b\d+)'", loop[4]))))
    for name, stage in stages.items():
        if len(stage.loops) > counts[name]["loops"]:
            fold_write_out(stage, counts[name]["loops"], counts[name]["bundles"])
    return stages


def compile_shaders(compiler: Path, shaders: list[Path]) -> dict[str, Stage]:
    """Links the files, whose endings name the stages."""
    try:
        run = subprocess.run([str(compiler), T880, *map(str, shaders)], capture_output=True, text=True, timeout=300, check=False)
    except (OSError, subprocess.TimeoutExpired) as why:
        raise Failed(f"{compiler} cannot be run: {why}\n{HOW}") from why
    output = run.stdout + run.stderr
    if failed := re.search(r"^(COMPILE .*|LINK): FAILED(\n.*)*", output, re.MULTILINE):
        raise Failed(f"a Mali-T880 does not take {', '.join(map(str, shaders))}:\n{failed[0]}")
    stages = parse(output)
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
