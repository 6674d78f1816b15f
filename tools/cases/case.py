"""What a hard case is, and how its result is told."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any, Callable

from .run import Unacceptable, Vct


class Skipped(Exception):
    """Says why a case cannot be run here."""


@dataclass
class Measured:
    value: float  # distance from the right answer: 0 is right
    picture: Path | None = None
    note: str = ""


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
    row: dict[str, Any] = {
        "name": case.name,
        "what": case.what,
        "right_answer": case.right_answer,
        "preset": vct.preset,
        "measured": None,
        "unit": case.unit,
        "bar": case.bar,
        "status": "fail",
        "note": "",
        "picture": None,
        "known_range": case.known_range,
    }
    try:
        found = case.measure(vct)
    except Unacceptable as error:
        row["note"] = str(error)
        return row
    except Skipped as why:
        row.update(status="not-run", note=str(why))
        return row
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
    lines = [f"{'case':34} {'measured':>10} {'bar':>8}  {'status':13} unit; note"]
    for row in rows:
        measured = "-" if row["measured"] is None else f"{row['measured']:.4g}"
        lines.append(
            f"{row['name']:34} {measured:>10} {row['bar']:>8.3g}  {row['status']:13} {row['unit']}; {row['note']}"
        )
    counts = {
        status: sum(row["status"] == status for row in rows)
        for status in ("pass", "known-failure", "fail", "not-run")
    }
    lines.append(", ".join(f"{count} {status}" for status, count in counts.items()))
    return "\n".join(lines)
