#!/usr/bin/env python3
"""What the presets must reach, checked: a Markdown table of every bar, and 1 where one is missed or not measured.

    build/desktop/vct bench assets/cornell.glb --preset thesis,mobile,quality --json out/presets.json
    .venv/bin/python tools/bars.py --sweep out/sweep/sweep.json --bench out/presets.json

Errors come from the sweep, at each preset's usual settings; times and memory from the bench. Not a test: a software
driver's times differ from one run to the next.
"""
from __future__ import annotations

import argparse
import json
import math
import sys
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parent))

from references import SAME_PICTURE  # noqa: E402
from report.sweep_data import closeness, usual_settings  # noqa: E402
from sweep import store  # noqa: E402

PRESETS = ("thesis", "mobile", "quality")
Values = dict[str, float | None]  # by preset; None where it was not measured


@dataclass(frozen=True)
class Limit:
    """What a value must not exceed, or with `least` fall short of: a number, or a share of the thesis's value."""

    value: float
    of_thesis: bool = False
    least: bool = False

    def held(self, value: float | None, thesis: float | None) -> bool:
        """A bias counts by its size."""
        if value is None or (self.of_thesis and thesis is None):
            return False
        limit = self.value * thesis if self.of_thesis else self.value
        return value >= limit if self.least else abs(value) <= limit

    def __str__(self) -> str:
        number = f"1/{1 / self.value:g}" if self.of_thesis and (1 / self.value).is_integer() else f"{self.value:g}"
        return f"{'≥' if self.least else '≤'} {number}{' of thesis' if self.of_thesis else ''}"


@dataclass(frozen=True)
class Bar:
    figure: str
    measure: str
    metric: str
    limits: dict[str, tuple[Limit, ...]]  # by preset
    but: frozenset[str] = frozenset()  # scenes that it does not hold for
    only: frozenset[str] = frozenset()  # the scenes that it holds for; none: all
    mean: dict[str, tuple[Limit, ...]] | None = None  # of the geometric mean over the scenes

    def holds_for(self, scene: str) -> bool:
        return scene not in self.but and (not self.only or scene in self.only)


# The furnace is a truth and not a scene, as is the lone plane: of its light, 0, there is no share. The lamp's box is lit
# by a small emitter alone, which few cones meet, and has bars of its own.
FURNACE, LONE_PLANE, LAMP = frozenset({"furnace"}), frozenset({"lone_plane"}), frozenset({"lamp"})
NO_SHARE = FURNACE | LONE_PLANE
NO_SUN = FURNACE | LAMP
BARS = (
    Bar("indirect light, relMSE", "indirect", "relmse",
        {"mobile": (Limit(1 / 4, True),), "quality": (Limit(1 / 6, True),)}, NO_SHARE | LAMP,
        mean={"mobile": (Limit(1 / 8, True),), "quality": (Limit(1 / 12, True),)}),
    Bar("indirect light, FLIP", "indirect", "flip",
        {"mobile": (Limit(0.7, True),), "quality": (Limit(1 / 2, True), Limit(0.08))}, NO_SHARE | LAMP),
    Bar("indirect light, bias", "indirect", "bias", {"quality": (Limit(0.10),)}, NO_SHARE | LAMP),
    Bar("ambient occlusion, RMSE", "ao", "rmse", {"mobile": (Limit(0.05),), "quality": (Limit(0.05),)}),
    Bar("soft shadow, RMSE", "shadow", "rmse", {"mobile": (Limit(0.05),), "quality": (Limit(0.05),)}, NO_SUN),
    Bar("mode 4 against all bounces, FLIP", "gi-full", "flip", {"mobile": (Limit(0.08),), "quality": (Limit(0.06),)}, NO_SUN),
    Bar("mode 4 against all bounces, bias", "gi-full", "bias", {"mobile": (Limit(0.15),)}, NO_SUN),
    Bar("all bounces of a furnace, bias", "gi-full", "bias", {"mobile": (Limit(0.06),), "quality": (Limit(0.06),)},
        only=FURNACE),
    Bar("light of a lamp alone, all bounces, FLIP", "gi-full", "flip", {"mobile": (Limit(0.18),), "quality": (Limit(0.12),)},
        only=LAMP),
    Bar("light of a lamp alone, all bounces, relMSE", "gi-full", "relmse",
        {"mobile": (Limit(0.05),), "quality": (Limit(0.02),)}, only=LAMP),
    Bar("light of a lamp alone, all bounces, sparks", "gi-full", "sparks", {"mobile": (Limit(0),), "quality": (Limit(0),)},
        only=LAMP),
    Bar("indirect light where none is, RMSE", "indirect", "rmse", {"mobile": (Limit(0.03),), "quality": (Limit(0.03),)},
        only=LONE_PLANE),
)
# Of the bench: how many times the thesis's time or memory is the preset's.
SPEED: tuple[tuple[str, Callable[[dict[str, Any]], float], Limit], ...] = (
    ("trace of mode 5", lambda preset: preset["modes"]["gi-cone-shadow"]["trace"]["median"], Limit(25, least=True)),
    ("trace of mode 4", lambda preset: preset["modes"]["gi"]["trace"]["median"], Limit(10, least=True)),
    ("voxelize + mipmap, mode 5", lambda preset: preset["modes"]["gi-cone-shadow"]["voxelize_mipmap"]["median"],
     Limit(5, least=True)),
    ("GL memory", lambda preset: preset["bytes"] / 1e6, Limit(4, least=True)),
)


