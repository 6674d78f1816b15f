"""Which loop of the source is which loop of the compiled shader: the compiler unrolls some."""
from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any


class LoopError(Exception):
    """The compiled loops cannot be told."""


@dataclass
class _Node:
    index: int
    inner: list[_Node] = field(default_factory=list)


def _tree(depths: Sequence[int]) -> list[_Node]:
    """Loops in the order they run, a nested one after the one around it."""
    top: list[_Node] = []
    path: list[_Node] = []
    for index, depth in enumerate(depths):
        node = _Node(index)
        del path[depth:]
        (path[-1].inner if path else top).append(node)
        path.append(node)
    return top


Match = dict[int, int]  # compiled loop -> source loop
Loop = dict[str, Any]  # of the manifest: name, depth, constant (its length), iterations


def _matches(source: list[_Node], compiled: list[_Node], loops: Sequence[Loop]) -> Iterator[Match]:
    """Every way to read `compiled` as `source`, where loops of constant length may be unrolled."""
    if not source:
        if not compiled:
            yield {}
        return
    first, rest = source[0], source[1:]
    if compiled:
        for inner in _matches(first.inner, compiled[0].inner, loops):
            for match in _matches(rest, compiled[1:], loops):
                yield {compiled[0].index: first.index, **inner, **match}
    if not loops[first.index]["constant"]:
        return
    # Unrolled: what it contains is there once per copy.
    for taken in range(0, len(compiled) + 1):
        for inner in _copies(first.inner, compiled[:taken], loops):
            for match in _matches(rest, compiled[taken:], loops):
                yield {**inner, **match}


def _copies(source: list[_Node], compiled: list[_Node], loops: Sequence[Loop]) -> Iterator[Match]:
    """`compiled` as copies of `source` that are all alike."""
    if not compiled:
        yield from _matches(source, [], loops)
        return
    for size in range(1, len(compiled) + 1):
        if len(compiled) % size:
            continue
        for first in _matches(source, compiled[:size], loops):
            match = dict(first)
            for start in range(size, len(compiled), size):
                match |= next(iter(_matches(source, compiled[start:start + size], loops)), {})
            if all(node.index in match for node in compiled):
                yield match


def match_loops(loops: Sequence[Loop], compiled_depths: Sequence[int]) -> list[int]:
    """For each compiled loop the one of `loops` that it is: the reading with the fewest and shortest loops unrolled."""
    depths = [loop["depth"] for loop in loops]
    source, compiled = _tree(depths), _tree(compiled_depths)
    # What is inlined at more than one place, as the voxelizer's for both sides of a surface, is there as often.
    readings = list(_matches(source, compiled, loops)) or list(_copies(source, compiled, loops))
    if not readings:
        raise LoopError(f"loops of depths {list(compiled_depths)} cannot be those of the source, {depths}: is one of them "
                        "not counted (shaders/shared/counters.glsl)?")

    def unrolled(match: Match) -> tuple[int, float]:
        gone = [loop["iterations"] for index, loop in enumerate(loops) if index not in match.values()]
        return len(gone), sum(gone)

    least = min(map(unrolled, readings))
    best = [match for match in readings if unrolled(match) == least]
    if any(match != best[0] for match in best):
        raise LoopError(f"loops of depths {list(compiled_depths)} can be those of the source, {depths}, in more than one "
                        "way")
    return [best[0][index] for index in range(len(compiled_depths))]
