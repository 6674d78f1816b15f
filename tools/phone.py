"""Controls the app on a phone that is connected by adb. docs/phone.md explains how to connect it.

  scripts/phone.sh all                   installs, tests, measures and takes pictures; makes a folder and an archive to send
  scripts/phone.sh install               installs the APK
  scripts/phone.sh push SCENE.glb...     copies scenes to the phone with the files that they name, and their sky (.hdr) and kept
                                         light (.vctlight) beside them, for the app's list of scenes; skies (.hdr) alone, too
  scripts/phone.sh bench [KEY=VALUE...]  installs, measures, copies the results and prints the tables;
                                         default: scene=cornell.glb preset=thesis size=400x400
  scripts/phone.sh shot                  saves a picture of the phone's screen
  scripts/phone.sh log                   prints the app's messages
  scripts/phone.sh info                  prints what the phone tells about itself

Options before the command: --apk FILE (default: the newest build), --timeout SECONDS for each wait (default: 1800), --out DIR
(default: out/phone; each run makes a folder MODEL-DATE in it and deletes nothing). ANDROID_SERIAL chooses one of several phones.
"""
from __future__ import annotations

import json
import re
import subprocess
import sys
import time
import urllib.parse
from pathlib import Path

from device import everything, facts
from device.adb import FILES, Adb
from device.app import App
from files import ROOT, Failed

BESIDE = (".hdr", ".vctlight")  # what the app reads of the same name beside a scene
BENCH = {"scene": "cornell.glb", "preset": "thesis", "size": "400x400"}


class Usage(Exception):
    """The command line is wrong."""


def say(text: str) -> None:
    print(f"phone: {text}", flush=True)


class Options:
    def __init__(self, words: list[str]) -> None:
        self.apk: Path | None = None
        self.timeout_s = 1800.0
        self.out = ROOT / "out/phone"
        while words and words[0].startswith("--"):
            if len(words) < 2:
                raise Usage
            name, value, words = words[0], words[1], words[2:]
            if name == "--apk":
                self.apk = Path(value)
            elif name == "--timeout":
                if not re.fullmatch(r"[1-9][0-9]*", value):
                    raise Failed(f"--timeout is '{value}', not a number of seconds")
                self.timeout_s = float(value)
            elif name == "--out":
                self.out = Path(value).expanduser()
            else:
                raise Usage
        if not words:
            raise Usage
        self.command, self.words = words[0], words[1:]

    def find_apk(self) -> Path:
        if self.apk is not None:
            if not self.apk.is_file():
                raise Failed(f"there is no APK '{self.apk}'")
            return self.apk
        built = [path for path in (ROOT / "build/android/vct.apk", ROOT / "app/build/outputs/apk/debug/app-debug.apk") if path.is_file()]
        if not built:
            raise Failed("there is no APK yet: scripts/apk.sh or ./gradlew assembleDebug builds one")
        return max(built, key=lambda path: path.stat().st_mtime)


def files_of(scene: Path) -> list[Path]:
    """A scene, its sky and its light, and the files that it names, relative to its folder."""
    found = [Path(scene.name), *(Path(scene.name).with_suffix(ending) for ending in BESIDE if scene.with_suffix(ending).is_file())]
    if scene.suffix == ".gltf":
        try:
            document = json.loads(scene.read_text())
        except (OSError, ValueError) as error:
            raise Failed(f"'{scene}' cannot be read as glTF: {error}") from None
        for source in [*document.get("buffers", []), *document.get("images", [])]:
            uri = source.get("uri", "data:")
            if uri.startswith("data:"):
                continue
            name = Path(urllib.parse.unquote(uri))
            if name.is_absolute() or ".." in name.parts:
                raise Failed(f"'{scene}' names '{uri}', which is outside of its folder: move the file there, or export a .glb")
            if not (scene.parent / name).is_file():
                raise Failed(f"'{scene}' names '{uri}', and there is no such file beside it")
            found.append(name)
    return list(dict.fromkeys(found))


