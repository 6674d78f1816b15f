"""Hard triangles: degenerate, sliver, edge-on, at 45 degrees, on voxel boundaries and on the edge of the volume."""
from __future__ import annotations

import random

import numpy as np

from scenes.hard_cases import RED, SUN, Part, View, box, floor, frame_markers, make, room, rotated, triangles
from scenes.shapes import quads

from .case import INDIRECT, PIXELS, Case
from .run import Measured, Vct, share_different


def _still_life() -> list[Part]:
    return [Part(floor()), Part(box((12, 19, 12)), RED, place={"translation": [6, 0, 2]})]


def _without_area(kind: int, rng: random.Random) -> tuple:
    """A point, a line with two corners in one place, a line along an axis, a line across all axes."""
    a, b = (tuple(rng.uniform(2, 17) for _ in range(3)) for _ in range(2))
    if kind == 0:
        return a, a, a
    if kind == 1:
        return a, b, a
    if kind == 2:
        return a, (b[0], a[1], a[2]), (0.5 * (a[0] + b[0]), a[1], a[2])
    return a, tuple(p + 0.4 * (q - p) for p, q in zip(a, b)), b


def degenerate(vct: Vct) -> Measured:
    rng = random.Random(1)
    bad = [_without_area(i % 3, rng) for i in range(120)]
    modes = "gi,gi-cone-shadow"
    clean = vct.render("degenerate_without", make(_still_life()), mode=modes)
    with_bad = vct.render("degenerate", make([*_still_life(), Part(triangles(bad), (1, 1, 1))]), mode=modes)
    return with_bad.measured(max(share_different(with_bad[name], clean[name], 0.0) for name in clean.images))


def collinear(vct: Vct) -> Measured:
    """Lines across all axes, in float: hairs of an area of 1e-6, which may hit a pixel or the middle of a voxel."""
    rng = random.Random(1)
    hairs = [_without_area(3, rng) for _ in range(120)]
    return vct.difference("collinear", make([*_still_life(), Part(triangles(hairs), (1, 1, 1))]), "collinear_without",
                          make(_still_life()), ("indirect_light",))


def sliver_wall(vct: Vct) -> Measured:
    """The same wall as 2 triangles and as 1680 slivers of 30 x 0.025 voxels."""
    def scene(wall: tuple) -> bytes:
        return make([Part(floor()), Part(quads(*wall), RED)], (0.3, -1, -0.8))
    slivers = tuple(((-15, i * 0.025, -5.5), (30, 0, 0), (0, 0.025, 0)) for i in range(840))
    return vct.difference("sliver_wall", scene(slivers), "sliver_wall_plain", scene((((-15, 0, -5.5), (30, 0, 0), (0, 21, 0)),)),
                          ("indirect_light",))


def _voxels_on_line(a: np.ndarray, b: np.ndarray) -> set[tuple[int, ...]]:
    t = np.linspace(0.001, 0.999, 20000)[:, None]
    return set(map(tuple, np.floor(a + t * (b - a) + 32.0).astype(int)))


def _markers(vct: Vct) -> int:
    """Voxels of the frame's markers alone."""
    return vct.render("markers", make([frame_markers()]), count_voxels=True, check_order=False).active_voxels


