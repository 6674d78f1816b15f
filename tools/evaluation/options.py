"""Types of command-line options."""
import argparse
from collections.abc import Callable, Collection
from pathlib import Path

from files import ROOT

PRESETS = ("thesis", "mobile", "quality")


def size(text: str) -> tuple[int, int]:
    parts = text.split("x")
    if len(parts) != 2 or not all(part.isdigit() and 0 < int(part) <= 8192 for part in parts):
        raise argparse.ArgumentTypeError(f"'{text}' is not a size such as 256x256")
    return int(parts[0]), int(parts[1])


def samples(text: str) -> int:
    if not text.isdigit() or int(text) < 2 or int(text) % 2:
        raise argparse.ArgumentTypeError(f"'{text}' is not an even number of samples, 2 or more")
    return int(text)


def count(text: str) -> int:
    if not text.isdigit() or int(text) < 1:
        raise argparse.ArgumentTypeError(f"'{text}' is not a whole number of 1 or more")
    return int(text)


def counts(text: str) -> list[int]:
    """Counts with commas."""
    return [count(part) for part in text.split(",")]


def length(text: str) -> str:
    try:
        metres = float(text)
    except ValueError:
        metres = 0
    if not 0 < metres < float("inf"):
        raise argparse.ArgumentTypeError(f"'{text}' is not a length in metres above 0")
    return text


def names(known: Collection[str], kind: str) -> Callable[[str], list[str]]:
    """A list of known names with commas."""
    def parse(text: str) -> list[str]:
        if unknown := [name for name in text.split(",") if name not in known]:
            raise argparse.ArgumentTypeError(f"unknown {kind} '{unknown[0]}'; choose from {', '.join(known)}")
        return text.split(",")
    return parse


def add_cameras(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--cameras", type=lambda text: text.split(","), default=[None], metavar="NAMES",
                        help="cameras of the scene, with commas (default: its first)")


def add_store(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--out", type=Path, default=ROOT / "out/eval", help="folder of the results (default: out/eval)")


def add_presets(parser: argparse.ArgumentParser, default: Collection[str] = PRESETS) -> None:
    parser.add_argument("--presets", type=names(PRESETS, "preset"), default=list(default),
                        help=f"with commas (default: {','.join(default)})")
