"""tools/sequence.py: moments of one run against runs of each moment."""
from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from sequence import difference
from truth.exr import write_exr


def test_the_moments_are_those_of_fresh_runs_and_are_not_all_the_same(program, root, tmp_path):
    done = subprocess.run([sys.executable, str(root / "tools/sequence.py"), "--program", program, "--out", str(tmp_path),
                           "--frames", "2", "--seconds", "2"], check=True, capture_output=True, text=True)
    assert "2 moments differ from fresh renders by 0" in done.stdout
    frames = json.loads((tmp_path / "sequence.json").read_text())["frames"]
    assert [frame["time_s"] for frame in frames] == [0, 1]
    for kind in ("picture", "indirect_light"):
        first, second = (np.asarray(Image.open(tmp_path / frame[kind]), float) for frame in frames)
        assert np.abs(first - second).mean() > 1, kind
    assert Image.open(tmp_path / "sheet.png").size == (480, 480)


def test_a_difference_is_found_and_is_of_the_brightest(tmp_path: Path):
    picture = np.full((4, 4, 3), 2.0, np.float32)
    write_exr(tmp_path / "a.exr", picture)
    picture[1, 2, 0] = 2.5
    write_exr(tmp_path / "b.exr", picture)
    assert difference(tmp_path / "a.exr", tmp_path / "a.exr") == 0
    assert difference(tmp_path / "a.exr", tmp_path / "b.exr") == pytest.approx(0.2)


def test_a_scene_that_stands_still_is_one_error(program, root, tmp_path):
    done = subprocess.run([sys.executable, str(root / "tools/sequence.py"), "--program", program, "--out", str(tmp_path),
                           "--scene", str(root / "assets/cornell.glb")], capture_output=True, text=True, check=False)
    assert done.returncode == 1
    assert done.stderr.startswith("error: assets/cornell.glb is not rendered: ") and "Traceback" not in done.stderr
