"""What a hard case is, and how its result is told."""
from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from tables import markdown

from .run import Measured, Unacceptable, Vct

# Units of many cases.
LIGHT, INDIRECT = "mean difference over mean light", "mean difference over mean indirect light"
PIXELS = "share of pixels that differ"


@dataclass(frozen=True)
class Case:
    name: str
    what: str
    right_answer: str
    unit: str
    bar: float  # passes where measured <= bar
    measure: Callable[[Vct], Measured]
    # Where the algorithm of the preset `thesis` is known to fail: between which sizes, and why. Below the range
    # something has been cured, above it something has become worse.
    known_range: tuple[float, float] | None = None
    cause: str = ""
    quick: bool = True


def run_case(case: Case, vct: Vct) -> dict[str, Any]:
    """One row of the table. Keys are stable: the report reads them."""
    row: dict[str, Any] = {"name": case.name, "what": case.what, "right_answer": case.right_answer, "preset": vct.preset,
                           "measured": None, "unit": case.unit, "bar": case.bar, "status": "fail", "note": "",
                           "picture": None, "known_range": case.known_range}
    try:
        found = case.measure(vct)
    except Unacceptable as error:
        return row | {"note": str(error)}
    row["measured"] = float(f"{found.value:.4g}")
    row["note"] = "; ".join(text for text in (found.note, case.cause) if text)
    if found.picture is not None and found.picture.exists():
        row["picture"] = found.picture.relative_to(vct.out).as_posix()
    if found.value <= case.bar:
        row["status"] = "pass"
    elif case.known_range and found.value <= case.known_range[1]:
        row["status"] = "known-failure"
    return row


def table(rows: list[dict[str, Any]]) -> str:
    text = markdown(["case", "measured", "bar", "status", "unit", "note"], (
        [row["name"], "–" if row["measured"] is None else f"{row['measured']:.4g}", f"{row['bar']:.3g}", row["status"],
         row["unit"], row["note"].replace("\n", " ")] for row in rows))
    counts = Counter(row["status"] for row in rows)
    return text + "\n" + ", ".join(f"{counts[status]} {status}" for status in ("pass", "known-failure", "fail"))
