"""tools/mali: reading the compiler, telling loops, the bound's arithmetic."""
import pathlib

import pytest

from mali.bound import CLOCK_HZ, CORES, Cost, stage_cost
from mali.compiler import G57, T880, CompilerError, Loop, Stage, compile_shaders, parse
from mali.loops import LoopError, match_loops
from mali.page import published_bound_ms
from mali.varyings import passing_vertex_shader

DATA = pathlib.Path(__file__).resolve().parent / "data"


def stored(name, gpu):
    return parse((DATA / f"mali_{name}.txt").read_text(), gpu)


def test_the_tracers_words_and_loops_are_read():
    fragment = stored("cone_tracer_t880", T880)["fragment"]
    assert (fragment.registers, fragment.threads, fragment.spills, fragment.fills) == (16, 1, 3, 13)
    assert fragment.outside == {"A": 44, "LS": 10, "T": 3}
    assert [(loop.depth, loop.words) for loop in fragment.loops] == [
        (0, {"A": 14, "LS": 1, "T": 0}), (1, {"A": 74, "LS": 3, "T": 8}), (0, {"A": 79, "LS": 7, "T": 16})]


def test_the_g57_has_other_pipes_and_no_register_count():
    stages = stored("cone_tracer_g57", G57)
    assert set(stages) == {"position", "varying", "fragment"}
    assert stages["fragment"].registers is None
    assert stages["fragment"].loops[2].words == {"fma": 66, "cvt": 249, "sfu": 9, "v": 0, "ls": 2, "t": 16}


def test_writing_three_targets_is_no_loop_and_counts_once():
    fragment = stored("g_buffer_t880", T880)["fragment"]  # 20 bundles, of which the compiler's loops show 19 twice
    assert fragment.loops == []
    assert fragment.outside == {"A": 19, "LS": 1, "T": 0}


def test_words_that_do_not_add_up_are_refused():
    text = (DATA / "mali_g_buffer_t880.txt").read_text().replace("20 bundles", "25 bundles")
    with pytest.raises(CompilerError, match="25 bundles"):
        parse(text, T880)


def test_a_write_out_around_everything_is_no_loop_either():
    fragment = stored("write_out_t880", T880)["fragment"]
    assert [(loop.depth, loop.words["A"], loop.words["T"]) for loop in fragment.loops] == [(0, 19, 0), (1, 32, 3)]
    assert fragment.outside == {"A": 42, "LS": 1, "T": 2}


def loops(*entries):
    """(depth, iterations), with a letter where the length is constant."""
    return [{"name": str(index), "depth": depth, "iterations": iterations, "constant": bool(constant)}
            for index, (depth, iterations, *constant) in enumerate(entries)]


@pytest.mark.parametrize("source, compiled, which", [
    (loops((0, 6), (1, 40), (0, 99)), [0, 1, 0], [0, 1, 2]),
    (loops((0, 6), (1, 40), (0, 8, "c"), (0, 16, "c")), [0, 1], [0, 1]),  # the last two unrolled
    (loops((0, 3, "c"), (1, 40), (0, 99)), [0, 0, 0, 0], [1, 1, 1, 2]),  # the first unrolled three times
    (loops((0, 10), (1, 30, "c"), (2, 60, "c")), [0], [0]),
    (loops((0, 8, "c"), (0, 16, "c")), [0], [1]),  # the shorter unrolled
    (loops((0, 5, "c"), (1, 20, "c")), [], []),
    ([], [], []),
    (loops((0, 6), (0, 9)), [0, 0, 0, 0], [0, 1, 0, 1]),  # of a function that is called twice
])
def test_compiled_loops_are_told(source, compiled, which):
    assert match_loops(source, compiled) == which


def test_loops_that_cannot_be_told_are_an_error():
    with pytest.raises(LoopError, match="cannot be those"):
        match_loops(loops((0, 1)), [0, 1])
    with pytest.raises(LoopError, match="cannot be those"):
        match_loops(loops((0, 1), (0, 2)), [0])  # none may be unrolled
    with pytest.raises(LoopError, match="more than one way"):
        match_loops(loops((0, 4, "c"), (0, 4, "c")), [0])


def test_the_bound_is_the_readmes_formula():
    stage = Stage("fragment", 8, 2, 0, 0, {"A": 30, "LS": 20, "T": 2},
                  [Loop(0, {"A": 6, "LS": 0, "T": 4}), Loop(1, {"A": 3, "LS": 1, "T": 10})])
    cost = stage_cost(stage, 1000, loops((0, 5000), (1, 20000)))
    assert cost.words == {"A": 30_000 + 30_000 + 60_000, "LS": 20_000 + 20_000, "T": 2_000 + 20_000 + 200_000}
    assert cost.bottleneck() == "T"
    assert cost.bound_ms() == pytest.approx(1000 / CORES * (222_000 / 1000) / CLOCK_HZ * 1e3)
    assert cost.bound_ms(2) == pytest.approx(2 * cost.bound_ms())
    arithmetic = Cost(1000, {"A": 900_000, "LS": 1, "T": 1})
    assert arithmetic.bottleneck() == "A" and arithmetic.bound_ms() == pytest.approx(300_000 / CORES / CLOCK_HZ * 1e3)


def test_copies_of_an_unrolled_loop_share_its_iterations():
    stage = Stage("fragment", 8, 2, 0, 0, {"A": 0, "LS": 0, "T": 0}, [Loop(0, {"A": 1, "LS": 0, "T": 0}) for _ in range(3)])
    assert stage_cost(stage, 100, loops((0, 300, "c"), (1, 3000))).words["A"] == 3000


def test_the_published_programs_bound():
    assert published_bound_ms() == pytest.approx(159, abs=0.5)


def test_the_passing_vertex_shader_keeps_the_variants():
    text = passing_vertex_shader("#version 310 es\n#extension GL_EXT_geometry_shader : require\n#define X\n#line 1 0\n"
                                 "layout(triangles) in;\nin vec3 v[];\nout vec3 a;\n#ifdef X\nout vec2 b;\n#endif\nvoid main() {}\n")
    assert "#extension" not in text and text.startswith("#version 310 es\n#define X\n")
    assert text.count("#ifdef X") == 2 and "b = vec2(vertex * 2.5);" in text


def test_a_compiler_that_is_not_there_says_how_it_is_built(tmp_path):
    with pytest.raises(CompilerError, match="drm-shim"):
        compile_shaders(tmp_path / "none", T880, [])
