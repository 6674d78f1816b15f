#!/usr/bin/env python3
"""Measures the renderer: time per frame, error against path tracing, light over frames, bounds for a phone's GPU.

    tools/eval.py render --headline              the README's table
    tools/eval.py judge my.glb                   your own scene
    tools/eval.py VERB --help                    teaches one verb

Run it in .venv, which scripts/python.sh makes. Results are kept in a folder (--out), in results.json and pictures/. The same
command measures only what changed since: scene, reference, settings, vct or its shaders. Ctrl-C keeps every finished result.
Tables go to stdout, progress to stderr. Exit status: 0 done, 1 something failed, 2 wrong command line, 130 stopped by Ctrl-C (128
and the signal's number).
"""
import argparse
import contextlib
import importlib
import signal
import sys
from collections.abc import Iterator
from pathlib import Path

import program
from evaluation import progress
from files import Failed

VERBS = {
    "references": "path-traced pictures of scenes, into references/",
    "points": "path-traced irradiance at points of rooms, for the test of the library's look-up",
    "render": "times and errors of each preset's picture of scenes that have references",
    "judge": "the same for your own scene, on one page",
    "products": "pictures of products, beside path tracing",
    "thin": "light along ten thin things, beside path tracing",
    "motion": "light and times while camera, light or objects move",
    "report": "one page of all results in the folder",
    "phone": "what a phone sent (scripts/phone.sh all), beside this machine and the bounds",
    "mali": "time below which a Mali-T880 cannot draw a frame",
}


@contextlib.contextmanager
def stopped_by(*signals: signal.Signals) -> Iterator[None]:
    """Lets signals end the block as Ctrl-C does, with the programs that it started and its unfinished files."""
    def stop(number: int, _: object) -> None:
        raise KeyboardInterrupt(number)
    before = {number: signal.getsignal(number) for number in signals}
    for number in signals:
        if before[number] != signal.SIG_IGN:  # as under nohup
            signal.signal(number, stop)
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


def main(words: list[str]) -> int:
    raw = argparse.RawDescriptionHelpFormatter
    if not words or words[0] not in VERBS:
        listed = "\n".join(f"  {verb:<11} {text}" for verb, text in VERBS.items())
        parser = argparse.ArgumentParser(prog="eval.py", usage="eval.py VERB [options]", description=f"{__doc__}\nverbs:\n{listed}",
                                         formatter_class=raw)
        parser.add_argument("verb", choices=VERBS, metavar="VERB", help="one of the above")
        parser.parse_args(words[:1])
    verb = importlib.import_module(f"evaluation.{words[0]}")
    parser = argparse.ArgumentParser(prog=f"eval.py {words[0]}", description=verb.__doc__, formatter_class=raw)
    parser.add_argument("--program", type=Path, default=program.vct, help="the renderer (default: build/desktop/vct)")
    verb.add_arguments(parser)
    options = parser.parse_args(words[1:])
    program.vct = options.program.resolve()
    try:
        with progress.reported(), stopped_by(signal.SIGTERM, signal.SIGHUP):
            return verb.run(options)
    except (Failed, OSError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt as stop:
        print("stopped; the same command continues", file=sys.stderr)
        return 128 + (stop.args[0] if stop.args else signal.SIGINT)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
