"""Things that touch, lie in each other, are hollow or far away: occlusion that must be there, and no more."""

from __future__ import annotations

from typing import Callable

import numpy as np

from scenes import shapes
from scenes.hard_cases import HALF, Part, View, floor, make

from .case import Case, Measured
from .floor import floor_points, openness_beside_wall, openness_under_ceiling, rectangle_form_factor
from .run import Vct, mean_difference

SIZE = 128
GRID = 256  # the thesis's; scenes are 59 units wide, so a voxel here is 59 / 251 units
VOXEL = 59.0 / 251.0
REACH = 0.045 * 256 * VOXEL  # of ambient occlusion, in units (pipeline.md: 0.045 of the volume's side)
SUN = (-0.5, -1.0, -0.3)
RED = (0.6, 0.05, 0.05)


def contact_occlusion(voxels: float) -> Callable[[Vct], Measured]:
    """Openness of the floor at `voxels` from a big box that rests on it, against the closed form of a wall."""

    def measure(vct: Vct) -> Measured:
        view = View((4.0, 9.0, 0.01), (4.0, 0, 0), 45)
        box = Part(shapes.box((20, 10.5, 40), None), RED, place={"translation": [-10 + 0.5 * VOXEL, 0, 0]})
        answer = vct.render("contact", make([Part(floor()), box], SUN, view), grid=GRID, size=f"{SIZE}x{SIZE}")
        x, z = floor_points(view, SIZE)
        distance = (x - 0.5 * VOXEL) / VOXEL
        band = (np.abs(distance - voxels) < 0.5) & (np.abs(z) < 3)
        found = float(answer["ambient_occlusion"][..., 0][band].mean())
        right = openness_beside_wall(voxels * VOXEL, REACH)
        return Measured(
            abs(found - right), answer.folder / "ambient_occlusion.png", f"ambientVisibility {found:.3f}, right {right:.3f}"
        )

    return measure


def coincident(vct: Vct) -> Measured:
    """The same box twice in one place, red and blue; and two boxes that share part of their top face."""
    blue, place = (0.05, 0.1, 0.6), {"translation": [-10, 0, -6]}
    parts = [
        Part(floor()),
        Part(shapes.box((12, 11, 12), None), RED, place=place),
        Part(shapes.box((12, 11, 12), None), blue, place=place),
        Part(shapes.box((12, 11, 12), None), RED, place={"translation": [8, 0, 8]}),
        Part(shapes.box((12, 11, 12), None), blue, place={"translation": [12, 0, 10]}),
    ]
    answer = vct.render("coincident", make(parts, SUN, View((0, 50, 40), (0, 5, 0), 45)), mode="gi,phong")
    return Measured(0.0, answer.folder / "phong.png", "equal in every bit with the triangles shuffled")


def nested(vct: Vct) -> Measured:
    """A closed box, and the same with three boxes inside: what is shut in cannot be seen."""
    place = {"translation": [2, 0, 1]}
    outer = [Part(floor()), Part(shapes.box((20, 21, 20), None), RED, place=place)]
    inner = [
        Part(shapes.box((s, s, s), None), (0.05, 0.6, 0.05), place={"translation": [2, 0.5 * (21 - s), 1]})
        for s in (17.0, 12.0, 6.0)
    ]
    view = View((25, 30, 45), (0, 5, 0), 45)
    empty = vct.render("nested_without", make(outer, SUN, view))
    full = vct.render("nested", make(outer + inner, SUN, view))
    return Measured(
        mean_difference(full["indirect_light"], empty["indirect_light"]), full.folder / "indirect_light.png"
    )


def hollow(vct: Vct) -> Measured:
    """Under a closed slab 3 voxels above the floor: the cones start 5 voxels up, inside it."""
    slab = Part(shapes.box((40, 8 * VOXEL, 40), None), place={"translation": [0, 3 * VOXEL, 0]})
    view = View((0.0, 2.5 * VOXEL, 7.0), (0, 0, 0), 40)
    answer = vct.render("hollow", make([Part(floor()), slab], SUN, view), grid=GRID, size=f"{SIZE}x{SIZE}")
    x, z = floor_points(view, SIZE)
    found = float(answer["ambient_occlusion"][..., 0][(np.abs(x) < 2) & (np.abs(z) < 4)].mean())
    right = openness_under_ceiling(3 * VOXEL, REACH)
    return Measured(
        abs(found - right), answer.folder / "ambient_occlusion.png", f"ambientVisibility {found:.3f}, right {right:.3f}"
    )


def small_object(vct: Vct) -> Measured:
    """A slab 4 voxels high on the floor is below where the cones start: its side occludes the floor for nobody."""
    slab = Part(shapes.box((20, 4 * VOXEL, 40), None), RED, place={"translation": [-10 + 0.5 * VOXEL, 0, 0]})
    view = View((4.0, 9.0, 0.01), (4.0, 0, 0), 45)
    answer = vct.render("small_object", make([Part(floor()), slab], SUN, view), grid=GRID, size=f"{SIZE}x{SIZE}")
    x, z = floor_points(view, SIZE)
    band = (x > 0.5 * VOXEL) & (x < 1.5 * VOXEL) & (np.abs(z) < 3)
    found = float(answer["ambient_occlusion"][..., 0][band].mean())
    # A wall of height h at distance d blocks (1 - d / sqrt(d^2 + h^2)) / 2 of the cosine-weighted hemisphere; here
    # d is half a voxel and h four, all of it within the reach.
    right = 1.0 - 0.5 * (1.0 - 0.5 / (0.25 + 16.0) ** 0.5)
    return Measured(
        abs(found - right), answer.folder / "ambient_occlusion.png", f"ambientVisibility {found:.3f}, right {right:.3f}"
    )


