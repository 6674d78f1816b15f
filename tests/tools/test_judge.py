"""tools/judge.py, with the real program and the real path tracer."""
import base64
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import time

import numpy as np
import pytest
from PIL import Image

import files
import judge as judge_tool
from conftest import ROOT
from report.pictures import error_scale_png
from truth.exr import read_exr, write_exr
from truth.hdr import read_sky

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
    assert "hint: the scene wants --grid " in first.stdout and "hint: the scene wants --grid " in page
    other = judge(program, root / "assets/contact.glb", out, "--grid", "128")
    assert other.stderr.count("unchanged") == 1, "another grid needs no other reference"
    assert "mobile, 128^3" in other.stdout
    stored = json.loads((out / "reference.json").read_text())
    stored["key"]["path_tracer"] = "another"
    (out / "reference.json").write_text(json.dumps(stored))
    again = judge(program, root / "assets/contact.glb", out, "--grid", "128")
    assert "path tracing, 64 samples per pixel: unchanged" not in again.stderr, "another path tracer draws other references"


def test_what_the_path_tracer_is_made_of_counts(tmp_path, monkeypatch):
    shutil.copytree(ROOT / "tools/truth", tmp_path / "tools/truth", ignore=shutil.ignore_patterns("__pycache__"))
    before = files.path_tracer_sha256()
    monkeypatch.setattr(files, "ROOT", tmp_path)
    assert files.path_tracer_sha256() == before
    with (tmp_path / "tools/truth/kinds.py").open("a") as source:
        source.write("# another\n")
    assert files.path_tracer_sha256() != before


def test_files_that_a_scene_names_in_any_spelling_count(tmp_path):
    (tmp_path / "a b").mkdir()
    for name in ("a b/part 1.bin", "é.png"):
        (tmp_path / name).write_bytes(b"one")
    scene = tmp_path / "scene.gltf"
    inside = "data:;base64," + base64.b64encode(b"one").decode()
    scene.write_text(json.dumps({"asset": {"version": "2.0"}, "buffers": [{"uri": "a%20b/part%201.bin"}, {"uri": inside}],
                                 "images": [{"uri": "%C3%A9.png"}, {"bufferView": 0}]}))
    hashes = {judge_tool.scene_sha256(scene)}
    for name in ("a b/part 1.bin", "é.png"):
        (tmp_path / name).write_bytes(b"two")
        hashes.add(judge_tool.scene_sha256(scene))
    assert len(hashes) == 3


def test_the_countdown_says_how_much_is_left(capsys, monkeypatch):
    now = [100.0]
    monkeypatch.setattr(judge_tool.time, "monotonic", lambda: now[0])
    countdown = judge_tool.Countdown(400)
    for count, seconds in ((50, 1), (50, 9), (150, 15), (150, 15)):
        now[0] += seconds
        countdown.tell(count)
    assert capsys.readouterr().err.splitlines() == ["  25 %, about 30 s to go", "  62 %, about 15 s to go"]


def test_the_colour_bar_has_the_colours_of_errors(tmp_path):
    (tmp_path / "scale.png").write_bytes(error_scale_png(256))
    bar = np.asarray(Image.open(tmp_path / "scale.png").convert("RGB")).astype(int)[8:-8, 5]
    assert len(bar) == 256
    for row, colour in ((0, (255, 255, 0)), (64, (255, 0, 0)), (127, (0, 0, 0)), (191, (0, 0, 255)), (255, (0, 255, 255))):
        assert np.abs(bar[row] - colour).max() < 16, row


def test_a_scene_without_camera_and_light_is_the_same_on_both_sides(program, room, tmp_path):
    out = tmp_path / "judged"
    done = judge(program, room, out)
    assert done.returncode == 0, done.stderr
    assert "the scene has no light of its own" in done.stdout and "camera: --camera eye=" in done.stdout
    assert abs(judged(out)["bias"]) < 0.08 and judged(out)["relmse"] < 0.05


@pytest.mark.parametrize("options", [("--camera", "eye=1.5,1.2,1.5,target=0,0.3,0,fov=60"),
                                     ("--light", "direction=1,-1,-0.5,color=1,0.5,0.2,intensity=6", "--sky", "0.1,0.2,0.4"),
                                     ("--environment", str(ROOT / "assets/patio.hdr")),
                                     ("--environment", "patio.exr")])
