"""tools/judge.py, with the real program and the real path tracer."""
import json
import re
import signal
import subprocess
import sys
import time

import pytest

from conftest import ROOT
from truth.exr import read_exr

SMALL = ("--size", "48x32", "--spp", "64", "--presets", "mobile")


def judge(program, scene, out, *options):
    return subprocess.run([sys.executable, "-B", ROOT / "tools/judge.py", scene, "--program", program, "--out", out, *SMALL, *options],
                          capture_output=True, text=True, check=False)


def judged(out):
    return json.loads((out / "mobile" / "judged.json").read_text())["result"]


@pytest.fixture
def room(maker):
    """A floor, a wall behind it, and something between the two; neither camera nor light."""
    grey = maker.grey(0.6)
    maker.quad((-1, 0, 1), (2, 0, 0), (0, 0, -2), grey)
    maker.quad((-1, 0, -1), (2, 0, 0), (0, 1.5, 0), grey)
    maker.quad((-0.3, 0, -0.2), (0.6, 0, 0), (0, 0.6, 0), maker.glb.material("red", (0.8, 0.1, 0.1)))
    maker.path.write_bytes(maker.glb.to_bytes())
    return maker.path


def test_the_page_holds_what_the_table_says_and_a_second_run_makes_nothing(program, root, tmp_path):
    out = tmp_path / "judged"
    first = judge(program, root / "assets/contact.glb", out)
    assert first.returncode == 0, first.stderr
    page = (out / "index.html").read_text()
    row = next(line for line in first.stdout.splitlines() if line.startswith("| mobile"))
    for cell in row.strip("| ").split(" | "):
        assert cell in page, cell
    for name in re.findall(r'<img src="([^"]+)"', page):
        assert (out / name).stat().st_size > 100, name
    picture = (out / "mobile/gi.exr").stat().st_mtime_ns
    second = judge(program, root / "assets/contact.glb", out)
    assert second.stderr.count("unchanged") == 2 and (out / "mobile/gi.exr").stat().st_mtime_ns == picture
    assert second.stdout == first.stdout
    other = judge(program, root / "assets/contact.glb", out, "--grid", "128")
    assert other.stderr.count("unchanged") == 1, "another grid needs no other reference"
    assert "mobile, 128^3" in other.stdout


def test_a_scene_without_camera_and_light_is_the_same_on_both_sides(program, room, tmp_path):
    out = tmp_path / "judged"
    done = judge(program, room, out)
    assert done.returncode == 0, done.stderr
    assert "nothing in the scene shines" in done.stdout and "camera: --camera eye=" in done.stdout
    assert abs(judged(out)["bias"]) < 0.08 and judged(out)["relmse"] < 0.05


@pytest.mark.parametrize("options", [("--camera", "eye=1.5,1.2,1.5,target=0,0.3,0,fov=60"),
                                     ("--light", "direction=1,-1,-0.5,color=1,0.5,0.2,intensity=6", "--sky", "0.1,0.2,0.4"),
                                     ("--environment", str(ROOT / "assets/patio.hdr"))])
def test_options_reach_program_and_path_tracer(program, room, tmp_path, options):
    usual, given = tmp_path / "usual", tmp_path / "given"
    assert judge(program, room, usual).returncode == 0
    done = judge(program, room, given, *options)
    assert done.returncode == 0, done.stderr
    assert judged(given)["relmse"] < 0.05, "the two sides differ"
    for name in ("reference.exr", "mobile/gi.exr"):
        before, after = read_exr(usual / name), read_exr(given / name)
        assert ((after - before) ** 2 / (before ** 2 + 0.01)).mean() > 0.05, f"{name} does not know {options[0]}"


def test_a_file_that_is_no_scene_is_said(program, root, tmp_path):
    broken = tmp_path / "broken.glb"
    broken.write_bytes((root / "assets/contact.glb").read_bytes()[:2000])
    done = judge(program, broken, tmp_path / "out")
    assert done.returncode == 1 and "broken.glb" in done.stderr and "Traceback" not in done.stderr, done.stderr
    assert judge(program, tmp_path / "none.glb", tmp_path / "out").returncode == 2
    assert judge(program, broken, tmp_path / "out", "--presets", "best").returncode == 2


def test_stopping_keeps_what_is_done(program, root, tmp_path):
    out = tmp_path / "judged"
    running = subprocess.Popen([sys.executable, "-B", ROOT / "tools/judge.py", root / "assets/contact.glb", "--program", program, "--out", out,
                                *SMALL[:4], "--presets", "thesis,quality"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    for _ in range(600):
        if (out / "thesis/judged.json").is_file() or running.poll() is not None:
            break
        time.sleep(0.1)
    running.send_signal(signal.SIGINT)
    running.communicate(timeout=60)
    assert running.returncode == 130
    page = (out / "index.html").read_text()
    assert "Missing: </b>quality" in page and "thesis, 256^3" in page
