"""Thin walls, sheets and single-sided surfaces: light must not pass through what is thinner than a voxel."""
from __future__ import annotations

from functools import partial

import numpy as np

from scenes import thin_wall
from scenes.hard_cases import HALF, Part, View, floor, make
from scenes.shapes import quads

from .case import Case
from .floor import on_floor
from .run import Answer, Measured, Vct

SIDE_VIEW = View((0, 60, 60), (0, 5, 0), 50)
BEHIND = View((70, 12, 0), (0, 12, 0), 40)
LEVEL_SUN = (1.0, 0.0, 0.0)  # along +X and level: lights what stands, never the floor
BLUE = (0.2, 0.3, 0.7)


def _thin_wall(thickness_m: float, grid: int, vct: Vct) -> Measured:
    """Of a room of 4 m; a voxel of 128^3 is 33 mm, of 256^3 16 mm."""
    answer = vct.render(f"thin_wall_{1000 * thickness_m:g}mm", thin_wall.build(thickness_m).to_bytes(), grid=grid)
    light = answer["indirect_light"]
    middle, margin = len(light) // 2, 4 + int(len(light) * thickness_m / 4)  # the wall's edge, which faces the camera
    dark, lit = light[:, :middle - margin].mean(), light[:, middle + margin:].mean()
    return answer.measured(dark / lit, "indirect_light", f"dark half {dark:.4f}, lit half {lit:.4f}")


def _dark_floor(vct: Vct) -> tuple[Answer, np.ndarray]:
    """Direct light on the dark half's floor, over what the sun would give it without any wall."""
    answer = vct.render("thin_wall_direct", thin_wall.build().to_bytes(), grid=128)
    cos_sun = 1.0 / float(np.linalg.norm((0.5, 1.0, 0.25)))
    direct = (answer["gi"] - answer["indirect_light"])[..., 0] / (0.7 * cos_sun)
    direct /= np.maximum(answer["ambient_occlusion"][..., 0], 1e-3)
    return answer, on_floor(direct, View((0, 1.35, 6.2), (0, 1.2, 0), 46), (-1.9, -0.02), 1.9)  # the scene's first camera


def bias_leak(vct: Vct) -> Measured:
    answer, light = _dark_floor(vct)
    return answer.measured((light > 0.5).mean())


def shadow_strength(vct: Vct) -> Measured:
    answer, light = _dark_floor(vct)
    return answer.measured(np.median(light))


def _sheet(vct: Vct, name: str, double_sided: bool, faces_light: bool) -> tuple[Answer, float, float]:
    """A sheet at x = 0.5 (the middle of a voxel) across a floor, lit from -X by a level sun: light before and behind it.

    The floor's only light is what the sheet sends. The sheet hides none of the judged floor from SIDE_VIEW, which sees it
    edge-on.
    """
    depth = 20.0 if faces_light else -20.0
    sheet = Part(quads(((0.5, 0, -depth), (0, 0, 2 * depth), (0, 21, 0))), BLUE, double_sided=double_sided)
    answer = vct.render(name, make([Part(floor()), sheet], LEVEL_SUN, SIDE_VIEW))
    light = answer["indirect_light"].mean(axis=2)
    lit, dark = (float(on_floor(light, SIDE_VIEW, x, 10).mean()) for x in ((-11.5, -2.5), (3.5, 12.5)))
    return answer, lit, dark


def sheet_leak(double_sided: bool, vct: Vct) -> Measured:
    answer, lit, dark = _sheet(vct, "sheet_double" if double_sided else "sheet_single", double_sided, faces_light=True)
    return answer.measured(dark / max(lit, 1e-9), "indirect_light", f"lit side {lit:.4f}, dark side {dark:.4f}")


def black_back(vct: Vct) -> Measured:
    answer, lit, dark = _sheet(vct, "sheet_back", double_sided=False, faces_light=False)
    return answer.measured(max(lit, dark))


def _from_behind(vct: Vct, name: str, double_sided: bool, mode: str) -> Answer:
    sheet = Part(quads(((0, 0, -20), (0, 0, 40), (0, 21, 0))), BLUE, double_sided=double_sided)
    return vct.render(name, make([sheet], LEVEL_SUN, BEHIND), mode=mode)


