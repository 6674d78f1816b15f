"""Starts the app with a command, and waits for what it answers."""
from __future__ import annotations

import os
import time
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

from files import Failed

from .adb import ACTIVITY, FILES, PACKAGE, Adb

POLL_S = float(os.environ.get("VCT_PHONE_POLL_S", "2"))
# Lines of the app's log that end a wait (jni/app/viewer_measuring.cpp).
SELF_TEST = ("self-test passed", "self-test FAILED")
FAILURES = ("measuring failed: ", "recording failed: ")


class App:
    def __init__(self, adb: Adb, say: Callable[[str], None]) -> None:
        self.adb = adb
        self.say = say
        self.pid = ""

    def start(self, command: str) -> None:
        """`command` is one of those of docs/phone.md. -S, because a running app would not receive it."""
        self.pid = ""
        text = self.adb.shell(f"input keyevent KEYCODE_WAKEUP; wm dismiss-keyguard; am start -S -n {ACTIVITY} --es vct '{command}'")
        if "Error" in text or "Exception" in text:
            raise Failed(f"the app does not start: {text}")

    def is_running(self) -> bool:
        found = self.adb.shell(f"pidof {PACKAGE}")
        self.pid = found or self.pid
        return bool(found)

    def log(self) -> list[str]:
        """The messages of the app that was started last, also after its end."""
        only = f" --pid={self.pid.split()[0]}" if self.pid else ""
        return [line for line in self.adb.shell(f"logcat -d -s vct{only}").splitlines() if not line.startswith("---")]

    def wait(self, what: str, timeout_s: float, is_done: Callable[[list[str]], bool]) -> list[str]:
        """Waits until `is_done` takes the log. Fails as soon as the app has ended or reports a failure."""
        end = time.monotonic() + timeout_s
        last = ""
        while True:
            running = self.is_running()
            lines = self.log()
            if is_done(lines):
                return lines
            if lines and lines[-1] != last:
                last = lines[-1]
                self.say(last)
            for line in lines:
                if any(failure in line for failure in FAILURES):
                    raise Failed(line[min(line.index(failure) for failure in FAILURES if failure in line):])
            words = "\n".join(lines[-20:])
            if not running:
                raise Failed(f"the app ended without {what}; its last messages:\n{words}")
            if time.monotonic() >= end:
                shown = self.adb.shell("dumpsys activity activities | grep -m 1 -i resumedactivity")
                self.adb.shell(f"am force-stop {PACKAGE}")
                hint = "" if not shown or PACKAGE in shown else "; another app is on the screen: unlock the phone and leave it alone"
                raise Failed(f"{what} did not come within {timeout_s:g} s{hint}; the app's last messages (--timeout gives it more time):\n{words}")
            time.sleep(POLL_S)

    def measure(self, command: str, out: Path, timeout_s: float) -> None:
        """Runs a command that writes results, and brings them into `out`, with the app's log in any case."""
        def state() -> str:
            found = self.adb.shell(f"cd {FILES}/results && ls done failed").splitlines()
            return next((name for name in found if name in ("done", "failed")), "")
        self.adb.shell(f"rm -rf {FILES}/results")
        try:
            self.start(command)
            self.wait("a result", timeout_s, lambda _: bool(state()))
            self.adb.pull(f"{FILES}/results", out)
            if (out / "failed").exists():
                raise Failed(f"the app could not measure: {(out / 'failed').read_text().strip()} ({out}/log.txt has its log)")
        finally:
            with suppress(Failed):
                (out / "log.txt").write_text("\n".join(self.log()) + "\n")

    def screenshot(self, path: Path) -> None:
        done = self.adb.raw("exec-out", "screencap -p")
        if not done.stdout.startswith(b"\x89PNG"):
            raise Failed(f"the phone made no picture of its screen: {(done.stdout[:200] + done.stderr).decode(errors='replace').strip()}")
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(done.stdout)
