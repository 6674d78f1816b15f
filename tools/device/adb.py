"""Runs adb. Every call ends after a time, whatever the phone does."""
from __future__ import annotations

import os
import re
import shutil
import subprocess
import time
from pathlib import Path

from files import Failed

PACKAGE = "vct.app"
ACTIVITY = f"{PACKAGE}/android.app.NativeActivity"
FILES = f"/sdcard/Android/data/{PACKAGE}/files"

INSTALL_FAILURES = {
    "UPDATE_INCOMPATIBLE": f"the phone has the app with another signature: adb uninstall {PACKAGE} (its results and scenes go with "
                           "it), then run this again",
    "USER_RESTRICTED": "the phone does not let a computer install apps: turn 'Install via USB' on in its developer options (Xiaomi "
                       "asks for an account and a SIM card), answer its question, then run this again",
    "VERIFICATION_FAILURE": "the phone's check of apps (Play Protect) refused the app: turn 'Verify apps over USB' off in the "
                            "developer options, then run this again",
    "INSUFFICIENT_STORAGE": "the phone has too little free space (INSUFFICIENT_STORAGE): free 200 MB, then run this again",
}


class Lost(Failed):
    """The phone no longer answers."""


class Adb:
    def __init__(self) -> None:
        self.program = shutil.which("adb")

    def raw(self, *arguments: str, timeout_s: float = 60) -> subprocess.CompletedProcess[bytes]:
        # adb shell would read this program's stdin.
        try:
            return subprocess.run([str(self.program), *arguments], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                  stderr=subprocess.PIPE, timeout=timeout_s, check=False)
        except subprocess.TimeoutExpired:
            raise Lost(f"the phone did not answer 'adb {' '.join(arguments)}' within {timeout_s:g} s") from None

    def run(self, *arguments: str, timeout_s: float = 60) -> str:
        """The output; a connection that was lost is an error, and nothing else is, because old versions of adb end with 0 always."""
        done = self.raw(*arguments, timeout_s=timeout_s)
        if done.returncode != 0 and not self.is_connected():
            raise Lost("the connection to the phone was lost; the app goes on without it: connect it and run this again")
        return (done.stdout + done.stderr).decode(errors="replace").replace("\r", "")

    def shell(self, command: str, timeout_s: float = 60) -> str:
        return self.run("shell", command, timeout_s=timeout_s).strip()

    def has_app(self) -> bool:
        try:
            return bool(self.shell(f"pm path {PACKAGE}"))
        except Lost:
            return False

    def is_connected(self) -> bool:
        try:
            return self.raw("get-state", timeout_s=10).stdout.strip() == b"device"
        except Lost:
            return False

    def wait(self, seconds: float) -> bool:
        """Waits for a phone that was lost."""
        end = time.monotonic() + seconds
        while not self.is_connected():
            if time.monotonic() >= end:
                return False
            time.sleep(min(1.0, seconds))
        return True

    def require_phone(self) -> None:
        """Fails unless there is one phone that trusts this computer."""
        if self.program is None:
            raise Failed("adb is not installed: on Debian or Ubuntu, apt install adb; or Android's platform tools")
        listed = self.raw("devices")
        text = listed.stdout.decode(errors="replace").replace("\r", "")
        if listed.returncode != 0:
            raise Failed(f"adb devices: {text}{listed.stderr.decode(errors='replace')}")
        found = re.findall(r"^([^ *\t][^\t\n]*)\t(.*)$", text, re.MULTILINE)
        serial = os.environ.get("ANDROID_SERIAL")
        found = [(name, state) for name, state in found if not serial or name == serial]
        if not found:
            raise Failed(f"adb finds no phone{' ' + serial if serial else ''}: connect it by USB and turn USB debugging on in its "
                         "developer options")
        if len(found) > 1:
            raise Failed("adb finds several phones; choose one by ANDROID_SERIAL: " + ", ".join(name for name, _ in found))
        state = found[0][1]
        if state.startswith("unauthorized"):
            raise Failed("the phone does not trust this computer yet: answer the question on its screen, then run this again")
        if "no permissions" in state:
            raise Failed(f"this computer may not use the phone ({state}): apt install android-sdk-platform-tools-common, take the "
                         "cable out and in again")
        if not state.startswith("device"):
            raise Failed(f"the phone is '{state}': unlock it, or take the cable out and in again")

    def model(self) -> str:
        return re.sub(r"[^A-Za-z0-9._-]", "_", self.shell("getprop ro.product.model")) or "phone"

    def install(self, apk: Path) -> None:
        text = self.run("install", "-r", str(apk), timeout_s=600).strip()
        if re.search(r"^Success", text, re.MULTILINE):
            return
        for word, meaning in INSTALL_FAILURES.items():
            if word in text:
                raise Failed(meaning)
        if "NO_MATCHING_ABIS" in text:
            raise Failed(f"the APK has no library for this phone's processor ({self.shell('getprop ro.product.cpu.abilist')}): it is "
                         "built for 64-bit ARM")
        raise Failed(f"installing failed: {text}")

    def pull(self, source: str, target: Path) -> None:
        """Copies a folder's contents from the phone."""
        target.mkdir(parents=True, exist_ok=True)
        done = self.raw("pull", f"{source}/.", str(target), timeout_s=300)
        if done.returncode != 0:
            if not self.is_connected():
                raise Lost("the connection to the phone was lost while it sent its results")
            raise Failed(f"cannot fetch {source}: {(done.stdout + done.stderr).decode(errors='replace').strip()}")
