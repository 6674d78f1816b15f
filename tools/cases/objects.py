"""Things that touch, lie in each other, are hollow or far away: occlusion that must be there, and no more."""
from __future__ import annotations

from functools import partial

from scenes import shapes
from scenes.hard_cases import RED, SUN, Part, View, box, floor, make

from .case import INDIRECT, Case
from .floor import on_floor, openness_beside_wall, openness_under_ceiling, rectangle_form_factor
from .run import Measured, Vct

GRID = 256  # the thesis's; scenes are 59 units wide, so a voxel here is 59 / 251 units
VOXEL = 59.0 / 251.0
REACH = 0.045 * 256 * VOXEL  # of ambient occlusion, in units (pipeline.md: 0.045 of the volume's side)
WHITE, BLUE = (1.0, 1.0, 1.0), (0.05, 0.1, 0.6)
SKY = ("--sky", "1,1,1")
BESIDE = View((4.0, 9.0, 0.01), (4.0, 0, 0), 45)  # the floor beside a box whose side is half a voxel from the middle


def visibility(vct: Vct, name: str, part: Part, view: View, x: tuple[float, float], z: float, right: float) -> Measured:
    """How far the ambient visibility of a part of the floor is from the right one, with one thing on or above it."""
    answer = vct.render(name, make([Part(floor()), part], SUN, view), grid=GRID)
    found = float(on_floor(answer["ambient_occlusion"][..., 0], view, x, z).mean())
    return answer.measured(abs(found - right), "ambient_occlusion", f"ambientVisibility {found:.3f}, right {right:.3f}")


def contact_occlusion(voxels: float, vct: Vct) -> Measured:
    """Openness of the floor at `voxels` from a big box that rests on it, against the closed form of a wall."""
    part = Part(box((20, 10.5, 40)), RED, place={"translation": [-10 + 0.5 * VOXEL, 0, 0]})
    return visibility(vct, "contact", part, BESIDE, (voxels * VOXEL, (voxels + 1) * VOXEL), 3,
                      openness_beside_wall(voxels * VOXEL, REACH))


def coincident(vct: Vct) -> Measured:
    """The same box twice in one place, red and blue; and two boxes that share part of their top face."""
    places = (((-10, 0, -6), RED), ((-10, 0, -6), BLUE), ((8, 0, 8), RED), ((12, 0, 10), BLUE))
    boxes = [Part(box((12, 11, 12)), color, place={"translation": list(place)}) for place, color in places]
    scene = make([Part(floor()), *boxes], SUN, View((0, 50, 40), (0, 5, 0), 45))
    answer = vct.render("coincident", scene, mode="gi,phong")
    return answer.measured(0.0, "phong", "equal in every bit with the triangles shuffled")


def nested(vct: Vct) -> Measured:
    """A closed box, and the same with three boxes inside: what is shut in cannot be seen."""
    outer = [Part(floor()), Part(box((20, 21, 20)), RED, place={"translation": [2, 0, 1]})]
    inner = [Part(box((s, s, s)), (0.05, 0.6, 0.05), place={"translation": [2, 0.5 * (21 - s), 1]}) for s in (17.0, 12.0, 6.0)]
    view = View((25, 30, 45), (0, 5, 0), 45)
    return vct.difference("nested", make(outer + inner, SUN, view), "nested_without", make(outer, SUN, view), ("indirect_light",))


def hollow(vct: Vct) -> Measured:
    """Under a closed slab 3 voxels above the floor: the cones start 5 voxels up, inside it."""
    slab = Part(box((40, 8 * VOXEL, 40)), place={"translation": [0, 3 * VOXEL, 0]})
    return visibility(vct, "hollow", slab, View((0.0, 2.5 * VOXEL, 7.0), (0, 0, 0), 40), (-2, 2), 4,
                      openness_under_ceiling(3 * VOXEL, REACH))


def small_object(vct: Vct) -> Measured:
    """A slab 4 voxels high on the floor is below where the cones start: its side occludes the floor for nobody.

    A wall of height h at distance d blocks (1 - d / sqrt(d^2 + h^2)) / 2 of the cosine-weighted hemisphere; here d is
    half a voxel and h four, all of it within the reach.
    """
    slab = Part(box((20, 4 * VOXEL, 40)), RED, place={"translation": [-10 + 0.5 * VOXEL, 0, 0]})
    return visibility(vct, "small_object", slab, BESIDE, (0.5 * VOXEL, 1.5 * VOXEL), 3,
                      1.0 - 0.5 * (1.0 - 0.5 / (0.25 + 16.0) ** 0.5))


