"""scripts/build.sh shows the progress of a long build, and all that a compiler says."""

import os
import pathlib
import subprocess

SOURCE = pathlib.Path(__file__).resolve().parents[2]

CMAKE = r"""#!/bin/bash
[[ "$1" == --build ]] || exit 0
for ((i = 1; i <= STEPS; ++i)); do echo "${NINJA_STATUS:-[%f/%t] }Building $i" | sed "s/%f/$i/; s/%t/$STEPS/"; done
echo "a.cpp:1:2: warning: something"
exit "$STATUS"
"""


def built(tmp_path, steps, status=0):
    stand_in = tmp_path / "cmake"
    stand_in.write_text(CMAKE)
    stand_in.chmod(0o755)
    environment = os.environ | {"PATH": f"{tmp_path}:{os.environ['PATH']}", "STEPS": str(steps), "STATUS": str(status)}
    return subprocess.run([SOURCE / "scripts/build.sh", "desktop"], env=environment, capture_output=True, text=True, check=False)


def test_a_long_build_shows_each_tenth(tmp_path):
    lines = built(tmp_path, 200).stdout.splitlines()
    assert "desktop: 20 of 200 steps" in lines and "desktop: 200 of 200 steps" in lines
    assert sum(" steps" in line for line in lines) == 10
    assert not any("Building" in line for line in lines)
    assert "a.cpp:1:2: warning: something" in lines


def test_a_short_build_shows_warnings_only(tmp_path):
    lines = built(tmp_path, 5).stdout.splitlines()
    assert not any(" steps" in line for line in lines) and "a.cpp:1:2: warning: something" in lines


def test_a_failed_build_fails(tmp_path):
    assert built(tmp_path, 200, status=1).returncode == 1
