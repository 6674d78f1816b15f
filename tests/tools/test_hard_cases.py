"""The quick hard cases against the program, and the closed forms that say what is right."""
import json
import math
import pathlib

import numpy as np
import pytest

import hard_cases
from cases.floor import floor_points, on_floor, openness_beside_wall, openness_under_ceiling, rectangle_form_factor
from scenes.hard_cases import View

KEYS = {"name", "what", "right_answer", "preset", "measured", "unit", "bar", "status", "note", "picture", "known_range"}


@pytest.fixture(scope="module")
def quick(program, tmp_path_factory):
    """Rows and folder of one quick run."""
    folder = tmp_path_factory.mktemp("hard_cases")
    return hard_cases.run(pathlib.Path(program), folder, quick=True), folder


def test_every_case_passes_or_fails_with_its_known_size(quick):
    """Below its range something has been cured: then say so, and give the case its new range or a bar that it keeps."""
    rows, _ = quick
    assert len([row for row in rows if row["known_range"]]) >= 20
    unexpected = [f"{row['name']}: {row['measured']} {row['unit']} is {row['status']}, bar {row['bar']}, known {row['known_range']}; "
                  f"{row['note']}" for row in rows
                  if row["status"] != ("known-failure" if row["known_range"] else "pass")
                  or (row["known_range"] and row["measured"] < row["known_range"][0])]
    assert not unexpected, "\n".join(unexpected)


def test_json_is_what_the_report_reads(quick):
    rows, folder = quick
    assert json.loads((folder / "hard_cases.json").read_text()) == json.loads(json.dumps(rows))
    assert {row["name"] for row in rows} == {case.name for case in hard_cases.CASES if case.quick}
    assert len({row["name"] for row in rows}) == len(rows)
    for row in rows:
        assert set(row) == KEYS, row["name"]
        assert math.isfinite(row["measured"])
        assert row["picture"] is None or (folder / row["picture"]).is_file()


def test_a_crash_is_a_fail(tmp_path):
    program = tmp_path / "crashing"
    program.write_text("#!/bin/sh\nkill -SEGV $$\n")
    program.chmod(0o755)
    (row,) = hard_cases.run(program, tmp_path / "out", only=["furnace"])
    assert row["status"] == "fail" and row["measured"] is None and "-11" in row["note"]


def test_closed_forms_agree_with_sampling():
    """Of cosine-weighted directions around +Y, by Malley's method."""
    u, v = np.random.default_rng(3).random((2, 400_000))
    radius, angle = np.sqrt(u), 2 * np.pi * v
    d = np.stack([radius * np.cos(angle), np.sqrt(1 - u), radius * np.sin(angle)], -1)
    for distance in (0.0, 0.3, 0.9, 2.0):
        assert openness_beside_wall(distance, 1.0) == pytest.approx(1.0 - (d[:, 0] > distance).mean(), abs=3e-3)
    assert openness_under_ceiling(0.4, 1.0) == pytest.approx((0.4 / d[:, 1] > 1.0).mean(), abs=3e-3)
    at = d[:, [0, 2]] * (3.0 / d[:, 1:2])
    assert rectangle_form_factor(2.0, 3.0) == pytest.approx((np.abs(at) < 2.0).all(axis=1).mean(), abs=3e-3)


def test_floor_points_follow_the_camera():
    x, z = floor_points(View((0, 10, 10), (0, 0, 0), 90), 4)
    assert x[2, 2] > 0 > x[2, 1] and z[3, 2] > z[2, 2]  # right is +X; the lower pixels are nearer
    view = View((1, 5, 3), (1, 0, -2), 40)
    middle = floor_points(view, 101)
    assert middle[0][50, 50] == pytest.approx(1.0) and middle[1][50, 50] == pytest.approx(-2.0)
    chosen = on_floor(middle[0], view, (0.5, 1.5), 2.5)
    assert 0.5 < chosen.min() < 0.6 and 1.4 < chosen.max() < 1.5