def grate(height_voxels: int) -> Callable[[Vct], Measured]:
    """Black tiles of 2 x 2 voxels in a pattern of 8 x 8, so 1/16 of a plane, over a white floor under a sky of 1."""

    def measure(vct: Vct) -> Measured:
        tiles = shapes.Shape()
        for i in range(7):
            for j in range(7):
                shapes.add_quad(tiles, (-26 + 8 * i, height_voxels, -26 + 8 * j), (2, 0, 0), (0, 0, 2))
        view = View((0, 0.45 * height_voxels, 6.0), (0, 0, 0), 30)
        # The floor is small so that it hides no sky from itself at coarse levels more than it must.
        scene = make(
            [Part(floor(HALF), (1.0, 1.0, 1.0)), Part(tiles, (0, 0, 0), double_sided=True)], SUN, view, 0.0
        )
        answer = vct.render(f"grate_{height_voxels}", scene, options=("--sky", "1,1,1"), size=f"{SIZE}x{SIZE}")
        bare = vct.render(
            "grate_none",
            make([Part(floor(HALF), (1.0, 1.0, 1.0))], SUN, view, 0.0),
            options=("--sky", "1,1,1"),
            size=f"{SIZE}x{SIZE}",
        )
        x, z = floor_points(view, SIZE)
        middle = (np.abs(x) < 4) & (np.abs(z) < 4)
        found, without = (float(a["indirect_light"][..., 0][middle].mean()) for a in (answer, bare))
        right = 1.0 - rectangle_form_factor(28.0, height_voxels) / 16.0
        return Measured(
            abs(found / max(without, 1e-9) - right),
            answer.folder / "indirect_light.png",
            f"sky left {found / max(without, 1e-9):.3f} of that without, right {right:.3f}",
        )

    return measure


def open_sky(vct: Vct) -> Measured:
    """A white floor alone under a sky of 1 sees all of it."""
    view = View((0, 12, 30), (0, 0, 0), 40)
    answer = vct.render(
        "open_sky", make([Part(floor(), (1.0, 1.0, 1.0))], SUN, view, 0.0), options=("--sky", "1,1,1"), grid=GRID
    )
    x, z = floor_points(view, SIZE)
    found = answer["indirect_light"][..., 0][(np.abs(x) < 20) & (np.abs(z) < 20)]
    return Measured(
        1.0 - float(found.mean()),
        answer.folder / "indirect_light.png",
        f"mean {found.mean():.3f}, least {found.min():.3f}, right 1",
    )


SIX = "six wide cones stand for the hemisphere, and a voxel that is touched is full"
CONTACT = "cones start 5 voxels along the normal and sample first 2.5 voxels further"
CASES = [
    Case(
        "touching-1-voxel",
        "the floor 1 voxel from a big box that rests on it",
        "closed form of a wall: 0.55",
        "error of ambientVisibility",
        0.05,
        contact_occlusion(1.0),
        (0.05, 0.12),
        SIX,
    ),
    Case(
        "touching-4-voxels",
        "the floor 4 voxels from the box",
        "closed form of a wall: 0.72",
        "error of ambientVisibility",
        0.05,
        contact_occlusion(4.0),
        (0.05, 0.12),
        SIX,
        quick=False,
    ),
    Case(
        "touching-low-slab",
        "the floor half a voxel beside a slab of 4 voxels",
        "closed form of a low wall: 0.56",
        "error of ambientVisibility",
        0.05,
        small_object,
        (0.3, 0.5),
        CONTACT,
    ),
    Case(
        "coincident-faces",
        "two boxes in one place, red and blue, and two that share part of a face",
        "either colour, the same in any order of triangles",
        "(order alone)",
        0.0,
        coincident,
    ),
    Case(
        "nested-objects",
        "boxes shut into a closed box",
        "the picture without them",
        "mean difference over mean indirect light",
        0.02,
        nested,
        (0.06, 0.2),
        "coarse levels mix the inside with the outside",
    ),
    Case(
        "hollow-object",
        "the floor under a slab 3 voxels above it, 8 voxels thick",
        "closed form of a ceiling: 0.07",
        "error of ambientVisibility",
        0.05,
        hollow,
        (0.15, 0.4),
        "cones start inside the hollow slab",
    ),
    Case(
        "over-occlusion-at-8",
        "a grate that covers 1/16 of the sky, 8 voxels above a floor",
        "closed form: 0.94",
        "error of the sky left",
        0.05,
        grate(8),
        (0.15, 0.35),
        "a voxel is opaque as soon as one of its children is",
        quick=False,
    ),
    Case(
        "over-occlusion-at-24",
        "the same grate 24 voxels above",
        "closed form: 0.96",
        "error of the sky left",
        0.05,
        grate(24),
        (0.3, 0.6),
        "a voxel is opaque as soon as one of its children is",
    ),
    Case(
        "self-occlusion",
        "a floor alone under a sky of 1",
        "all of the sky: 1",
        "sky lost",
        0.02,
        open_sky,
        (0.08, 0.2),
        "coarse levels of the cones beside the normal reach the floor itself",
    ),
]
