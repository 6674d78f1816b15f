"""Makes a page of what a phone sent: the archive of `scripts/phone.sh all`, or its folder.

    tools/eval.py phone out/phone/Pixel_7-20260101-120000.tar.gz

The page has what failed, the times of each preset beside those of this machine's vct and beside the bound for a Mali-T880 (with
`--bounds out/mali/bounds.json`, which `tools/eval.py mali` writes), the frames of a minute with the heat of the phone, and every
picture beside this machine's, with the differences. Writes OUT/index.html and its pictures, and prints the tables. An archive that
lacks a part makes a page without it. The exit status is 0 where a page could be made.
"""
from __future__ import annotations

import argparse
import csv
import json
import re
import statistics
import tarfile
import tempfile
from html import escape
from pathlib import Path
from typing import Any

import program
from files import ROOT, Failed, read_json, write_whole
from tables import STEPS, markdown

from .progress import say

REPORT_VERSION = 1  # of tools/device/everything.py
VISIBLE = 5 / 255  # a difference of colours that a pixel may have (vct compare)
SCREEN_OPTIONS = ("--preset", "mobile", "--mode", "gi-cone-shadow")  # of everything.SHOWN
FACTS = {"Android": r"ro\.build\.version\.release\]: \[(.*)\]", "build": r"ro\.build\.fingerprint\]: \[(.*)\]",
         "chip": r"ro\.soc\.model\]: \[(.*)\]", "GPU and driver": r"GLES: (.*)", "display": r"Physical size: (.*)",
         "memory": r"MemTotal: *(.*)", "kernel": r"^(Linux .*)"}


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("archive", type=Path, metavar="ARCHIVE", help="a .tar.gz of scripts/phone.sh all, or its folder")
    parser.add_argument("--bounds", type=Path, default=ROOT / "out/mali/bounds.json",
                        help="bounds of cornell at 400x400 (default: out/mali/bounds.json, where it is there)")
    parser.add_argument("--out", type=Path, help="folder (default: out/phone-page/ and the archive's name)")


def unpacked(archive: Path, into: Path) -> Path:
    """The folder of the results."""
    if archive.is_dir():
        return archive
    try:
        with tarfile.open(archive) as packed:
            # Others sent it: files only, and none outside of the folder.
            members = [member for member in packed if member.isfile() and not Path(member.name).is_absolute()
                       and ".." not in Path(member.name).parts]
            packed.extractall(into, members)
    except (OSError, tarfile.TarError, EOFError) as error:
        raise Failed(f"{archive} cannot be read as an archive of scripts/phone.sh all: {error}") from None
    folders = [path for path in into.iterdir() if path.is_dir()]
    if len(folders) != 1:
        raise Failed(f"{archive} has {len(folders)} folders, not one: it is no archive of scripts/phone.sh all")
    return folders[0]


def text_of(path: Path) -> str:
    return path.read_text(errors="replace") if path.is_file() else ""


def facts_table(folder: Path) -> str:
    text = text_of(folder / "device/device.txt")
    found = {name: match[1].strip() for name, pattern in FACTS.items() if (match := re.search(pattern, text, re.MULTILINE))}
    test = re.search(r"self-test (passed|FAILED).*", text_of(folder / "first-start/self-test.txt"))
    return markdown(["", "the phone says"], [*map(list, found.items()), ["test of the driver", test[0] if test else "no result"]])


def stages_table(report: dict[str, Any]) -> str:
    return markdown(["part", "seconds", "result"],
                    [[stage["name"], f"{stage['seconds']:.0f}",
                      "succeeded" if stage["passed"] else " / ".join(stage["problem"].splitlines()) or "failed"]
                     for stage in report["stages"]])


def heat_of(state: str, part: str) -> str:
    """Thermal status and battery temperature before and after a part: `0 -> 2, 31.0 -> 38.5 C`."""
    values = []
    for pattern, scale in ((r"Thermal Status: (\d+)", 1.0), (r"temperature: (\d+)", 0.1)):
        found = []
        for when in ("before", "after"):
            section = state.partition(f"== {when} {part} ==")[2].partition("\n== ")[0]
            match = re.search(pattern, section)
            found.append(f"{int(match[1]) * scale:.3g}" if match else "?")
        values.append(" -> ".join(found))
    return f"{values[0]}, {values[1]} C"


