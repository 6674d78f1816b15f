"""scripts/phone.sh against a stand-in for adb (stand_in_adb.sh): the commands that it sends, and its errors when the phone does
something else. No phone is involved."""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tarfile

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
        self.environment = {}
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
        environment = os.environ | {"PHONE": str(self.folder), "VCT_PHONE_POLL_S": "0.1", "VCT_PHONE_SETTLE_S": "0",
                                    "VCT_PHONE_RECONNECT_S": "0", "TMPDIR": str(self.folder.parent),
                                    "PATH": path or f"{self.bin}:{os.environ['PATH']}"} | self.environment
        environment.pop("ANDROID_SERIAL", None)
        return subprocess.run([self.script, *arguments], env=environment, capture_output=True, text=True, check=False,
                              timeout=300)

    def bench(self, *arguments, timeout="5"):
        return self.run("--apk", str(self.apk), "--out", str(self.out), "--timeout", timeout, "bench", *arguments)

    def results(self):
        """The one folder of results."""
        [found] = [path for path in self.out.iterdir() if path.is_dir()]
        return found

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


def test_bench_brings_the_results_and_prints_their_tables(phone):
    phone.app(f"echo 'milliseconds of each step' > {RESULTS}/presets.txt", f"echo picture > {RESULTS}/gi.png",
              f"echo ok > {RESULTS}/done.tmp", f"mv {RESULTS}/done.tmp {RESULTS}/done")
    done = phone.bench("scene=my court.glb", "grid=64")
    assert done.returncode == 0, done.stdout + done.stderr
    assert "--es vct 'bench preset=thesis size=400x400 scene=my court.glb grid=64'" in phone.calls()
    assert "am start -S -n vct.app/android.app.NativeActivity" in phone.calls()
    assert sorted(path.name for path in phone.results().iterdir()) == ["done", "gi.png", "log.txt", "presets.txt"]
    assert "frame 2" in (phone.results() / "log.txt").read_text()
    assert done.stdout.endswith("milliseconds of each step\n")


def test_results_of_an_earlier_run_are_ignored(phone):
    old = phone.folder / RESULTS
    old.mkdir(parents=True)
    (old / "done").write_text("old")
    phone.app("sleep 60")
    failed(phone.bench(timeout="1"), "a result did not come within 1 s")
    assert [path.name for path in phone.results().iterdir()] == ["log.txt"]


@pytest.mark.parametrize(("does", "words"), [
    (["sleep 60"], ["a result did not come within 1 s", "frame 2"]),
    ([f"echo 'no GL_EXT_geometry_shader' > {RESULTS}/failed"], ["could not measure: no GL_EXT_geometry_shader"]),
    (["sleep 0.3"], ["ended without a result", "frame 2"]),
    (["echo 'E vct: measuring failed: cannot create the folder' > log", "sleep 60"], ["measuring failed: cannot create the folder"]),
    (["touch unplugged", "sleep 60"], ["connection to the phone was lost"]),
    ([f"echo ok > {RESULTS}/done"], ["neither bench.txt nor presets.txt"])])
def test_an_app_without_results_is_reported_with_the_cause(phone, does, words):
    phone.app(*does)
    failed(phone.bench(timeout="1" if does == ["sleep 60"] else "20"), *words)
    assert ("am force-stop vct.app" in phone.calls()) == (does == ["sleep 60"])
    assert (phone.results() / "log.txt").exists() == ("touch unplugged" not in does)


def test_a_missing_adb_is_an_error(phone, tmp_path):
    tools = tmp_path / "tools"
    tools.mkdir()
    for name in ("bash", "dirname", "env"):
        (tools / name).symlink_to(shutil.which(name))
    (tools / "python3").symlink_to(os.path.realpath(sys.executable))
    failed(phone.run("bench", path=str(tools)), "adb is not installed")


