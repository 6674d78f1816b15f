#!/usr/bin/env python3
"""One picture of time against error for all presets, from a sweep: docs/images/pareto.png.

    .venv/bin/python tools/pareto.py --sweep out/sweep/sweep.json

Small marks are scenes, large ones the geometric means over them. Time is that of mode 4's voxels, irradiance and cones,
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
LEFT, TOP, RIGHT, BOTTOM = 160, 100, 1570, 730
# The report's, a little darker: they must stand on white.
COLOURS = {"thesis": "#c8641e", "mobile": "#3b7fc4", "quality": "#0a7f5d"}
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
                and settings["grid"] != "auto"
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
                    [(0, -1.3), (1.3, 0), (0, 1.3), (-1.3, 0)], [(0, 1.15), (1.1, -0.9), (-1.1, -0.9)],
                    [(-0.4, -1.2), (0.4, -1.2), (0.4, -0.4), (1.2, -0.4), (1.2, 0.4), (0.4, 0.4), (0.4, 1.2),
                     (-0.4, 1.2), (-0.4, 0.4), (-1.2, 0.4), (-1.2, -0.4), (-0.4, -0.4)],
                    [(-1.2, -0.55), (1.2, -0.55), (1.2, 0.55), (-1.2, 0.55)])
        outline = outlines[number % len(outlines)]
        self.pen.polygon([((at[0] + r * x) * TWICE, (at[1] + r * y) * TWICE) for x, y in outline], colour, PAPER, TWICE)

    def text(self, at: tuple[float, float], text: str, size: int, colour: str = INK, anchor: str = "lm") -> float:
        """Stands out against what is drawn already. Returns where it ends, across."""
        font = ImageFont.load_default(size * TWICE)
        self.pen.text((at[0] * TWICE, at[1] * TWICE), text, colour, font, anchor, stroke_width=3 * TWICE, stroke_fill=PAPER)
        return at[0] + font.getlength(text) / TWICE

    def cubed(self, at: tuple[float, float], text: str, size: int, colour: str) -> None:
        """The text, its middle there, and a raised 3 behind, which Pillow's own font does not have."""
        width = ImageFont.load_default(size * TWICE).getlength(text) / TWICE
        self.text((at[0] + width / 2 + 2, at[1] - size * 0.28), "3", round(size * 0.6), colour, "lm")
        self.text(at, text, size, colour, "mm")

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


def is_usual(dot: Dot) -> bool:
    """Not another grid of the thesis's preset."""
    return dot.preset != "thesis" or dot.grid == USUAL["grid"]


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
    page.text(((LEFT + RIGHT) / 2, BOTTOM + 62), "milliseconds a frame: voxels, irradiance and cones", 28, anchor="mm")
    page.upright((28, (TOP + BOTTOM) / 2), "error of the indirect light, relMSE", 28)


def footnote(sweep: dict[str, Any]) -> str:
    entry = next(entry for entry in sweep["points"] if "driver" in entry)
    driver = entry["driver"]["renderer"].split(" (")[0]
    return (f"{driver}{', a software driver' if driver == 'llvmpipe' else ''}; mode 4; times and errors of the same frames "
            f"of {entry['settings']['size']} pixels; both axes logarithmic.")


def draw(found: list[Dot], note: str) -> bytes:
    small, middle = [dot for dot in found if is_usual(dot)], means(found)
    page, axes = Page(), Axes(small + middle)
    scenes = sorted({dot.scene for dot in found})
    draw_axes(page, axes)
    for dot in small:
        page.shape(scenes.index(dot.scene), axes.at(dot), 9, COLOURS[dot.preset])
    page.line([axes.at(dot) for dot in middle if dot.preset == "thesis"], COLOURS["thesis"], 2.5)
    for dot in middle:
        x, y = axes.at(dot)
        if is_usual(dot):
            page.shape(0, (x, y), 19, COLOURS[dot.preset])
            page.cubed((x, y - 40), f"{dot.preset} {dot.grid}", 32, COLOURS[dot.preset])
        else:
            page.shape(0, (x, y), 11, COLOURS[dot.preset])
            page.cubed((x, y + 28), f"{dot.grid}", 24, COLOURS[dot.preset])
    x = page.text((28, 40), "Lower left is better.  Large: mean of the scenes.  Small:", 26)
    for number, scene in enumerate(scenes):
        page.shape(number, (x + 26, 40), 9, SOFT)
        x = page.text((x + 42, 40), scene.replace("_", " "), 26)
    page.text((LEFT, SIZE[1] - 26), note, 22, SOFT)
    return page.png()


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sweep", type=Path, default=Path("out/sweep/sweep.json"), help="default: %(default)s")
    parser.add_argument("--out", type=Path, default=Path("docs/images/pareto.png"), help="default: %(default)s")
    options = parser.parse_args()
    sweep = store.read(options.sweep)
    found = dots(sweep)
    if not found:
        raise SystemExit(f"error: {options.sweep} has no errors of the indirect light")
    write_beside(options.out, draw(found, footnote(sweep)))
    print(shown(options.out))
    return 0


if __name__ == "__main__":
    sys.exit(main())
