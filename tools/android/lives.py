"""Runs the app's library through lives of an Android activity: fixed ones, which test one thing each, and random ones.

    lives.py [--random COUNT] [--emulated] [--only NAME] LOGS COMMAND...

COMMAND starts tools/android/activity.cpp and ends with its argument FILES, an empty folder. Each life has a log in LOGS, and the exit
code is 1 if one failed. A life fails if a step does, if the app does what Android does not allow or does not end by itself, or if it
logs an error that is not expected. Standard library only.
"""

from __future__ import annotations

import argparse
import dataclasses
import pathlib
import random
import re
import subprocess
import sys
import time

TIMEOUT_S = 1800
START = ["create", "start", "resume", "window 96 64", "focus 1"]
END = ["pause", "lose-window", "stop", "destroy"]
TESTED = "log self-test passed"
SHOWN = ["log triangles", "frames 2"]  # the scene is loaded and its programs are linked; frames before have no scene
# Actions of AMotionEvent; those of a second finger have its index in the next byte.
DOWN, UP, MOVE, CANCEL, SECOND_DOWN, SECOND_UP = 0, 1, 2, 3, 5 + 256, 6 + 256
HOVER_MOVE, SCROLL, HOVER_ENTER, HOVER_EXIT = 7, 8, 9, 10  # of a mouse or a pen


@dataclasses.dataclass
class Life:
    name: str
    command: str  # the extra of the intent
    steps: list[str]
    errors: str = "(?!)"  # a pattern of the errors that the app is expected to log
    same: bool = False  # the pictures of the life are equal


def drag(start: tuple[int, int], end: tuple[int, int]) -> list[str]:
    """A finger that moves, with a frame after each event."""
    between = [[round(a + (b - a) * i / 8) for a, b in zip(start, end)] for i in range(1, 9)]
    events = [(DOWN, *start), *((MOVE, *point) for point in between), (UP, *end)]
    return [step for action, x, y in events for step in (f"touch {action} 0 {x} {y}", "frames 1")]


def fixed_lives(pictures: pathlib.Path) -> list[Life]:
    fast = "grid=64 mode=phong display=off"
    touches = [f"touch {DOWN} 0 30 30", f"touch {MOVE} 0 40 35", f"touch {SECOND_DOWN} 0 40 35 1 50 60",
               f"touch {MOVE} 0 38 30 1 60 70", f"touch {SECOND_UP} 0 38 30 1 60 70", f"touch {UP} 0 38 30",
               f"touch {DOWN} 0 5 5", f"touch {CANCEL} 0 5 5", "key 0"]
    return [
        Life("self-test and frames", "show grid=64 display=off",
             [*START, TESTED, *SHOWN, f"picture {pictures}/gi.ppm", "frames 1", *END]),
        Life("rotation, touch and focus", f"show {fast}",
             [*START, TESTED, *SHOWN, "resize 64 96", "frames 2", *touches, "frames 2", "focus 0", "focus 1", "frames 2",
              f"picture {pictures}/rotated.ppm", "frames 1", "resize 96 64", "frames 2", *END]),
        Life("lost windows", f"show {fast}",
             [*START, "frames 1", "lose-window", "no-frames", "window 80 60", "frames 2", "lose-window", "window 33 47",
              TESTED, "frames 2", *END]),
        Life("low memory", f"show {fast}",
             [*START, TESTED, *SHOWN, "low-memory", "frames 2", "pause", "no-frames", "low-memory", "resume",
              f"picture {pictures}/low_memory.ppm", "frames 2", *END]),
        Life("cascades", "show scene=moving.glb grid=64 cascades=3 mode=gi display=off",
             [*START, TESTED, *SHOWN, f"touch {DOWN} 0 30 30", f"touch {MOVE} 0 60 35", f"touch {UP} 0 60 35", "frames 4",
              "low-memory", "frames 2", "lose-window", "window 64 96", f"picture {pictures}/cascades.ppm", "frames 2", *END]),
        # A mouse or a pen that touches nothing does not turn the view.
        Life("hovering", f"show {fast}",
             [*START, TESTED, *SHOWN, f"picture {pictures}/before_hovering.ppm", "frames 1",
              *(f"touch {action} 0 {x} 30" for x in (20, 50, 80) for action in (HOVER_ENTER, HOVER_MOVE, SCROLL, HOVER_EXIT)),
              "frames 2", f"picture {pictures}/after_hovering.ppm", "frames 1", *END], same=True),
        # The panel of a small window is folded, and a tap on its button unfolds it. Then a finger scrolls it up and down.
        Life("scrolled panel", "show grid=64 mode=phong",
             [*START[:3], "window 300 200", "focus 1", TESTED, *SHOWN, *drag((50, 40), (50, 40)), "frames 3",
              f"picture {pictures}/panel.ppm", "frames 1", *drag((60, 170), (60, 40)), f"picture {pictures}/panel_scrolled.ppm",
              "frames 1", *drag((60, 40), (60, 170)), "resize 200 300", "frames 2", *END]),
        # The restarted app does not obey the command again.
        Life("save and restore", f"show scene=moving.glb {fast}",
             [*START, "log scenes/moving.glb", TESTED, "frames 2", "pause", "save", "stop", "lose-window", "destroy",
              *START, "log scenes/cornell.glb", "frames 1", *END]),
        Life("end before the first frame", f"show {fast}", ["create", "destroy", "create", "start", "stop", "destroy"]),
        Life("broken file", f"show scene=broken.glb {fast}",
             [*START, "log broken.glb", TESTED, "frames 2", *END], errors=r"broken\.glb"),
        Life("missing scene", f"show scene=missing.glb {fast}",
             [*START, "log there is no scene 'missing.glb'", TESTED, "frames 2", *END], errors="missing.glb"),
        Life("wrong option", "show colour=red", [*START, "log colour", "frames 1", *END], errors="colour"),
        Life("wrong value", "show mode=loud", [*START, "log loud", "frames 1", *END], errors="loud"),
        Life("wrong command", "dance", [*START, "log measuring failed", "frames 1", *END], errors="dance"),
        Life("benchmark without a scene", "bench scene=missing.glb", [*START, "log measuring failed", "frames 1", *END],
             errors="missing.glb"),
    ]