def push(adb: Adb, scenes: list[str]) -> None:
    if not scenes:
        raise Failed("push needs at least one scene (.glb, .gltf) or sky (.hdr)")
    for scene in scenes:
        if not Path(scene).is_file():
            raise Failed(f"there is no file '{scene}'")
        if not scene.endswith((".glb", ".gltf", ".hdr")):
            raise Failed(f"'{scene}' is neither .glb nor .gltf nor .hdr")
    wanted = [(Path(scene), files_of(Path(scene))) for scene in scenes]
    adb.require_phone()
    if not adb.has_app():
        raise Failed("the app is not installed: scripts/phone.sh install")
    for scene, names in wanted:
        for name in names:
            target = f"{FILES}/{name.as_posix()}"
            # The phone's shell splits words, and this one passes them on.
            adb.shell(f"mkdir -p '{Path(target).parent.as_posix()}'")
            done = adb.raw("push", str(scene.parent / name), target, timeout_s=600)
            if done.returncode != 0:
                raise Failed(f"cannot push '{scene.parent / name}': {(done.stdout + done.stderr).decode(errors='replace').strip()}")
        say(f"pushed {' '.join(map(str, names))}; the app's lists show {scene.name} when opened next")


def bench(adb: Adb, options: Options) -> None:
    chosen = dict(BENCH)
    for word in options.words:
        # The argument passes through two shells.
        if not re.fullmatch(r"[a-z-]+=[A-Za-z0-9._,:=+-][A-Za-z0-9._,:=+ -]*", word):
            raise Failed(f"'{word}' is not KEY=VALUE of letters, digits, spaces and . _ , : = + -")
        name, _, value = word.partition("=")
        chosen.pop(name, None)
        chosen[name] = value
    command = " ".join(["bench", *(f"{name}={value}" for name, value in chosen.items())])
    adb.require_phone()
    install(adb, options)
    model = adb.model()
    say(f"{model}: {command} (unlock the phone and leave it alone; at most {options.timeout_s:g} s)")
    folder = results_folder(adb, options)
    start = time.monotonic()
    App(adb, say).measure(command, folder, options.timeout_s)
    say(f"results of {time.monotonic() - start:.0f} s in {folder}")
    tables = [folder / name for name in ("bench.txt", "presets.txt") if (folder / name).is_file()]
    if not tables:
        raise Failed(f"the app reported success, but there is neither bench.txt nor presets.txt in {folder}")
    print(tables[0].read_text(), end="")


def results_folder(adb: Adb, options: Options) -> Path:
    return everything.new_folder(options.out, f"{adb.model()}-{time.strftime('%Y%m%d-%H%M%S')}", say)


def install(adb: Adb, options: Options) -> None:
    apk = options.find_apk()
    say(f"installing {apk}")
    adb.install(apk)


def run_all(adb: Adb, options: Options) -> None:
    apk = options.find_apk()
    adb.require_phone()
    folder = results_folder(adb, options)
    say(f"everything goes to {folder}; unlock the phone and leave it alone for about half an hour")
    work = everything.Everything(adb, folder, options.timeout_s, say)
    passed = False
    try:
        passed = work.run(apk)
    finally:
        say(f"send this file: {everything.archive(folder, say)}")
    if not passed:
        failed = [f"{stage['name']}: {stage['problem'].splitlines()[0]}" for stage in work.stages if not stage["passed"]]
        raise Failed("not everything succeeded, and the archive says why:\n" + "\n".join(failed))


def run(options: Options) -> None:
    adb = Adb()
    if options.words and options.command not in ("push", "bench"):
        raise Usage
    if options.command == "push":
        return push(adb, options.words)
    if options.command == "bench":
        return bench(adb, options)
    if options.command == "all":
        return run_all(adb, options)
    if options.command not in ("install", "shot", "log", "info"):
        raise Usage
    adb.require_phone()
    if options.command == "install":
        install(adb, options)
    elif options.command == "shot":
        path = results_folder(adb, options) / "screen.png"
        App(adb, say).screenshot(path)
        say(f"wrote {path}")
    elif options.command == "log":
        print("\n".join(App(adb, say).log()))
    else:
        print(facts.answers(adb, (*facts.DEVICE, *facts.STATE)))
    return None


def main(words: list[str]) -> int:
    try:
        run(Options(words))
        return 0
    except Usage:
        print(__doc__, file=sys.stderr)
        return 2
    except (Failed, OSError, subprocess.SubprocessError) as error:
        print(f"phone: error: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("phone: stopped", file=sys.stderr)
        return 130


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
