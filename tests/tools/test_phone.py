"""scripts/phone.sh against a stand-in for adb (stand_in_adb.sh): the commands that it sends, and its errors when the phone does
something else. No phone is involved; the measurements are those of the renderer on this machine."""
import json
import os
import pathlib
import shutil
import subprocess

import phone_tables
import pytest

RESULTS = "sdcard/Android/data/vct.app/files/results"
DEVICE = "0123456789ABCDEF\tdevice\n"


class Phone:
    """A folder that stands in for a phone, and the script run against it."""

    def __init__(self, root, folder):
        self.script = root / "scripts" / "phone.sh"
        self.folder = folder / "phone"
        self.bin = folder / "bin"
        self.out = folder / "out"
        self.apk = folder / "vct.apk"
        self.bin.mkdir()
        (self.bin / "adb").symlink_to(root / "tests" / "tools" / "stand_in_adb.sh")
        (self.folder / "sdcard").mkdir(parents=True)
        self.apk.write_bytes(b"an APK, to a stand-in")
        self.set("devices", DEVICE)
        self.set("install", "Performing Streamed Install\nSuccess\n")
        self.set("log", "I vct: frame 1\nI vct: frame 2\n")

    def set(self, name, text):
        (self.folder / name).write_text(text)

    def app(self, *lines):
        """Sets the app's behaviour: lines of shell, run in the phone's folder after the results' folder is made."""
        self.set("app", "\n".join(["set -eu", f"mkdir -p {RESULTS}", *lines, "rm -f running"]))

    def run(self, *arguments, path=None):
        environment = os.environ | {"PHONE": str(self.folder), "VCT_PHONE_POLL_S": "0.1",
                                    "PATH": path or f"{self.bin}:{os.environ['PATH']}"}
        environment.pop("ANDROID_SERIAL", None)
        return subprocess.run([self.script, *arguments], env=environment, capture_output=True, text=True, check=False,
                              timeout=60)

    def bench(self, *arguments, timeout="5"):
        return self.run("--apk", str(self.apk), "--out", str(self.out), "--timeout", timeout, "bench", *arguments)

    def calls(self):
        return (self.folder / "calls").read_text()


@pytest.fixture
def phone(root, tmp_path):
    return Phone(root, tmp_path)


def failed(done, *words):
    assert done.returncode == 1, done.stdout + done.stderr
    assert "phone: error: " in done.stderr
    for word in words:
        assert word in done.stderr, done.stderr


@pytest.fixture
def timings(program, root, tmp_path):
    """A real timings.json."""
    folder = tmp_path / "timings"
    subprocess.run([program, "render", root / "assets" / "cornell.glb", "--out", folder, "--mode", "gi", "--grid", "64",
                    "--size", "64x64", "--timings", folder / "timings.json"], check=True, capture_output=True)
    return folder / "timings.json"


def test_bench_brings_the_results_and_prints_them_beside_others(phone, timings):
    phone.app(f"cp {timings} {RESULTS}/timings.json", f"echo picture > {RESULTS}/gi.png", f"echo ok > {RESULTS}/done.tmp",
              f"mv {RESULTS}/done.tmp {RESULTS}/done")
    done = phone.run("--apk", str(phone.apk), "--out", str(phone.out), "--beside", f"desk={timings}", "bench",
                     "scene=my court.glb", "grid=64")
    assert done.returncode == 0, done.stdout + done.stderr
    assert "--es vct 'bench preset=thesis size=400x400 scene=my court.glb grid=64'" in phone.calls()
    assert "am start -S -n vct.app/android.app.NativeActivity" in phone.calls()
    assert sorted(path.name for path in phone.out.iterdir()) == ["done", "gi.png", "log.txt", "timings.json"]
    assert "frame 2" in (phone.out / "log.txt").read_text()
    assert "Test Phone, 64^3" in done.stdout and "desk, 64^3" in done.stdout
    total = next(iter(json.loads(timings.read_text())["modes"].values()))["steps"]["total"]["median"]
    assert f"| frame | {total:.2f} | {total:.2f} |" in done.stdout


def test_results_of_an_earlier_run_are_ignored(phone):
    old = phone.folder / RESULTS
    old.mkdir(parents=True)
    (old / "done").write_text("old")
    phone.app("sleep 60")
    failed(phone.bench(timeout="1"), "no result after 1 s")
    assert not phone.out.exists()


