"""tools/eval.py judge, with the real program and the real path tracer."""
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import time

import flip_evaluator
import numpy as np
import pytest
from PIL import Image

import files
import metrics
from conftest import ROOT, SceneMaker
from evaluation.judge import REFERENCE, hint, noise_notes
from truth.exr import read_exr, write_exr
from truth.hdr import read_sky

PICTURE = "pictures/render-scene-mobile/gi.exr"
COMMAND = [sys.executable, "-B", ROOT / "tools/eval.py", "judge"]


def judge(scene, out, *options):
    done = subprocess.run([*COMMAND, scene, "--out", out, "--size", "48x32", "--spp", "64", "--presets", "mobile", *options],
                          capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return done


def result(out):
    return json.loads((out / "results.json").read_text())["results"]["render-scene-mobile"]["result"]


def errors(out):
    return result(out)["camera"]["errors"]["gi"]


def fails(scene, out, *options):
    """What a run that must fail prints."""
    done = subprocess.run([*COMMAND, scene, "--out", out, "--size", "48x32", "--spp", "64", "--presets", "mobile", *options],
                          capture_output=True, text=True, check=False)
    assert done.returncode == 1 and "Traceback" not in done.stderr, done.stderr
    return done.stderr


def contents(folder):
    """Every file of a judged scene but results.json, by name."""
    return {path.relative_to(folder): path.read_bytes() for path in folder.rglob("*")
            if path.is_file() and path.name != "results.json"}


@pytest.fixture(scope="module")
def room(tmp_path_factory):
    """A floor, a wall behind it, and something between the two; neither camera nor light."""
    maker = SceneMaker(tmp_path_factory.mktemp("room"))
    grey = maker.grey(0.6)
    maker.quad((-1, 0, 1), (2, 0, 0), (0, 0, -2), grey)
    maker.quad((-1, 0, -1), (2, 0, 0), (0, 1.5, 0), grey)
    maker.quad((-0.3, 0, -0.2), (0.6, 0, 0), (0, 0.6, 0), maker.glb.material("red", (0.8, 0.1, 0.1)))
    maker.path.write_bytes(maker.glb.to_bytes())
    return maker.path


@pytest.fixture(scope="module")
def usual(program, room, tmp_path_factory):
    """The room judged without options: the folder, and what was printed."""
    out = tmp_path_factory.mktemp("usual")
    return out, judge(room, out)


def test_a_scene_without_camera_and_light_is_the_same_on_both_sides(usual):
    out, done = usual
    assert "the scene has no light of its own" in done.stdout and "camera: --camera eye=" in done.stdout
    assert abs(errors(out)["bias"]) < 0.08 and errors(out)["relmse"] < 0.05


def test_the_page_has_the_table_and_a_second_run_measures_nothing(usual, room):
    out, first = usual
    page = (out / "index.html").read_text()
    row = next(line for line in first.stdout.splitlines() if line.startswith("| scene | mobile"))
    assert all(f">{cell}<" in page for cell in row.strip("| ").split(" | ")) and "hint: the scene wants --grid " in page
    assert all((out / name).stat().st_size > 100 for name in re.findall(r'<img src="([^"]+)"', page))
    second = judge(room, out)
    assert second.stderr.count("unchanged") == 2 and second.stdout == first.stdout


@pytest.fixture(scope="module")
def shown(usual):
    """The picture of `mobile` and the path-traced one, as the page shows them: (height, width, 3), 0 to 255."""
    with Image.open(usual[0] / "page/scene.png") as page:
        assert page.mode == "RGB"
        cells = np.asarray(page)[40:, 16:]  # each is enlarged tenfold
    return [cells[5:320:10, 496 * i + 5:496 * i + 480:10] for i in (0, 1)]


def test_the_page_shows_what_vct_render_shows(program, usual, shown, room, tmp_path):
    picture, traced = shown
    with Image.open((usual[0] / PICTURE).with_suffix(".png")) as own:
        assert np.abs(np.asarray(own.convert("RGB")).astype(int) - picture).max() <= 1
    exact = 255 * metrics.displayed(read_exr(usual[0] / REFERENCE / "full.exr"), result(usual[0])["exposure"])
    assert np.abs(exact - traced).max() < 0.6, "colours of a palette are further away"
    # A sky of an option is its own background, so the file has all the light that the exposure is chosen for.
    done = subprocess.run([program, "render", room, "--out", tmp_path, "--mode", "gi", "--size", "48x32", "--sky", "1,1,1"],
                          capture_output=True, text=True, check=True)
    exposure = re.search(r"--exposure (\S+) repeats it", done.stderr)[1]
    assert metrics.automatic_exposure(read_exr(tmp_path / "gi.exr")) == pytest.approx(float(exposure))


def test_errors_are_those_of_surfaces_as_they_are_shown(usual, shown):
    out = usual[0]
    picture, traced = read_exr(out / PICTURE), read_exr(out / REFERENCE / "full.exr")
    surface = read_exr(out / REFERENCE / "coverage.exr")[..., 0] > 0
    assert 0.2 < surface.mean() < 0.8 and result(out)["surface"] == pytest.approx(surface.mean())
    assert result(out)["exposure"] == metrics.automatic_exposure(traced[surface])
    error = np.mean((picture - traced)[surface] ** 2 / (traced[surface] ** 2 + 0.01))
    assert errors(out)["relmse"] == pytest.approx(error, rel=1e-3)
    encoded = [np.ascontiguousarray(part / 255, np.float32) for part in (shown[1], shown[0])]
    flip = flip_evaluator.evaluate(*encoded, "LDR", applyMagma=False, parameters={"ppd": 67})[0]
    assert errors(out)["flip"] == pytest.approx(flip[surface].mean(), rel=0.03)


def test_voxels_that_are_asked_for_need_no_other_reference(usual, room, tmp_path):
    out = tmp_path / "copy"
    shutil.copytree(usual[0], out)
    done = judge(room, out, "--grid", "64")
    assert "reference: path-traced: unchanged" in done.stderr and done.stderr.count("unchanged") == 1
    assert "the scene wants" not in done.stdout
    assert result(out)["grid"] == 64


def test_notes_are_about_options_that_were_given(usual):
    assert "has no effect" not in usual[1].stdout


def test_hints_name_options_that_exist():
    assert hint("grid 64: voxels of 3 cm; less than") == "hint: the scene wants --grid 64: voxels of 3 cm; less than"
    nested = "grid 64, 3 cascades: voxels of 4.24 cm around the camera to 16.9 cm far from it"
    assert hint(nested) == f"hint: the scene wants --voxel-size 0.0428 ({nested})"


def test_noise_of_the_reference_is_named_if_it_is_a_large_part_of_an_error():
    one, other = ({"preset": preset, "noise": {"gi": noise}, "camera": {"errors": {"gi": {"relmse": 0.01}}}}
                  for preset, noise in (("mobile", 0.0045), ("quality", 0.0019)))
    assert noise_notes([other], 64) == []
    assert noise_notes([one, other], 64) == [
        "warning: the noise of the path-traced picture is 45 % of the relMSE of mobile; --spp 256 makes it a quarter"]


@pytest.mark.parametrize("options", [("--camera", "eye=1.5,1.2,1.5,target=0,0.3,0,fov=60"),
                                     ("--light", "direction=1,-1,-0.5,color=1,0.5,0.2,intensity=6", "--sky", "0.1,0.2,0.4"),
                                     ("--environment", "patio.exr")])
def test_options_reach_program_and_path_tracer(usual, room, tmp_path, options):
    if options[1] == "patio.exr":
        write_exr(tmp_path / "patio.exr", read_sky(ROOT / "assets/patio.hdr"))
        options = (options[0], str(tmp_path / options[1]))
    judge(room, tmp_path / "given", *options)
    assert errors(tmp_path / "given")["relmse"] < 0.05, "the two sides differ"
    for name in (f"{REFERENCE}/full.exr", PICTURE):
        before, after = read_exr(usual[0] / name), read_exr(tmp_path / "given" / name)
        assert ((after - before) ** 2 / (before ** 2 + 0.01)).mean() > 0.05, f"{name} ignores {options[0]}"


def test_emission_is_scaled_on_both_sides(program, maker, tmp_path):
    grey = maker.grey(0.6)
    for wall in (((-1, 0, 1), (2, 0, 0), (0, 0, -2)), ((-1, 0, -1), (2, 0, 0), (0, 1.5, 0)), ((-1, 0, 1), (0, 0, -2), (0, 1.5, 0)),
                 ((1, 0, -1), (0, 0, 2), (0, 1.5, 0)), ((-1, 1.5, -1), (2, 0, 0), (0, 0, 2))):
        maker.quad(*wall, grey)
    emitter = maker.glb.material("emitter", (0.5, 0.5, 0.5), emissive=((1, 1, 1), 2.0, None))
    maker.quad((-0.5, 1.4, -0.5), (1, 0, 0), (0, 0, 1), emitter)
    maker.path.write_bytes(maker.glb.to_bytes())
    judge(maker.path, tmp_path, "--camera", "eye=0,1,2.5,target=0,0.5,0,fov=50", "--emission", "3")
    assert abs(errors(tmp_path)["bias"]) < 0.1
    for name in (f"{REFERENCE}/full.exr", PICTURE):
        assert 3 * 2.0 < read_exr(tmp_path / name).max() < 3 * 4.0, name  # the camera sees the emitter, of radiance 2


def test_a_closed_room_has_the_same_lamp_on_both_sides(program, maker, tmp_path):
    grey, x, y, z = maker.grey(0.6), (4, 0, 0), (0, 2, 0), (0, 0, 3)
    for corner, u, v in (((0, 0, 0), z, x), ((0, 2, 0), x, z), ((0, 0, 0), x, y), ((4, 0, 3), (-4, 0, 0), y),
                         ((0, 0, 3), (0, 0, -3), y), ((4, 0, 0), z, y)):
        maker.quad(corner, u, v, grey)
    maker.path.write_bytes(maker.glb.to_bytes())
    assert "adds a point light" in judge(maker.path, tmp_path).stdout
    assert read_exr(tmp_path / REFERENCE / "full.exr").mean() > 0.2
    assert abs(errors(tmp_path)["bias"]) < 0.1 and errors(tmp_path)["relmse"] < 0.05


def test_options_are_checked_before_path_tracing(usual, room, tmp_path):
    occupied = tmp_path / "file"
    occupied.write_text("mine")
    before = contents(usual[0])
    for options, words in ((("--grid", "100"), "--grid: 100 not in"), (("--sky", "1,2"), "--sky: '1,2' is not three numbers"),
                           (("--sky", "white"), "--sky white: the path tracer takes radiance as R,G,B"),
                           (("--camera", "eye=0"), "--camera"), (("--emission", "nan"), "--emission"),
                           (("--light", "colour=1,1,1"), "--light: unknown"), (("--out", occupied), f"the folder {occupied}")):
        said = fails(room, usual[0], *options)
        assert words in said and "reference" not in said, said
    assert contents(usual[0]) == before and occupied.read_text() == "mine"


def test_a_run_that_fails_leaves_an_earlier_one_as_it_is(program, usual, room, tmp_path):
    out, broken = tmp_path / "copy", tmp_path / "broken.sh"
    shutil.copytree(usual[0], out)
    before = contents(out), result(out)
    assert "the camera sees no surface" in fails(room, out, "--camera", "eye=0,1,5,target=0,1,9")
    broken.write_text(f"#!/bin/sh\nfor word; do [ \"$word\" = --revoxelize ] && exit 1; done\nexec '{program}' \"$@\"\n")
    broken.chmod(0o755)
    assert "no page is written, because scene-mobile failed" in fails(room, out, "--program", broken)
    assert (contents(out), result(out)) == before
    assert judge(room, out).stderr.count("unchanged") == 2


def test_a_preset_that_fails_is_named_on_the_page_of_the_others(program, usual, room, tmp_path):
    out, broken = tmp_path / "copy", tmp_path / "broken.sh"
    shutil.copytree(usual[0], out)
    broken.write_text(f"#!/bin/sh\nfor word; do [ \"$word\" = thesis ] && {{ echo 'error: no voxels' >&2; exit 1; }}; done\n"
                      f"exec '{program}' \"$@\"\n")
    broken.chmod(0o755)
    done = subprocess.run([*COMMAND, room, "--out", out, "--size", "48x32", "--spp", "64", "--presets", "mobile,thesis", "--program",
                           broken], capture_output=True, text=True, check=False)
    assert done.returncode == 1 and "Traceback" not in done.stderr, done.stderr
    assert done.stderr.splitlines()[-1] == "error: 1 of 2 failed: scene-thesis (vct render ended with exit status 1: error: no voxels)"
    page = (out / "index.html").read_text()
    assert "no voxels" in page and "<td>mobile" in page and "earlier result" not in page


def test_help_needs_no_build_and_no_packages(tmp_path):
    shutil.copytree(ROOT / "tools", tmp_path / "tools", ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copytree(ROOT / "scripts", tmp_path / "scripts")
    (tmp_path / "scripts/setup.sh").write_text("exit 3\n")
    done = subprocess.run([tmp_path / "scripts/judge.sh", "--help"], capture_output=True, text=True, check=False,
                          env={"PATH": "/usr/bin:/bin"})
    assert done.returncode == 0 and "--environment" in done.stdout, done.stderr
    bare = [sys.executable, "-S", tmp_path / "tools/eval.py", "judge", "--help"]  # -S: without the packages of .venv
    assert subprocess.run(bare, capture_output=True, check=False).returncode == 0


def test_the_path_tracers_sources_are_part_of_a_references_key(tmp_path, monkeypatch):
    shutil.copytree(ROOT / "tools/truth", tmp_path / "tools/truth", ignore=shutil.ignore_patterns("__pycache__"))
    before = files.path_tracer_sha256()
    monkeypatch.setattr(files, "ROOT", tmp_path)
    assert files.path_tracer_sha256() == before
    with (tmp_path / "tools/truth/kinds.py").open("a") as source:
        source.write("# another\n")
    assert files.path_tracer_sha256() != before


def test_a_file_that_is_no_scene_is_one_clear_error(program, root, tmp_path):
    broken = tmp_path / "broken.glb"
    broken.write_bytes((root / "assets/contact.glb").read_bytes()[:2000])
    for scene, status in ((broken, 1), (tmp_path / "none.glb", 1)):
        done = subprocess.run([*COMMAND, scene, "--out", tmp_path / "out"], capture_output=True, text=True, check=False)
        assert done.returncode == status and scene.name in done.stderr and "Traceback" not in done.stderr, done.stderr


def test_whatever_takes_more_than_two_seconds_is_reported(root, tmp_path):
    slow = tmp_path / "slow.sh"
    slow.write_text("#!/bin/sh\nsleep 3\nexit 1\n")
    slow.chmod(0o755)
    said = fails(root / "assets/contact.glb", tmp_path / "judged", "--program", slow)
    *progress, error = said.splitlines()
    assert "  reading the scene: 2 s so far" in progress and error.startswith("error: "), said


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_stopping_is_one_line_and_ends_the_program(root, tmp_path, number):
    slow, out = tmp_path / "slow.sh", tmp_path / "judged"
    slow.write_text(f"#!/bin/sh\necho $$ >'{tmp_path}/begun'\nexec sleep 60\n")
    slow.chmod(0o755)
    running = subprocess.Popen([*COMMAND, root / "assets/contact.glb", "--program", slow, "--out", out],
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    for _ in range(600):
        if (tmp_path / "begun").is_file() or running.poll() is not None:
            break
        time.sleep(0.1)
    running.send_signal(number)
    said, error = running.communicate(timeout=60)
    error = [line for line in error.splitlines() if not line.endswith("s so far")]  # of a machine under load
    assert (running.returncode, said, error) == (128 + number, "", ["stopped; the same command continues"])
    assert not out.exists()
    with pytest.raises(ProcessLookupError):
        for _ in range(100):  # until it is reaped
            os.kill(int((tmp_path / "begun").read_text()), 0)
            time.sleep(0.1)
