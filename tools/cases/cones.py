"""Shadow cones from needle to plate, and the shadow map: what a closed room keeps out and an open floor gets."""

from __future__ import annotations

from typing import Callable

import numpy as np

from scenes.hard_cases import HALF, Part, View, floor, make, room

from .case import Case, Measured
from .floor import floor_points
from .run import Vct

SIZE = 128
SUN = (-0.5, -1.0, -0.3)
INSIDE = View((12, 8, 24), (-6, -5, -28), 75)


def closed_room(degrees: float) -> Callable[[Vct], Measured]:
    """A closed room with the sun outside: no cone of any width sees out. Judged on its floor."""

    def measure(vct: Vct) -> Measured:
        answer = vct.render(
            f"cone_room_{degrees:g}",
            make([Part(room())], SUN, INSIDE),
            mode="gi-cone-shadow",
            options=("--cone-angle", f"{degrees:g}"),
            size=f"{SIZE}x{SIZE}",
        )
        x, z = floor_points(INSIDE, SIZE, -HALF)
        image = answer["cone_shadow"][..., 0][(np.abs(x) < 28) & (np.abs(z) < 28)]
        return Measured(float(image.mean()), answer.folder / "cone_shadow.png", f"largest {image.max():.3f}")

    return measure


def closed_room_shadow_map(vct: Vct) -> Measured:
    """Direct light is less than half of what it were without walls: not even a line of light along the edges."""
    answer = vct.render("map_room", make([Part(room(), (0.6,) * 3)], SUN, INSIDE), size="256x256")
    direct = (answer["gi"] - answer["indirect_light"])[..., 0] / np.maximum(
        answer["ambient_occlusion"][..., 0], 1e-3
    )
    return Measured(float((direct > 0.3 * 0.6).mean()), answer.folder / "gi.png", f"largest {direct.max():.3f}")


def lone_floor_cone(degrees: float) -> Callable[[Vct], Measured]:
    """A lone floor under a sun in the zenith: up to 180 degrees the cone does not touch it."""

    def measure(vct: Vct) -> Measured:
        view = View((0, 12, 40), (0, 0, 0), 40)
        answer = vct.render(
            f"cone_floor_{degrees:g}",
            make([Part(floor())], (0, -1, 0), view),
            mode="gi-cone-shadow",
            options=("--cone-angle", f"{degrees:g}"),
            size=f"{SIZE}x{SIZE}",
        )
        x, z = floor_points(view, SIZE)
        image = answer["cone_shadow"][..., 0][(np.abs(x) < 28) & (np.abs(z) < 28)]
        return Measured(1.0 - float(image.mean()), answer.folder / "cone_shadow.png", f"least {image.min():.3f}")

    return measure


NEEDLE = "a thin cone sees one layer of voxels in part only, where it crosses between their middles"
SPARSE = "steps grow with the distance, and a wall between two samples is seen in part only"
WIDE = "a wide cone's first sample by eq. 4.8 lies behind the volume: it sees nothing"
CASES = [
    Case(
        "shadow-map-closed-room",
        "the shadow map in a closed room, sun outside",
        "dark",
        "share of pixels that are lit",
        0.0,
        closed_room_shadow_map,
        (0.001, 0.01),
        "the bias of up to 0.01 of the depth range lights a line along edges to the sun",
    ),
    *(
        Case(
            f"cone-{a:g}-closed-room",
            f"a shadow cone of {a:g} degrees in a closed room",
            "dark",
            "mean visibility",
            0.01,
            closed_room(a),
            known,
            cause,
            quick=a not in (1.0, 30.0),
        )
        for a, known, cause in (
            (0.1, None, ""),
            (1.0, None, ""),
            (5.0, (0.01, 0.04), NEEDLE),
            (30.0, (0.015, 0.06), SPARSE),
            (90.0, (0.08, 0.2), SPARSE),
            (170.0, (0.8, 1.0), WIDE),
        )
    ),
    *(
        Case(
            f"cone-{a:g}-lone-floor",
            f"a shadow cone of {a:g} degrees on a lone floor, sun in the zenith",
            "all light",
            "mean visibility lost",
            0.01,
            lone_floor_cone(a),
        )
        for a in (0.1, 5.0, 170.0)
    ),
]
