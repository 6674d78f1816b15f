"""tools/summary.py and tools/pareto.py, on a sweep that is made up: what is right is known."""
import pytest

import pareto
import summary
from sweep.usual import usual_points

GOOD = {"thesis": {"relmse": 0.4, "flip": 0.4, "bias": 0.5, "rmse": 0.2}, "mobile": {"relmse": 0.04, "flip": 0.08, "bias": -0.06, "rmse": 0.02},
        "quality": {"relmse": 0.02, "flip": 0.06, "bias": 0.05, "rmse": 0.02}}
MS = {"thesis": 100.0, "mobile": 5.0, "quality": 50.0}


def entry(scene, preset, grid, ms, angle=5.0):
    steps = {name: {"samples": [ms] * 5} for name in ("voxelize", "inject", "mipmap", "irradiance", "trace")}
    errors = {name: GOOD[preset] for name in ("indirect", "gi-full", "shadow", "ao")}
    return {"scene": scene, "grid": grid, "errors": errors, "modes": {"gi": steps}, "driver": {"renderer": "llvmpipe (LLVM 15)"},
            "settings": {"preset": preset, "size": "256x256", "grid": grid, "cone_angle_deg": angle}}


@pytest.fixture
def sweep():
    """Every preset at its usual grid, the thesis's at another one too, and once with another cone."""
    points = [entry(scene, preset, grid, MS[preset]) for scene in ("contact", "cornell", "furnace", "lamp", "lone_plane")
              for preset, grid in (("thesis", 128), ("thesis", 256), ("mobile", 64), ("quality", 128))]
    return {"points": [*points, entry("cornell", "thesis", 256, 1e6, angle=10.0)]}


def test_the_pareto_means_are_those_of_the_scenes(sweep):
    found = pareto.dots(sweep)
    assert {dot.scene for dot in found} == {"contact", "cornell", "lamp"}
    found[0] = pareto.Dot(**{**vars(found[0]), "ms": 4 * found[0].ms})
    by_preset = {(dot.preset, dot.grid): dot for dot in pareto.means(found)}
    assert set(by_preset) == {("thesis", 128), ("thesis", 256), ("mobile", 64), ("quality", 128)}
    assert by_preset["thesis", 128].ms == pytest.approx(4 ** (1 / 3) * 5 * MS["thesis"])  # Five steps; one of three scenes 4 times as long.
    assert by_preset["mobile", 64].error == pytest.approx(0.04)
    assert pareto.draw(found, pareto.footnote(sweep)).startswith(b"\x89PNG")


def test_the_table_of_the_readme_holds_the_three_presets(sweep):
    text = summary.table(usual_points(sweep))
    assert "| cornell | .4000 / .0400 / .0200 | +50 % / −6 % / +5 % | .40 / .08 / .06 |" in text
    assert "| furnace | .4000 / .0400 / .0200 | +50 % / −6 % / +5 % | .40 / .08 / .06 | .200 / .020 / .020 | " \
           ".4000 / .0400 / .0200 | +50 % / −6 % / +5 % | – |" in text