def seen_from_behind(vct: Vct) -> Measured:
    """From +X the single-sided sheet is not there for the eye; the background is black."""
    answer = _from_behind(vct, "sheet_from_behind", False, "phong")
    return answer.measured((answer["phong"] > 0).any(axis=2).mean(), "phong")


def double_from_behind(vct: Vct) -> Measured:
    """The dark side of a double-sided sheet: visible, and in its own shadow."""
    answer = _from_behind(vct, "sheet_double_behind", True, "gi")
    return answer.measured(np.abs(answer["gi"] - answer["indirect_light"]).max())


def standing_wall(height: float, low: float, high: float, vct: Vct) -> Measured:
    """A sheet of `height` voxels across the floor, light at 45 degrees; dark `low` to `high` voxels behind it."""
    view = View((0, 70, 45), (0, 0, 0), 50)
    wall = Part(quads(((0.5, 0, -HALF), (0, 0, 2 * HALF), (0, height, 0))))
    answer = vct.render(f"wall_shadow_{height:g}", make([Part(floor()), wall], (1, -1, 0), view), mode="gi-cone-shadow")
    shade = on_floor(answer["cone_shadow"][..., 0], view, (0.5 + low, 0.5 + high), 20)
    return answer.measured(shade.mean(), "cone_shadow", f"largest {shade.max():.3f}")


LEAK = "the wall's two sides share voxels, and cones step over or blur what is thin"
SHEET = "a voxel sends its light to both sides; the five cones beside the normal favour one of them"
BLACK, HALVES = "the other half is black", "dark half over lit half"
NOTHING, SIDES = "the floor on its dark side gets nothing", "dark side over lit side"
VISIBILITY = "mean visibility by the shadow cone"
CASES = [
    Case("thin-wall-2mm", "a room cut in two by a wall of 2 mm (0.06 voxels of 128^3), sun in one half; indirect light", BLACK,
         HALVES, 0.01, partial(_thin_wall, 0.002, 128), (0.2, 0.4), LEAK),
    Case("thin-wall-10mm-256", "the same with 10 mm (0.6 voxels of 256^3), as in assets/thin_wall.glb", BLACK, HALVES, 0.01,
         partial(_thin_wall, 0.01, 256), (0.3, 0.5), LEAK, quick=False),
    Case("thick-wall-300mm", "the same with a wall of 0.3 m, which is 9 voxels of 128^3", BLACK, HALVES, 0.01,
         partial(_thin_wall, 0.3, 128), (0.2, 0.4),
         "samples of the wide cones lie so far apart that walls fall between them, and coarse levels mix both sides"),
    Case("thin-wall-direct", "direct light by the shadow map behind a wall of 10 mm", BLACK,
         "share of the dark floor that is more than half lit", 0.001, bias_leak),
    Case("shadow-strength", "the same floor, its median", "no direct light in shadow", "share of unshadowed light", 0.01,
         shadow_strength, (0.09, 0.11), "eq. 4.9 lets a shadow take 0.9 of the light only"),
    Case("thin-wall-cone-shadow", "a sheet of 21 voxels on a floor, light at 45 degrees, 2 to 10 voxels behind it", "dark",
         VISIBILITY, 0.01, partial(standing_wall, 21, 2, 10)),
    Case("shadow-start", "the same with a sheet of 7 voxels, 2 to 5 voxels behind it", "dark", VISIBILITY, 0.01,
         partial(standing_wall, 7, 2, 5), (0.8, 1.0), "the shadow cone starts 8 voxels along the normal, above the sheet"),
    Case("sheet-double-sided", "a double-sided sheet lit from one side, on a floor that the sun does not light", NOTHING, SIDES,
         0.01, partial(sheet_leak, True), (1.0, 2.0), SHEET),
    Case("sheet-single-sided", "the same, single-sided, its front to the light", NOTHING, SIDES, 0.01, partial(sheet_leak, False),
         (1.0, 2.0), SHEET),
    Case("sheet-back-to-the-light", "a single-sided sheet with its back to the light", "a back is black: no light on the floor",
         "largest mean indirect light", 0.0, black_back),
    Case("single-sided-from-behind", "a single-sided sheet seen from behind", "not there for the eye",
         "share of the picture that is not black", 0.0, seen_from_behind),
    Case("double-sided-from-behind", "the dark side of a double-sided sheet", "no direct light", "largest direct light", 1e-3,
         double_from_behind),
]