def grate(height_voxels: int, vct: Vct) -> Measured:
    """Black tiles of 2 x 2 voxels in a pattern of 8 x 8, so 1/16 of a plane, over a white floor under a sky of 1."""
    tiles = shapes.quads(*(((-26 + 8 * i, height_voxels, -26 + 8 * j), (2, 0, 0), (0, 0, 2)) for i in range(7) for j in range(7)))
    view = View((0, 0.45 * height_voxels, 6.0), (0, 0, 0), 30)
    ground = Part(floor(), WHITE)
    answer = vct.render(f"grate_{height_voxels}", make([ground, Part(tiles, (0, 0, 0), double_sided=True)], SUN, view, 0.0),
                        options=SKY)
    bare = vct.render("grate_none", make([ground], SUN, view, 0.0), options=SKY)
    found, without = (on_floor(one["indirect_light"][..., 0], view, (-4, 4), 4).mean() for one in (answer, bare))
    left = float(found) / max(float(without), 1e-9)
    right = 1.0 - rectangle_form_factor(28.0, height_voxels) / 16.0
    return answer.measured(abs(left - right), "indirect_light", f"sky left {left:.3f} of that without, right {right:.3f}")


def open_sky(vct: Vct) -> Measured:
    """A white floor alone under a sky of 1 sees all of it."""
    view = View((0, 12, 30), (0, 0, 0), 40)
    answer = vct.render("open_sky", make([Part(floor(), WHITE)], SUN, view, 0.0), options=SKY, grid=GRID)
    found = on_floor(answer["indirect_light"][..., 0], view, (-20, 20), 20)
    return answer.measured(1.0 - float(found.mean()), "indirect_light",
                           f"mean {found.mean():.3f}, least {found.min():.3f}, right 1")


SIX = "six wide cones stand for the hemisphere, and a voxel that is touched is full"
CONTACT = "cones start 5 voxels along the normal and sample first 2.5 voxels further"
FULL = "a voxel is opaque as soon as one of its children is"
ERROR = "error of ambientVisibility"
CASES = [
    Case("touching-1-voxel", "the floor 1 voxel from a big box that rests on it", "closed form of a wall: 0.55", ERROR, 0.05,
         partial(contact_occlusion, 1.0), (0.05, 0.12), SIX),
    Case("touching-4-voxels", "the floor 4 voxels from the box", "closed form of a wall: 0.72", ERROR, 0.05,
         partial(contact_occlusion, 4.0), (0.05, 0.12), SIX, quick=False),
    Case("touching-low-slab", "the floor half a voxel beside a slab of 4 voxels", "closed form of a low wall: 0.56", ERROR, 0.05,
         small_object, (0.3, 0.5), CONTACT),
    Case("coincident-faces", "two boxes in one place, red and blue, and two that share part of a face",
         "either colour, the same in any order of triangles", "(order alone)", 0.0, coincident),
    Case("nested-objects", "boxes shut into a closed box", "the picture without them", INDIRECT, 0.02, nested, (0.06, 0.2),
         "coarse levels mix the inside with the outside"),
    Case("hollow-object", "the floor under a slab 3 voxels above it, 8 voxels thick", "closed form of a ceiling: 0.07", ERROR, 0.05,
         hollow, (0.15, 0.4), "cones start inside the hollow slab"),
    Case("over-occlusion-at-8", "a grate that covers 1/16 of the sky, 8 voxels above a floor", "closed form: 0.94",
         "error of the sky left", 0.05, partial(grate, 8), (0.15, 0.35), FULL, quick=False),
    Case("over-occlusion-at-24", "the same grate 24 voxels above", "closed form: 0.96", "error of the sky left", 0.05,
         partial(grate, 24), (0.3, 0.6), FULL),
    Case("self-occlusion", "a floor alone under a sky of 1", "all of the sky: 1", "sky lost", 0.02, open_sky, (0.08, 0.2),
         "coarse levels of the cones beside the normal reach the floor itself"),
]
