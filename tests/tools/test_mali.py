"""tools/eval.py mali: reading the compiler, matching loops, the bound's arithmetic."""
import pathlib

import pytest

from evaluation.gpus import GPUS
from evaluation.mali import bound_ms, limit, memory_ms, output_bytes, words_of
from evaluation.mali_compiler import CompiledLoop, Stage, compile_shaders, parse
from evaluation.mali_loops import match_loops
from files import Failed

DATA = pathlib.Path(__file__).resolve().parent / "data"


T880, G52, ADRENO = GPUS["t880"], GPUS["g52"], GPUS["a630"]


def stored(name):
    return parse((DATA / f"mali_{name}.txt").read_text(), T880)["fragment"]


def test_words_and_loops_are_read():
    fragment = stored("cone_tracer_t880")
    assert fragment.outside == {"A": 44, "LS": 10, "T": 3}
    assert [(loop.depth, loop.words) for loop in fragment.loops] == [
        (0, {"A": 14, "LS": 1, "T": 0}), (1, {"A": 74, "LS": 3, "T": 8}), (0, {"A": 79, "LS": 7, "T": 16})]


def test_writing_several_targets_is_no_loop_and_counts_once():
    fragment = stored("g_buffer_t880")  # 20 bundles, of which the compiler's loops list 19 twice
    assert fragment.loops == [] and fragment.outside == {"A": 19, "LS": 1, "T": 0}
    fragment = stored("write_out_t880")
    assert [(loop.depth, loop.words["A"], loop.words["T"]) for loop in fragment.loops] == [(0, 19, 0), (1, 32, 3)]
    assert fragment.outside == {"A": 42, "LS": 1, "T": 2}
    with pytest.raises(Failed, match="25 bundles"):
        parse((DATA / "mali_g_buffer_t880.txt").read_text().replace("20 bundles", "25 bundles"), T880)


def test_other_gpus_have_pipes_of_their_own():
    mali = parse("SHADER-DB: MESA_SHADER_FRAGMENT shader: 966 inst, 710 tuples, 622 quadwords, 1 threads, 0 preloads, 1 loops, "
                 "41:141 spills:fills\n  outside loops: inst=394 arith=282 tex=6 vary=0 ldst=0\n"
                 "  loop@b3 depth 0 (11 blocks): exclusive per iteration inst=145 arith=94 tex=1 vary=0 ldst=2\n", G52)["fragment"]
    assert mali.outside == {"arith": 282, "tex": 6, "vary": 0, "ldst": 0} and mali.loops[0].words["ldst"] == 2
    assert (mali.registers, mali.spills) == ("1 threads", "41:141")
    adreno = parse("SHADER-DB: MESA_SHADER_COMPUTE shader: 16 inst, 4 nops, 16 registers, 0 half, 0 loops, 0:0 spills:fills\n"
                   "  outside loops: alu=9 nop=4 sfu=1 tex=1 mem=1\n", ADRENO)["compute"]
    assert adreno.outside == {"alu": 9, "sfu": 1, "tex": 1, "mem": 1} and adreno.registers == "16 registers"


def test_memory_is_between_outputs_alone_and_every_access():
    source = "layout(location = 0) out mediump vec4 a;\nlayout(location = 1) out uvec2 b;\nin vec2 uv;\n"
    assert output_bytes(source) == 20
    least, most = memory_ms({"A": 1, "LS": 30, "T": 70}, T880, 200.0)
    assert (least, most) == (pytest.approx(400 / 28.7e9 * 1e3), pytest.approx(600 / 28.7e9 * 1e3))
    assert memory_ms({"A": 1, "LS": 0, "T": 0}, T880, 200.0) == (least, least)
    assert limit(8, 1, 7) == "shaders" and limit(8, 9, 12) == "memory"
    assert limit(8, 0, 10) == "shaders, if caches spare 20 % of the accesses"


def loops(*entries):
    """(depth, iterations), with a letter where the length is constant."""
    return [{"place": str(index), "depth": depth, "iterations": iterations, "constant": bool(constant)}
            for index, (depth, iterations, *constant) in enumerate(entries)]


