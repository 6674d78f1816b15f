"""Adds shared libraries and assets to an APK that aapt2 linked. apksigner signs the result.

Android maps an uncompressed library straight from the APK, if it starts on a page: 16 KiB on the newest phones. zipalign
knows that since build tools 35; older ones, such as Debian's, align to 4 KiB. So this places the files itself.
"""

import argparse
import pathlib
import shutil
import struct
import zipfile

PAGE = 16384
# The zip extra field in which zipalign and apksigner note an alignment: apksigner keeps it when it rewrites the file.
ALIGNMENT_FIELD = 0xD935
LOCAL_HEADER_SIZE = 30
# The time of every entry, so that the same input gives the same APK. It is the oldest that a zip can hold.
TIME = (1980, 1, 1, 0, 0, 0)


def add_stored(apk: zipfile.ZipFile, name: str, data: bytes) -> None:
    """Adds an uncompressed entry whose first byte lies at the start of a page."""
    info = zipfile.ZipInfo(name, TIME)
    fixed = struct.pack("<HHH", ALIGNMENT_FIELD, 0, PAGE)
    start = apk.start_dir + LOCAL_HEADER_SIZE + len(name.encode()) + len(fixed)
    padding = -start % PAGE
    info.extra = struct.pack("<HHH", ALIGNMENT_FIELD, 2 + padding, PAGE) + bytes(padding)
    apk.writestr(info, data, zipfile.ZIP_STORED)


def add_folder(apk: zipfile.ZipFile, folder: pathlib.Path, name: str) -> None:
    """Every shader, scene or sky below the folder, compressed."""
    for path in sorted(folder.rglob("*")):
        # The app does not read pages.
        if path.is_file() and path.suffix != ".md":
            info = zipfile.ZipInfo(f"assets/{name}/{path.relative_to(folder).as_posix()}", TIME)
            apk.writestr(info, path.read_bytes(), zipfile.ZIP_DEFLATED, 9)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("base", type=pathlib.Path, help="the APK that aapt2 linked")
    parser.add_argument("out", type=pathlib.Path, help="the unsigned APK")
    parser.add_argument("--abi", required=True, help="such as arm64-v8a")
    parser.add_argument("--libraries", type=pathlib.Path, nargs="+", required=True)
    parser.add_argument("--assets", nargs="+", default=[], help="FOLDER=NAME, which becomes assets/NAME")
    arguments = parser.parse_args()

    temporary = arguments.out.with_name(arguments.out.name + ".tmp")
    shutil.copyfile(arguments.base, temporary)
    with zipfile.ZipFile(temporary, "a") as apk:
        for library in arguments.libraries:
            add_stored(apk, f"lib/{arguments.abi}/{library.name}", library.read_bytes())
        for entry in arguments.assets:
            folder, name = entry.rsplit("=", 1)
            add_folder(apk, pathlib.Path(folder), name)
    temporary.replace(arguments.out)


if __name__ == "__main__":
    main()
