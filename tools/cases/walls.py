"""Thin walls, sheets and single-sided surfaces: light must not pass through what is thinner than a voxel."""

from __future__ import annotations

from typing import Callable

import numpy as np

from scenes import thin_wall
from scenes.hard_cases import HALF, Part, View, floor, make, quad

from .case import Case, Measured
from .floor import floor_points
from .run import Answer, Vct

SIZE = 128
SIDE_VIEW = View((0, 60, 60), (0, 5, 0), 50)
LEVEL_SUN = (1.0, 0.0, 0.0)  # along +X and level: lights what stands, never the floor
BLUE = (0.2, 0.3, 0.7)


def _thin_wall(thickness_m: float, grid: int) -> Callable[[Vct], Measured]:
    """Of a room of 4 m; a voxel of 128^3 is 33 mm, of 256^3 16 mm."""

    def measure(vct: Vct) -> Measured:
        answer = vct.render(
            f"thin_wall_{1000 * thickness_m:g}mm",
            thin_wall.build(thickness_m).to_bytes(),
            grid=grid,
            size=f"{SIZE}x{SIZE}",
        )
        image = answer["indirect_light"]
        margin = 4 + int(SIZE * thickness_m / 4)  # pixels on both sides of the wall's edge, which faces the camera
        dark, lit = image[:, : SIZE // 2 - margin].mean(), image[:, SIZE // 2 + margin :].mean()
        return Measured(
            float(dark / lit), answer.folder / "indirect_light.png", f"dark half {dark:.4f}, lit half {lit:.4f}"
        )

    return measure


def _dark_floor(vct: Vct) -> tuple[Answer, np.ndarray]:
    """Direct light on the dark half's floor, over what the sun would give it without any wall."""
    answer = vct.render("thin_wall_direct", thin_wall.build().to_bytes(), grid=128, size=f"{SIZE}x{SIZE}")
    view = View((0, 1.35, 6.2), (0, 1.2, 0), 46)  # the scene's first camera
    x, z = floor_points(view, SIZE)
    inside = (x > -1.9) & (x < -0.02) & (z > -1.9) & (z < 1.9)
    cos_sun = 1.0 / float(np.linalg.norm((0.5, 1.0, 0.25)))
    direct = (answer["gi"] - answer["indirect_light"])[..., 0] / (0.7 * cos_sun)
    return answer, (direct / np.maximum(answer["ambient_occlusion"][..., 0], 1e-3))[inside]


def bias_leak(vct: Vct) -> Measured:
    answer, light = _dark_floor(vct)
    return Measured(float((light > 0.5).mean()), answer.folder / "gi.png")


def shadow_strength(vct: Vct) -> Measured:
    answer, light = _dark_floor(vct)
    return Measured(float(np.median(light)), answer.folder / "gi.png")


def _sheet(vct: Vct, name: str, double_sided: bool, faces_light: bool, view: View = SIDE_VIEW) -> tuple:
    """A sheet at x = 0.5 (the middle of a voxel) across a floor, lit from -X by a level sun.

    The floor's only light is what the sheet sends.
    """
    depth = 20.0
    shape = (
        quad((0.5, 0, -depth), (0, 0, 2 * depth), (0, 21, 0))
        if faces_light
        else quad((0.5, 0, depth), (0, 0, -2 * depth), (0, 21, 0))
    )
    answer = vct.render(name, make([Part(floor()), Part(shape, BLUE, double_sided=double_sided)], LEVEL_SUN, view))
    x, z = floor_points(view, SIZE)
    near = (np.abs(z) < 10) & (np.abs(x - 0.5) > 3) & (np.abs(x - 0.5) < 12)
    # The sheet hides none of this from above at the angle of SIDE_VIEW: it is seen edge-on.
    light = answer["indirect_light"].mean(axis=2)
    return answer, float(light[near & (x < 0.5)].mean()), float(light[near & (x > 0.5)].mean())


def sheet_leak(double_sided: bool) -> Callable[[Vct], Measured]:
    def measure(vct: Vct) -> Measured:
        name = "sheet_double" if double_sided else "sheet_single"
        answer, lit, dark = _sheet(vct, name, double_sided, faces_light=True)
        return Measured(
            dark / max(lit, 1e-9),
            answer.folder / "indirect_light.png",
            f"lit side {lit:.4f}, dark side {dark:.4f}",
        )

    return measure


def black_back(vct: Vct) -> Measured:
    answer, lit, dark = _sheet(vct, "sheet_back", double_sided=False, faces_light=False)
    return Measured(max(lit, dark), answer.folder / "gi.png")


def seen_from_behind(vct: Vct) -> Measured:
    """From +X the single-sided sheet is not there for the eye; the background is black."""
    view = View((70, 12, 0), (0, 12, 0), 40)
    scene = [Part(quad((0, 0, -20), (0, 0, 40), (0, 21, 0)), BLUE)]
    answer = vct.render("sheet_from_behind", make(scene, LEVEL_SUN, view), mode="phong")
    return Measured(float((answer["phong"] > 0).any(axis=2).mean()), answer.folder / "phong.png")


def double_from_behind(vct: Vct) -> Measured:
    """The dark side of a double-sided sheet: visible, and in its own shadow."""
    view = View((70, 12, 0), (0, 12, 0), 40)
    scene = [Part(quad((0, 0, -20), (0, 0, 40), (0, 21, 0)), BLUE, double_sided=True)]
    answer = vct.render("sheet_double_behind", make(scene, LEVEL_SUN, view), mode="gi")
    direct = answer["gi"] - answer["indirect_light"]
    return Measured(float(np.abs(direct).max()), answer.folder / "gi.png")


def standing_wall(height: float, low: float, high: float) -> Callable[[Vct], Measured]:
    """A sheet of `height` voxels across the floor, light at 45 degrees; dark `low` to `high` voxels behind it."""

    def measure(vct: Vct) -> Measured:
        view = View((0, 70, 45), (0, 0, 0), 50)
        wall = Part(quad((0.5, 0, -HALF), (0, 0, 2 * HALF), (0, height, 0)))
        answer = vct.render(
            f"wall_shadow_{height:g}",
            make([Part(floor()), wall], (1, -1, 0), view),
            mode="gi-cone-shadow",
            size=f"{SIZE}x{SIZE}",
        )
        x, z = floor_points(view, SIZE)
        shade = answer["cone_shadow"][..., 0][(x > 0.5 + low) & (x < 0.5 + high) & (np.abs(z) < 20)]
        return Measured(float(shade.mean()), answer.folder / "cone_shadow.png", f"largest {shade.max():.3f}")

    return measure


LEAK = "the wall's two sides share voxels, and cones step over or blur what is thin"
SHEET = "a voxel sends its light to both sides; the five cones beside the normal favour one of them"
CASES = [
    Case(
        "thin-wall-2mm",
        "a room cut in two by a wall of 2 mm (0.06 voxels of 128^3), sun in one half; indirect light",
        "the other half is black",
        "dark half over lit half",
        0.01,
        _thin_wall(0.002, 128),
        (0.2, 0.4),
        LEAK,
    ),
    Case(
        "thin-wall-10mm-256",
        "the same with 10 mm (0.6 voxels of 256^3), as in assets/thin_wall.glb",
        "the other half is black",
        "dark half over lit half",
        0.01,
        _thin_wall(0.01, 256),
        (0.3, 0.5),
        LEAK,
        quick=False,
    ),
    Case(
        "thick-wall-300mm",
        "the same with a wall of 0.3 m, which is 9 voxels of 128^3",
        "the other half is black",
        "dark half over lit half",
        0.01,
        _thin_wall(0.3, 128),
        (0.2, 0.4),
        "samples of the wide cones lie so far apart that walls fall between them, and coarse levels mix both sides",
    ),
    Case(
        "thin-wall-direct",
        "direct light by the shadow map behind a wall of 10 mm",
        "the other half is black",
        "share of the dark floor that is more than half lit",
        0.001,
        bias_leak,
    ),
    Case(
        "shadow-strength",
        "the same floor, its median",
        "no direct light in shadow",
        "share of unshadowed light",
        0.01,
        shadow_strength,
        (0.09, 0.11),
        "eq. 4.9 lets a shadow take 0.9 of the light only",
    ),
    Case(
        "thin-wall-cone-shadow",
        "a sheet of 21 voxels on a floor, light at 45 degrees, 2 to 10 voxels behind it",
        "dark",
        "mean visibility by the shadow cone",
        0.01,
        standing_wall(21, 2, 10),
    ),
    Case(
        "shadow-start",
        "the same with a sheet of 7 voxels, 2 to 5 voxels behind it",
        "dark",
        "mean visibility by the shadow cone",
        0.01,
        standing_wall(7, 2, 5),
        (0.8, 1.0),
        "the shadow cone starts 8 voxels along the normal, above the sheet",
    ),
    Case(
        "sheet-double-sided",
        "a double-sided sheet lit from one side, on a floor that the sun does not light",
        "the floor on its dark side gets nothing",
        "dark side over lit side",
        0.01,
        sheet_leak(True),
        (1.0, 2.0),
        SHEET,
    ),
    Case(
        "sheet-single-sided",
        "the same, single-sided, its front to the light",
        "the floor on its dark side gets nothing",
        "dark side over lit side",
        0.01,
        sheet_leak(False),
        (1.0, 2.0),
        SHEET,
    ),
    Case(
        "sheet-back-to-the-light",
        "a single-sided sheet with its back to the light",
        "a back is black: no light on the floor",
        "largest mean indirect light",
        0.0,
        black_back,
    ),
    Case(
        "single-sided-from-behind",
        "a single-sided sheet seen from behind",
        "not there for the eye",
        "share of the picture that is not black",
        0.0,
        seen_from_behind,
    ),
    Case(
        "double-sided-from-behind",
        "the dark side of a double-sided sheet",
        "no direct light",
        "largest direct light",
        1e-3,
        double_from_behind,
    ),
]
