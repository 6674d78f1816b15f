"""Light along surfaces, straight up and down; albedo 0 and 1; furnace and lone plane."""
from __future__ import annotations

import math
from functools import partial

from scenes import shapes
from scenes.hard_cases import INSIDE, RED, SUN, Part, View, box, floor, make, room

from .case import LIGHT, Case
from .floor import on_floor
from .run import Answer, Measured, Vct, mean_difference


def parallel(degrees: float, vct: Vct) -> Measured:
    """A lone floor and a sun that many degrees below its plane: it lights the underside only, which is black."""
    angle = math.radians(degrees)
    scene = make([Part(floor())], (math.cos(angle), math.sin(angle), 0.0))
    answer = vct.render(f"parallel_{degrees:g}", scene, mode="gi,gi-cone-shadow")
    return answer.measured(max(answer["gi"].max(), answer["gi-cone-shadow"].max()))


def _towers() -> list[Part]:
    return [Part(floor()), Part(box((12, 19, 12)), RED, place={"translation": [6.3, 0, 2.3]}),
            Part(shapes.icosphere(6, 2), place={"translation": [-12.2, 9.7, -3.1]})]


def straight_down(vct: Vct) -> Measured:
    """Exactly straight down, where a light's frame has no natural up, against 0.01 degrees beside."""
    return vct.difference("straight_down", make(_towers(), (0, -1, 0)), "straight_down_nearly", make(_towers(), (1.7e-4, -1, 0)),
                          ("gi-cone-shadow",), mode="gi-cone-shadow")


def straight_up(vct: Vct) -> Measured:
    """The scene of straight_down with everything, camera and light too, turned upside down about Z."""
    return vct.difference("straight_up", make(_towers(), (0, -1, 0), root={"rotation": [0, 0, 1, 0]}), "straight_down",
                          make(_towers(), (0, -1, 0)), ("shadow-map",), mode="shadow-map")


def black(vct: Vct) -> Measured:
    """Albedo 0: nothing comes back, whatever falls on it."""
    parts = _towers()
    for part in parts:
        part.color = (0.0, 0.0, 0.0)
    answer = vct.render("albedo_0", make(parts), mode="gi,gi-cone-shadow")
    return answer.measured(max(answer[name].max() for name in ("gi", "gi-cone-shadow", "indirect_light")))


def _furnace(vct: Vct, albedo: float) -> Answer:
    scene = make([Part(room(), (albedo,) * 3, emits=(1.0, 1.0, 1.0))], SUN, INSIDE, lux=0.0)
    return vct.render(f"furnace_{albedo:g}", scene)


def furnace_loss(vct: Vct) -> Measured:
    answer = _furnace(vct, 0.8)
    light = answer["indirect_light"] / 0.8
    return answer.measured(abs(1.0 - light.mean()), "indirect_light",
                           f"mean {light.mean():.3f}, least {light.min():.3f}, largest {light.max():.3f}")


def white(vct: Vct) -> Measured:
    """Albedo 1 in a furnace of 1: one bounce must not make light."""
    answer = _furnace(vct, 1.0)
    largest = float(answer["indirect_light"].max())
    return answer.measured(max(0.0, largest - 1.0), "indirect_light", f"largest {largest:.4f}")


def lone_plane(vct: Vct) -> Measured:
    view = View((0, 30, 50), (0, 0, 0), 45)
    answer = vct.render("lone_plane", make([Part(floor(), (0.8,) * 3)], SUN, view), grid=256)
    light, all_light = (on_floor(answer[name], view, (-28, 28), 28) for name in ("indirect_light", "gi"))
    return answer.measured(light.mean() / (all_light - light).mean(), "indirect_light", f"largest {light.max():.4f}")


def bright_sun(vct: Vct) -> Measured:
    """The sun's real 100,000 lux gives the picture of pi lux, times 100,000 / pi."""
    usual, bright = vct.render("sun_pi", make(_towers())), vct.render("sun_1e5", make(_towers(), lux=1e5))
    return bright.measured(mean_difference(bright["gi"] * (math.pi / 1e5), usual["gi"]))


CASES = [
    Case("light-parallel", "a sun exactly parallel to a lone floor", "black", "largest light", 0.0, partial(parallel, 0.0)),
    Case("light-0.001-degrees-below", "a sun 0.001 degrees under the floor's plane", "black", "largest light", 0.0,
         partial(parallel, 0.001)),
    Case("light-straight-down", "the sun in the zenith", "the picture of 0.01 degrees beside", LIGHT, 0.01, straight_down),
    Case("light-straight-up", "a sun in the nadir, the scene hanging", "the picture of straight down, turned", LIGHT, 0.01,
         straight_up),
    Case("albedo-0", "black surfaces", "black", "largest light", 0.0, black),
    Case("albedo-1", "white surfaces in a furnace of 1", "never more than 1", "largest light above 1", 0.01, white),
    Case("furnace", "a closed box that emits 1", "light gathered: 1", "error of the mean", 0.02, furnace_loss, (0.2, 0.4),
         "start offsets and skipped levels lose light, colours are rounded down"),
    Case("lone-plane", "one lit floor", "no indirect light", "indirect over direct light", 0.001, lone_plane, (0.05, 0.12),
         "coarse levels of the cones beside the normal reach the floor itself"),
    Case("sun-of-100000-lux", "a light as bright as the sun", "the picture of pi lux, scaled", LIGHT, 0.002, bright_sun),
]