def frames_table(folder: Path) -> str:
    """Times of each preset's minute, in four quarters, so that a phone that slows down shows it."""
    state = text_of(folder / "state.txt")
    rows = []
    for path in sorted(folder.glob("frames/*/frames.csv")):
        frames = list(csv.DictReader(text_of(path).splitlines()))
        if not frames:
            continue
        last = float(frames[-1]["end_ms"])
        work = [float(frame["work_ms"]) for frame in frames]
        quarters = [[float(frame["frame_ms"]) for frame in frames if int(4 * float(frame["end_ms"]) / (last + 1e-9)) == quarter]
                    for quarter in range(4)]
        headrooms = [float(frame["headroom"]) for frame in frames if frame["headroom"]]
        rows.append([path.parent.name, str(len(frames)), " ".join(f"{statistics.median(ms):.1f}" if ms else "-" for ms in quarters),
                     f"{statistics.median(work):.1f}", f"{max(work):.0f}",
                     " ".join(dict.fromkeys(f"{float(frame['divisor']):g}" for frame in frames)),
                     f"{min(headrooms):.2f} to {max(headrooms):.2f}" if headrooms else "not told",
                     heat_of(state, f"frames/{path.parent.name}")])
    return markdown(["preset", "frames", "ms between frames, by quarter", "GPU's work, ms", "longest, ms", "divisors in turn",
                     "headroom (1: throttled)", "thermal status, battery"], rows) if rows else ""


class Desktop:
    """Renders what the phone rendered, on this machine."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    def bench(self, preset: str, phone: dict[str, Any]) -> tuple[Path, dict[str, Any]]:
        out = self.folder / preset
        settings = phone["settings"]
        program.run("render", ROOT / "assets" / Path(phone["scene"]).name, "--preset", preset, "--mode", "all", "--grid", settings["grid"],
                    "--size", f"{settings['width']}x{settings['height']}", "--shadow-map", settings["shadow_map"], "--cone-angle",
                    settings["cone_angle_deg"], "--revoxelize", "--tone-map", "none", "--exposure", "1", "--out", out, "--timings",
                    out / "timings.json")
        return out, json.loads((out / "timings.json").read_text())

    def screen(self, scene: str, size: tuple[int, int]) -> Path:
        """At half of the screen's size, as the app renders it."""
        from truth.gltf_file import GltfFile
        out, path = self.folder / f"{scene}-{size[0]}", ROOT / f"assets/{scene}.glb"
        time = ("--time", 1) if GltfFile(path).json.get("animations") else ()
        program.render(path, out, "--size", f"{size[0] // 2}x{size[1] // 2}", *SCREEN_OPTIONS, *time)
        return out / "gi-cone-shadow.png"


def times_table(preset: str, phone: dict[str, Any], desktop: dict[str, Any] | None, bounds: dict[str, Any]) -> str:
    """Milliseconds of each step: the phone's, this machine's, and the bound."""
    rows = []
    for mode, measured in phone["modes"].items():
        here = (desktop or {"modes": {}})["modes"].get(mode, {"steps": {}})["steps"]
        bound = bounds.get(preset, {}).get(mode, {})
        for step, times in measured["steps"].items():
            least = sum(bound.values()) if step == "total" else bound.get(step)
            rows.append([f"{mode}, {STEPS[step]}", f"{times['median']:.2f}", f"{here[step]['median']:.2f}" if step in here else "–",
                         f"{least:.2g}" if bound and least is not None else "–"])
        if "present" in measured:
            rows.append([f"{mode}, present", f"{measured['present']['median']:.2f}", "–", "–"])
    return markdown([f"{preset}: medians in ms", "phone", f"here: {desktop['driver']['renderer']}" if desktop else "here",
                     "bound, Mali-T880"], rows)