@pytest.mark.parametrize(("file", "content", "words"), [
    ("devices", "", "adb finds no phone"),
    ("devices", "0123\tunauthorized\n", "answer the question on its screen"),
    ("devices", "0123\toffline\n", "is 'offline'"),
    ("devices", "0123\tno permissions (missing udev rules?)\n", "android-sdk-platform-tools-common"),
    ("install", "Failure [INSTALL_FAILED_USER_RESTRICTED: Install canceled by user]\n", "Install via USB"),
    ("install", "Failure [INSTALL_FAILED_VERIFICATION_FAILURE]\n", "Verify apps over USB"),
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
    failed(phone.run("push", str(phone.apk)), "neither .glb nor .gltf nor .hdr")


def test_a_wrong_command_line_prints_the_usage(phone):
    for arguments in ((), ("fly",), ("--unknown", "x", "bench"), ("--apk",)):
        done = phone.run(*arguments)
        assert done.returncode == 2
        assert "scripts/phone.sh push SCENE.glb" in done.stderr
    failed(phone.run("--timeout", "soon", "bench"), "not a number of seconds")


# An app that does all that `all` asks for, with a picture's pixels left out.
EVERYTHING = f"""
mkdir -p {RESULTS}
case "$VCT_COMMAND" in
    *record=*) echo 'end_ms,frame_ms,work_ms,divisor,headroom' > {RESULTS}/frames.csv; echo ok > {RESULTS}/done ;;
    bench*) echo picture > {RESULTS}/gi.png; echo ok > {RESULTS}/done ;;
    show*)
        scene="${{VCT_COMMAND#*scene=}}"
        printf 'I vct: self-test passed: all\nI vct: scenes/%s: 36 triangles\n' "${{scene%% *}}" > log ;;
esac
"""
STAGES = ["device", "install", "first-start", "pictures", "frames/mobile", "frames/quality", "frames/thesis", "bench/mobile",
          "bench/quality", "bench/thesis"]


def run_all(phone, behaviour=EVERYTHING, timeout="20"):
    phone.set("app", behaviour)
    return phone.run("--apk", str(phone.apk), "--out", str(phone.out), "--timeout", timeout, "all")


def archived(place):
    """The files of the one archive, without the name of its folder, and its report by stage."""
    [path] = place.glob("*.tar.gz")
    with tarfile.open(path) as packed:
        names = {name.partition("/")[2]: name for name in packed.getnames()}
        report = json.load(packed.extractfile(names["report.json"]))
    return set(names), {stage["name"]: stage["problem"] for stage in report["stages"]}


def test_all_brings_everything_in_one_archive(phone):
    (phone.folder / "settings").mkdir()
    (phone.folder / "settings/accelerometer_rotation").write_text("1\n")
    done = run_all(phone)
    assert done.returncode == 0, done.stdout + done.stderr
    names, problems = archived(phone.out)
    assert problems == dict.fromkeys(STAGES, "")
    assert {"device/device.txt", "state.txt", "first-start/self-test.txt", "pictures/town-landscape.png",
            "pictures/cornell-portrait.png", "pictures/panel-portrait.png", "frames/thesis/frames.csv", "bench/quality/gi.png",
            *(f"{stage}/{file}" for stage in STAGES for file in ("logcat.txt", "ended.txt"))} <= names
    assert "send this file: " in done.stdout
    assert (phone.folder / "settings/accelerometer_rotation").read_text() == "1\n", "the screen turns by itself again"
    state = (phone.results() / "state.txt").read_text()
    assert "== before bench/thesis ==" in state and "dumpsys of battery" in state


def test_a_second_run_and_other_files_stay(phone):
    phone.out.mkdir()
    (phone.out / "mine.txt").write_text("mine")
    assert run_all(phone).returncode == run_all(phone).returncode == 0
    assert (phone.out / "mine.txt").read_text() == "mine"
    assert len(list(phone.out.glob("*.tar.gz"))) == 2
    assert "rm -rf /sdcard/Android/data/vct.app/files/results" in phone.calls()


def test_a_crash_in_the_middle_loses_only_its_part(phone):
    done = run_all(phone, "if [[ $VCT_COMMAND == bench*quality* ]]; then echo 'F libc: Fatal signal 11' > log; rm -f running; exit; fi\n"
                   + EVERYTHING)
    failed(done, "not everything succeeded", "bench/quality: the app ended without a result")
    names, problems = archived(phone.out)
    assert [name for name, problem in problems.items() if problem] == ["bench/quality"]
    assert "bench/thesis/gi.png" in names
    assert "Fatal signal 11" in (phone.results() / "bench/quality/logcat.txt").read_text()
    assert "dumpsys of activity exit-info" in (phone.results() / "bench/quality/ended.txt").read_text()


def test_a_phone_without_space_sends_its_facts(phone):
    phone.set("install", "Failure [INSTALL_FAILED_INSUFFICIENT_STORAGE]\n")
    failed(run_all(phone), "install: the phone has too little free space")
    names, problems = archived(phone.out)
    assert list(problems) == STAGES[:2]
    assert {"device/device.txt", "install/logcat.txt"} <= names


def test_an_app_that_cannot_write_says_so_for_each_part(phone):
    done = run_all(phone, EVERYTHING.replace(f"mkdir -p {RESULTS}\n", f"""
case "$VCT_COMMAND" in bench*|*record=*) echo 'E vct: measuring failed: no space left' > log; sleep 60; exit ;; esac
mkdir -p {RESULTS}
"""))
    failed(done, "frames/mobile: measuring failed: no space left", "bench/thesis: measuring failed: no space left")
    names, problems = archived(phone.out)
    assert [name for name, problem in problems.items() if not problem] == STAGES[:4]
    assert "frames/mobile/log.txt" in names


def test_a_phone_that_is_unplugged_leaves_what_it_sent(phone):
    done = run_all(phone, "[[ $VCT_COMMAND != bench*quality* ]] || touch unplugged\n" + EVERYTHING)
    failed(done, "bench/quality: the connection to the phone was lost", "bench/thesis: not run: the phone was lost")
    names, problems = archived(phone.out)
    assert [name for name, problem in problems.items() if problem] == STAGES[-2:]
    assert "bench/mobile/gi.png" in names


def test_a_phone_that_is_plugged_in_again_goes_on(phone):
    phone.environment["VCT_PHONE_RECONNECT_S"] = "20"
    done = run_all(phone, "[[ $VCT_COMMAND != bench*quality* ]] || { touch unplugged; sleep 2; rm unplugged; }\n" + EVERYTHING)
    failed(done, "bench/quality: the connection to the phone was lost")
    _, problems = archived(phone.out)
    assert [name for name, problem in problems.items() if problem] == ["bench/quality"]


def test_a_folder_that_cannot_be_written_is_replaced(phone):
    phone.out.write_text("a file where the folder should be")
    done = run_all(phone)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "cannot be written (File exists): the results go to " in done.stdout
    [folder] = phone.folder.parent.glob("vct-phone-*")
    assert archived(folder)[1] == dict.fromkeys(STAGES, "")
    assert phone.out.read_text() == "a file where the folder should be"


def test_shot_log_and_info_are_commands(phone):
    done = phone.run("--out", str(phone.out), "shot")
    assert done.returncode == 0, done.stderr
    assert (phone.results() / "screen.png").read_bytes().startswith(b"\x89PNG")
    assert "I vct: frame 2" in phone.run("log").stdout
    assert "dumpsys of battery" in phone.run("info").stdout


def test_push_brings_the_files_that_a_scene_names(phone, tmp_path):
    phone.set("installed", "")
    scene = tmp_path / "mine.gltf"
    scene.write_text(json.dumps({"buffers": [{"uri": "my%20data/mine.bin"}],
                                 "images": [{"uri": "wood.png"}, {"uri": "data:image/png;base64,AAAA"}, {"bufferView": 0}]}))
    failed(phone.run("push", str(scene)), "names 'my%20data/mine.bin', and there is no such file")
    (tmp_path / "my data").mkdir()
    (tmp_path / "my data/mine.bin").write_bytes(b"bytes")
    (tmp_path / "wood.png").write_bytes(b"wood")
    done = phone.run("push", str(scene))
    assert done.returncode == 0, done.stderr
    files = phone.folder / "sdcard/Android/data/vct.app/files"
    assert (files / "mine.gltf").exists() and (files / "wood.png").read_bytes() == b"wood"
    assert (files / "my data/mine.bin").read_bytes() == b"bytes"
    scene.write_text(json.dumps({"buffers": [{"uri": "../secret.bin"}]}))
    failed(phone.run("push", str(scene)), "outside of its folder")


def test_push_brings_the_sky_and_the_light_beside_a_scene(phone, tmp_path):
    phone.set("installed", "")
    for name in ("mine.glb", "mine.hdr", "mine.vctlight", "other.hdr"):
        (tmp_path / name).write_bytes(name.encode())
    files = phone.folder / "sdcard/Android/data/vct.app/files"
    assert phone.run("push", str(tmp_path / "mine.glb")).returncode == 0
    assert {path.name for path in files.iterdir()} == {"mine.glb", "mine.hdr", "mine.vctlight"}
    assert phone.run("push", str(tmp_path / "other.hdr")).returncode == 0
    assert (files / "other.hdr").read_bytes() == b"other.hdr"