def test_options_reach_program_and_path_tracer(program, room, tmp_path, options):
    usual, given = tmp_path / "usual", tmp_path / "given"
    if options[1] == "patio.exr":
        write_exr(tmp_path / "patio.exr", read_sky(ROOT / "assets/patio.hdr"))
        options = (options[0], str(tmp_path / options[1]))
    assert judge(program, room, usual).returncode == 0
    done = judge(program, room, given, *options)
    assert done.returncode == 0, done.stderr
    assert judged(given)["relmse"] < 0.05, "the two sides differ"
    for name in ("reference.exr", "mobile/gi.exr"):
        before, after = read_exr(usual / name), read_exr(given / name)
        assert ((after - before) ** 2 / (before ** 2 + 0.01)).mean() > 0.05, f"{name} does not know {options[0]}"


@pytest.mark.parametrize("emission", ["3", "0"])
def test_emission_is_scaled_on_both_sides(program, maker, tmp_path, emission):
    grey = maker.grey(0.6)
    maker.quad((-1, 0, 1), (2, 0, 0), (0, 0, -2), grey)
    maker.quad((-1, 0, -1), (2, 0, 0), (0, 1.5, 0), grey)
    maker.quad((-1, 0, 1), (0, 0, -2), (0, 1.5, 0), grey)
    maker.quad((1, 0, -1), (0, 0, 2), (0, 1.5, 0), grey)
    maker.quad((-1, 1.5, -1), (2, 0, 0), (0, 0, 2), grey)
    maker.quad((-0.5, 1.4, -0.5), (1, 0, 0), (0, 0, 1), maker.glb.material("lamp", (0.5, 0.5, 0.5), emissive=((1, 1, 1), 2.0, None)))
    maker.path.write_bytes(maker.glb.to_bytes())
    usual, given = tmp_path / "usual", tmp_path / "given"
    options = ("--camera", "eye=0,1,2.5,target=0,0.5,0,fov=50")
    assert judge(program, maker.path, usual, *options).returncode == 0
    done = judge(program, maker.path, given, *options, "--emission", emission)
    assert done.returncode == 0, done.stderr
    assert ("the scene has no light of its own" in done.stdout) == (emission == "0")
    if emission == "0":
        assert abs(judged(given)["bias"]) < 0.1
    else:
        assert judged(given)["bias"] == pytest.approx(judged(usual)["bias"], abs=0.02)
        for name in ("reference.exr", "mobile/gi.exr"):
            assert read_exr(given / name).mean() == pytest.approx(3 * read_exr(usual / name).mean(), rel=0.02), name


def test_a_compiler_for_mali_that_is_none_is_said_and_the_rest_stays(program, room, tmp_path):
    out = tmp_path / "judged"
    done = judge(program, room, out, "--mali-compiler", "/bin/false")
    assert done.returncode == 1 and "error: bounds for a Mali-T880: /bin/false printed no counts" in done.stderr, done.stderr
    assert "| mobile, 64^3" in done.stdout and (out / "index.html").is_file()


def test_a_bound_for_a_mali_where_its_compiler_is_there(program, room, tmp_path):
    compiler = os.environ.get("VCT_MALI_COMPILER")
    if not compiler:
        pytest.skip("VCT_MALI_COMPILER does not name Mesa's compiler for Mali (tools/mali.py --help)")
    out = tmp_path / "judged"
    done = judge(program, room, out, "--mali-compiler", compiler)
    assert done.returncode == 0, done.stderr
    camera, changing = map(float, re.search(r"^\| mobile.* (\S+) \| (\S+) \|$", done.stdout, re.MULTILINE).groups())
    assert 0 < camera < changing < 20
    assert "Mali-T880, all changing, ms" in (out / "index.html").read_text()


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


def test_stopping_at_the_first_call_is_one_line(program, root, tmp_path):
    """The program is the real one behind a shell that takes its time."""
    slow, out = tmp_path / "slow.sh", tmp_path / "judged"
    slow.write_text(f"#!/bin/sh\ntouch '{tmp_path}/begun'\nsleep 5\nexec '{program}' \"$@\"\n")
    slow.chmod(0o755)
    running = subprocess.Popen([sys.executable, "-B", ROOT / "tools/judge.py", root / "assets/contact.glb", "--program", slow, "--out", out],
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    for _ in range(600):
        if (tmp_path / "begun").is_file() or running.poll() is not None:
            break
        time.sleep(0.1)
    running.send_signal(signal.SIGINT)
    said, error = running.communicate(timeout=60)
    assert (running.returncode, said, error) == (130, "", "stopped\n")
    assert not out.exists()
