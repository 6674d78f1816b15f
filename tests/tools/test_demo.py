"""scripts/demo.sh, with stand-ins for all that takes long: the order of its pictures, and what it says if packages are missing."""
import shutil
import subprocess

import pytest

from conftest import ROOT


def script(path, *lines):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("\n".join(["#!/bin/bash", *lines, ""]))
    path.chmod(0o755)


@pytest.fixture
def clone(tmp_path):
    shutil.copytree(ROOT / "scripts", tmp_path / "scripts")
    (tmp_path / "docs").mkdir()
    (tmp_path / "docs/demo.md").write_text("words")
    for name in ("setup", "python", "build"):
        script(tmp_path / f"scripts/{name}.sh")
    script(tmp_path / "build/desktop/vct", 'echo "vct $*" >>calls')
    script(tmp_path / ".venv/bin/python", 'echo "python $*" >>calls')
    return tmp_path


def run(clone):
    done = subprocess.run([clone / "scripts/demo.sh"], cwd=clone, capture_output=True, text=True, check=False)
    return done, (clone / "calls").read_text().splitlines()


def test_what_a_visitor_should_see_comes_first_and_quality_last(clone):
    done, calls = run(clone)
    assert done.returncode == 0, done.stderr
    told = ["courtyard.png", "--preset mobile", "--preset thesis", "--presets thesis,mobile ", "--presets thesis,mobile,quality"]
    assert len(calls) == len(told) and all(words in call for words, call in zip(told, calls)), calls
    assert done.stdout.splitlines()[-1].startswith("demo: done; out/demo/presets.png")
    assert (clone / "out/demo/README.md").read_text() == "words"


def test_without_the_python_packages_the_other_pictures_are_there_and_the_last_line_says_why(clone):
    script(clone / "scripts/python.sh", "echo 'python: error: pip could not install tools/requirements.txt'", "exit 1")
    done, calls = run(clone)
    assert done.returncode == 0 and len(calls) == 3 and not any(call.startswith("python") for call in calls)
    last = done.stdout.splitlines()[-1]
    assert "presets.png" in last and last.endswith("pip could not install tools/requirements.txt")


def test_a_measurement_that_fails_is_a_failure_that_the_last_line_names(clone):
    script(clone / ".venv/bin/python", "exit 1")
    done, _ = run(clone)
    assert done.returncode == 1 and "a measurement failed" in done.stdout.splitlines()[-1]
