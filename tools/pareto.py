#!/usr/bin/env python3
"""One picture of time against error for all presets, from a sweep: docs/images/pareto.png.

    .venv/bin/python tools/pareto.py --sweep out/report/sweep/sweep.json

Small marks are scenes, large ones the geometric means over them. Time is that of mode 4's voxels, bounces and cones,
the error relMSE of the indirect light. Left out: the furnace and the lone plane, which are truths and not scenes.
"""
from __future__ import annotations

import argparse
import io
import math
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from PIL import Image, ImageDraw, ImageFont

sys.path.insert(0, str(Path(__file__).resolve().parent))

from bars import NO_SHARE, geometric_mean  # noqa: E402
from references import SAME_PICTURE  # noqa: E402
from report.sweep_data import USUAL, light_ms  # noqa: E402
from sweep import store  # noqa: E402
from sweep.identity import shown, write_beside  # noqa: E402

SIZE = (1600, 860)  # pixels of the file, drawn twice as large
TWICE = 2
LEFT, TOP, RIGHT, BOTTOM = 130, 100, 1570, 730
# The report's, a little darker: they must stand on white.
COLOURS = {"thesis": "#c8641e", "mobile": "#0a7f5d", "quality": "#3b7fc4"}
INK, SOFT, PAPER = "#222222", "#777777", "#ffffff"


@dataclass(frozen=True)
class Dot:
    scene: str
    preset: str
    grid: int
    ms: float
    error: float


def dots(sweep: dict[str, Any]) -> list[Dot]:
    found = []
    for entry in sweep["points"]:
        settings = entry["settings"]
        error = entry.get("errors", {}).get("indirect", {}).get("relmse")
        if (error and entry["scene"] not in NO_SHARE | SAME_PICTURE.keys() and settings["experiment"] == "none"
                and settings["cone_angle_deg"] == USUAL["cone_angle_deg"]):
            found.append(Dot(entry["scene"], settings["preset"], settings["grid"], light_ms(entry["modes"]["gi"])[0], error))
    return found


def means(found: list[Dot]) -> list[Dot]:
    """Over the scenes, of each preset and grid that has all of them."""
    groups: dict[tuple[str, int], list[Dot]] = {}
    for dot in found:
        groups.setdefault((dot.preset, dot.grid), []).append(dot)
    scenes = {dot.scene for dot in found}
    return [Dot("", preset, grid, geometric_mean([dot.ms for dot in group]), geometric_mean([dot.error for dot in group]))
            for (preset, grid), group in sorted(groups.items()) if {dot.scene for dot in group} == scenes]


class Axes:
    """Both logarithmic."""

    def __init__(self, found: list[Dot]) -> None:
        self.x = self.range([dot.ms for dot in found])
        self.y = self.range([dot.error for dot in found])

    @staticmethod
    def range(values: list[float]) -> tuple[float, float]:
        return min(values) / 1.3, max(values) * 1.3

    def at(self, dot: Dot) -> tuple[float, float]:
        across = math.log(dot.ms / self.x[0]) / math.log(self.x[1] / self.x[0])
        up = math.log(dot.error / self.y[0]) / math.log(self.y[1] / self.y[0])
        return LEFT + across * (RIGHT - LEFT), BOTTOM - up * (BOTTOM - TOP)


def ticks(low: float, high: float) -> list[float]:
    return [digit * 10.0**power for power in range(math.floor(math.log10(low)), math.ceil(math.log10(high)) + 1)
            for digit in (1, 2, 5) if low <= digit * 10.0**power <= high]


