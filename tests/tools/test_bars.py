"""tools/bars.py and tools/pareto.py, on sweeps that are made up: what is right is known."""
from __future__ import annotations

import copy
import json
import subprocess
import sys
from pathlib import Path

import pytest
from PIL import Image

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

import pareto  # noqa: E402
import summary  # noqa: E402
from bars import usual_points  # noqa: E402

SCENES = ("contact", "cornell", "furnace", "lamp", "lone_plane")
GOOD = {"thesis": {"relmse": 0.4, "flip": 0.4, "bias": 0.5, "rmse": 0.2, "sparks": 9},
        "mobile": {"relmse": 0.04, "flip": 0.08, "bias": -0.06, "rmse": 0.02, "sparks": 0},
        "quality": {"relmse": 0.02, "flip": 0.06, "bias": 0.05, "rmse": 0.02, "sparks": 0}}
MS = {"thesis": 100.0, "mobile": 5.0, "quality": 50.0}


def entry(scene: str, preset: str, grid: int, ms: float, angle: float = 5.0) -> dict:
    steps = {name: {"median": ms, "min": ms, "max": ms, "samples": [ms] * 5}
             for name in ("shadow_map", "render_data", "voxelize", "mipmap", "irradiance", "trace", "total")}
    errors = {name: dict(GOOD[preset]) for name in ("indirect", "gi-full", "shadow", "ao")}
    return {"key": f"{scene} {preset} {grid} {angle}", "scene": scene, "status": "done", "errors": errors,
            "settings": {"backend": "egl", "preset": preset, "size": "256x256", "grid": grid,
                         "cone_angle_deg": angle, "experiment": "none"},
            "modes": {"gi": steps}, "driver": {"renderer": "llvmpipe (LLVM 15)"}}


def sweep() -> dict:
    points = [entry(scene, preset, grid, MS[preset]) for scene in SCENES
              for preset, grid in (("thesis", 128), ("thesis", 256), ("mobile", 64), ("quality", 128))]
    points.append(entry("cornell", "thesis", 256, 1e6, angle=10.0))
    for bad in (point for point in points if point["settings"]["grid"] == 128 and point["settings"]["preset"] == "thesis"):
        bad["errors"]["indirect"]["relmse"] = 0.01  # No bar is of this grid.
    return {"version": 2, "points": points}


def bench() -> dict:
    def preset(name: str, ms: float, megabytes: float) -> dict:
        steps = {step: {"median": ms} for step in ("trace", "voxelize_mipmap")}
        return {"preset": name, "bytes": megabytes * 1e6, "modes": {"gi": steps, "gi-cone-shadow": steps}}
    return {"version": 1, "scene": "assets/cornell.glb",
            "presets": [preset("thesis", 100, 90), preset("mobile", 4, 20), preset("quality", 60, 90)]}


def bars(folder: Path, swept: dict, benched: dict) -> subprocess.CompletedProcess[str]:
    (folder / "sweep.json").write_text(json.dumps(swept))
    (folder / "bench.json").write_text(json.dumps(benched))
    return subprocess.run([sys.executable, str(ROOT / "tools/bars.py"), "--sweep", str(folder / "sweep.json"), "--bench",
                           str(folder / "bench.json")], capture_output=True, text=True, check=False)


def test_what_reaches_every_bar_is_held(tmp_path: Path):
    done = bars(tmp_path, sweep(), bench())
    assert done.returncode == 0, done.stdout + done.stderr
    assert "missed**" not in done.stdout and ", 0 missed." in done.stdout
    assert "| trace of mode 5, ms | cornell | thesis / mobile ≥ 25 (is 25.0) | 100.0 | 4.0 | 60.0 | held |" in done.stdout
    # Furnace and lamp have no sun and bars of their own, and the lone plane no share of the thesis's light.
    bars_of = {scene: {line.split("|")[1].strip() for line in done.stdout.splitlines() if f"| {scene} |" in line}
               for scene in ("furnace", "lamp")}
    assert bars_of == {"furnace": {"ambient occlusion, RMSE", "all bounces of a furnace, bias"},
                       "lamp": {"ambient occlusion, RMSE", "light of a lamp alone, all bounces, FLIP",
                                "light of a lamp alone, all bounces, relMSE",
                                "light of a lamp alone, all bounces, sparks"}}
    assert "| indirect light, relMSE | lone_plane" not in done.stdout


