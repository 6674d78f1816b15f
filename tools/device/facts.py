"""What a phone tells about itself and about an app that ended, as text for a person and for tools/eval.py phone."""
from __future__ import annotations

from collections.abc import Iterable

from .adb import PACKAGE, Adb, Lost

DEVICE = (
    "getprop | grep -E 'ro\\.(product|soc|board|hardware|build\\.(fingerprint|version)|boot\\.(hardware|qemu)|opengles|gfx|vendor)'",
    "getprop ro.build.fingerprint",
    "dumpsys SurfaceFlinger | grep -i -m 3 GLES",
    "wm size; wm density",
    "dumpsys display | grep -E -m 20 'fps|refreshRate|DisplayModeRecord'",
    "dumpsys window displays | grep -m 5 -i -E 'cutout|rotation'",
    "settings get global low_power; settings get system peak_refresh_rate; settings get system font_scale",
    "head -n 5 /proc/meminfo",
    "cat /proc/cpuinfo | grep -E 'Hardware|CPU part' | sort | uniq -c",
    "uname -a",
    "df -h /data /sdcard",
    f"dumpsys package {PACKAGE} | grep -E -m 4 'versionName|primaryCpuAbi|firstInstallTime|lastUpdateTime'",
    f"cmd game mode {PACKAGE}; dumpsys game | grep -A 3 {PACKAGE}",
)
STATE = (
    "date",
    "dumpsys battery",
    "dumpsys thermalservice",
    f"dumpsys meminfo {PACKAGE} | head -n 40",
)
# Reports about an app that ended. Only the system keeps tombstones and traces, and hands them out by dropbox.
ENDED = (
    f"dumpsys activity exit-info {PACKAGE}",
    *(f"dumpsys dropbox --print {tag} | grep -A 400 {PACKAGE} | head -n 1500"
      for tag in ("data_app_native_crash", "data_app_anr", "data_app_crash", "SYSTEM_TOMBSTONE")),
)


def answers(adb: Adb, commands: Iterable[str]) -> str:
    """Each command and its output, by one call. A command that a phone lacks costs nothing but its own answer."""
    commands = list(commands)
    heads = ["echo '$ " + command.replace("'", "'\\''") + "'" for command in commands]
    try:
        return adb.shell("; ".join(f"{head}; ({command}) 2>&1; echo" for head, command in zip(heads, commands))) + "\n"
    except Lost:
        if not adb.is_connected():
            raise
    # One of them did not end.
    parts = []
    for command in commands:
        try:
            parts.append(f"$ {command}\n{adb.shell(command, timeout_s=20)}\n")
        except Lost:
            if not adb.is_connected():
                raise
            parts.append(f"$ {command}\n(no answer within 20 s)\n")
    return "\n".join(parts)
