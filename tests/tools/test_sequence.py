"""tools/sequence.py: moments of one run against still pictures of each moment."""
from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from sequence import flip
from truth.exr import write_exr


def test_the_moments_are_near_still_pictures_and_are_not_all_the_same(program, root, tmp_path):
    done = subprocess.run([sys.executable, str(root / "tools/sequence.py"), "--program", program, "--out", str(tmp_path),
                           "--frames", "2", "--seconds", "0.5"], check=True, capture_output=True, text=True)
    frames = json.loads((tmp_path / "sequence.json").read_text())["frames"]
    assert [frame["time_s"] for frame in frames] == pytest.approx([0, 8 / 30])
    assert frames[0]["flip"] < 1e-4  # A sequence begins with light that has converged.
    assert 1e-3 < frames[1]["flip"] < 0.2
    mean = (frames[0]["flip"] + frames[1]["flip"]) / 2
    assert f"2 moments differ from still pictures by a mean FLIP of {mean:.4f}" in done.stdout
    for kind in ("picture", "indirect_light"):
        first, second = (np.asarray(Image.open(tmp_path / frame[kind]), float) for frame in frames)
        assert np.abs(first - second).mean() > 0.3, kind
    assert Image.open(tmp_path / "sheet.png").size == (480, 480)


def test_a_difference_is_found(tmp_path: Path):
    picture = np.full((16, 16, 3), 0.5, np.float32)
    write_exr(tmp_path / "a.exr", picture)
    picture[4:12, 4:12, 0] = 0.9
    write_exr(tmp_path / "b.exr", picture)
    assert flip(tmp_path / "a.exr", tmp_path / "a.exr") == pytest.approx(0, abs=1e-6)
    assert flip(tmp_path / "a.exr", tmp_path / "b.exr") > 0.02


def test_a_scene_that_stands_still_is_one_error(program, root, tmp_path):
    done = subprocess.run([sys.executable, str(root / "tools/sequence.py"), "--program", program, "--out", str(tmp_path),
                           "--scene", str(root / "assets/cornell.glb")], capture_output=True, text=True, check=False)
    assert done.returncode == 1
    assert done.stderr.startswith("error: assets/cornell.glb is not rendered: ") and "Traceback" not in done.stderr