@pytest.mark.parametrize("preset, measure, metric, value, figure", [
    ("mobile", "indirect", "relmse", 0.11, "indirect light, relMSE | cornell"),
    ("mobile", "indirect", "relmse", 0.08, "indirect light, relMSE | geometric mean of 2"),
    ("mobile", "indirect", "flip", 0.29, "indirect light, FLIP | cornell"),
    ("quality", "indirect", "flip", 0.09, "indirect light, FLIP | cornell"),
    ("quality", "indirect", "bias", -0.11, "indirect light, bias | cornell"),
    ("quality", "ao", "rmse", 0.07, "ambient occlusion, RMSE | cornell"),
    ("mobile", "shadow", "rmse", 0.06, "soft shadow, RMSE | cornell"),
    ("mobile", "gi-full", "flip", 0.13, "mode 4 against all bounces, FLIP | cornell"),
    ("quality", "gi-full", "flip", 0.07, "mode 4 against all bounces, FLIP | cornell"),
    ("mobile", "gi-full", "bias", -0.16, "mode 4 against all bounces, bias | cornell"),
    ("quality", "gi-full", "bias", 0.07, "all bounces of a furnace, bias | furnace"),
    ("mobile", "gi-full", "flip", 0.19, "light of a lamp alone, all bounces, FLIP | lamp"),
    ("quality", "gi-full", "relmse", 0.03, "light of a lamp alone, all bounces, relMSE | lamp"),
    ("mobile", "gi-full", "sparks", 1, "light of a lamp alone, all bounces, sparks | lamp"),
    ("quality", "indirect", "rmse", 0.04, "indirect light where none is, RMSE | lone_plane")])
def test_a_bar_that_is_missed_is_named(tmp_path: Path, preset: str, measure: str, metric: str, value: float, figure: str):
    swept = sweep()
    for point in swept["points"]:
        if point["settings"]["preset"] == preset and point["scene"] in (figure.split(" | ")[1], "cornell"):
            point["errors"][measure][metric] = value
    done = bars(tmp_path, swept, bench())
    (line,) = [line for line in done.stdout.splitlines() if f"| {figure} |" in line]
    assert done.returncode == 1 and f"**missed**: {preset}" in line


@pytest.mark.parametrize("change, figure", [
    (lambda mobile: mobile["modes"]["gi-cone-shadow"]["trace"].update(median=4.1), "trace of mode 5, ms"),
    (lambda mobile: mobile["modes"]["gi"]["trace"].update(median=10.1), "trace of mode 4, ms"),
    (lambda mobile: mobile["modes"]["gi-cone-shadow"]["voxelize_mipmap"].update(median=20.1), "voxelize + mipmap, mode 5, ms"),
    (lambda mobile: mobile.update(bytes=22.6e6), "GL memory, MB")])
def test_a_time_or_memory_that_is_missed_is_named(tmp_path: Path, change, figure: str):
    benched = copy.deepcopy(bench())
    change(benched["presets"][1])
    done = bars(tmp_path, sweep(), benched)
    assert done.returncode == 1
    assert any(line.startswith(f"| {figure} |") and "**missed**: mobile" in line for line in done.stdout.splitlines())


def test_what_was_not_measured_is_missed(tmp_path: Path):
    swept = sweep()
    swept["points"] = [point for point in swept["points"]
                       if (point["scene"], point["settings"]["preset"]) != ("contact", "quality")]
    done = bars(tmp_path, swept, bench())
    assert done.returncode == 1
    assert any("| contact |" in line and "| – | **missed**: quality" in line for line in done.stdout.splitlines())


def test_a_bench_of_tables_is_one_sentence(tmp_path: Path):
    done = bars(tmp_path, sweep(), {"version": 1, "tables": {}})
    assert done.returncode != 0 and "--preset thesis,mobile,quality" in done.stderr and "Traceback" not in done.stderr


def test_the_pareto_picture_is_small_and_its_means_are_those_of_the_scenes(tmp_path: Path):
    found = pareto.dots(sweep())
    assert {dot.scene for dot in found} == {"contact", "cornell", "lamp"}
    found[0] = pareto.Dot(**{**vars(found[0]), "ms": 4 * found[0].ms})
    by_preset = {(dot.preset, dot.grid): dot for dot in pareto.means(found)}
    assert set(by_preset) == {("thesis", 128), ("thesis", 256), ("mobile", 64), ("quality", 128)}
    assert by_preset["thesis", 128].ms == pytest.approx(4 ** (1 / 3) * 4 * MS["thesis"])  # Four steps; one of three scenes 4 times as long.
    assert by_preset["mobile", 64].error == pytest.approx(0.04)

    (tmp_path / "sweep.json").write_text(json.dumps(sweep()))
    out = tmp_path / "pareto.png"
    subprocess.run([sys.executable, str(ROOT / "tools/pareto.py"), "--sweep", str(tmp_path / "sweep.json"), "--out",
                    str(out)], check=True, capture_output=True)
    assert out.stat().st_size < 200_000
    with Image.open(out) as image:
        colours = {colour for _, colour in image.convert("RGB").getcolors(1 << 20)}
    for colour in pareto.COLOURS.values():
        wanted = tuple(int(colour[i:i + 2], 16) for i in (1, 3, 5))
        assert any(max(abs(a - b) for a, b in zip(colour, wanted)) < 8 for colour in colours)


def test_the_tables_of_the_readme_hold_the_three_presets():
    text = summary.table(usual_points(sweep()), summary.INDIRECT)
    assert "| cornell | .4000 / .0400 / .0200 | +50 % / −6 % / +5 % | .40 / .08 / .06 |" in text
    assert "| furnace | .200 / .020 / .020 | – |" in summary.table(usual_points(sweep()), summary.REST)