def random_life(seed: int, emulated: bool) -> Life:
    """A life in an order that Android allows, with pauses of random length between the calls."""
    chance = random.Random(seed)
    steps: list[str] = []

    def add(*added: str) -> None:
        for step in added:
            steps.append(step)
            if chance.random() < 0.5:
                steps.append(f"sleep {chance.choice([0.005, 0.02, 0.05, 0.2, 0.6])}")

    def window() -> str:
        return f"window {chance.choice(['96 64', '64 96', '33 47', '128 128'])}"

    def shown() -> None:
        add(window())
        if chance.random() < 0.8:
            add("focus 1")
        for _ in range(chance.randrange(7)):
            x, y = chance.randrange(100), chance.randrange(100)
            add(*chance.choice([
                [f"touch {DOWN} 0 {x} {y}", f"touch {MOVE} 0 {y} {x}", f"touch {chance.choice([UP, CANCEL])} 0 5 5"],
                [f"resize {chance.choice(['96 64', '64 96', '50 50'])}"],
                [f"touch {DOWN} 0 {x} 90", f"touch {MOVE} 0 {x} 50", f"touch {MOVE} 0 {x} 10", f"touch {UP} 0 {x} 10"],
                [f"touch {action} 0 {x} {y}" for action in (HOVER_ENTER, HOVER_MOVE, SCROLL, HOVER_EXIT)],
                ["low-memory"], ["focus 0", "focus 1"], ["key 0"], ["lose-window", window()], ["frames 1"],
            ]))

    for _ in range(chance.choice([1, 1, 2, 3])):
        add("create")
        for _ in range(chance.choice([0, 1, 1, 2])):
            add("start")
            for _ in range(chance.choice([1, 1, 2])):
                has_window = chance.random() < 0.9
                add("resume")
                if has_window:
                    shown()
                add("pause")
                if has_window:
                    add("lose-window")
            if chance.random() < 0.6:
                add("save")
            add("stop")
            if chance.random() < 0.2:
                add("low-memory")
        add("destroy")
        # A restored activity shows the default preset.
        if chance.random() < 0.5 or emulated:
            add("discard")
    scene = chance.choice(["cornell", "moving", "walker", "lamp", "night"])
    preset = chance.choice(["thesis", "mobile", "quality"])
    mode = "phong" if emulated else chance.choice(["phong", "ao", "gi", "gi-cone-shadow"])
    cascades = f" cascades={chance.choice([2, 3])}" if preset != "thesis" and chance.random() < 0.5 else ""
    show = f"show scene={scene}.glb grid=64 pixels=2 mode={mode} preset={preset}{cascades}"
    bench = "bench scene=cornell.glb size=32x32 grid=64 repeat=1"
    command = chance.choice([show, show, show if emulated else bench, f"show scene=missing.glb grid=64 mode={mode}"])
    # The benchmark ends with an error if the activity does before it.
    return Life(f"random {seed}", command, steps, errors="missing.glb|measuring failed")


