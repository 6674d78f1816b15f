"""Tables in Markdown, and what stands in their heads."""
from __future__ import annotations

from collections.abc import Iterable, Sequence

# A frame's, as timings.json and people name them.
STEPS = {"shadow_map": "shadow map", "render_data": "G-buffer", "voxelize": "voxelize", "mipmap": "mipmap",
         "inject": "inject", "irradiance": "irradiance", "trace": "trace", "total": "frame"}


def markdown(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """A row that is shorter than the head is filled up with dashes."""
    def line(cells: Iterable[str]) -> str:
        return "| " + " | ".join(cells) + " |\n"
    filled = ([*row, *["–"] * (len(head) - len(row))] for row in rows)
    return line(head) + "|---" * len(head) + "|\n" + "".join(map(line, filled))
