"""Tables in Markdown, and how numbers are written in them."""
from __future__ import annotations

from collections.abc import Iterable, Sequence

# The steps of a frame, by their names in timings.json.
STEPS = {"shadow_map": "shadow map", "render_data": "G-buffer", "voxelize": "voxelize", "mipmap": "mipmap",
         "inject": "inject", "irradiance": "irradiance", "trace": "trace", "total": "frame"}


def markdown(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """Rows that are shorter than the head are filled up with dashes."""
    def line(cells: Iterable[str]) -> str:
        return "| " + " | ".join(cells) + " |\n"
    filled = ([*row, *["–"] * (len(head) - len(row))] for row in rows)
    return line(head) + "|---" * len(head) + "|\n" + "".join(map(line, filled))


def milliseconds(value: float) -> str:
    return f"{value:.0f} ms" if value >= 10 else f"{value:.1f} ms"


def fraction(value: float | None, digits: int) -> str:
    """.0185"""
    return "–" if value is None else f"{value:.{digits}f}".replace("0.", ".", 1) if abs(value) < 1 else f"{value:.{digits}f}"


def percent(value: float | None) -> str:
    """+11 %"""
    return "–" if value is None else f"{value * 100:+.0f} %".replace("+0 %", "0 %").replace("-0 %", "0 %")
