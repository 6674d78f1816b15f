#!/usr/bin/env python3
"""Every hard case of the truth as a small scene: what is right, what vct gives, and whether that is within the bar.

    .venv/bin/python tools/hard_cases.py --out out/hard_cases [--quick] [--only NAME ...]

Writes DIR/hard_cases.json, a list of {name, what, right_answer, preset, measured, unit, bar, status, note, picture,
known_range}: `measured` is the distance from the right answer (0 is right, null where nothing could be measured),
`status` is pass, fail or known-failure, `picture` is relative to DIR. A crash, a hang, a GL error, a NaN or a picture that
depends on the order of the triangles is a fail in every case.
"""
from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path
from typing import Any

import program
from cases import cones, light, limits, objects, scale, triangles, walls
from cases.case import run_case, table
from cases.run import Vct
from files import ROOT

CASES = [*triangles.CASES, *walls.CASES, *objects.CASES, *light.CASES, *cones.CASES, *scale.CASES, *limits.CASES]
ORDER_MATTERS = [*triangles.CASES, *objects.CASES]  # shuffled in a quick run too


def run(vct_program: Path, out: Path, quick: bool = False, only: list[str] | None = None,
        preset: str = "thesis") -> list[dict[str, Any]]:
    """All rows, also written to out/hard_cases.json."""
    out.mkdir(parents=True, exist_ok=True)
    vct = Vct(vct_program.resolve(), out.resolve(), preset)
    chosen = [case for case in CASES if (case.name in only if only else case.quick or not quick)]
    rows = []
    for number, case in enumerate(chosen, 1):
        print(f"[{number}/{len(chosen)}] {case.name}", file=sys.stderr, flush=True)
        vct.check_order = not quick or case in ORDER_MATTERS
        rows.append(run_case(case, vct))
    (out / "hard_cases.json").write_text(json.dumps(rows, indent=1) + "\n")
    return rows


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    program.add_option(parser)
    parser.add_argument("--out", type=Path, default=ROOT / "out/hard_cases", help="default: out/hard_cases")
    parser.add_argument("--preset", default="thesis", help="preset of vct (default: thesis)")
    parser.add_argument("--quick", action="store_true",
                        help="leave out what takes long, and shuffle triangles only where their order matters most")
    parser.add_argument("--only", nargs="+", choices=[case.name for case in CASES], metavar="NAME", help="these cases alone")
    options = parser.parse_args()
    program.require(options.program)
    rows = run(options.program, options.out, options.quick, options.only, options.preset)
    print(table(rows))
    return 1 if any(row["status"] == "fail" for row in rows) else 0


if __name__ == "__main__":
    sys.exit(main())
