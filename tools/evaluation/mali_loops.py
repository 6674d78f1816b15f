"""Matches the loops of a compiled shader to the loops of its source, some of which the compiler unrolls."""
from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any

from files import Failed


@dataclass
class Node:
    index: int
    inner: list[Node] = field(default_factory=list)


Match = dict[int, int]  # compiled loop -> source loop
Loop = dict[str, Any]  # of the manifest: place, depth, constant (has a constant length), iterations


def tree(depths: Sequence[int]) -> list[Node]:
    """`depths`: of loops in the order they run, an inner one after the one around it."""
    top: list[Node] = []
    path: list[Node] = []
    for index, depth in enumerate(depths):
        node = Node(index)
        del path[depth:]
        (path[-1].inner if path else top).append(node)
        path.append(node)
    return top


def matches(source: list[Node], compiled: list[Node], loops: Sequence[Loop]) -> Iterator[Match]:
    """Every way to read `compiled` as `source`, where loops of constant length may be unrolled."""
    if not source:
        if not compiled:
            yield {}
        return
    first, rest = source[0], source[1:]
    if compiled:
        for inner in matches(first.inner, compiled[0].inner, loops):
            for match in matches(rest, compiled[1:], loops):
                yield {compiled[0].index: first.index, **inner, **match}
    if loops[first.index]["constant"]:
        # Unrolled: its inner loops are there once per copy.
        for taken in range(0, len(compiled) + 1):
            for inner in copies(first.inner, compiled[:taken], loops):
                for match in matches(rest, compiled[taken:], loops):
                    yield {**inner, **match}


def copies(source: list[Node], compiled: list[Node], loops: Sequence[Loop]) -> Iterator[Match]:
    """Every way to read `compiled` as equal copies of `source`."""
    if not compiled:
        yield from matches(source, [], loops)
        return
    for size in range(1, len(compiled) + 1):
        if len(compiled) % size:
            continue
        for first in matches(source, compiled[:size], loops):
            match = dict(first)
            for start in range(size, len(compiled), size):
                match |= next(matches(source, compiled[start:start + size], loops), {})
            if all(node.index in match for node in compiled):
                yield match


def left_by_return(depths: Sequence[int]) -> Iterator[list[int]]:
    """The depths if the compiler has moved a loop out of the one around it, as it may if that ends with the loop and a `return`."""
    for index, depth in enumerate(depths):
        if depth > 0 and (index + 1 == len(depths) or depths[index + 1] < depth):
            yield [*depths[:index], depth - 1, *depths[index + 1:]]


def foldable(loops: Sequence[Loop], invocations: float) -> list[Loop]:
    """The loops, where the compiler may also have removed one that ran never or once for each entry, or one call's of several."""
    path: list[Loop] = []
    changed = []
    copies_of = Counter(loop["place"] for loop in loops)
    for loop in loops:
        del path[loop["depth"]:]
        entries = path[-1]["iterations"] if path else invocations
        may_go = loop["constant"] or loop["iterations"] in (0, entries) or copies_of[loop["place"]] > 1
        changed.append({**loop, "constant": may_go})
        path.append(loop)
    return changed


def match_loops(loops: Sequence[Loop], compiled_depths: Sequence[int], invocations: float = 0) -> list[int]:
    """The index in `loops` of each compiled loop, by the reading with the fewest loops removed that are not of constant length, then the
    fewest and shortest unrolled."""
    fixed = [loop["constant"] for loop in loops]
    loops = foldable(loops, invocations)
    depths = [loop["depth"] for loop in loops]
    compiled = tree(compiled_depths)
    # A function that is inlined at several places has its loops as often.
    readings = list(matches(tree(depths), compiled, loops)) or list(copies(tree(depths), compiled, loops)) or [
        match for moved in left_by_return(depths) for match in matches(tree(moved), compiled, loops)]
    if not readings:
        raise Failed(f"loops of depths {list(compiled_depths)} cannot be those of the source, {depths}: is one of them "
                     "not read (jni/lab/shader_loops.cpp)?")

    def unrolled(match: Match) -> tuple[int, int, float]:
        gone = [index for index in range(len(loops)) if index not in match.values()]
        return sum(not fixed[index] for index in gone), len(gone), sum(loops[index]["iterations"] for index in gone)
    least = min(map(unrolled, readings))
    best = [match for match in readings if unrolled(match) == least]

    def lengths(match: Match) -> list[float]:
        return [loops[match[index]]["iterations"] for index in range(len(compiled_depths))]
    if any(lengths(match) != lengths(best[0]) for match in best):
        raise Failed(f"loops of depths {list(compiled_depths)} can be those of the source, {depths}, in more than one way")
    return [best[0][index] for index in range(len(compiled_depths))]
