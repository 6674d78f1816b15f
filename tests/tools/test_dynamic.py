"""tools/dynamic.py: its scenes move what they say, and its table has what the renderer measured."""
import subprocess
import sys

import pytest

from dynamic import CASES
from scenes import balls


@pytest.mark.parametrize("changes, moving", [({"moving": 1}, {"ball 50"}), ({"moving": 100}, {f"ball {i}" for i in range(100)}),
                                             ({"turn_light": True}, {"sun"}), ({"turn_camera": True}, {"front"})])
def test_what_is_asked_for_moves_and_nothing_else(changes, moving):
    document = balls.build(**changes).json
    targets = [channel["target"]["node"] for animation in document["animations"] for channel in animation["channels"]]
    assert {document["nodes"][node]["name"] for node in targets} == moving


def test_the_table(program, root, tmp_path):
    done = subprocess.run([sys.executable, str(root / "tools/dynamic.py"), "--program", program, "--out", str(tmp_path),
                           "--presets", "mobile", "--frames", "3", "--repeat", "1"],
                          check=True, capture_output=True, text=True)
    lines = [[cell.strip() for cell in line.strip("|").split("|")] for line in done.stdout.splitlines()]
    share = {cells[0]: float(cells[-1].strip(" %")) for cells in lines if cells[0] in CASES}
    everything, camera, light, one_ball, all_balls = (share[case] for case in CASES)
    assert everything == 100
    # A camera that moves makes no voxels, but on a busy machine nothing takes its time too.
    assert camera < 15
    # Light is injected into all faces, and geometry is voxelized where it moves alone.
    assert 5 < light < 50
    assert 2 < one_ball < all_balls
