#!/usr/bin/env python3
"""Every hard case of the truth as a small scene: what is right, what vct gives, and whether that is within the bar.

    python tools/hard_cases.py --vct build/desktop/vct --out out/hard_cases [--quick] [--only NAME ...]

Writes DIR/hard_cases.json, a list of {name, what, right_answer, preset, measured, unit, bar, status, note, picture,
known_range}: `measured` is the distance from the right answer (0 is right, null where nothing could be measured),
`status` is pass, fail, known-failure or not-run, `picture` is relative to DIR. A crash, a hang, a GL error, a NaN or
a picture that depends on the order of the triangles is a fail in every case.
"""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path
from typing import Any

sys.dont_write_bytecode = True

from cases import run_case, table  # noqa: E402
from cases.all import CASES, ORDER_MATTERS  # noqa: E402
from cases.run import Vct  # noqa: E402


def run(
    program: Path,
    out: Path,
    quick: bool = False,
    only: list[str] | None = None,
    preset: str = "thesis",
    show: bool = True,
) -> list[dict[str, Any]]:
    """All rows, also written to out/hard_cases.json."""
    out.mkdir(parents=True, exist_ok=True)
    vct = Vct(program.resolve(), out.resolve(), preset)
    chosen = [c for c in CASES if (c.name in only if only else c.quick or not quick)]
    rows = []
    for number, case in enumerate(chosen):
        if show:
            print(f"[{number + 1}/{len(chosen)}] {case.name}", file=sys.stderr, flush=True)
        vct.check_order = not quick or case in ORDER_MATTERS
        rows.append(run_case(case, vct))
    (out / "hard_cases.json").write_text(json.dumps(rows, indent=1) + "\n")
    return rows


def main() -> int:
    parser = argparse.ArgumentParser(description="The hard cases: right answers, what vct gives, pass or fail.")
    parser.add_argument("--vct", type=Path, required=True, help="the program")
    parser.add_argument("--out", type=Path, required=True, help="folder for scenes, pictures and hard_cases.json")
    parser.add_argument("--preset", default="thesis", help="preset of vct (default: thesis)")
    parser.add_argument(
        "--quick",
        action="store_true",
        help="leave out what takes long, and shuffle triangles only where their order matters most",
    )
    parser.add_argument(
        "--only", nargs="+", choices=[c.name for c in CASES], metavar="NAME", help="these cases alone"
    )
    options = parser.parse_args()
    if not options.vct.is_file():
        parser.error(f"--vct {options.vct}: no such program; build it with scripts/build.sh")
    rows = run(options.vct, options.out, options.quick, options.only, options.preset)
    print(table(rows))
    return 1 if any(row["status"] == "fail" for row in rows) else 0


if __name__ == "__main__":
    sys.exit(main())