def fault(life: Life, status: int | None, log: str) -> str:
    """Why a life failed, or an empty string."""
    for line in log.splitlines():
        if line.startswith("misuse: ") or re.fullmatch("step: .*: FAILED, .*", line):
            return line
        if re.match(r"[EF]/", line) and not re.search(life.errors, line):
            return f"unexpected: {line}"
    if status is None:
        return f"it did not end in {TIMEOUT_S} s"
    return "" if status == 0 else f"exit code {status}"


def is_blank(picture: pathlib.Path) -> bool:
    pixels = picture.read_bytes().split(b"\n", 3)[3]
    return len({pixels[i:i + 3] for i in range(0, len(pixels), 3)}) < 20


def fault_of_pictures(pictures: list[pathlib.Path], same: bool) -> str:
    for picture in pictures:
        if is_blank(picture):
            return f"{picture} has fewer than 20 colours"
    if same and len({picture.read_bytes() for picture in pictures}) > 1:
        return f"{' and '.join(map(str, pictures))} differ"
    return ""


def run(life: Life, command: list[str], logs: pathlib.Path) -> bool:
    start = time.monotonic()
    log_path = logs / (re.sub(r"\W+", "_", life.name) + ".log")
    with log_path.open("w") as log:
        print(f"command: {life.command}", file=log, flush=True)
        try:
            status = subprocess.run([*command, life.command, *life.steps], stdout=log, stderr=log, check=False,
                                    timeout=TIMEOUT_S).returncode
        except subprocess.TimeoutExpired:
            status = None
    found = fault(life, status, log_path.read_text(errors="replace"))
    pictures = [pathlib.Path(step.split()[1]) for step in life.steps if step.startswith("picture ")]
    if not found:
        found = fault_of_pictures(pictures, life.same)
    print(f"{life.name}: {f'FAILED: {found} ({log_path})' if found else 'ok'}, {len(life.steps)} steps, "
          f"{time.monotonic() - start:.0f} s", flush=True)
    return not found


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--random", type=int, default=20, metavar="COUNT", help="random lives, by their seeds 1 to COUNT")
    parser.add_argument("--emulated", action="store_true",
                        help="show only direct light in random lives, because other frames take 15 s and more under emulation")
    parser.add_argument("--only", default="", metavar="NAME", help="run one life, such as 'random 7'")
    parser.add_argument("logs", type=pathlib.Path)
    parser.add_argument("command", nargs=argparse.REMAINDER)
    arguments = parser.parse_args()
    arguments.logs.mkdir(parents=True, exist_ok=True)
    files = pathlib.Path(arguments.command[-1])
    files.mkdir(parents=True, exist_ok=True)
    (files / "broken.glb").write_bytes(b"glTF\x02\0\0\0")
    lives = fixed_lives(arguments.logs)
    lives += [random_life(seed, arguments.emulated) for seed in range(1, arguments.random + 1)]
    lives = [life for life in lives if arguments.only in ("", life.name)]
    failed = sum(not run(life, arguments.command, arguments.logs) for life in lives)
    print(f"{len(lives)} lives, {sum(len(life.steps) for life in lives)} steps, {failed} failed")
    return 1 if failed or not lives else 0


if __name__ == "__main__":
    sys.exit(main())
