"""tools/eval.py with the real program: pictures, motion and the page."""
import json
import re
import shutil
import subprocess
import sys
from urllib.parse import unquote, urlsplit

import numpy as np
import pytest
from PIL import Image

from conftest import ROOT
from evaluation import report
from evaluation.measures import MEASURES, References, averaged_down
from evaluation.pictures import CELL, GAP, HEAD
from evaluation.store import Store
from files import SCALED, Failed, reference_folder, scene_sha256, static_scenes
from truth.exr import read_exr


def evaluate(words, *more):
    command = [sys.executable, "-B", ROOT / "tools/eval.py", *words.split(), *map(str, more)]
    return subprocess.run(command, capture_output=True, text=True, check=False)


def results(folder):
    return {name: entry.get("result") for name, entry in json.loads((folder / "results.json").read_text())["results"].items()}


@pytest.fixture(scope="module")
def measured(program, tmp_path_factory):
    """A folder with a picture of a given grid, another one and a failed one, and its page."""
    folder = tmp_path_factory.mktemp("eval")
    done = evaluate("render cornell --presets thesis --grids 64 --size 32x32 --measures all --out", folder)
    assert done.returncode == 0, done.stderr
    done = evaluate("render contact --presets mobile --size 32x32 --out", folder, "--sheet", folder / "sheet.png")
    assert done.returncode == 0, done.stderr
    assert "| contact | mobile, 64³ | " in done.stdout and "[1/1] render: contact-mobile" in done.stderr
    data = json.loads((folder / "results.json").read_text())
    data["results"]["lag-broken"] = {"kind": "lag", "name": "broken", "key": {"build": None}, "failed": "no <light> & no sun"}
    (folder / "results.json").write_text(json.dumps(data))
    assert evaluate("report --out", folder).returncode == 0
    return folder


def test_errors_are_those_of_the_pictures_at_their_own_size(measured):
    one = results(measured)["render-cornell-thesis-64"]
    assert one["grid"] == 64 and set(one["camera"]["errors"]) == set(MEASURES)
    truth = read_exr(ROOT / "references/cornell/ao.exr").reshape(32, 8, 32, 8, 3).mean((1, 3))
    for state, folder in (("camera", "."), ("changing", "changing")):
        assert all(0 < ms < 10000 for ms in one[state]["ms"].values())
        picture = read_exr(measured / "pictures/render-cornell-thesis-64" / folder / "ambient_occlusion.exr")
        assert one[state]["errors"]["ao"]["rmse"] == pytest.approx(float(np.sqrt(np.mean((picture - truth) ** 2))), rel=1e-6)
        for name in ("gi", "indirect", "soft"):
            assert one["noise"][name] < one[state]["errors"][name]["relmse"] < 1
    assert one["camera"]["ms"]["gi"] < one["changing"]["ms"]["gi"]
    assert 0 < results(measured)["render-contact-mobile"]["camera"]["errors"]["indirect"]["relmse"] < 0.02


def test_a_camera_has_a_row_and_a_reference_of_its_own(program, tmp_path):
    done = evaluate("render town --cameras court --measures gi --presets mobile --size 32x32 --out", tmp_path)
    assert done.returncode == 0, done.stderr
    assert "| town-court | mobile, 64³ | " in done.stdout
    assert results(tmp_path)["render-town-court-mobile"]["reference"] == "references/town-court/full.exr"
    done = evaluate("render cornell --cameras side --presets mobile --out", tmp_path)
    assert done.returncode == 1 and "references assets/cornell.glb --cameras side" in done.stderr


def test_numbers_of_cascades_have_rows_and_pictures_of_their_own(measured, tmp_path):
    folder = shutil.copytree(measured, tmp_path / "with one cascade")
    done = evaluate("render contact --presets mobile --cascades 1,2 --size 32x32 --out", folder, "--sheet", tmp_path / "two.png")
    assert done.returncode == 0, done.stderr
    assert "| contact | mobile, 64³ | " in done.stdout and "| contact | mobile, 64³, 2 cascades | " in done.stdout
    one, two = (results(folder)[f"render-contact-mobile{more}"] for more in ("", "-2-cascades"))
    assert (one["cascades"], two["cascades"]) == (1, 2)
    assert two["camera"]["errors"]["gi"]["relmse"] != one["camera"]["errors"]["gi"]["relmse"]
    sheet = np.asarray(Image.open(tmp_path / "two.png"))[HEAD:HEAD + CELL, GAP:]
    first, second = sheet[:, :CELL], sheet[:, CELL + GAP:2 * CELL + GAP]
    assert (first != second).any()
    done = evaluate("render cornell --presets thesis --cascades 2 --size 32x32 --out", tmp_path / "thesis")
    assert done.returncode == 1 and "cascades do not work with the preset thesis" in done.stderr


