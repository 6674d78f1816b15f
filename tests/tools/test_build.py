"""scripts/build.sh shows the progress of a long build, and all that a compiler says."""

import os
import pathlib
import signal
import subprocess
import time

SOURCE = pathlib.Path(__file__).resolve().parents[2]

CMAKE = r"""#!/bin/bash
[[ "$1" == --build ]] || exit 0
step() { echo "${NINJA_STATUS:-[%f/%t] }Building $1" | sed "s/%f/$1/; s/%t/200/"; }
for ((i = 1; i <= 20; ++i)); do step $i; done
sleep "$SECONDS_OF_STEP_20"
step 200
echo "a.cpp:1:2: warning: something"
exit "$STATUS"
"""


def start(tmp_path, seconds, status=0):
    stand_in = tmp_path / "cmake"
    stand_in.write_text(CMAKE)
    stand_in.chmod(0o755)
    environment = os.environ | {"PATH": f"{tmp_path}:{os.environ['PATH']}", "SECONDS_OF_STEP_20": str(seconds), "STATUS": str(status)}
    return subprocess.Popen([SOURCE / "scripts/build.sh", "desktop"], env=environment, stdout=subprocess.PIPE, text=True)


def test_a_build_tells_where_it_is_even_while_a_step_takes_long(tmp_path):
    lines, before, pauses = [], time.monotonic(), []
    for line in start(tmp_path, 6).stdout:
        lines.append(line.strip())
        pauses.append(time.monotonic() - before)
        before = time.monotonic()
    assert max(pauses) < 8, "nothing may be silent for long"
    assert sum(line.startswith("desktop: 20 of 200 steps, ") for line in lines) == 1
    assert not any("Building" in line for line in lines)
    assert "a.cpp:1:2: warning: something" in lines and lines[-1].startswith("desktop: built in ")


def test_a_short_build_shows_warnings_only(tmp_path):
    lines = start(tmp_path, 0).communicate()[0].splitlines()
    assert not any(" steps" in line for line in lines) and "a.cpp:1:2: warning: something" in lines


def test_a_failed_build_fails(tmp_path):
    running = start(tmp_path, 0, status=1)
    running.communicate()
    assert running.returncode == 1


def test_a_signal_ends_the_build_with_all_that_it_started(tmp_path):
    """The step that takes 300 s holds the pipe until it ends."""
    running = start(tmp_path, 300)
    time.sleep(0.5)
    running.send_signal(signal.SIGTERM)
    running.communicate(timeout=10)
    assert running.returncode == 143
