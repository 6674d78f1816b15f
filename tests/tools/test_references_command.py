"""tools/eval.py references, and the stored references."""
import hashlib
import json
import subprocess
import sys

import numpy as np
import pytest

from evaluation import references
from files import ROOT, reference_folder, static_scenes
from scenes import shapes
from truth.exr import read_exr
from truth.scene import load_scene

STORED = sorted((ROOT / "references").glob("*/reference.json"))


def run(*arguments):
    return subprocess.run([sys.executable, ROOT / "tools/eval.py", "references", *map(str, arguments)],
                          capture_output=True, text=True, check=False)


def test_two_runs_give_the_same_bytes_and_a_changed_one_is_found(tmp_path):
    options = (ROOT / "assets/courtyard.glb", "--size", "24x16", "--spp", "4", "--out", tmp_path)
    made = run(*options)
    assert made.returncode == 0, made.stderr
    folder = tmp_path / "courtyard"
    assert {p.stem for p in folder.glob("*.exr")} == set(references.KINDS)
    assert not list(folder.glob("*.tmp"))
    again = run(*options, "--check")
    assert again.returncode == 0 and "bit for bit" in again.stdout, again.stdout + again.stderr

    data = bytearray((folder / "full.exr").read_bytes())
    data[-1] ^= 1
    (folder / "full.exr").write_bytes(data)
    changed = run(*options, "--check", "--kinds", "direct,full")
    assert changed.returncode == 1 and "differs: full.exr (" in changed.stdout


def test_each_camera_has_references_of_its_own(program, tmp_path):
    scene, options = ROOT / "assets/courtyard.glb", ("--size", "24x16", "--spp", "4", "--kinds", "coverage,full", "--out", tmp_path)
    assert run(scene, *options).returncode == 0
    made = run(scene, "--cameras", "gate,corner", *options)
    assert made.returncode == 0, made.stderr
    first, gate, corner = (read_exr(tmp_path / name / "full.exr") for name in ("courtyard", "courtyard-gate", "courtyard-corner"))
    np.testing.assert_allclose(gate.mean(), first.mean(), rtol=1e-3)  # the first camera, by name
    assert np.abs(corner - first).mean() > 0.05 * first.mean()
    assert json.loads((tmp_path / "courtyard-corner/reference.json").read_text())["camera"]["name"] == "corner"
    wrong = run(scene, "--cameras", "roof", *options)
    assert wrong.returncode == 1 and "roof" in wrong.stderr and "Traceback" not in wrong.stderr


def test_every_camera_of_the_town_has_references():
    for camera in ("street", "court", "interior", "stairs"):
        assert (reference_folder(ROOT / "assets/town.glb", camera=camera) / "reference.json").is_file(), camera


@pytest.mark.parametrize("arguments, words", [
    (["missing.glb"], "no scene 'missing.glb'"),
    (["a.glb", "--size", "0x4"], "0x4"),
    (["a.glb", "--spp", "3"], "even number"),
    (["a.glb", "--kinds", "direct,gloss"], "gloss"),
])
def test_bad_arguments_are_one_clear_error(arguments, words, tmp_path):
    done = run(*arguments, "--out", tmp_path)
    assert done.returncode != 0 and words in done.stderr and "Traceback" not in done.stderr
    assert list(tmp_path.iterdir()) == []


def test_a_scene_without_a_camera_is_one_clear_error(tmp_path):
    (tmp_path / "a.gltf").write_text('{"asset": {"version": "2.0"}}')
    done = run(tmp_path / "a.gltf", "--out", tmp_path / "out")
    assert done.returncode == 1 and "camera" in done.stderr and "Traceback" not in done.stderr


def test_every_static_scene_has_references():
    for scene in static_scenes():
        assert (reference_folder(scene) / "reference.json").is_file(), scene.name


@pytest.mark.parametrize("path", STORED, ids=lambda p: p.parent.name)
def test_a_stored_reference_is_of_the_scene_as_it_is_now(path):
    facts = json.loads(path.read_text())
    scene = ROOT / "assets" / facts["scene"]
    assert hashlib.sha256(scene.read_bytes()).hexdigest() == facts["scene_sha256"]
    loaded = load_scene(scene)
    gloss = {"glossy"} if scene.stem == "glossy" else set()
    large = scene.stem == "town"  # all bounces alone, of several cameras
    assert "full" in facts["kinds"] if large else set(facts["kinds"]) == {*references.KINDS, *gloss}
    assert facts["ao_distance_world"] == pytest.approx(loaded.ao_distance_world)
    np.testing.assert_allclose(facts["light"]["towards"], loaded.sun.towards, atol=1e-8)
    pictures = {kind: read_exr(path.parent / f"{kind}.exr") for kind in facts["kinds"]}
    for kind, picture in pictures.items():
        assert picture.shape == (facts["size"][1], facts["size"][0], 3)
        assert np.isfinite(picture).all() and picture.min() >= 0, kind
        assert facts["kinds"][kind]["noise_relmse"] < (2e-3 if large else 1e-3), kind
    for kind in {"coverage", "ao", "shadow"} & pictures.keys():
        assert pictures[kind].max() <= 1
    if large:
        return
    # More light is never darker in the mean, by more than noise.
    if gloss:  # all kinds except `full` and `glossy` have Lambert surfaces
        assert pictures["full"].mean() >= pictures["glossy"].mean()
    else:
        assert pictures["full"].mean() >= (pictures["direct"] + pictures["indirect"]).mean() * 0.999


def orthographic(glb):
    glb.node("plan", translation=[0.2, 0.5, 4], camera=glb._append("cameras", {
        "type": "orthographic", "orthographic": {"xmag": 1.6, "ymag": 0.9, "znear": 0.1, "zfar": 10}}))


def wide(glb):
    glb.camera("wide", (0, 1, 4), (0, 0, 0), 30)
    glb.json["cameras"][0]["perspective"]["aspectRatio"] = 2.0


@pytest.mark.parametrize("add_camera", [lambda glb: None, orthographic, wide], ids=["none", "orthographic", "wide"])
def test_a_scene_is_seen_as_the_renderer_sees_it(maker, program, tmp_path, add_camera):
    """Also where its camera cannot be used as it is."""
    emissive = maker.glb.material("emissive", (0, 0, 0), emissive=((1, 1, 1), 1, None))
    maker.place(shapes.box((1.0, 0.4, 0.7), 1.0), emissive)
    maker.place(shapes.icosphere(0.3, 2), emissive, translation=[0.4, 0.6, 0.1])
    add_camera(maker.glb)
    maker.path.write_bytes(maker.glb.to_bytes())
    made = run(maker.path, "--size", "48x32", "--spp", "16", "--kinds", "coverage", "--out", tmp_path)
    assert made.returncode == 0, made.stderr
    covered = read_exr(tmp_path / "scene/coverage.exr")[..., 0] > 0.5
    subprocess.run([program, "render", maker.path, "--size", "48x32", "--mode", "phong", "--grid", "64", "--samples", "1",
                    "--out", tmp_path],
                   check=True, capture_output=True)
    rendered = read_exr(tmp_path / "phong.exr")[..., 0] > 0.5
    assert 0.05 < rendered.mean() < 0.95
    assert (covered != rendered).mean() < 0.01
