"""tools/dynamic.py: its scenes move what they say, and its table has what the renderer measured."""
from __future__ import annotations

import subprocess
import sys

import pytest
from dynamic import CASES, ball_room


def channels(glb) -> list[str]:
    nodes = glb.json["nodes"]
    return [nodes[channel["target"]["node"]]["name"] for animation in glb.json.get("animations", [])
            for channel in animation["channels"]]


@pytest.mark.parametrize("moving", [1, 100])
def test_as_many_balls_move_as_are_asked_for(moving):
    assert len(set(channels(ball_room(moving=moving)))) == moving


def test_the_light_and_the_camera_move_alone():
    assert channels(ball_room(turn_light=True)) == ["sun"]
    assert channels(ball_room(turn_camera=True)) == ["front"]


def test_the_table(program, root, tmp_path):
    done = subprocess.run([sys.executable, str(root / "tools/dynamic.py"), "--program", program, "--out", str(tmp_path),
                           "--presets", "mobile", "--frames", "3", "--repeat", "1"],
                          check=True, capture_output=True, text=True)
    lines = [[cell.strip() for cell in line.strip("|").split("|")] for line in done.stdout.splitlines()]
    share = {cells[0]: float(cells[-1].strip(" %")) for cells in lines if cells[0] in CASES}
    shares = [share[case] for case in CASES]
    assert shares[0] == 100
    # A camera that moves makes no voxels, but on a busy machine nothing takes its time too.
    camera, light, one_ball, all_balls = shares[1:]
    assert camera < 15
    assert light > 20
    assert 2 < one_ball < 0.5 * all_balls
