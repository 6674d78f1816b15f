"""The lives of an activity that scripts/android-userland.sh runs: what is a fault of the app, and that random lives are possible."""

import os
import pathlib
import re
import subprocess
import sys

import pytest

from android import lives

SOURCE = pathlib.Path(__file__).resolve().parents[2]
GOOD = "step: create: ok, 0.1 s, 0 frames\nE/vct(1): cannot load broken.glb\n"


@pytest.mark.parametrize("status, log, found", [
    (0, GOOD, ""),
    (0, GOOD + "E/vct(1): out of memory\n", "unexpected: E/vct(1): out of memory"),
    (0, GOOD + "misuse: a surface outlasts its window\n", "misuse: a surface outlasts its window"),
    (1, GOOD + "step: frames 2: FAILED, 300.0 s, 1 frames\n", "step: frames 2: FAILED, 300.0 s, 1 frames"),
    (-6, GOOD, "exit code -6"),
    (None, GOOD, "it did not end in 1800 s"),
])
def test_faults_are_found(status, log, found):
    assert lives.fault(lives.Life("", "", [], errors="broken.glb"), status, log) == found


def test_pictures_are_not_blank_and_equal_where_they_should_be(tmp_path):
    def picture(name, first):
        (tmp_path / name).write_bytes(b"P6\n30 1\n255\n" + bytes(range(first, first + 90)))
        return tmp_path / name
    a, same, other = picture("a.ppm", 0), picture("same.ppm", 0), picture("other.ppm", 9)
    assert lives.fault_of_pictures([a, same], True) == lives.fault_of_pictures([a, other], False) == ""
    assert "differ" in lives.fault_of_pictures([a, other], True)
    (tmp_path / "blank.ppm").write_bytes(b"P6\n30 1\n255\n" + bytes(90))
    assert "20 colours" in lives.fault_of_pictures([tmp_path / "blank.ppm"], False)


# A letter for each event whose order Android promises.
LETTERS = {"create": "C", "start": "S", "resume": "R", "window": "W", "lose-window": "L", "pause": "P", "stop": "T", "destroy": "D"}


@pytest.mark.parametrize("emulated", [False, True])
def test_random_lives_are_possible_and_can_be_repeated(emulated):
    for seed in range(300):
        life = lives.random_life(seed, emulated)
        words = [step.split()[0] for step in life.steps]
        events = "".join(LETTERS.get(word, "") for word in words)
        assert re.fullmatch("(C(S(R(W(LW)*PL|P))*T)*D)+", events), (seed, events)
        assert life == lives.random_life(seed, emulated)


def test_a_crash_fails_the_run(tmp_path):
    done = subprocess.run([sys.executable, SOURCE / "tools/android/lives.py", "--random", "0", "--only", "lost windows",
                           tmp_path / "logs", "sh", "-c", "kill -ABRT $$", tmp_path / "files"],
                          capture_output=True, text=True, check=False)
    assert done.returncode == 1
    assert "lost windows: FAILED: exit code -6" in done.stdout and "1 lives, 18 steps, 1 failed" in done.stdout


def test_the_script_says_why_it_is_skipped():
    environment = {name: value for name, value in os.environ.items() if name != "ANDROID_USERLAND"}
    done = subprocess.run([SOURCE / "scripts/android-userland.sh"], env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0 and "skipped: ANDROID_USERLAND is not set" in done.stdout
