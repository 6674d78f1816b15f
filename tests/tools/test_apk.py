"""tools/apk: pack.py writes what Android needs, and check.py finds errors of an APK.

The checks run on tampered copies of the real APK, build/android/vct.apk; without one they are skipped.
"""
import os
import pathlib
import shutil
import struct
import subprocess
import sys
import zipfile

import pytest

from apk import check, elf, pack
from files import ROOT

PT_LOAD = 1  # a loaded segment
APK = ROOT / "build" / "android" / "vct.apk"
OURS = "lib/arm64-v8a/libvct.so"


@pytest.fixture(scope="module")
def ndk():
    folder = os.environ.get("ANDROID_NDK_HOME")
    if not folder or not APK.exists():
        pytest.skip("no ANDROID_NDK_HOME, or scripts/apk.sh has not built an APK with it")
    return check.Ndk(pathlib.Path(folder))


class Copy:
    """The entries of the real APK, to be changed and written again."""

    def __init__(self, folder):
        self.path = folder / "tampered.apk"
        with zipfile.ZipFile(APK) as apk:
            self.entries = {info.filename: [info.compress_type, apk.read(info)] for info in apk.infolist()
                            if not info.filename.startswith("META-INF/")}

    def replace(self, name, old, new):
        data = self.entries[name][1]
        assert data.count(old) >= 1 and len(old) == len(new)
        self.entries[name][1] = data.replace(old, new)

    def write(self, signed=True):
        with zipfile.ZipFile(self.path, "w") as apk:
            for name, (kind, data) in self.entries.items():
                if kind == zipfile.ZIP_STORED:
                    pack.add_stored(apk, name, data)
                else:
                    apk.writestr(zipfile.ZipInfo(name), data, kind)
        if signed:
            user = pathlib.Path(os.environ.get("ANDROID_USER_HOME", pathlib.Path.home() / ".android"))
            subprocess.run(["apksigner", "sign", "--ks", user / "debug.keystore", "--ks-pass", "pass:android", self.path], check=True)
        return self.path

    def found(self, ndk, **how):
        return check.problems(self.write(**how), ndk)


@pytest.fixture
def copy(ndk, tmp_path):
    return Copy(tmp_path)


def only(found, name, *words):
    """Asserts that this check failed with these words, and no other did."""
    assert [key for key, messages in found.items() if messages] == [name], found
    text = "\n".join(found[name])
    for word in words:
        assert word in text
    return text


def test_untouched_copy_has_no_problem(copy, ndk):
    assert not any(copy.found(ndk).values())


def test_the_command_prints_problems_and_ends_with_1(copy, ndk):
    copy.entries["assets/scenes/extra.glb"] = [zipfile.ZIP_DEFLATED, b"glTF"]
    done = subprocess.run([sys.executable, ROOT / "tools/apk/check.py", copy.write(), "--ndk",
                           os.environ["ANDROID_NDK_HOME"]], capture_output=True, text=True, check=False)
    assert done.returncode == 1
    assert "assets: FAILED\n    assets/scenes/extra.glb is not in the repository" in done.stdout


def test_an_unsigned_apk_fails(copy, ndk):
    only(copy.found(ndk, signed=False), "signature", "apksigner")


def test_a_file_that_is_not_an_apk_is_an_error(ndk, tmp_path):
    for content in (b"", b"no zip file", APK.read_bytes()[:100000]):
        (tmp_path / "x.apk").write_bytes(content)
        done = subprocess.run([sys.executable, ROOT / "tools/apk/check.py", tmp_path / "x.apk", "--ndk",
                               os.environ["ANDROID_NDK_HOME"]], capture_output=True, text=True, check=False)
        assert done.returncode == 1
        assert "x.apk is not an APK" in done.stderr and "Traceback" not in done.stderr


def test_missing_and_changed_assets_fail(copy, ndk):
    del copy.entries["assets/shaders/shared/layout.h"]
    copy.entries["assets/shaders/passes/shade.frag"][1] += b"\n"
    only(copy.found(ndk), "assets", "shared/layout.h is missing", "passes/shade.frag differs from shaders/passes/shade.frag")


def segment_offsets(data):
    """Offsets of the program headers of loaded segments."""
    start, size, count = struct.unpack_from("<Q", data, 32)[0], *struct.unpack_from("<HH", data, 54)
    return [start + i * size for i in range(count) if struct.unpack_from("<I", data, start + i * size)[0] == PT_LOAD]


def test_a_segment_aligned_to_4_kib_fails(copy, ndk):
    data = bytearray(copy.entries[OURS][1])
    struct.pack_into("<Q", data, segment_offsets(data)[0] + 48, 4096)
    copy.entries[OURS][1] = bytes(data)
    only(copy.found(ndk), "pages of 16 KiB", "is aligned to 4096")


@pytest.mark.parametrize(("old", "new", "words"), [
    (b"\0libEGL.so\0", b"\0libEGX.so\0", "needs libEGX.so, which neither Android 24 nor the APK has"),
    (b"\0AAssetManager_open\0", b"\0AAssetManager_opeX\0", "no library that it needs has AAssetManager_opeX"),
    (b"\0ANativeActivity_onCreate\0", b"\0ANativeActivity_onCreatX\0", "not ANativeActivity_onCreate alone"),
    (b"\0.comment\0", b"\0.debug_x\0", "is not stripped"),
])
def test_wrong_names_in_our_library_fail(copy, ndk, old, new, words):
    copy.replace(OURS, old, new)
    assert words in only(copy.found(ndk), "libraries")