@pytest.mark.parametrize(("does", "words"), [
    (["sleep 60"], ["no result after 1 s", "frame 2"]),
    ([f"echo 'no GL_EXT_geometry_shader' > {RESULTS}/failed"], ["could not measure: no GL_EXT_geometry_shader"]),
    (["sleep 0.3"], ["ended without a result", "frame 2"]),
    (["touch unplugged", "sleep 60"], ["connection to the phone was lost"]),
    ([f"echo ok > {RESULTS}/done"], ["neither bench.json nor timings.json"])])
def test_an_app_without_results_is_reported_with_the_cause(phone, does, words):
    phone.app(*does)
    failed(phone.bench(timeout="1" if does == ["sleep 60"] else "5"), *words)
    assert ("am force-stop vct.app" in phone.calls()) == (does == ["sleep 60"])
    assert (phone.out / "log.txt").exists() == any(RESULTS in line for line in does)


def test_a_missing_adb_is_an_error(phone, tmp_path):
    tools = tmp_path / "tools"
    tools.mkdir()
    for name in ("bash", "dirname", "sed", "env"):
        (tools / name).symlink_to(shutil.which(name))
    failed(phone.run("bench", path=str(tools)), "adb is not installed")


@pytest.mark.parametrize(("file", "content", "words"), [
    ("devices", "", "adb finds no phone"),
    ("devices", "0123\tunauthorized\n", "answer the question on its screen"),
    ("devices", "0123\toffline\n", "is 'offline'"),
    ("devices", "0123\tdevice\n4567\tdevice\n", "ANDROID_SERIAL"),
    ("install", "Failure [INSTALL_FAILED_UPDATE_INCOMPATIBLE: signatures do not match]\n", "adb uninstall vct.app"),
    ("install", "Failure [INSTALL_FAILED_NO_MATCHING_ABIS]\n", "no library for this phone's processor"),
    ("install", "Failure [INSTALL_FAILED_INSUFFICIENT_STORAGE]\n", "INSUFFICIENT_STORAGE")])
def test_a_phone_that_is_not_ready_or_refuses_the_app_is_an_error(phone, file, content, words):
    phone.set(file, content)
    failed(phone.bench(), words)
    assert ("install" in phone.calls()) == (file == "install")
    assert "am start" not in phone.calls()


def test_a_missing_apk_is_an_error(phone):
    phone.apk.unlink()
    failed(phone.bench(), "there is no APK")


@pytest.mark.parametrize("argument", ["grid", "scene= b.glb", "scene=x';reboot'", "Grid=64"])
def test_arguments_must_be_key_and_value(phone, argument):
    failed(phone.bench(argument), "is not KEY=VALUE")
    assert not (phone.folder / "calls").exists()


def test_push_copies_scenes_and_refuses_other_files(phone, tmp_path):
    scene = tmp_path / "mine.glb"
    scene.write_bytes(b"glTF")
    failed(phone.run("push", str(scene)), "not installed")
    assert phone.run("--apk", str(phone.apk), "install").returncode == 0
    done = phone.run("push", str(scene))
    assert done.returncode == 0, done.stderr
    assert (phone.folder / "sdcard/Android/data/vct.app/files/mine.glb").read_bytes() == b"glTF"
    failed(phone.run("push", str(pathlib.Path("nowhere.glb"))), "no file 'nowhere.glb'")
    failed(phone.run("push", str(phone.apk)), "neither .glb nor .gltf")


def test_a_wrong_command_line_prints_the_usage(phone):
    for arguments in ((), ("fly",), ("--unknown", "x", "bench"), ("--apk",)):
        done = phone.run(*arguments)
        assert done.returncode == 2
        assert "scripts/phone.sh push SCENE.glb" in done.stderr
    failed(phone.run("--timeout", "soon", "bench"), "not a number of seconds")


def test_counters_of_the_gpu_have_rows():
    mode = {"steps": {"total": {"median": 12.5}}}
    counted = mode | {"gpu_counters": {"cycles": 5e6, "read_bytes": 25e5, "written_bytes": 1e6}}
    files = [("phone", {"settings": {"grid": 64}, "modes": {"ao": counted}}),
             ("desk", {"settings": {"grid": 64}, "modes": {"ao": mode}})]
    [(_, _, rows)] = phone_tables.step_tables(files)
    assert rows[1:] == [["GPU cycles, million", "5.00", "–"], ["read, MB", "2.50", "–"], ["written, MB", "1.00", "–"]]
    [(_, _, rows)] = phone_tables.step_tables(files[1:])
    assert len(rows) == 1
