"""tools/sweep.py: what it renders, that it continues, that a failure is kept."""
import json
import shutil
import signal
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from files import ROOT
from program import render
from sweep.measures import MEASURES
from sweep.settings import SETTINGS, points, values_of_presets
from truth.exr import read_exr

THESIS = ["--scenes", "cornell", "--sizes", "32x32", "--presets", "thesis"]
SMALL = [*THESIS, "--grids", "64", "--cone-angles", "5"]


class Sweep:
    def __init__(self, program: str, out: Path) -> None:
        self.out, self.command = out, [sys.executable, str(ROOT / "tools/sweep.py"), "--program", program, "--out", str(out)]

    def run(self, *more: str, status: int = 0) -> str:
        """What it said."""
        done = subprocess.run([*self.command, *more], capture_output=True, text=True, check=False)
        assert done.returncode == status and "Traceback" not in done.stderr, done.stderr
        return done.stderr

    def points(self) -> list[dict]:
        return json.loads((self.out / "sweep.json").read_text())["points"]


@pytest.fixture
def sweep(program: str, tmp_path: Path) -> Sweep:
    return Sweep(program, tmp_path)


def defaults(**changes: tuple) -> list[dict[str, tuple]]:
    return values_of_presets({"preset": ("thesis",), **changes}, quick=False)


def test_the_cone_angle_is_varied_only_for_the_mode_that_feels_it():
    found = points([Path("a.glb")], defaults(grid=(64,)), ("gi", "gi-cone-shadow", "ao"))
    modes = {point.settings["cone_angle_deg"]: point.modes for point in found}
    assert modes == {2.5: ("gi-cone-shadow",), 5.0: ("gi", "gi-cone-shadow", "ao"), 7.5: ("gi-cone-shadow",),
                     10.0: ("gi-cone-shadow",)}


def test_a_scaled_scene_is_rendered_at_one_cone_angle():
    found = points([Path("a.glb"), Path("a_1mm.glb")], defaults(), ("gi-cone-shadow",), {"a_1mm"})
    assert sum(point.scene.stem == "a" for point in found) == 16
    assert {point.settings["cone_angle_deg"] for point in found if point.scene.stem == "a_1mm"} == {5.0}


def test_other_presets_run_once_at_their_own_grid():
    found = points([Path("a.glb")], values_of_presets({}, quick=False), ("gi", "gi-cone-shadow"))
    others = [(point.settings["preset"], point.settings["grid"], point.settings["cone_angle_deg"]) for point in found
              if point.settings["preset"] != "thesis"]
    assert others == [("mobile", 64, 5.0), ("quality", 128, 5.0)]
    asked = points([Path("a.glb")], values_of_presets({"preset": ("mobile",), "grid": (64, 256)}, quick=False), ("gi",))
    assert [point.settings["grid"] for point in asked] == [64, 256]


def test_a_quick_sweep_shows_each_preset_at_its_own_grid():
    found = points([Path("a.glb")], values_of_presets({}, quick=True), ("gi",))
    assert [(point.settings["preset"], point.settings["grid"]) for point in found] == [("thesis", 256), ("mobile", 64), ("quality", 128)]


def test_the_key_follows_settings_program_and_scene():
    point, other = points([Path("a.glb")], defaults(grid=(64, 128), cone_angle_deg=(5.0,)), ("gi",))
    identity = {"program": "p", "scene_sha256": "s"}
    assert len({point.key(identity), other.key(identity), point.key(identity | {"program": "q"}),
                point.key(identity | {"scene_sha256": "t"})}) == 4
    assert point.key(identity) == point.key(dict(identity))


def test_the_grids_of_presets_are_the_programs(program, tmp_path):
    grids = next(setting for setting in SETTINGS if setting.name == "grid").of_preset
    for preset, values in grids.items():
        render(program, ROOT / "assets/cornell.glb", "--out", tmp_path, "--preset", preset, "--size", "8x8", "--mode", "phong",
               "--timings", tmp_path / "t.json")
        assert values == (json.loads((tmp_path / "t.json").read_text())["settings"]["grid"],)


def test_a_grid_that_the_scene_chooses_is_recorded(sweep):
    sweep.run("--scenes", "corridor", "--sizes", "8x8", "--presets", "mobile", "--grids", "auto,64", "--modes", "ao")
    assert [(entry["settings"]["grid"], entry["grid"]) for entry in sweep.points()] == [("auto", 128), (64, 64)]


def test_all_bounces_are_judged_against_the_full_light(sweep):
    sweep.run("--scenes", "cornell", "--sizes", "32x32", "--presets", "mobile")
    (entry,) = sweep.points()
    assert entry["settings"]["grid"] == 64 and entry["light_frames"] > 0
    assert set(entry["errors"]) == {"indirect", "gi-full", "soft-full", "shadow", "ao"}
    assert 0 < entry["errors"]["soft-full"]["relmse"] < 1