@dataclass(frozen=True)
class Row:
    figure: str
    where: str
    bar: str
    values: Values
    missed: list[str]  # presets
    form: str = ".4f"

    def cells(self) -> list[str]:
        shown = ["–" if (value := self.values.get(preset)) is None else format(value, self.form) for preset in PRESETS]
        return [self.figure, self.where, self.bar, *shown, f"**missed**: {', '.join(self.missed)}" if self.missed else "held"]


def row(bar: Bar, limits: dict[str, tuple[Limit, ...]], where: str, values: Values) -> Row:
    text = "; ".join(f"{preset} {' and '.join(map(str, mine))}" for preset, mine in limits.items())
    missed = [preset for preset, mine in limits.items()
              if not all(limit.held(values.get(preset), values.get("thesis")) for limit in mine)]
    return Row(bar.figure, where, text, values, missed, {"bias": "+.3f", "sparks": "d"}.get(bar.metric, ".4f"))


def usual_points(sweep: dict[str, Any]) -> dict[str, dict[str, dict[str, Any]]]:
    """Scene -> preset -> the point at the preset's usual settings; a scene that is another one scaled is left out."""
    usual = usual_settings(sweep["points"])
    found: dict[str, dict[str, dict[str, Any]]] = {}
    for entry in sweep["points"]:
        if entry["scene"] not in SAME_PICTURE and closeness(entry, usual) == 0:
            found.setdefault(entry["scene"], {})[entry["settings"]["preset"]] = entry
    return found


def values_of(points: dict[str, dict[str, Any]], bar: Bar) -> Values:
    return {preset: entry.get("errors", {}).get(bar.measure, {}).get(bar.metric) for preset, entry in points.items()}


def geometric_mean(values: list[float | None]) -> float | None:
    if not values or any(value is None or value <= 0 for value in values):
        return None
    return math.exp(sum(math.log(value) for value in values) / len(values))


def error_rows(scenes: dict[str, dict[str, dict[str, Any]]]) -> list[Row]:
    rows = []
    for bar in BARS:
        found = {scene: values_of(points, bar) for scene, points in scenes.items() if bar.holds_for(scene)}
        rows += [row(bar, bar.limits, scene, values) for scene, values in found.items()]
        if bar.mean:
            means = {preset: geometric_mean([values.get(preset) for values in found.values()]) for preset in PRESETS}
            rows.append(row(bar, bar.mean, f"geometric mean of {len(found)}", means))
    return rows


def speed_rows(path: Path) -> list[Row]:
    data = json.loads(path.read_text())
    presets = {preset["preset"]: preset for preset in data.get("presets", ())}
    if not {"thesis", "mobile"} <= set(presets):
        raise SystemExit(f"error: {path} is not of `vct bench --preset thesis,mobile,quality`")
    rows = []
    for figure, of, limit in SPEED:
        values = {name: of(preset) for name, preset in presets.items()}
        times = values["thesis"] / values["mobile"]
        rows.append(Row(f"{figure}, {'MB' if figure == 'GL memory' else 'ms'}", Path(data["scene"]).stem,
                        f"thesis / mobile {limit} (is {times:.1f})", values,
                        [] if limit.held(times, None) else ["mobile"], ".1f"))
    return rows


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sweep", type=Path, default=Path("out/sweep/sweep.json"), help="default: %(default)s")
    parser.add_argument("--bench", type=Path, nargs="+", required=True, metavar="JSON",
                        help="of vct bench --preset thesis,mobile,quality, one for each scene")
    options = parser.parse_args()
    for path in (options.sweep, *options.bench):
        if not path.is_file():
            raise SystemExit(f"error: {path}: no such file")
    rows = error_rows(usual_points(store.read(options.sweep))) + [one for path in options.bench for one in speed_rows(path)]
    print("| figure | scene | bar | thesis | mobile | quality | |\n|---|---|---|---|---|---|---|")
    for one in rows:
        print("| " + " | ".join(one.cells()) + " |")
    missed = sum(bool(one.missed) for one in rows)
    print(f"\n{len(rows) - missed} of {len(rows)} bars held, {missed} missed.")
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
