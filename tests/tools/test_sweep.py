"""tools/sweep.py: what it renders, that it continues, that a failure is kept."""
from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

from sweep.settings import SETTINGS, points, values_of_presets  # noqa: E402
from truth.exr import read_exr  # noqa: E402

PROGRAM = Path(os.environ.get("VCT_PROGRAM", ROOT / "build/desktop/vct"))
needs_program = pytest.mark.skipif(not PROGRAM.exists(), reason="vct is not built: scripts/build.sh desktop vct")
SMALL = ["--scenes", "cornell", "--sizes", "32x32", "--presets", "thesis", "--grids", "64"]


def command(out: Path, *more: str) -> list[str]:
    return [sys.executable, str(ROOT / "tools/sweep.py"), "--program", str(PROGRAM), "--out", str(out), *more]


def sweep(out: Path, *more: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(command(out, *more), capture_output=True, text=True, check=False)


def stored(out: Path) -> dict:
    return json.loads((out / "sweep.json").read_text())


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


@needs_program
def test_the_grids_of_presets_are_the_programs(tmp_path: Path):
    grids = next(setting for setting in SETTINGS if setting.name == "grid").of_preset
    for preset, values in grids.items():
        subprocess.run([str(PROGRAM), "render", str(ROOT / "assets/cornell.glb"), "--out", str(tmp_path), "--preset",
                        preset, "--size", "8x8", "--mode", "phong", "--timings", str(tmp_path / "t.json")],
                       check=True, capture_output=True)
        assert values == (json.loads((tmp_path / "t.json").read_text())["settings"]["grid"],)


@needs_program
def test_a_grid_that_the_scene_chooses_is_recorded(tmp_path: Path):
    done = sweep(tmp_path, "--scenes", "corridor", "--sizes", "8x8", "--presets", "mobile", "--grids", "auto,64",
                 "--modes", "ao")
    assert done.returncode == 0, done.stderr
    found = [(entry["settings"]["grid"], entry["grid"]) for entry in stored(tmp_path)["points"]]
    assert found == [("auto", 128), (64, 64)]


@needs_program
def test_all_bounces_are_judged_against_the_full_light(tmp_path: Path):
    done = sweep(tmp_path, "--scenes", "cornell", "--sizes", "32x32", "--presets", "mobile")
    assert done.returncode == 0, done.stderr
    (entry,) = stored(tmp_path)["points"]
    assert entry["settings"]["grid"] == 64 and entry["light_frames"] > 0
    assert set(entry["errors"]) == {"indirect", "gi-full", "soft-full", "shadow", "ao"}
    assert 0 < entry["errors"]["soft-full"]["relmse"] < 1


@needs_program
def test_errors_are_of_the_frame_that_was_timed(tmp_path: Path):
    done = sweep(tmp_path, *SMALL, "--modes", "ao")
    assert done.returncode == 0, done.stderr
    (entry,) = stored(tmp_path)["points"]
    alone = tmp_path / "alone"
    subprocess.run([str(PROGRAM), "render", str(ROOT / "assets/cornell.glb"), "--out", str(alone), "--preset", "thesis",
                    "--grid", "64", "--size", "32x32", "--mode", "ao", "--light-parts", "--revoxelize", "--timings",
                    str(alone / "timings.json")], check=True, capture_output=True)
    picture = read_exr(alone / "ambient_occlusion.exr")
    truth = read_exr(ROOT / "references/cornell/ao.exr").reshape(32, 8, 32, 8, 3).mean((1, 3))
    assert entry["errors"]["ao"]["rmse"] == pytest.approx(float(np.sqrt(np.mean((picture - truth) ** 2))), rel=1e-6)


@needs_program
def test_a_picture_is_never_averaged_down(tmp_path: Path):
    done = sweep(tmp_path, *SMALL[:2], "--sizes", "512x512", "--presets", "mobile", "--modes", "ao")
    assert done.returncode == 0, done.stderr
    (entry,) = stored(tmp_path)["points"]
    assert entry["modes"]["ao"]["total"]["median"] > 0
    assert "references.py --size 512x512" in entry["errors"]["ao"]["missing"]


def test_the_key_follows_settings_program_and_scene():
    point, other = points([Path("a.glb")], defaults(grid=(64, 128), cone_angle_deg=(5.0,)), ("gi",))
    identity = {"program": "p", "scene_sha256": "s"}
    keys = {point.key(identity), other.key(identity), point.key(identity | {"program": "q"}),
            point.key(identity | {"scene_sha256": "t"})}
    assert len(keys) == 4
    assert point.key(identity) == point.key(dict(identity))


@needs_program
def test_times_and_errors_of_a_point(tmp_path: Path):
    done = sweep(tmp_path, *SMALL, "--cone-angles", "5")
    assert done.returncode == 0, done.stderr
    data = stored(tmp_path)
    (entry,) = data["points"]
    assert data["version"] == 2 and entry["status"] == "done"
    assert entry["settings"]["grid"] == 64 and entry["settings"]["size"] == "32x32"
    for mode in ("gi", "gi-cone-shadow", "ao"):
        total = entry["modes"][mode]["total"]
        assert 0 < total["min"] <= total["median"] <= total["max"] and len(total["samples"]) == 5
    assert entry["active_voxels"][-1] == 1 and entry["resources"]
    assert set(entry["errors"]) == {measure["name"] for measure in data["measures"]}
    for name, error in entry["errors"].items():
        assert 0 < error["relmse"] < 1, name
        assert error["noise_relmse"] < error["relmse"], name
    assert (tmp_path / entry["folder"] / "gi.exr").exists()
    assert "left" not in done.stderr and "[1/1]" in done.stderr


@needs_program
def test_a_second_run_keeps_what_is_finished_and_adds_the_rest(tmp_path: Path):
    assert sweep(tmp_path, *SMALL, "--cone-angles", "5", "--modes", "ao").returncode == 0
    (first,) = stored(tmp_path)["points"]
    done = sweep(tmp_path, *SMALL[:6], "--grids", "64,128", "--cone-angles", "5", "--modes", "ao")
    assert "2 points, 1 to render" in done.stderr
    entries = stored(tmp_path)["points"]
    assert entries[0] == first and [entry["settings"]["grid"] for entry in entries] == [64, 128]
    assert [entry["run"] for entry in entries] == [1, 2]


@needs_program
def test_new_references_are_measured_without_rendering(tmp_path: Path):
    sweep(tmp_path, *SMALL, "--modes", "ao", "--references", str(tmp_path / "none"))
    (entry,) = stored(tmp_path)["points"]
    assert entry["errors"]["ao"] == {"missing": "no reference ao"}
    done = sweep(tmp_path, *SMALL, "--modes", "ao")
    assert "0 to render" in done.stderr and "measured anew" in done.stderr
    (again,) = stored(tmp_path)["points"]
    assert again["errors"]["ao"]["rmse"] > 0 and again["modes"] == entry["modes"]


@needs_program
def test_a_reference_of_another_state_of_the_scene_is_not_used(tmp_path: Path):
    stale = tmp_path / "references" / "cornell"
    shutil.copytree(ROOT / "references" / "cornell", stale)
    about = json.loads((stale / "reference.json").read_text())
    (stale / "reference.json").write_text(json.dumps(about | {"scene_sha256": "0"}))
    sweep(tmp_path, *SMALL, "--modes", "ao", "--references", str(stale.parent))
    (entry,) = stored(tmp_path)["points"]
    assert "another state of the scene" in entry["errors"]["ao"]["missing"]


@needs_program
def test_a_failed_point_is_kept_with_its_message_and_tried_again(tmp_path: Path):
    # 100 is no size of a grid; the other point must not suffer.
    small = [*SMALL[:6], "--grids", "100,64", "--modes", "ao"]
    done = sweep(tmp_path, *small)
    assert done.returncode == 1 and "FAILED" in done.stderr
    bad, good = stored(tmp_path)["points"]
    assert bad["status"] == "failed" and "grid" in bad["message"] and good["status"] == "done"
    assert "2 points, 1 to render" in sweep(tmp_path, *small).stderr


@needs_program
def test_a_point_that_takes_too_long_is_a_failure(tmp_path: Path):
    sweep(tmp_path, *SMALL, "--modes", "ao", "--timeout", "0.01")
    (entry,) = stored(tmp_path)["points"]
    assert entry["status"] == "failed" and "0.01 s" in entry["message"]


@needs_program
def test_stopping_keeps_what_is_finished(tmp_path: Path):
    small = [*SMALL[:6], "--grids", "64,128,256", "--modes", "ao"]
    with subprocess.Popen(command(tmp_path, *small), stderr=subprocess.PIPE, text=True) as running:
        for line in running.stderr:
            if line.startswith("[1/3]"):
                running.send_signal(signal.SIGINT)
                break
        said = running.stderr.read()
        assert running.wait(timeout=30) == 130 and "continues" in said
    finished = len(stored(tmp_path)["points"])
    assert 1 <= finished < 3
    assert sweep(tmp_path, *small).returncode == 0
    assert [entry["status"] for entry in stored(tmp_path)["points"]] == ["done"] * 3


@pytest.mark.parametrize("arguments, said", [
    (["--grids", "many"], "--grids many"), (["--modes", "magic"], "unknown mode magic"),
    (["--scenes", "nowhere"], "no such scene"), (["--program", "/nowhere/vct"], "is not built")])
def test_a_bad_command_line_is_one_sentence(tmp_path: Path, arguments: list[str], said: str):
    done = sweep(tmp_path, *arguments)
    assert done.returncode != 0 and said in done.stderr and "Traceback" not in done.stderr
    assert not (tmp_path / "sweep.json").exists()