def test_times_and_errors_are_of_the_same_frame(sweep, program, tmp_path):
    assert "[1/1]" in sweep.run(*SMALL)
    (entry,) = sweep.points()
    for mode in ("gi", "gi-cone-shadow", "ao"):
        total = entry["modes"][mode]["total"]
        assert 0 < total["min"] <= total["median"] <= total["max"] and len(total["samples"]) == 5
    assert entry["active_voxels"][-1] == 1 and entry["resources"]
    assert set(entry["errors"]) == {measure.name for measure in MEASURES}
    for name, error in entry["errors"].items():
        assert 0 < error["noise_relmse"] < error["relmse"] < 1, name
    alone = tmp_path / "alone"
    render(program, ROOT / "assets/cornell.glb", "--out", alone, "--preset", "thesis", "--grid", 64, "--size", "32x32", "--mode", "ao",
           "--light-parts", "--revoxelize", "--timings", alone / "timings.json")
    picture = read_exr(alone / "ambient_occlusion.exr")
    truth = read_exr(ROOT / "references/cornell/ao.exr").reshape(32, 8, 32, 8, 3).mean((1, 3))
    assert entry["errors"]["ao"]["rmse"] == pytest.approx(float(np.sqrt(np.mean((picture - truth) ** 2))), rel=1e-6)


def test_a_picture_is_never_averaged_down(sweep):
    sweep.run("--scenes", "cornell", "--sizes", "512x512", "--presets", "mobile", "--modes", "ao")
    (entry,) = sweep.points()
    assert entry["modes"]["ao"]["total"]["median"] > 0
    assert "references.py --size 512x512" in entry["errors"]["ao"]["missing"]


def test_a_second_run_keeps_what_is_finished_and_adds_the_rest(sweep):
    sweep.run(*SMALL, "--modes", "ao")
    (first,) = sweep.points()
    assert "2 points, 1 to render" in sweep.run(*THESIS, "--grids", "64,128", "--cone-angles", "5", "--modes", "ao")
    entries = sweep.points()
    assert entries[0] == first and [(entry["settings"]["grid"], entry["run"]) for entry in entries] == [(64, 1), (128, 2)]


def test_new_references_are_measured_without_rendering(sweep, tmp_path):
    stale = tmp_path / "references" / "cornell"
    sweep.run(*SMALL, "--modes", "ao", "--references", str(stale.parent))
    (entry,) = sweep.points()
    assert entry["errors"]["ao"] == {"missing": "no reference ao"}
    shutil.copytree(ROOT / "references" / "cornell", stale)
    about = json.loads((stale / "reference.json").read_text())
    (stale / "reference.json").write_text(json.dumps(about | {"scene_sha256": "0"}))
    sweep.run(*SMALL, "--modes", "ao", "--references", str(stale.parent))
    assert "another state of the scene" in sweep.points()[0]["errors"]["ao"]["missing"]
    said = sweep.run(*SMALL, "--modes", "ao")
    assert "0 to render" in said and "measured anew" in said
    (again,) = sweep.points()
    assert again["errors"]["ao"]["rmse"] > 0 and again["modes"] == entry["modes"]


def test_a_failed_point_is_kept_with_its_message_and_tried_again(sweep):
    # 100 is no size of a grid; the other point must not suffer.
    small = [*THESIS, "--grids", "100,64", "--modes", "ao"]
    assert "FAILED" in sweep.run(*small, status=1)
    bad, good = sweep.points()
    assert bad["status"] == "failed" and "grid" in bad["message"] and good["status"] == "done"
    assert "2 points, 1 to render" in sweep.run(*small, status=1)


def test_a_point_that_takes_too_long_is_a_failure(sweep):
    sweep.run(*SMALL, "--modes", "ao", "--timeout", "0.01", status=1)
    (entry,) = sweep.points()
    assert entry["status"] == "failed" and "0.01 s" in entry["message"]


def test_stopping_keeps_what_is_finished(sweep):
    small = [*THESIS, "--grids", "64,128,256", "--modes", "ao"]
    with subprocess.Popen([*sweep.command, *small], stderr=subprocess.PIPE, text=True) as running:
        next(line for line in running.stderr if line.startswith("[1/3]"))
        running.send_signal(signal.SIGINT)
        said = running.stderr.read()
        assert running.wait(timeout=30) == 130 and "continues" in said
    assert 1 <= len(sweep.points()) < 3
    sweep.run(*small)
    assert [entry["status"] for entry in sweep.points()] == ["done"] * 3


@pytest.mark.parametrize("arguments, said", [
    (["--grids", "many"], "--grids many"), (["--modes", "magic"], "unknown mode magic"),
    (["--scenes", "nowhere"], "no such scene"), (["--program", "/nowhere/vct"], "is not built")])
def test_a_bad_command_line_is_one_sentence(tmp_path, arguments, said):
    assert said in Sweep("/nowhere/vct", tmp_path).run(*arguments, status=1)
    assert not (tmp_path / "sweep.json").exists()