def differences(ours: Path, theirs: Path, blur: int, out: Path) -> tuple[float, float]:
    """The largest difference of two pictures, and the share of visible ones. `out` gets both beside their difference, enlarged five
    times. Pictures of a screen are compared as means of `blur` x `blur` pixels, because the app smooths and scales edges."""
    import numpy as np
    from PIL import Image
    first, second = (Image.open(path).convert("RGB") for path in (ours, theirs))
    if blur > 1:
        size = (max(1, first.width // blur), max(1, first.height // blur))
        first, second = (image.resize(size, Image.Resampling.BOX) for image in (first, second))
    if first.size != second.size:
        raise Failed(f"{ours} has {first.size} pixels and this machine's picture {second.size}")
    a, b = (np.asarray(image, np.float32) / 255 for image in (first, second))
    error = np.abs(a - b)
    beside = np.concatenate([a, b, np.minimum(5 * error, 1)], axis=1)
    out.parent.mkdir(parents=True, exist_ok=True)
    Image.fromarray((beside * 255 + 0.5).astype(np.uint8)).save(out)
    return float(error.max()), float((error.max(axis=2) > VISIBLE).mean())


def compared(pairs: list[tuple[str, Path, Path, int]], out: Path) -> tuple[str, str]:
    """A table and the pictures. `pairs`: name, the phone's picture, this machine's, and blur."""
    rows, pictures = [], ""
    for name, ours, theirs, blur in pairs:
        try:
            largest, share = differences(ours, theirs, blur, out / f"{name}.png")
        except (Failed, OSError) as error:
            rows.append([name, "–", str(error)])
            continue
        rows.append([name, f"{largest * 255:.0f}/255", f"{100 * share:.2f} %"])
        pictures += (f'<figure><img src="pictures/{escape(name)}.png" alt="{escape(name)}"><figcaption>{escape(name)}: phone, here, '
                     "difference &times; 5</figcaption></figure>")
    return markdown(["picture", "largest difference", "pixels that differ by more than 5/255"], rows) if rows else "", pictures


def sections(folder: Path, bounds: dict[str, Any], out: Path, work: Path) -> list[tuple[str, str, str]]:
    """Title, tables as Markdown, and pictures as HTML."""
    from PIL import Image
    report = read_json(folder / "report.json", "stages", REPORT_VERSION)
    failed = [stage["name"] for stage in report["stages"] if not stage["passed"]]
    first = "Everything succeeded.\n\n" if not failed else f"Failed: {', '.join(failed)}.\n\n"
    found = [("The phone", first + facts_table(folder) + "\n" + stages_table(report), ""),
             ("A minute of frames", frames_table(folder), "")]
    desktop = Desktop(work)
    tables, pairs = [], []
    for path in sorted(folder.glob("bench/*/timings.json")):
        preset = path.parent.name
        say(f"phone: {preset} on this machine")
        phone = read_json(path, "modes", program.TIMINGS_VERSION)
        try:
            pictures, here = desktop.bench(preset, phone)
            pairs += [(f"{preset}-{picture.stem}", picture, pictures / picture.name, 1) for picture in sorted(path.parent.glob("*.png"))]
        except Failed as error:
            here = None
            tables.append(f"{preset} on this machine: {error}\n")
        tables.append(times_table(preset, phone, here, bounds))
    for path in sorted(folder.glob("pictures/*.png")):
        scene = path.stem.rpartition("-")[0]
        if not (ROOT / f"assets/{scene}.glb").is_file():
            continue
        say(f"phone: {path.stem} on this machine")
        try:
            with Image.open(path) as image:
                size = image.size
            pairs.append((f"screen-{path.stem}", path, desktop.screen(scene, size), 16))
        except (Failed, OSError) as error:
            tables.append(f"{path.stem}: {error}\n")
    table, shown = compared(pairs, out / "pictures")
    return [*found, ("Times", "\n".join(tables), ""), ("Pictures", table, shown)]


def run(asked: argparse.Namespace) -> int:
    from .report import html_of
    out = asked.out or ROOT / "out/phone-page" / asked.archive.name.removesuffix(".tar.gz")
    bounds: dict[str, Any] = {}
    if asked.bounds.is_file():
        stored = read_json(asked.bounds, "presets", 1)
        if (stored["scene"], stored["size"]) != ("cornell.glb", [400, 400]):
            raise Failed(f"{asked.bounds} has the bounds of {stored['scene']}, and the phone measures cornell.glb at 400x400")
        bounds = stored["presets"]
    with tempfile.TemporaryDirectory() as name:
        folder = unpacked(asked.archive, Path(name))
        parts = [part for part in sections(folder, bounds, out, Path(name) / "here") if part[1] or part[2]]
        title = folder.name
    css = (Path(__file__).parent / "page.css").read_text()
    body = "".join(f"<h2>{escape(head)}</h2>{html_of(text)}{pictures}" for head, text, pictures in parts)
    write_whole(out / "index.html", f'<!DOCTYPE html><html lang="en"><meta charset="utf-8"><title>{escape(title)}</title>'
                f"<style>{css}</style><h1>{escape(title)}</h1>{body}</html>\n")
    print("\n".join(text for _, text, _ in parts if text), end="")
    print(f"Open {out / 'index.html'}")
    return 0
