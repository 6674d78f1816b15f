"""Messages on stderr: no work of more than two seconds is silent."""
import contextlib
import math
import sys
import threading
import time
from collections.abc import Iterator

LONGEST_PAUSE_S = 30.0


class Work:
    """Something that may take long, and how much of it is done, if it can tell."""

    def __init__(self, what: str) -> None:
        self.what, self.start, self.due_s = what, time.monotonic(), 2.0
        self.countdown: Countdown | None = None

    def message(self) -> str | None:
        """The message that is due: after 2, 4, 8 and so on seconds, later every 30."""
        seconds = time.monotonic() - self.start
        if seconds < self.due_s:
            return None
        self.due_s = seconds + min(seconds, LONGEST_PAUSE_S)
        return f"  {self.what}: {self.countdown and self.countdown.text() or f'{seconds:.0f} s so far'}"


class Countdown:
    """Counts the parts of the current work that are done, and tells how long the rest takes at the speed so far. The first part is
    left out of the speed once there are others, because it includes loading and compiling."""

    def __init__(self, total: int) -> None:
        self.total, self.start, self.counts = total, time.monotonic(), [(0, 0.0)]  # parts that were done, and when
        current.countdown = self

    def advance(self, count: int) -> None:
        self.counts.append((self.counts[-1][0] + count, time.monotonic() - self.start))

    def text(self) -> str:
        (done, end), (before, begin) = self.counts[-1], self.counts[1 if len(self.counts) > 2 else 0]
        if not 0 < done < self.total:
            return ""
        left = (self.total - done) * (end - begin) / (done - before) - (time.monotonic() - self.start - end)
        return f"{100 * done // self.total} %, about {max(left, 0):.0f} s left"


current = Work("starting")


def begin(what: str) -> None:
    """Names the work that begins; nothing is printed unless it takes long."""
    global current
    current = Work(what)


def end() -> None:
    """Ends the current work: nothing is printed until other work begins."""
    current.due_s = math.inf


def say(text: str) -> None:
    print(text, file=sys.stderr, flush=True)


@contextlib.contextmanager
def reported() -> Iterator[None]:
    """Prints the messages that are due while the block runs."""
    ended = threading.Event()

    def report() -> None:
        while not ended.wait(0.2):
            if message := current.message():
                say(message)
    thread = threading.Thread(target=report, daemon=True)
    thread.start()
    try:
        yield
    finally:
        ended.set()
        thread.join()