def test_a_scene_of_any_name_has_its_picture_on_the_page(tmp_path):
    address = re.search('src="([^"]*)"', report.picture(Store(tmp_path), '50% "off" #2', b"drawn"))[1]
    assert (tmp_path / unquote(urlsplit(address).path)).read_bytes() == b"drawn"


def test_a_reference_of_another_scene_or_size_is_refused(tmp_path):
    for scene in static_scenes() + [ROOT / f"assets/{name}.glb" for name in SCALED]:
        assert References(scene).size == (256, 256)
    scene = tmp_path / "cornell.glb"
    scene.write_bytes((ROOT / "assets/contact.glb").read_bytes())
    with pytest.raises(Failed, match="another version.*eval.py references"):
        References(scene)
    with pytest.raises(Failed, match="no references.*eval.py references"):
        References(tmp_path / "mine.glb")
    picture = np.zeros((256, 256, 3))
    for size in ((512, 512), (96, 96), (64, 32)):
        with pytest.raises(Failed, match="whole multiple"):
            averaged_down(picture, size)
    assert reference_folder(scene).name == "cornell"


def test_files_that_a_scene_names_are_part_of_its_hash(tmp_path):
    (tmp_path / "a b").mkdir()
    scene = tmp_path / "scene.gltf"
    buffers, images = [{"uri": "a%20b/part%201.bin"}, {"uri": "data:;base64,AA=="}], [{"uri": "%C3%A9.png"}, {"bufferView": 0}]
    scene.write_text(json.dumps({"asset": {"version": "2.0"}, "buffers": buffers, "images": images}))
    hashes = {scene_sha256(scene)}
    for name in ("a b/part 1.bin", "é.png"):
        (tmp_path / name).write_bytes(b"two")
        hashes.add(scene_sha256(scene))
    assert len(hashes) == 3


def test_the_headline_has_the_errors_of_still_pictures(program, tmp_path):
    """A frame of one sample has jagged edges, which are a part of its error."""
    errors = {}
    for name, option in (("still", "--headline"), ("frame", "--measures gi")):
        done = evaluate(f"render contact {option} --presets thesis --size 64x64 --out", tmp_path / name)
        assert done.returncode == 0, done.stderr
        errors[name] = results(tmp_path / name)["render-contact-thesis"]["camera"]["errors"]["gi"]["relmse"]
    assert errors["still"] < 0.9 * errors["frame"]


def test_lag_compares_a_sequence_with_converged_pictures(program, tmp_path):
    done = evaluate("motion lag --presets mobile --scenes moving --frames 20 --every 19 --size 32x32 --out", tmp_path)
    assert done.returncode == 0, done.stderr
    first, last = results(tmp_path)["lag-moving-mobile"]["frames"]
    assert first["relmse"] < 1e-4 < last["relmse"] < 0.1, "a sequence starts with the converged light of its first moment"


def test_dynamic_tells_the_cost_of_each_change(program, tmp_path):
    done = evaluate("motion dynamic --presets thesis --frames 3 --repeat 1 --size 32x32 --out", tmp_path)
    assert done.returncode == 0, done.stderr
    rows = [line for line in done.stdout.splitlines() if line.endswith("% |")]
    everything, camera, *changes = (float(row.split(" | ")[-1].strip(" |%")) for row in rows)
    assert everything == 100 and camera < 15 < min(changes) and len(changes) == 3


@pytest.mark.parametrize("words, status, said", [
    ("rendr", 2, "invalid choice: 'rendr'"), ("render nowhere", 1, "there is no scene 'nowhere'"),
    ("render --presets best", 2, "unknown preset 'best'"), ("render --grids 100", 2, "unknown grid '100'"),
    ("render --cascades 1,0", 2, "'0' is not a whole number of 1 or more"),
    ("render cornell --program /nowhere/vct", 1, "scripts/build.sh desktop vct"),
    ("motion --frames 0", 2, "1 or more"), ("report", 1, "no results yet"), ("mali --compiler /nowhere/mali", 1, "drm_shim")])
def test_a_bad_command_line_is_one_clear_error(tmp_path, words, status, said):
    done = evaluate(words, *(["--out", tmp_path] if status == 1 else []))
    assert done.returncode == status and said in done.stderr and "Traceback" not in done.stderr, done.stderr
    assert list(tmp_path.iterdir()) == []


def test_a_program_that_crashes_is_a_failure(tmp_path):
    crashing = tmp_path / "crashing"
    crashing.write_text("#!/bin/sh\nkill -SEGV $$\n")
    crashing.chmod(0o755)
    done = evaluate("motion dynamic --presets mobile --program", crashing, "--out", tmp_path / "out")
    assert done.returncode == 1 and "vct render ended with signal 11" in done.stderr