class Page:
    """Coordinates are pixels of the file."""

    def __init__(self) -> None:
        self.image = Image.new("RGB", (SIZE[0] * TWICE, SIZE[1] * TWICE), PAPER)
        self.pen = ImageDraw.Draw(self.image)

    def line(self, points: list[tuple[float, float]], colour: str, width: float) -> None:
        self.pen.line([(x * TWICE, y * TWICE) for x, y in points], colour, round(width * TWICE))

    def shape(self, number: int, at: tuple[float, float], r: float, colour: str) -> None:
        outlines = ([(math.cos(t / 20 * math.tau), math.sin(t / 20 * math.tau)) for t in range(20)],
                    [(-0.9, -0.9), (0.9, -0.9), (0.9, 0.9), (-0.9, 0.9)], [(0, -1.15), (1.1, 0.9), (-1.1, 0.9)],
                    [(0, -1.3), (1.3, 0), (0, 1.3), (-1.3, 0)], [(0, 1.15), (1.1, -0.9), (-1.1, -0.9)])
        outline = outlines[number % len(outlines)]
        self.pen.polygon([((at[0] + r * x) * TWICE, (at[1] + r * y) * TWICE) for x, y in outline], colour, PAPER, TWICE)

    def text(self, at: tuple[float, float], text: str, size: int, colour: str = INK, anchor: str = "lm") -> float:
        """Returns where it ends, across."""
        font = ImageFont.load_default(size * TWICE)
        self.pen.text((at[0] * TWICE, at[1] * TWICE), text, colour, font, anchor)
        return at[0] + font.getlength(text) / TWICE

    def upright(self, at: tuple[float, float], text: str, size: int) -> None:
        font = ImageFont.load_default(size * TWICE)
        words = Image.new("RGB", (round(font.getlength(text)) + 8, size * TWICE * 2), PAPER)
        ImageDraw.Draw(words).text((4, words.height / 2), text, INK, font, "lm")
        turned = words.rotate(90, expand=True)
        self.image.paste(turned, (round(at[0] * TWICE - turned.width / 2), round(at[1] * TWICE - turned.height / 2)))

    def png(self) -> bytes:
        out = io.BytesIO()
        self.image.resize(SIZE, Image.Resampling.LANCZOS).quantize(128).save(out, "PNG", optimize=True)
        return out.getvalue()


def draw_axes(page: Page, axes: Axes) -> None:
    for value in ticks(*axes.x):
        x, _ = axes.at(Dot("", "", 0, value, axes.y[0]))
        page.line([(x, TOP), (x, BOTTOM)], "#e4e4e4", 1)
        page.text((x, BOTTOM + 24), f"{value:g}", 24, SOFT, "mm")
    for value in ticks(*axes.y):
        _, y = axes.at(Dot("", "", 0, axes.x[0], value))
        page.line([(LEFT, y), (RIGHT, y)], "#e4e4e4", 1)
        page.text((LEFT - 14, y), f"{value:.4f}".rstrip("0"), 24, SOFT, "rm")
    page.line([(LEFT, TOP), (LEFT, BOTTOM), (RIGHT, BOTTOM)], SOFT, 2)
    page.text(((LEFT + RIGHT) / 2, BOTTOM + 62), "milliseconds a frame: voxels, bounces and cones", 28, anchor="mm")
    page.upright((32, (TOP + BOTTOM) / 2), "error of the indirect light, relMSE", 28)


def draw(found: list[Dot], driver: str) -> bytes:
    page, axes = Page(), Axes(found)
    scenes = sorted({dot.scene for dot in found})
    draw_axes(page, axes)
    middle = means(found)
    # From each preset's mean to its scenes: which mark belongs to which.
    for dot in found:
        usual = dot.preset != "thesis" or dot.grid == USUAL["grid"]
        if usual:
            page.shape(scenes.index(dot.scene), axes.at(dot), 9, COLOURS[dot.preset])
    page.line([axes.at(dot) for dot in middle if dot.preset == "thesis"], COLOURS["thesis"], 2.5)
    for dot in middle:
        usual = dot.preset != "thesis" or dot.grid == USUAL["grid"]
        x, y = axes.at(dot)
        page.shape(0, (x, y), 19 if usual else 11, COLOURS[dot.preset])
        name = f"{dot.preset} {dot.grid}³" if usual else f"{dot.grid}³"
        page.text((x, y - (38 if usual else 28)), name, 32 if usual else 24, COLOURS[dot.preset], "mm")
    x = page.text((LEFT, 40), "Lower left is better.  Large: mean of the scenes.  Small:", 26)
    for number, scene in enumerate(scenes):
        page.shape(number, (x + 26, 40), 9, SOFT)
        x = page.text((x + 42, 40), scene.replace("_", " "), 26)
    page.text((LEFT, SIZE[1] - 26), f"Measured with {driver}; mode 4, 256×256 pixels; both axes logarithmic.", 22, SOFT)
    return page.png()


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sweep", type=Path, default=Path("out/report/sweep/sweep.json"), help="default: %(default)s")
    parser.add_argument("--out", type=Path, default=Path("docs/images/pareto.png"), help="default: %(default)s")
    options = parser.parse_args()
    sweep = store.read(options.sweep)
    found = dots(sweep)
    if not found:
        raise SystemExit(f"error: {options.sweep} has no errors of the indirect light")
    driver = next(entry["driver"]["renderer"] for entry in sweep["points"] if "driver" in entry)
    write_beside(options.out, draw(found, f"{driver.split(' (')[0]}, a software driver" if "llvmpipe" in driver else driver))
    print(shown(options.out))
    return 0


if __name__ == "__main__":
    sys.exit(main())
