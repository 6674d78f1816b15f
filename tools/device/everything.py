"""phone.sh all: runs everything that a phone can tell, and keeps it in a folder and an archive, whatever fails on the way."""
from __future__ import annotations

import json
import os
import tarfile
import tempfile
import time
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import Any

from files import Failed, write_whole

from . import facts
from .adb import Adb, Lost
from .app import SELF_TEST, App

VERSION = 1  # of report.json
PRESETS = ("mobile", "quality", "thesis")
SCENES = ("cornell.glb", "courtyard.glb", "night.glb", "town.glb")
SHOWN = "preset=mobile mode=gi-cone-shadow steps=off time=1"
SETTLE_S = float(os.environ.get("VCT_PHONE_SETTLE_S", "6"))  # until indirect light has converged
RECONNECT_S = float(os.environ.get("VCT_PHONE_RECONNECT_S", "60"))
RECORD_S = 60


def new_folder(out: Path, name: str, say: Callable[[str], None]) -> Path:
    """Makes a folder that did not exist: in `out`, or in the computer's folder for temporary files where `out` takes none."""
    try:
        return _make(out, name)
    except OSError as error:
        instead = Path(tempfile.mkdtemp(prefix="vct-phone-"))
        say(f"{out} cannot be written ({error.strerror}): the results go to {instead}")
        return _make(instead, name)


def _make(out: Path, name: str) -> Path:
    out.mkdir(parents=True, exist_ok=True)
    for number in range(1, 1000):
        folder = out / (name if number == 1 else f"{name}-{number}")
        with suppress(FileExistsError):
            folder.mkdir()
            return folder
    raise Failed(f"{out} has a thousand results of this second")


class Everything:
    """The stages write into a folder each. report.json is written after each stage."""

    def __init__(self, adb: Adb, folder: Path, timeout_s: float, say: Callable[[str], None]) -> None:
        self.adb, self.folder, self.timeout_s, self.say = adb, folder, timeout_s, say
        self.app = App(adb, say)
        self.stages: list[dict[str, Any]] = []
        self.since = ""

    def stage(self, name: str, work: Callable[[Path], None]) -> None:
        """Runs a part, keeps why it failed, and collects logs in any case."""
        self.say(f"{name} ...")
        start = time.monotonic()
        problem = ""
        place = self.folder / name
        try:
            if not self.adb.wait(RECONNECT_S):
                raise Lost(f"not run: the phone was lost, and was not connected again within {RECONNECT_S:g} s")
            place.mkdir(parents=True, exist_ok=True)
            self.since = self.adb.shell("date '+%m-%d %H:%M:%S.000'")
            self.note(f"before {name}")
            work(place)
        except (Failed, OSError) as error:
            problem = str(error)
            self.say(f"{name} failed: {problem.splitlines()[0]}")
        for collect in (lambda: self.note(f"after {name}"), lambda: self.logs(place)):
            with suppress(Failed, OSError):
                collect()
        self.stages.append({"name": name, "passed": not problem, "problem": problem, "seconds": round(time.monotonic() - start, 1)})
        with suppress(OSError):
            write_whole(self.folder / "report.json", json.dumps({"version": VERSION, "stages": self.stages}, indent=1) + "\n")

    def note(self, when: str) -> None:
        """Battery, heat and memory now."""
        with (self.folder / "state.txt").open("a") as file:
            file.write(f"== {when} ==\n{facts.answers(self.adb, facts.STATE)}\n")

    def logs(self, place: Path) -> None:
        since = f"-T '{self.since}' " if self.since else ""
        log = self.adb.shell(f"logcat -b main,system,crash -d -v threadtime {since}", timeout_s=120)
        place.mkdir(parents=True, exist_ok=True)
        (place / "logcat.txt").write_text(log + "\n")
        (place / "ended.txt").write_text(facts.answers(self.adb, facts.ENDED))

    def first_start(self, place: Path) -> None:
        self.app.start("show scene=cornell.glb")
        lines = self.app.wait("a self-test", self.timeout_s, lambda log: any(word in line for line in log for word in SELF_TEST))
        found = next(line for line in lines if any(word in line for word in SELF_TEST))
        (place / "self-test.txt").write_text("\n".join(lines) + "\n")
        if SELF_TEST[1] in found:
            raise Failed(found[found.index(SELF_TEST[1]):])

    def picture(self, path: Path, command: str) -> None:
        self.app.start(command)
        scene = command.split("scene=")[1].split()[0]
        self.app.wait(f"a picture of {scene}", self.timeout_s,
                      lambda log: any(scene in line and " triangles" in line for line in log))
        time.sleep(SETTLE_S)
        self.app.screenshot(path)

    def pictures(self, place: Path) -> None:
        """Upright and sideways, each scene without the panel and one with it."""
        names = ("accelerometer_rotation", "user_rotation")
        before = {name: self.adb.shell(f"settings get system {name}") for name in names}
        problems = []
        try:
            for turned, orientation in enumerate(("portrait", "landscape")):
                self.adb.shell(f"settings put system accelerometer_rotation 0; settings put system user_rotation {turned}")
                for scene in SCENES:
                    try:
                        self.picture(place / f"{Path(scene).stem}-{orientation}.png", f"show scene={scene} display=off {SHOWN}")
                    except Lost:
                        raise
                    except Failed as error:
                        problems.append(f"{scene}, {orientation}: {error}")
                self.picture(place / f"panel-{orientation}.png", f"show scene=courtyard.glb {SHOWN}")
        finally:
            for name, value in before.items():
                with suppress(Failed):
                    self.adb.shell(f"settings put system {name} {value if value.isdigit() else 0}")
        if problems:
            raise Failed("\n".join(problems))

    def run(self, apk: Path) -> bool:
        self.stage("device", lambda place: (place / "device.txt").write_text(facts.answers(self.adb, facts.DEVICE)))
        self.stage("install", lambda _: self.adb.install(apk))
        if self.stages[-1]["passed"] or self.adb.has_app():
            self.stage("first-start", self.first_start)
            self.stage("pictures", self.pictures)
            for preset in PRESETS:
                self.stage(f"frames/{preset}", lambda place, preset=preset: self.app.measure(
                    f"show scene=moving.glb preset={preset} mode=gi-cone-shadow display=off steps=off record={RECORD_S}", place,
                    self.timeout_s))
            for preset in PRESETS:
                self.stage(f"bench/{preset}", lambda place, preset=preset: self.app.measure(
                    f"bench scene=cornell.glb preset={preset} size=400x400", place, self.timeout_s))
        return all(stage["passed"] for stage in self.stages)


def archive(folder: Path, say: Callable[[str], None]) -> Path:
    """Packs the folder beside it, or into the folder for temporary files where that has no room."""
    for place in (folder.parent, Path(tempfile.gettempdir())):
        path = place / f"{folder.name}.tar.gz"
        try:
            with tarfile.open(path, "x:gz") as packed:
                packed.add(folder, arcname=folder.name)
            return path
        except OSError as error:
            say(f"{path} cannot be written: {error.strerror}")
            with suppress(OSError):
                if not isinstance(error, FileExistsError):
                    path.unlink(missing_ok=True)
    raise Failed(f"no archive could be written; the results are in {folder}")