def elf_file(alignment=16384, undefined=(), text=b""):
    """A shared library with one loaded segment, the names that it needs of others, and `text` among its data."""
    strings = b"\0" + b"".join(name.encode() + b"\0" for name in undefined)
    symbols = bytes(24)
    for name in undefined:
        symbols += struct.pack("<IBBHQQ", strings.index(b"\0" + name.encode() + b"\0") + 1, 0x12, 0, 0, 0, 0)
    names = b"\0.dynsym\0.dynstr\0.shstrtab\0"
    contents = [(b"", 0, 0), (symbols, 11, 2), (strings, 3, 0), (names, 3, 0)]
    data = bytes(64) + struct.pack("<IIQQQQQQ", PT_LOAD, 5, 0, 0, 0, 4096, 4096, alignment)
    headers = b""
    for name, (content, kind, link) in zip((0, 1, 9, 17), contents, strict=True):
        headers += struct.pack("<IIQQQQIIQQ", name, kind, 0, 0, len(data), len(content), link, 0, 1, 24 if kind == 11 else 0)
        data += content
    data += text
    start = b"\x7fELF\x02\x01\x01" + bytes(9)
    header = start + struct.pack("<HHIQQQIHHHHHH", 3, 183, 1, 0, 64, len(data), 0, 64, 56, 1, 64, 4, 3)
    return header + data[64:] + headers


def apk_with(folder, **libraries):
    path = folder / "made.apk"
    with zipfile.ZipFile(path, "w") as apk:
        for name, data in libraries.items():
            pack.add_stored(apk, f"lib/arm64-v8a/{name}.so", data)
    return check.Apk(path)


def test_every_library_must_be_aligned_for_pages_of_16_kib(tmp_path):
    assert not list(check.segments(apk_with(tmp_path, libvct=elf_file(), cxx=elf_file(65536))))
    text = "".join(check.segments(apk_with(tmp_path, **{"libvct": elf_file(), "libc++_shared": elf_file(4096)})))
    assert "lib/arm64-v8a/libc++_shared.so: a segment at 0x0 is aligned to 4096, not to 16384" in text and "libvct" not in text


def test_a_damaged_library_is_an_error():
    whole = elf_file(undefined=["abort"])
    assert elf.read(whole).undefined == {"abort"}
    for data in (b"", b"no library", whole[:40], whole[:-70]):
        with pytest.raises(ValueError, match="not an ELF file, or a damaged one"):
            elf.read(data)


LLVM = elf_file(undefined=["dl_iterate_phdr", "abort"], text=b"\0libunwind: %s - %s\0")
GCC = elf_file(undefined=["dl_iterate_phdr", "abort"])
NO_UNWINDER = elf_file(undefined=["abort", "_Unwind_Resume"])


@pytest.mark.parametrize(("ours", "cxx"), [(LLVM, LLVM), (GCC, GCC), (NO_UNWINDER, LLVM), (NO_UNWINDER, GCC)])
def test_unwinders_of_one_kind_are_right(tmp_path, ours, cxx):
    assert not list(check.unwinders(apk_with(tmp_path, **{"libvct": ours, "libc++_shared": cxx})))


@pytest.mark.parametrize(("ours", "cxx", "words"), [
    (GCC, LLVM, "libc++_shared.so has libunwind and lib/arm64-v8a/libvct.so has libgcc"),
    (LLVM, GCC, "libc++_shared.so has libgcc and lib/arm64-v8a/libvct.so has libunwind"),
])
def test_different_unwinders_fail(tmp_path, ours, cxx, words):
    text = "".join(check.unwinders(apk_with(tmp_path, **{"libvct": ours, "libc++_shared": cxx})))
    assert words in text and "same NDK" in text


def test_packing_aligns_libraries_and_compresses_assets(tmp_path):
    """Without an NDK: stored libraries begin on pages, assets are compressed, the same input gives the same bytes."""
    base, library, folder = tmp_path / "base.apk", tmp_path / "libx.so", tmp_path / "shaders"
    with zipfile.ZipFile(base, "w") as apk:
        apk.writestr(zipfile.ZipInfo("AndroidManifest.xml"), b"x" * 77)
    library.write_bytes(os.urandom(5000))
    (folder / "shared").mkdir(parents=True)
    (folder / "shared" / "a.glsl").write_text("void main() {}\n" * 20)
    (folder / "README.md").write_text("not for the phone")
    results = []
    for name in ("first.apk", "second.apk"):
        out = tmp_path / name
        subprocess.run([sys.executable, ROOT / "tools/apk/pack.py", base, out, "--abi", "arm64-v8a", "--libraries", library,
                        "--assets", f"{folder}=shaders"], check=True)
        results.append(out.read_bytes())
    assert results[0] == results[1]
    apk = check.Apk(tmp_path / "first.apk")
    assert apk.zip.testzip() is None
    assert sorted(apk.zip.namelist()) == ["AndroidManifest.xml", "assets/shaders/shared/a.glsl", "lib/arm64-v8a/libx.so"]
    offset = apk.data_offset(apk.libraries[0])
    assert offset % 16384 == 0
    assert results[0][offset:offset + 5000] == library.read_bytes()
    assert apk.zip.getinfo("assets/shaders/shared/a.glsl").compress_type == zipfile.ZIP_DEFLATED
    assert not (tmp_path / "first.apk.tmp").exists()


@pytest.mark.skipif(not shutil.which("zipalign"), reason="zipalign is not installed")
def test_zipalign_agrees_with_the_packing(tmp_path):
    out = tmp_path / "stored.apk"
    with zipfile.ZipFile(out, "w") as apk:
        for size in (1, 16384, 5000):
            pack.add_stored(apk, f"lib/arm64-v8a/lib{size}.so", bytes(size))
    assert subprocess.run(["zipalign", "-c", "-p", "4", out], check=False).returncode == 0