def lone_slivers(vct: Vct) -> Measured:
    """30 needles 0.1 voxel wide, far from each other: each crosses the voxels of its middle line."""
    rng = random.Random(2)
    needles, wanted = [], set()
    for i in range(30):
        a = np.array([-25 + 10 * (i % 6) + rng.random(), -22 + 10 * (i // 6) + rng.random(), -27 + rng.random()])
        b = a + np.array([rng.uniform(-4, 4), rng.uniform(-4, 4), 50])
        across = np.cross(b - a, (rng.random(), rng.random(), 0.1))
        across *= 0.05 / np.linalg.norm(across)
        needles += [(tuple(a - across), tuple(a + across), tuple(b))]
        wanted |= _voxels_on_line(a, 0.5 * (a + b))  # the far half is thinner than 0.05 voxels
        wanted |= _voxels_on_line(0.5 * (a + b), b)
    found = vct.render("lone_slivers", make([frame_markers(), Part(triangles(needles))]), count_voxels=True)
    count = found.active_voxels - _markers(vct)
    return found.measured(1.0 - count / len(wanted), note=f"{count} of {len(wanted)} voxels")


def edge_on(vct: Vct) -> Measured:
    """A sheet that lies in the camera's plane of symmetry and is parallel to the light."""
    sheet = Part(quads(((0, 0, 10), (0, 0, -20), (0, 20, 0))), RED, double_sided=True)
    view, light, around = View((0, 30, 75), (0, 4, 0), 45), (0.0, -1.0, -0.2), [Part(floor()), frame_markers()]
    clean = vct.render("edge_on_without", make(around, light, view), mode="shadow-map")
    found = vct.render("edge_on", make([*around, sheet], light, view), mode="shadow-map")
    return found.measured(share_different(found["shadow-map"], clean["shadow-map"], 0.02), "shadow-map")


def ties(vct: Vct) -> Measured:
    """A square turned by exactly 45 degrees about each axis, against one turned by 0.01 degrees more and less."""
    worst, notes, markers = 0.0, [], _markers(vct)
    flat, upright = ((-15, 0, 15), (30, 0, 0), (0, 0, -30)), ((-15, -15, 0), (30, 0, 0), (0, 30, 0))
    for axis in range(3):
        counts = []
        for degrees in (44.99, 45.0, 45.01):
            square = rotated(quads(upright if axis == 1 else flat), axis, degrees)
            answer = vct.render(f"tie_{axis}", make([frame_markers(), Part(square, double_sided=True)]), count_voxels=True,
                                check_order=degrees == 45.0)
            counts.append(answer.active_voxels - markers)
        worst = max(worst, *(abs(counts[1] / c - 1.0) for c in (counts[0], counts[2])))
        notes.append("/".join(map(str, counts)))
    return answer.measured(worst, note=f"voxels at 44.99/45/45.01 degrees about x, y, z: {', '.join(notes)}")


def voxel_boundary(vct: Vct) -> Measured:
    """A lit ceiling exactly on a voxel boundary, and 0.01 voxels above and below: the light on the floor beneath."""
    light, means = (0.0, 1.0, 0.9), []  # from below: it lights the ceiling and not the floor
    for y in (7.99, 8.0, 8.01):
        ceiling = quads(((-20, y, -20), (40, 0, 0), (0, 0, 40)))
        parts = [frame_markers(), Part(floor(20, -8)), Part(ceiling, (0.8, 0.8, 0.8))]
        answer = vct.render(f"boundary_{y:g}", make(parts, light, View((0, -4, 28), (0, -8, 0), 40)))
        means.append(float(answer["indirect_light"].mean()))
    spread = (max(means) - min(means)) / max(np.mean(means), 1e-9)
    return answer.measured(spread, note="mean indirect light " + ", ".join(f"{m:.4f}" for m in means))


def volume_edge(vct: Vct) -> Measured:
    """The walls of a closed box that lie on the bounds of the scene: a shell of 60^3 less 58^3 voxels."""
    answer = vct.render("volume_edge", make([Part(room())], SUN, View((0, 0, 25), (3, -5, -29), 80)), count_voxels=True)
    wanted = 60**3 - 58**3
    return answer.measured(abs(answer.active_voxels / wanted - 1.0), note=f"{answer.active_voxels} of {wanted} voxels")


CASES = [
    Case("degenerate-triangles", "120 triangles without area (points, doubled corners, lines along an axis) over a box",
         "the picture without them", PIXELS, 0.0, degenerate),
    Case("collinear-triangles", "120 lines across all axes, whose corners round to an area of 1e-6 voxels",
         "the light of the picture without them", INDIRECT, 0.01, collinear, (0.2, 0.8),
         "one lit voxel counts as a full one at every coarser level"),
    Case("sliver-wall", "a wall of 1680 slivers 0.025 voxels high, and the same wall of 2 triangles", "the same picture", INDIRECT,
         0.01, sliver_wall),
    Case("lone-slivers", "30 needles thinner than a tenth of a voxel, each alone", "every voxel that a needle crosses is occupied",
         "share of those voxels that is missing", 0.0, lone_slivers, (0.85, 1.0),
         "voxels are found at pixel centres only: the rasterization is not conservative"),
    Case("edge-on-triangles", "a sheet seen edge-on and parallel to the light", "the picture without it", PIXELS, 0.02, edge_on),
    Case("ties-of-45-degrees", "squares whose normal is exactly between two axes", "as many voxels as at 44.99 and 45.01 degrees",
         "relative difference", 0.01, ties),
    Case("voxel-boundary", "a lit ceiling exactly between two layers of voxels, and 0.01 voxels beside",
         "the same light beneath it", "spread over mean of the indirect light", 0.01, voxel_boundary, (0.03, 0.08),
         "a voxel is full or empty: what crosses its boundary moves by a whole voxel"),
    Case("edge-of-the-volume", "a closed box whose walls lie on the scene's bounds", "all its voxels are there, none is outside",
         "share of voxels missing or extra", 0.0, volume_edge, (0.004, 0.015),
         "edges that run through pixel centres belong to one side only: three of twelve are lost"),
]
