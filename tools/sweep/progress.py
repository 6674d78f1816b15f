"""What the sweep says while it runs."""
from __future__ import annotations

import sys
import time


def duration(seconds: float) -> str:
    """70 -> 1:10"""
    whole = int(seconds + 0.5)
    hours, minutes = whole // 3600, whole // 60 % 60
    return f"{hours}:{minutes:02}:{whole % 60:02}" if hours else f"{minutes}:{whole % 60:02}"


class Progress:
    """One line per point on stderr, with the time left from the points' guessed costs and the pace so far."""

    def __init__(self, costs: list[float]) -> None:
        self.costs = costs
        self.number = 0
        self.done_cost = 0.0
        self.start = time.monotonic()

    def elapsed(self) -> float:
        return time.monotonic() - self.start

    def line(self, name: str, outcome: str) -> None:
        """Call after each point, in order."""
        self.done_cost += self.costs[self.number]
        self.number += 1
        elapsed = self.elapsed()
        left = elapsed / self.done_cost * sum(self.costs[self.number:])
        eta = f", {duration(left)} left" if self.number < len(self.costs) else ""
        print(f"[{self.number}/{len(self.costs)}] {name}: {outcome} ({duration(elapsed)} so far{eta})",
              file=sys.stderr, flush=True)
