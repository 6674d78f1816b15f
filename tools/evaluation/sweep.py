"""Measures pictures as `render` does, at several grids: how time and error follow the number of voxels.

    tools/eval.py sweep --plot out/sweep.png
    tools/eval.py sweep cornell corridor --grids 64,128 --presets mobile

The plot, which `eval.py report` shows too, has the time of a frame that rebuilds everything against the error of its indirect
light.
"""
import argparse

from . import options
from .render import add_picture_arguments, measure_and_print

GRIDS = ("64", "128", "256", "512")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    add_picture_arguments(parser)
    parser.add_argument("--grids", type=options.names(GRIDS, "grid"), default=list(GRIDS[:3]),
                        help="voxels along a side (default: 64,128,256)")


def run(asked: argparse.Namespace) -> int:
    return measure_and_print(asked, "sweep", asked.grids)
