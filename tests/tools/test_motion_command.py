"""tools/motion.py: the scenes that it makes, and small runs of the command."""
from __future__ import annotations

import json
import math
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from motion import changed_scenes
from motion.geometry import MOVES
from truth.gltf_file import GltfFile
from truth.scene import load_scene, local_transform


def towards(path: Path) -> list[tuple[float, np.ndarray]]:
    """The keys of a scene's light: time, and where it comes from."""
    file = GltfFile(path)
    sampler = file.json["animations"][-1]["samplers"][0]
    times, turns = (file.accessor(sampler[end]) for end in ("input", "output"))
    return [(float(time[0]), local_transform({"rotation": turn.tolist()})[:3, 2]) for time, turn in zip(times, turns)]


def test_the_sun_goes_once_around(root, tmp_path):
    keys = towards(changed_scenes.light_once_around(root / "assets/contact.glb", tmp_path / "a.glb"))
    sun = load_scene(root / "assets/contact.glb").sun.towards
    azimuth = np.unwrap([math.atan2(-way[2], way[0]) for _, way in keys])
    np.testing.assert_allclose(azimuth - azimuth[0], np.linspace(0, 2 * math.pi, len(keys)), atol=1e-5)
    np.testing.assert_allclose([way[1] for _, way in keys], sun[1], atol=1e-5)
    assert keys[0][0] == 0 and keys[-1][0] == 10
    np.testing.assert_allclose(keys[0][1], sun, atol=1e-5)


def test_a_light_that_is_off_cannot_move(root):
    assert changed_scenes.has_sun(root / "assets/cornell.glb")
    assert not changed_scenes.has_sun(root / "assets/lamp.glb")


def test_a_lamp_is_no_sun(root):
    assert not changed_scenes.has_sun(root / "assets/night.glb")


def motion(program: str, out: Path, *more: str) -> subprocess.CompletedProcess[str]:
    root = Path(__file__).resolve().parents[2]
    return subprocess.run([sys.executable, str(root / "tools/motion.py"), "--program", program, "--out", str(out), "--presets",
                           "mobile", *more], capture_output=True, text=True, check=False)


def test_a_small_run_has_its_numbers_and_the_next_one_adds_to_them(program, tmp_path):
    done = motion(program, tmp_path, "--parts", "swim", "--scenes", "contact", "--frames", "1", "--size", "96x96")
    assert done.returncode == 0, done.stderr
    (entry,) = json.loads((tmp_path / "motion.json").read_text())["swim"]["contact"].values()
    assert 0 < entry["rms"] < entry["p99"] < 1 and set(entry["moves"]) == set(MOVES)
    assert entry["floor"]["rms"] < 0.005 and entry["carried"] > 0.8
    assert "| contact |" in done.stdout

    done = motion(program, tmp_path, "--parts", "lag", "--scenes", "contact,moving", "--lag-frames", "20", "--every", "19",
                  "--size", "96x96")
    assert done.returncode == 0, done.stderr
    data = json.loads((tmp_path / "motion.json").read_text())
    assert data["swim"]["contact"]["mobile"] == entry and set(data["lag"]) == {"contact, sun", "moving"}
    for of_scene in data["lag"].values():
        first, last = of_scene["mobile"]["frames"]
        assert (first["frame"], last["frame"]) == (0, 19)
        assert first["relmse"] < 1e-4  # a sequence starts with the light of its first moment
        assert last["relmse"] < 0.1 and of_scene["mobile"]["mean"]["relmse"] == last["relmse"]


@pytest.mark.parametrize("arguments, said", [
    (["--parts", "sink"], "sink"), (["--scenes", "nowhere"], "nowhere"), (["--frames", "0"], "1 or more")])
def test_a_bad_command_line_is_one_sentence(tmp_path: Path, arguments: list[str], said: str):
    done = motion("/nowhere/vct", tmp_path, *arguments)
    assert done.returncode != 0 and said in done.stderr and "Traceback" not in done.stderr


def test_a_run_that_fails_is_kept_with_what_was_said(program, tmp_path):
    done = motion(program, tmp_path, "--parts", "swim", "--scenes", "contact", "--presets", "magic")
    assert done.returncode == 1 and "magic" in done.stderr and "Traceback" not in done.stderr
    data = json.loads((tmp_path / "motion.json").read_text())
    assert "magic" in data["swim"]["contact"]["magic"]["failed"] and "failed" in done.stdout
