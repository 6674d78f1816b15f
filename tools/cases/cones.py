"""Shadow cones from needle to plate, and the shadow map: what a closed room keeps out and an open floor gets."""
from __future__ import annotations

from functools import partial

import numpy as np

from scenes.hard_cases import GREY, HALF, INSIDE, Part, View, floor, make, room

from .case import Case
from .floor import on_floor
from .run import Measured, Vct


def visibility(vct: Vct, name: str, degrees: float, scene: bytes, view: View, y: float) -> tuple:
    """A run with a shadow cone, and what its cone lets through over the floor."""
    answer = vct.render(f"{name}_{degrees:g}", scene, mode="gi-cone-shadow", options=("--cone-angle", f"{degrees:g}"))
    return answer, on_floor(answer["cone_shadow"][..., 0], view, (-28, 28), 28, y)


def closed_room(degrees: float, vct: Vct) -> Measured:
    """A closed room with the sun outside: no cone of any width sees out. Judged on its floor."""
    answer, light = visibility(vct, "cone_room", degrees, make([Part(room())], view=INSIDE), INSIDE, -HALF)
    return answer.measured(light.mean(), "cone_shadow", f"largest {light.max():.3f}")


def closed_room_shadow_map(vct: Vct) -> Measured:
    """Direct light is less than half of what it were without walls: not even a line of light along the edges."""
    answer = vct.render("map_room", make([Part(room())], view=INSIDE), size=256)
    direct = (answer["gi"] - answer["indirect_light"])[..., 0] / np.maximum(answer["ambient_occlusion"][..., 0], 1e-3)
    return answer.measured((direct > 0.3 * GREY[0]).mean(), note=f"largest {direct.max():.3f}")


def lone_floor_cone(degrees: float, vct: Vct) -> Measured:
    """A lone floor under a sun in the zenith: up to 180 degrees the cone does not touch it."""
    view = View((0, 12, 40), (0, 0, 0), 40)
    answer, light = visibility(vct, "cone_floor", degrees, make([Part(floor())], (0, -1, 0), view), view, 0.0)
    return answer.measured(1.0 - float(light.mean()), "cone_shadow", f"least {light.min():.3f}")


NEEDLE = "a thin cone sees one layer of voxels in part only, where it crosses between their middles"
SPARSE = "steps grow with the distance, and a wall between two samples is seen in part only"
WIDE = "a wide cone's first sample by eq. 4.8 lies behind the volume: it sees nothing"
ROOMS = ((0.1, None, ""), (1.0, None, ""), (5.0, (0.01, 0.04), NEEDLE), (30.0, (0.015, 0.06), SPARSE),
         (90.0, (0.08, 0.2), SPARSE), (170.0, (0.8, 1.0), WIDE))
CASES = [
    Case("shadow-map-closed-room", "the shadow map in a closed room, sun outside", "dark", "share of pixels that are lit", 0.0,
         closed_room_shadow_map, (0.001, 0.01), "the bias of up to 0.01 of the depth range lights a line along edges to the sun"),
    *(Case(f"cone-{a:g}-closed-room", f"a shadow cone of {a:g} degrees in a closed room", "dark", "mean visibility", 0.01,
           partial(closed_room, a), known, cause, quick=a not in (1.0, 30.0)) for a, known, cause in ROOMS),
    *(Case(f"cone-{a:g}-lone-floor", f"a shadow cone of {a:g} degrees on a lone floor, sun in the zenith", "all light",
           "mean visibility lost", 0.01, partial(lone_floor_cone, a)) for a in (0.1, 5.0, 170.0)),
]
