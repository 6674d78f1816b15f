"""Light along surfaces, straight up and down; albedo 0 and 1; furnace and lone plane."""

from __future__ import annotations

import math
from typing import Callable

import numpy as np

from scenes import shapes
from scenes.hard_cases import Part, View, floor, make, room

from .case import Case, Measured
from .floor import floor_points
from .run import Vct, mean_difference

SIZE = 128
SUN = (-0.5, -1.0, -0.3)
OVERVIEW = View((25, 45, 70), (0, 5, 0), 45)
INSIDE = View((12, 8, 24), (-6, -5, -28), 75)
RED = (0.6, 0.05, 0.05)


def parallel(degrees: float) -> Callable[[Vct], Measured]:
    """A lone floor and a sun that many degrees below its plane: it lights the underside only, which is black."""

    def measure(vct: Vct) -> Measured:
        angle = math.radians(degrees)
        travels = (math.cos(angle), math.sin(angle), 0.0)
        answer = vct.render(
            f"parallel_{degrees:g}", make([Part(floor())], travels, OVERVIEW), mode="gi,gi-cone-shadow"
        )
        return Measured(float(max(answer["gi"].max(), answer["gi-cone-shadow"].max())), answer.folder / "gi.png")

    return measure


def _towers() -> list[Part]:
    return [
        Part(floor()),
        Part(shapes.box((12, 19, 12), None), RED, place={"translation": [6.3, 0, 2.3]}),
        Part(shapes.icosphere(6, 2), place={"translation": [-12.2, 9.7, -3.1]}),
    ]


def straight_down(vct: Vct) -> Measured:
    """Exactly straight down, where a light's frame has no natural up, against 0.01 degrees beside."""
    exact = vct.render("straight_down", make(_towers(), (0, -1, 0), OVERVIEW), mode="gi-cone-shadow")
    tilted = vct.render("straight_down_nearly", make(_towers(), (1.7e-4, -1, 0), OVERVIEW), mode="gi-cone-shadow")
    return Measured(
        mean_difference(exact["gi-cone-shadow"], tilted["gi-cone-shadow"]), exact.folder / "gi-cone-shadow.png"
    )


def straight_up(vct: Vct) -> Measured:
    """The scene of straight_down with everything, camera and light too, turned upside down about Z."""
    down = vct.render("straight_down", make(_towers(), (0, -1, 0), OVERVIEW), mode="shadow-map")
    up = vct.render(
        "straight_up", make(_towers(), (0, -1, 0), OVERVIEW, root={"rotation": [0, 0, 1, 0]}), mode="shadow-map"
    )
    return Measured(mean_difference(up["shadow-map"], down["shadow-map"]), up.folder / "shadow-map.png")


def black(vct: Vct) -> Measured:
    """Albedo 0: nothing comes back, whatever falls on it."""
    parts = _towers()
    for part in parts:
        part.color = (0.0, 0.0, 0.0)
    answer = vct.render("albedo_0", make(parts, SUN, OVERVIEW), mode="gi,gi-cone-shadow")
    return Measured(
        max(float(answer[n].max()) for n in ("gi", "gi-cone-shadow", "indirect_light")), answer.folder / "gi.png"
    )


def _furnace(vct: Vct, albedo: float) -> np.ndarray:
    scene = make([Part(room(), (albedo,) * 3, emits=(1.0, 1.0, 1.0))], SUN, INSIDE, lux=0.0)
    return vct.render(f"furnace_{albedo:g}", scene)["indirect_light"] / albedo


def furnace_loss(vct: Vct) -> Measured:
    image = _furnace(vct, 0.8)
    return Measured(
        abs(1.0 - float(image.mean())),
        vct.out / "furnace_0.8" / "indirect_light.png",
        f"mean {image.mean():.3f}, least {image.min():.3f}, largest {image.max():.3f}",
    )


def white(vct: Vct) -> Measured:
    """Albedo 1 in a furnace of 1: one bounce must not make light."""
    image = _furnace(vct, 1.0)
    return Measured(
        max(0.0, float(image.max()) - 1.0),
        vct.out / "furnace_1" / "indirect_light.png",
        f"largest {image.max():.4f}",
    )


def lone_plane(vct: Vct) -> Measured:
    view = View((0, 30, 50), (0, 0, 0), 45)
    answer = vct.render(
        "lone_plane", make([Part(floor(), (0.8,) * 3)], SUN, view), grid=256, size=f"{SIZE}x{SIZE}"
    )
    x, z = floor_points(view, SIZE)
    inside = (np.abs(x) < 28) & (np.abs(z) < 28)
    image, direct = answer["indirect_light"][inside], (answer["gi"] - answer["indirect_light"])[inside]
    return Measured(
        float(image.mean() / direct.mean()), answer.folder / "indirect_light.png", f"largest {image.max():.4f}"
    )


def bright_sun(vct: Vct) -> Measured:
    """The sun's real 100,000 lux gives the picture of pi lux, times 100,000 / pi."""
    usual = vct.render("sun_pi", make(_towers(), SUN, OVERVIEW))
    bright = vct.render("sun_1e5", make(_towers(), SUN, OVERVIEW, lux=1e5))
    return Measured(mean_difference(bright["gi"] * (math.pi / 1e5), usual["gi"]), bright.folder / "gi.png")


CASES = [
    Case("light-parallel", "a sun exactly parallel to a lone floor", "black", "largest light", 0.0, parallel(0.0)),
    Case(
        "light-0.001-degrees-below",
        "a sun 0.001 degrees under the floor's plane",
        "black",
        "largest light",
        0.0,
        parallel(0.001),
    ),
    Case(
        "light-straight-down",
        "the sun in the zenith",
        "the picture of 0.01 degrees beside",
        "mean difference over mean light",
        0.01,
        straight_down,
    ),
    Case(
        "light-straight-up",
        "a sun in the nadir, the scene hanging",
        "the picture of straight down, turned",
        "mean difference over mean light",
        0.01,
        straight_up,
    ),
    Case("albedo-0", "black surfaces", "black", "largest light", 0.0, black),
    Case(
        "albedo-1", "white surfaces in a furnace of 1", "never more than 1", "largest light above 1", 0.01, white
    ),
    Case(
        "furnace",
        "a closed box that emits 1",
        "light gathered: 1",
        "error of the mean",
        0.02,
        furnace_loss,
        (0.2, 0.4),
        "start offsets and skipped levels lose light, colours are rounded down",
    ),
    Case(
        "lone-plane",
        "one lit floor",
        "no indirect light",
        "indirect over direct light",
        0.001,
        lone_plane,
        (0.05, 0.12),
        "coarse levels of the cones beside the normal reach the floor itself",
    ),
    Case(
        "sun-of-100000-lux",
        "a light as bright as the sun",
        "the picture of pi lux, scaled",
        "mean difference over mean light",
        0.002,
        bright_sun,
    ),
]
