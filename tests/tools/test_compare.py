"""tools/eval.py compare: jobs, tables and page, without the other renderers."""
import argparse

import numpy as np
import pytest

from conftest import ROOT
from evaluation import compare, rivals
from evaluation.rivals import EXPOSURES, RIVALS, SAMPLES, described, merged
from files import Failed
from metrics import srgb_from_linear


def test_a_job_has_the_scene_in_metres():
    job = described(ROOT / "assets/cornell.glb", (64, 32))
    assert job["size"] == [64, 32] and job["camera"]["vertical_fov_deg"] == pytest.approx(40, abs=1e-4)
    assert job["camera"]["eye"] == pytest.approx([0, 0, 3.85]) and job["sun"]["irradiance"] == pytest.approx([np.pi] * 3, rel=1e-6)
    assert np.allclose(job["bounds"], [[-1] * 3, [1] * 3])
    assert sum(len(surface["positions"]) for surface in job["surfaces"]) == 1298 * 9
    assert [0.64, 0.04, 0.04] in [surface["albedo"] for surface in job["surfaces"]]


def test_a_scene_that_not_all_can_draw_is_refused():
    with pytest.raises(Failed, match="patio.glb has point lights, a sky"):
        described(ROOT / "assets/patio.glb", (64, 64))


def test_exposures_are_merged_into_linear_light():
    light = np.array([0.004, 0.3, 5.0, 20.0])
    pictures = [np.round(srgb_from_linear(light * exposure) * 255) / 255 for exposure in EXPOSURES]
    found = merged([np.tile(np.repeat(picture, SAMPLES)[:, None], (SAMPLES, 1, 3)) for picture in pictures])
    assert found.shape == (1, 4, 3) and found[0, :, 1] == pytest.approx(light, rel=0.03)


def preset(scene, name, relmse):
    return {"scene": scene, "preset": name, "grid": 64, "driver": "llvmpipe", "cpu": "a processor", "frame_ms": 4.0,
            "errors": {"relmse": relmse, "bias": 0.01, "flip": 0.1}}


def drawn(scene, name, settings, relmse, **more):
    return {"scene": scene, "rival": name, "settings": settings, "direct": settings == RIVALS[name].direct, "version": "9.8",
            "driver": "a driver", "errors": {"relmse": relmse, "bias": -0.2, "flip": 0.05}, **more}


def test_tables_show_the_best_settings_and_where_others_are_better():
    first, second = RIVALS["godot"].variants[:2]
    cycles = RIVALS["cycles"].variants[0]
    found = {"godot": [drawn("a", "godot", RIVALS["godot"].direct, 0.001, frame_ms=20), drawn("a", "godot", first, 0.01, frame_ms=90),
                       drawn("a", "godot", second, 0.03), drawn("b", "godot", first, 0.07, frame_ms=95), drawn("b", "godot", second, 0.06, frame_ms=91)],
             "cycles": [drawn("a", "cycles", cycles, 0.0001), drawn("b", "cycles", cycles, 0.0001)]}
    text = compare.figures([preset("a", "mobile", 0.02), preset("b", "mobile", 0.02)], found)
    assert "| a | `mobile`, 64³ | .0200 | +1 % | .100 | 4.0 ms |" in text
    assert "| a | Godot 3.2, GIProbe | .0100 | -20 % | .050 | 90 ms |" in text
    assert "| b | Godot 3.2, GIProbe | .0600 | -20 % | .050 | 91 ms |" in text
    assert "- a: Godot 3.2, GIProbe has a lower relMSE than `mobile` (.0100 against .0200)." in text
    assert "- b: Godot 3.2, GIProbe has a lower relMSE" not in text and "- a: Cycles" not in text
    assert f"{compare.label(first)} | .0100 (shown) | .0700 |" in text
    assert f"{compare.label(second)} | .0300 | .0600 (shown) |" in text
    assert text.count("| a | Godot 3.2, GIProbe | .0010 |") == 1  # direct light


def test_figures_replace_those_of_the_page():
    page = f"# Title\n\n{compare.BEGIN}old\n{compare.END}\nText.\n"
    once = compare.page_with(page, "new\n")
    assert "old" not in once and once.startswith("# Title\n") and once.endswith(f"new\n\n{compare.END}\nText.\n")
    assert compare.page_with(once, "new\n") == once
    with pytest.raises(Failed, match="no lines"):
        compare.page_with("# Title\n", "new\n")
    assert compare.page_with((ROOT / "docs/comparison.md").read_text(), "new\n")


def test_what_is_missing_is_named_and_no_page_is_written(monkeypatch, tmp_path, capsys):
    monkeypatch.setattr(rivals.shutil, "which", lambda name: None)
    assert RIVALS["godot"].lacks(tmp_path) == ["the program godot3", "the program xvfb-run"]
    assert RIVALS["cycles"].lacks(tmp_path)[0] == str(tmp_path / "cycles/bin/python")
    page = tmp_path / "page.md"
    page.write_text(compare.BEGIN + compare.END)
    monkeypatch.setattr(compare.Store, "run", lambda self, tasks, again=False: [preset("contact", "mobile", 0.02)])
    monkeypatch.setattr(compare.Store, "failures", lambda self, tasks: [])
    asked = argparse.Namespace(page=page, scenes=["contact"], rivals=["godot"], installed=tmp_path, out=tmp_path, presets=["mobile"])
    assert compare.run(asked) == 1 and page.read_text() == compare.BEGIN + compare.END
    said = capsys.readouterr()
    assert "Godot 3.2, GIProbe is skipped, because it needs the program godot3 and the program xvfb-run" in said.err
    assert "is left as it is" in said.err and "| contact | `mobile`, 64³ |" in said.out
