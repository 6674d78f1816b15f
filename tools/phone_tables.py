"""Prints measurements of several machines beside each other: a phone's, this desktop's, the thesis's.

For bench.json files it prints the thesis's tables 5.2 to 5.5, a row for each machine; for timings.json files the steps of each
mode, a column for each machine. docs/timings.md describes both files.
"""
from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

from files import Failed, read_json
from program import TIMINGS_VERSION
from tables import STEPS, markdown

BENCH_VERSION = 1  # docs/timings.md tells when it changes
COUNTERS = {"cycles": "GPU cycles, million", "read_bytes": "read, MB", "written_bytes": "written, MB"}
File = tuple[str, dict[str, Any]]  # the machine's name, and its measurements


def bench_tables(files: list[File]) -> list[tuple[str, list[str], list[list[str]]]]:
    """Title, head and rows of each table, the thesis's own rows last."""
    benches = [(name, content["tables"]) for name, content in files if "tables" in content]
    tables = []
    for number, first in (benches[0][1] if benches else {}).items():
        rows = [(row["platform"].replace("Here", name), row["values"]) for name, measured in benches
                for row in measured[number]["rows"] if row["source"] == "measured"]
        rows += [(f"{row['platform']} (thesis)", row["values"]) for row in first["rows"] if row["source"] == "thesis"]
        tables.append((f"Table {number}: {first['title']}", ["", *first["columns"]],
                       [[name, *(f"{value:.2f}" for value in values)] for name, values in rows]))
    return tables


def step_tables(files: list[File]) -> list[tuple[str, list[str], list[list[str]]]]:
    """A table of the steps' medians for each mode, in the order of the files."""
    measured = [(f"{name}, {content['settings']['grid']}^3", content["modes"]) for name, content in files
                if "tables" not in content]
    tables = []
    for mode in dict.fromkeys(mode for _, found in measured for mode in found):
        columns = [(name, found[mode]) for name, found in measured if mode in found]
        steps = dict.fromkeys(key for _, found in columns for key in found["steps"])
        rows = [[STEPS[key], *(f"{found['steps'][key]['median']:.2f}" if key in found["steps"] else "–" for _, found in columns)]
                for key in steps]
        if any("gpu_counters" in found for _, found in columns):
            rows += [[text, *(f"{found['gpu_counters'][key] / 1e6:.2f}" if "gpu_counters" in found else "–"
                              for _, found in columns)] for key, text in COUNTERS.items()]
        tables.append((f"{mode}, medians in ms", ["", *(name for name, _ in columns)], rows))
    return tables


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="+", metavar="NAME=FILE", help="a bench.json or timings.json")
    files = []
    for entry in parser.parse_args().files:
        name, separator, path = entry.partition("=")
        if not separator:
            parser.error(f"'{entry}' is not NAME=FILE")
        try:
            files.append((name, read_json(Path(path), tables=BENCH_VERSION, modes=TIMINGS_VERSION)))
        except Failed as error:
            raise SystemExit(f"error: {error}") from None
    print("\n".join(f"{title}\n\n{markdown(head, rows)}" for title, head, rows in bench_tables(files) + step_tables(files)), end="")


if __name__ == "__main__":
    main()