@pytest.mark.parametrize("source, compiled, matched", [
    (loops((0, 6), (1, 40), (0, 99)), [0, 1, 0], [0, 1, 2]),
    (loops((0, 6), (1, 40), (0, 8, "c"), (0, 16, "c")), [0, 1], [0, 1]),  # the last two unrolled
    (loops((0, 3, "c"), (1, 40), (0, 99)), [0, 0, 0, 0], [1, 1, 1, 2]),  # the first unrolled three times
    (loops((0, 10), (1, 30, "c"), (2, 60, "c")), [0], [0]),
    (loops((0, 8, "c"), (0, 16, "c")), [0], [1]),  # the shorter unrolled
    (loops((0, 5, "c"), (1, 20, "c")), [], []),
    ([], [], []),
    (loops((0, 6), (0, 9)), [0, 0, 0, 0], [0, 1, 0, 1]),  # a function that is called twice
    (loops((0, 6), (1, 9), (2, 12), (2, 3)), [0, 1, 2, 1], [0, 1, 2, 3]),  # a `return` follows the last
])
def test_compiled_loops_are_matched(source, compiled, matched):
    assert match_loops(source, compiled) == matched


def test_calls_that_the_compiler_removed_leave_their_iterations_to_the_others():
    called_twice = [{"place": place, "depth": depth, "iterations": iterations, "constant": False}
                    for place, depth, iterations in [("a", 0, 40), ("b", 1, 90)] * 2]
    assert match_loops(called_twice, [0, 1]) in ([0, 1], [2, 3])
    stage = Stage({"A": 0}, [CompiledLoop(0, {"A": 1}), CompiledLoop(1, {"A": 10})])
    assert words_of(stage, 4, called_twice) == {"A": 40 + 900}
    assert match_loops(loops((0, 7), (1, 28, "c"), (1, 0)), [0, 1], 5) == [0, 2], "what can be unrolled is, before a loop that never ran goes"
    assert match_loops(loops((0, 7), (1, 7), (2, 30)), [0, 1], 5) == [0, 2], "a loop that runs once for each entry is removed"


@pytest.mark.parametrize("source, compiled, words", [
    (loops((0, 1)), [0, 1], "cannot be those"), (loops((0, 1), (0, 2)), [0], "cannot be those"),
    (loops((0, 2, "c"), (0, 4, "c"), (0, 2, "c")), [0, 0], "more than one way")])
def test_loops_that_cannot_be_matched_are_an_error(source, compiled, words):
    with pytest.raises(Failed, match=words):
        match_loops(source, compiled)


def test_the_bound_is_the_formula_of_the_help():
    stage = Stage({"A": 30, "LS": 20, "T": 2},
                  [CompiledLoop(0, {"A": 6, "LS": 0, "T": 4}), CompiledLoop(1, {"A": 3, "LS": 1, "T": 10})])
    words = words_of(stage, 1000, loops((0, 5000), (1, 20000)))
    assert words == {"A": 30_000 + 30_000 + 60_000, "LS": 20_000 + 20_000, "T": 2_000 + 20_000 + 200_000}
    assert bound_ms(words, T880) == (pytest.approx(222_000 / 12 / 850e6 * 1e3), "T")
    assert bound_ms({"A": 900_000, "LS": 1, "T": 1}, T880) == (pytest.approx(300_000 / 12 / 850e6 * 1e3), "A")
    assert bound_ms({"arith": 2400, "tex": 20, "vary": 0, "ldst": 300}, G52) == (pytest.approx(300 / 2 / 950e6 * 1e3), "ldst")
    unrolled = Stage({"A": 0, "LS": 0, "T": 0}, [CompiledLoop(0, {"A": 1, "LS": 0, "T": 0}) for _ in range(3)])
    assert words_of(unrolled, 100, loops((0, 300, "c"), (1, 3000)))["A"] == 3000, "copies share the iterations"


def test_a_program_that_is_no_compiler_is_an_error(tmp_path):
    for compiler in (tmp_path / "none", pathlib.Path("/bin/false")):
        with pytest.raises(Failed, match="drm_shim"):
            compile_shaders(compiler, T880, [tmp_path / "a.frag"])
