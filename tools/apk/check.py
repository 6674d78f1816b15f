"""Checks an APK of this project: would Android install and load it, and does it hold the files of this repository?

Prints a line for each check, and ends with 1 where one fails. Needs an NDK, whose stub libraries list the symbols of Android,
aapt2, apksigner and zipalign of Android's SDK or of Debian, and pyelftools.
"""

from __future__ import annotations

import argparse
import pathlib
import re
import struct
import subprocess
import sys
import tomllib
import zipfile
from collections.abc import Iterator

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))

from apk import elf  # noqa: E402
from files import ROOT  # noqa: E402

PACKAGE = "vct.app"
PAGE = 16384
MAX_BYTES = 12_000_000
TRIPLES = {"arm64-v8a": "aarch64-linux-android", "x86_64": "x86_64-linux-android"}


def versions() -> dict[str, str]:
    return tomllib.loads((ROOT / "gradle" / "libs.versions.toml").read_text())["versions"]


def run(*command: str | pathlib.Path) -> tuple[int, str]:
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    return done.returncode, done.stdout + done.stderr


class Ndk:
    def __init__(self, folder: pathlib.Path):
        self.sysroot = next(folder.glob("toolchains/llvm/prebuilt/*/sysroot"))

    def libraries(self, abi: str, api: str) -> dict[str, elf.Library]:
        """The libraries that Android of this API level has for apps, with the symbols that they export."""
        folder = self.sysroot / "usr" / "lib" / TRIPLES[abi] / api
        # libc++.so there is a linker script.
        stubs = [path for path in folder.glob("*.so") if path.read_bytes()[:4] == b"\x7fELF"]
        return {path.name: elf.read(path.read_bytes()) for path in stubs}


class Apk:
    def __init__(self, path: pathlib.Path):
        self.path = path
        self.zip = zipfile.ZipFile(path)
        self.libraries = [info for info in self.zip.infolist() if re.fullmatch(r"lib/[^/]+/[^/]+\.so", info.filename)]
        self.abis = sorted({info.filename.split("/")[1] for info in self.libraries})

    def data_offset(self, info: zipfile.ZipInfo) -> int:
        """The offset of an entry's bytes in the APK: after its local header, whose extra field may differ from the directory's."""
        with self.path.open("rb") as file:
            file.seek(info.header_offset + 26)
            name_size, extra_size = struct.unpack("<HH", file.read(4))
        return info.header_offset + 30 + name_size + extra_size


def signature(apk: Apk) -> Iterator[str]:
    status, text = run("apksigner", "verify", "--min-sdk-version", versions()["minSdk"], apk.path)
    if status != 0:
        yield f"apksigner: {text.strip()}"


def badging(apk: Apk) -> Iterator[str]:
    status, text = run("aapt2", "dump", "badging", apk.path)
    if status != 0:
        yield f"aapt2: {text.strip()}"
        return
    expected = {
        "the package": f"package: name='{PACKAGE}' ",
        "minSdk": f"sdkVersion:'{versions()['minSdk']}'\n",
        "targetSdk": f"targetSdkVersion:'{versions()['targetSdk']}'\n",
        "OpenGL ES 3.1": "uses-gl-es: '0x30001'\n",
        "the Android Extension Pack as optional": "uses-feature-not-required: name='android.hardware.opengles.aep'\n",
        "the activity to start": "launchable-activity: name='android.app.NativeActivity' ",
        "a label": "application-label:'Voxel cone tracing'\n",
    }
    yield from (f"aapt2 does not list {what}: {line.strip()}" for what, line in expected.items() if line not in text)
    native = re.search(r"^native-code:(.*)$", text, re.M)
    if not native or sorted(re.findall(r"'([^']+)'", native[1])) != apk.abis or not apk.abis:
        yield f"aapt2 lists {native[0] if native else 'no native-code'}; the APK holds {apk.abis}"
    tree = run("aapt2", "dump", "xmltree", "--file", "AndroidManifest.xml", apk.path)[1]
    for attribute in ("hasCode", "extractNativeLibs"):
        if not re.search(rf":{attribute}\(0x[0-9a-f]+\)=false$", tree, re.M):
            yield f"the manifest does not say {attribute}=false"
    if re.search(r":appCategory\(0x[0-9a-f]+\)=0$", tree, re.M):
        yield "the manifest says appCategory=game, so game modes may scale pictures and limit frames"
    if not re.search(r"E: profileable.*\n(\s+A: .*\n)*?\s+A: .*:shell\(0x[0-9a-f]+\)=true$", tree, re.M):
        yield "the manifest does not say profileable shell=true"


def alignment(apk: Apk) -> Iterator[str]:
    status, text = run("zipalign", "-c", "-p", "4", apk.path)
    if status != 0:
        yield f"zipalign: {text.strip() or 'not aligned'}"
    for info in apk.libraries:
        if info.compress_type != zipfile.ZIP_STORED:
            yield f"{info.filename} is compressed, so Android cannot map it"
        elif apk.data_offset(info) % PAGE:
            yield f"{info.filename} starts at byte {apk.data_offset(info)}, not on a page of 16 KiB"


def size(apk: Apk) -> Iterator[str]:
    if apk.path.stat().st_size > MAX_BYTES:
        yield f"{apk.path.stat().st_size} bytes, more than {MAX_BYTES}"


