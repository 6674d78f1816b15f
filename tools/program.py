"""Runs the program under test, `vct`, and says in words why a run gave nothing."""
from __future__ import annotations

import argparse
import json
import os
import subprocess
from pathlib import Path

from files import ROOT


class Failed(Exception):
    """The message says how the program ended, and what it said."""


def add_option(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--program", type=Path, default=ROOT / "build/desktop/vct", help="default: build/desktop/vct")


def usual() -> Path:
    """For tools that take no --program."""
    return Path(os.environ.get("VCT_PROGRAM", ROOT / "build/desktop/vct"))


def require(program: Path) -> None:
    if not program.is_file():
        raise SystemExit(f"error: {program} is not built: scripts/build.sh desktop vct")


def run(program: Path, *arguments: object, timeout_s: float | None = None) -> subprocess.CompletedProcess[str]:
    """Fails where the program cannot be started or takes too long; its exit status is the caller's to judge."""
    try:
        return subprocess.run([program, *map(str, arguments)], capture_output=True, text=True, timeout=timeout_s, check=False)
    except subprocess.TimeoutExpired:
        raise Failed(f"stopped after {timeout_s:g} s") from None
    except OSError as error:
        raise Failed(f"{program} could not be started: {error.strerror}; scripts/build.sh desktop vct builds it") from None


def last_words(text: str) -> str:
    """What a failed program said: its error, or the end of its output; without this machine's folders."""
    lines = [line.replace(f"{ROOT}/", "") for line in text.strip().splitlines() if line.strip()]
    errors = [line for line in lines if "error" in line.lower()]
    return "\n".join(errors[-3:] or lines[-5:]) or "it said nothing"


def render(program: Path, *arguments: object, timeout_s: float | None = None) -> str:
    """`vct render`; returns what it said on stderr, and fails where it ends with an error."""
    done = run(program, "render", *arguments, timeout_s=timeout_s)
    if done.returncode != 0:
        how = f"signal {-done.returncode}" if done.returncode < 0 else f"exit {done.returncode}"
        raise Failed(f"{how}: {last_words(done.stderr)}")
    return done.stderr


def camera(scene: Path, size: tuple[int, int]) -> dict:
    """From where `vct` sees a scene in a picture of this size: name, eye_world, right_up_back, vertical_fov_rad, and the
    option that repeats it."""
    done = run(usual(), "info", scene, "--print-camera", "--size", f"{size[0]}x{size[1]}")
    if done.returncode != 0:
        raise Failed(last_words(done.stderr))
    return json.loads(done.stdout)
