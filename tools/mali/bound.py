"""Words of a frame, and the time below which no Mali of so many cores can run them."""
from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from typing import Any

from mali.compiler import Stage, Words
from mali.loops import match_loops

# The thesis's phone: Mali-T880 MP12. Three arithmetic pipes, one load/store and one texture pipe per core.
CORES, CLOCK_HZ, ARITHMETIC_PIPES = 12, 850e6, 3


@dataclass(frozen=True)
class Cost:
    """Of one stage in one frame."""

    invocations: int
    words: Words  # of all invocations together

    def per_invocation(self, pipe: str) -> float:
        return self.words[pipe] / self.invocations

    def cycles(self, texture_cycles: int = 1) -> dict[str, float]:
        """Of each pipe of one core, were it the only one."""
        return {"A": self.words["A"] / ARITHMETIC_PIPES / CORES, "LS": self.words["LS"] / CORES,
                "T": self.words["T"] * texture_cycles / CORES}

    def bottleneck(self) -> str:
        cycles = self.cycles()
        return max(cycles, key=cycles.__getitem__)

    def bound_ms(self, texture_cycles: int = 1) -> float:
        return max(self.cycles(texture_cycles).values()) / CLOCK_HZ * 1e3


def stage_cost(stage: Stage, invocations: int, loops: list[dict[str, Any]]) -> Cost:
    """`loops`: of the manifest, {"name", "depth", "constant", "iterations"}. Both sides of a branch are taken as run."""
    which = match_loops(loops, [loop.depth for loop in stage.loops])
    copies = Counter(which)
    words = Counter({pipe: number * invocations for pipe, number in stage.outside.items()})
    for compiled, source in zip(stage.loops, which):
        iterations = loops[source]["iterations"] / copies[source]
        words.update({pipe: number * iterations for pipe, number in compiled.words.items()})
    return Cost(invocations, dict(words))