def assets(apk: Apk) -> Iterator[str]:
    expected = {f"assets/shaders/{path.relative_to(ROOT / 'shaders').as_posix()}": path
                for path in (ROOT / "shaders").rglob("*") if path.is_file()}
    expected |= {f"assets/scenes/{path.name}": path for end in ("glb", "hdr") for path in (ROOT / "assets").glob(f"*.{end}")}
    held = {name for name in apk.zip.namelist() if name.startswith("assets/")}
    yield from (f"{name} is missing" for name in sorted(expected.keys() - held))
    yield from (f"{name} is not in the repository" for name in sorted(held - expected.keys()))
    for name in sorted(held & expected.keys()):
        if apk.zip.read(name) != expected[name].read_bytes():
            yield f"{name} differs from {expected[name].relative_to(ROOT)}"


def segments(apk: Apk) -> Iterator[str]:
    """Linkers of old NDKs, and their libc++_shared.so, align for pages of 4 KiB, and then the app does not start on newer phones."""
    for info in apk.libraries:
        for segment in elf.read(apk.zip.read(info)).segments:
            if segment.p_align % PAGE or (segment.p_vaddr - segment.p_offset) % PAGE:
                yield (f"{info.filename}: a segment at {segment.p_vaddr:#x} is aligned to {segment.p_align}, not to {PAGE}: "
                       "use NDK r27 or newer")
                break


def unwinder(data: bytes) -> str:
    """The library that a shared library has a copy of to unwind the stack for exceptions, or "" where it has none.

    Both find the tables of all libraries by dl_iterate_phdr. Only LLVM's libunwind has messages, which begin with its name.
    """
    if b"libunwind: " in data:
        return "libunwind"
    return "libgcc" if "dl_iterate_phdr" in elf.read(data).undefined else ""


def unwinders(apk: Apk) -> Iterator[str]:
    """An exception that begins in the copy of one library must not continue in that of another: the app would be killed."""
    for abi in apk.abis:
        found = {name: kind for info in apk.libraries if info.filename.split("/")[1] == abi
                 for name, kind in [(info.filename, unwinder(apk.zip.read(info)))] if kind}
        if len(set(found.values())) > 1:
            held = " and ".join(f"{name} has {kind}" for name, kind in sorted(found.items()))
            yield f"{held} for exceptions, and one that passes both kills the app: take both libraries from the same NDK"


def library(apk: Apk, info: zipfile.ZipInfo, android: dict[str, elf.Library]) -> Iterator[str]:
    _, abi, name = info.filename.split("/")
    data = apk.zip.read(info)
    try:
        found = elf.read(data)
    except ValueError as error:
        yield f"{info.filename}: {error}"
        return
    if found.machine != elf.MACHINES[abi]:
        yield f"{info.filename} is for {found.machine}, not {abi}"
    own = {other.filename.split("/")[2]: other for other in apk.libraries if other.filename.split("/")[1] == abi}
    exported: set[str] = set()
    for needed in found.needed:
        if needed in own:
            exported |= elf.read(apk.zip.read(own[needed])).exported
        elif needed in android:
            exported |= android[needed].exported
        else:
            yield f"{info.filename} needs {needed}, which neither Android {versions()['minSdk']} nor the APK has"
    for symbol in sorted(found.undefined - exported):
        yield f"{info.filename}: no library that it needs has {symbol}"
    if name == "libvct.so":
        if found.exported != {"ANativeActivity_onCreate"}:
            yield f"{info.filename} exports {sorted(found.exported)[:5]}, not ANativeActivity_onCreate alone"
        if any(section.startswith(".debug_") for section in found.sections):
            yield f"{info.filename} is not stripped"
        if str(ROOT).encode() in data:
            yield f"{info.filename} names the folder that it was built in, {ROOT}"


def libraries(apk: Apk, ndk: Ndk) -> Iterator[str]:
    for abi in apk.abis:
        if f"lib/{abi}/libvct.so" not in apk.zip.namelist():
            yield f"lib/{abi}/libvct.so is missing"
        if abi not in TRIPLES:
            yield f"this project is not built for {abi}"
            continue
        android = ndk.libraries(abi, versions()["minSdk"])
        for info in apk.libraries:
            if info.filename.split("/")[1] == abi:
                yield from library(apk, info, android)


def problems(path: pathlib.Path, ndk: Ndk) -> dict[str, list[str]]:
    """The problems that each check found; an empty list where it found none."""
    apk = Apk(path)
    damaged = apk.zip.testzip()
    if damaged:
        return {"signature": list(signature(apk)), "archive": [f"{damaged} is damaged"]}
    checks = {
        "signature": signature(apk), "manifest": badging(apk), "alignment in the file": alignment(apk),
        "size": size(apk), "assets": assets(apk), "libraries": libraries(apk, ndk),
        "pages of 16 KiB": segments(apk), "one kind of unwinder": unwinders(apk),
    }
    return {name: list(found) for name, found in checks.items()}


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("apk", type=pathlib.Path)
    parser.add_argument("--ndk", type=pathlib.Path, required=True, help="the NDK that built it")
    arguments = parser.parse_args()
    ndk = Ndk(arguments.ndk)
    try:
        found = problems(arguments.apk, ndk)
    except (OSError, zipfile.BadZipFile) as error:
        print(f"error: {arguments.apk} is not an APK: {error}", file=sys.stderr)
        return 1
    for name, messages in found.items():
        print(f"{name}: {'FAILED' if messages else 'ok'}")
        for message in messages:
            print(f"    {message}")
    held = Apk(arguments.apk)
    print(f"{arguments.apk}: {arguments.apk.stat().st_size} bytes, {', '.join(held.abis)}")
    return 1 if any(found.values()) else 0


if __name__ == "__main__":
    sys.exit(main())
