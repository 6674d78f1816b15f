"""motion.json as tables, for the terminal and for the report."""
from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from tables import markdown

Entries = dict[str, dict[str, dict[str, Any]]]  # by scene and preset


@dataclass(frozen=True)
class Table:
    name: str
    what: str
    head: list[str]
    rows: list[list[str]]


def of_presets(entries: Entries, first: str, text: Callable[[dict[str, Any]], str]) -> tuple[list[str], list[list[str]]]:
    """Head and rows: a row for each scene, a column for each preset; what failed says why."""
    presets = list(dict.fromkeys(preset for scene in entries.values() for preset in scene))

    def cell(entry: dict[str, Any] | None) -> str:
        return "–" if entry is None else f"failed: {entry['failed']}" if "failed" in entry else text(entry)
    return [first, *presets], [[scene, *(cell(found.get(preset)) for preset in presets)] for scene, found in entries.items()]


def change(value: dict[str, float]) -> str:
    return f"{100 * value['rms']:.1f} % / {100 * value['p99']:.1f} %"


def swim(entries: Entries) -> Table:
    head, rows = of_presets(entries, "scene", change)
    for row, found in zip(rows, entries.values()):
        row.append(next((change(entry["floor"]) for entry in found.values() if "floor" in entry), "–"))
    return Table("Swimming", "A slow camera, 1.3 pixels a frame: how much the light that a surface point receives changes from "
                 "frame to frame, RMS / 99th percentile. Diffuse light does not depend on the view: it should not change at all. "
                 "The floor is what the measure finds of a field that is known not to change.", [*head, "floor"], rows)


def lag(entries: Entries) -> Table:
    def text(entry: dict[str, Any]) -> str:
        mean, worst = entry["mean"], entry["worst"]
        return f"{mean['relmse']:.5f} / {mean['flip']:.3f} ({worst['flip']:.3f})"
    return Table("Lag and noise", "A sun that goes once around in 10 s, and moving objects, at 30 frames a second: each frame after "
                 "the first 16 against the still picture of its moment. Mean relMSE / mean FLIP (largest FLIP).",
                 *of_presets(entries, "what moves", text))


PARTS = {"swim": swim, "lag": lag}


def tables(data: dict[str, Any]) -> list[Table]:
    """All that was measured."""
    return [table(data[part]) for part, table in PARTS.items() if data.get(part)]


def page(data: dict[str, Any]) -> str:
    return "\n".join(f"{table.what}\n\n{markdown(table.head, table.rows)}" for table in tables(data))
