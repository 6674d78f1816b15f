"""Runs the program under test, `vct`."""
import json
import os
import subprocess
import time
from pathlib import Path
from typing import Any

import files
from files import ROOT, Failed

NO_SKY = ("--sky", "0,0,0")  # the sun alone, where `vct render` would add a sky
TIMINGS_VERSION = 4  # of timings.json (docs/timings.md)
LONGEST_IDLE_S = 600.0
vct = Path(os.environ.get("VCT_PROGRAM", ROOT / "build/desktop/vct"))  # eval.py --program sets another one


def build_sha256() -> str:
    """Hashes the program and the shaders, which it reads when it runs."""
    if not vct.is_file():
        raise Failed(f"there is no program {vct}: scripts/build.sh desktop vct builds build/desktop/vct")
    return files.files_sha256(vct.read_bytes(), (ROOT / "shaders").rglob("*"))


def run(*arguments: object) -> subprocess.CompletedProcess[str]:
    """Fails where the program cannot be started, stops working or ends with an error. It may take any time, as long as it works:
    how long depends on the machine."""
    command = [str(vct), *map(str, arguments)]
    try:
        process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    except OSError as error:
        raise Failed(f"{vct} cannot be started: {error.strerror}") from None
    with process:
        try:
            out, err = finished(process)
        except BaseException:  # such as Ctrl-C
            process.kill()
            process.wait()
            raise
    if process.returncode != 0:
        how = f"signal {-process.returncode}" if process.returncode < 0 else f"exit status {process.returncode}"
        raise Failed(f"vct {arguments[0]} ended with {how}: {last_words(err)}")
    return subprocess.CompletedProcess(command, 0, out, err)


def finished(process: subprocess.Popen[str]) -> tuple[str, str]:
    """Waits for the end of a program, and returns what it printed. Fails if it takes no processor time for LONGEST_IDLE_S."""
    worked, idle_since = 0.0, time.monotonic()
    while True:
        try:
            return process.communicate(timeout=min(LONGEST_IDLE_S, 5))
        except subprocess.TimeoutExpired:
            if (now := processor_seconds(process.pid)) is None or now != worked:
                worked, idle_since = now or 0.0, time.monotonic()
            elif time.monotonic() - idle_since > LONGEST_IDLE_S:
                raise Failed(f"vct was stopped, because it had not worked for {LONGEST_IDLE_S:g} s") from None


def processor_seconds(process: int) -> float | None:
    """Processor time that a process has taken; None where the system does not tell."""
    try:
        fields = Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()
    except OSError:
        return None
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def last_words(text: str) -> str:
    """The errors that a failed program printed, or else the end of its output."""
    lines = [line.replace(f"{ROOT}/", "") for line in text.strip().splitlines() if line.strip()]
    errors = [line for line in lines if "error" in line.lower()]
    return "\n".join(errors[-3:] or lines[-5:]) or "it printed nothing"


def render(scene: Path, out: Path, *options: object) -> str:
    """Runs `vct render` with one sample per pixel, unless the options say otherwise, and returns what it printed on stderr."""
    samples = () if "--samples" in options else ("--samples", 1)
    return run("render", scene, "--out", out, *samples, *options).stderr


def render_timed(scene: Path, out: Path, *options: object) -> dict[str, Any]:
    """Runs `vct render --timings` and returns timings.json."""
    path = out / "timings.json"
    render(scene, out, "--timings", path, *options)
    timings = json.loads(path.read_text())
    if timings.get("version") != TIMINGS_VERSION:
        raise Failed(f"{path} has version {timings.get('version')}, not {TIMINGS_VERSION}: build vct from this checkout")
    return timings


def camera(scene: Path, size: tuple[int, int], *options: str) -> dict[str, Any]:
    """The view that `vct` takes for a picture of this size: name, eye_world, right_up_back, vertical_fov_rad, lights_itself,
    and the `option` that repeats it."""
    return json.loads(run("info", scene, "--print-camera", "--size", f"{size[0]}x{size[1]}", *options).stdout)
