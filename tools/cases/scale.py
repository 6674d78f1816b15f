"""Size, place and node transforms: the same scene told differently gives the same picture."""

from __future__ import annotations

from typing import Any, Callable

from scenes import cornell, shapes
from scenes.hard_cases import Part, View, floor, make, wrapped

from .case import Case, Measured
from .run import Vct, mean_difference

SUN = (-0.5, -1.0, -0.3)
OVERVIEW = View((25, 45, 70), (0, 5, 0), 45)
MODES = "gi,gi-cone-shadow"


def _cornell(vct: Vct) -> Any:
    return vct.render("cornell", cornell.build().to_bytes(), mode=MODES, check_order=False)


def _worst(a: Any, b: Any) -> float:
    return max(mean_difference(a[n], b[n]) for n in ("gi", "gi-cone-shadow", "indirect_light"))


def scaled(name: str, scale: float) -> Callable[[Vct], Measured]:
    def measure(vct: Vct) -> Measured:
        answer = vct.render(name, cornell.build(scale).to_bytes(), mode=MODES)
        return Measured(_worst(answer, _cornell(vct)), answer.folder / "gi.png")

    return measure


def far_node(vct: Vct) -> Measured:
    """Cornell of 2 m under a node that moves all of it by 10^6 m along every axis."""
    scene = wrapped(cornell.build(), {"translation": [1e6, 1e6, -1e6]}).to_bytes()
    answer = vct.render("cornell_far", scene, mode=MODES)
    return Measured(_worst(answer, _cornell(vct)), answer.folder / "gi.png")


def far_vertices(vct: Vct) -> Measured:
    """Vertices around 10^6 in the file itself, where a float is exact to 1/16: objects placed on that raster."""
    away = (1_000_000.0, 500_000.0, -1_000_000.0)

    def parts(offset: tuple[float, float, float]) -> list[Part]:
        box = shapes.box((12, 19, 12), None)
        whole = [shapes.Shape(list(floor().positions), list(floor().normals), [], floor().indices), box]
        for shape in whole:
            shape.positions = [tuple(c + o for c, o in zip(p, offset)) for p in shape.positions]
        return [Part(whole[0]), Part(whole[1], (0.6, 0.05, 0.05))]

    def view(offset: tuple[float, float, float]) -> View:
        return View(
            tuple(c + o for c, o in zip(OVERVIEW.eye, offset)),
            tuple(c + o for c, o in zip(OVERVIEW.target, offset)),
            45,
        )

    near = vct.render("vertices_near", make(parts((0.0, 0.0, 0.0)), SUN, view((0, 0, 0))), mode=MODES)
    far = vct.render("vertices_far", make(parts(away), SUN, view(away)), mode=MODES)
    return Measured(_worst(far, near), far.folder / "gi.png")


def _lopsided() -> shapes.Shape:
    """No symmetry: an L of two boxes and a ball."""
    shape = shapes.box((10, 4, 6), None)
    for other, (dx, dy, dz) in (
        (shapes.box((4, 12, 5), None), (-3, 0, 0.3)),
        (shapes.icosphere(2.5, 2), (3.2, 6.4, 0.9)),
    ):
        first = len(shape.positions)
        shape.positions += [(x + dx, y + dy, z + dz) for x, y, z in other.positions]
        shape.normals += other.normals
        shape.indices += [first + i for i in other.indices]
    shape.uvs = []
    return shape


def _baked(
    shape: shapes.Shape, scale: tuple[float, float, float], move: tuple[float, float, float]
) -> shapes.Shape:
    """The node's work done on the vertices: normals by the inverse, corners turned round where it mirrors."""
    turn = scale[0] * scale[1] * scale[2] < 0
    order = shape.indices if not turn else [i for a, b, c in zip(*[iter(shape.indices)] * 3) for i in (a, c, b)]
    return shapes.Shape(
        [tuple(s * c + m for s, c, m in zip(scale, p, move)) for p in shape.positions],
        [shapes.unit(tuple(c / s for s, c in zip(scale, n))) for n in shape.normals],
        [],
        order,
    )


def node_scale(name: str, scale: tuple[float, float, float]) -> Callable[[Vct], Measured]:
    def measure(vct: Vct) -> Measured:
        move = (2.3, 0.2 if scale[1] > 0 else 14.2, 1.15)
        color = (0.6, 0.3, 0.1)
        by_node = make(
            [Part(floor()), Part(_lopsided(), color, place={"translation": list(move), "scale": list(scale)})],
            SUN,
            OVERVIEW,
        )
        by_vertex = make([Part(floor()), Part(_baked(_lopsided(), scale, move), color)], SUN, OVERVIEW)
        answer = vct.render(name, by_node, mode=MODES)
        return Measured(
            _worst(answer, vct.render(f"{name}_baked", by_vertex, mode=MODES)), answer.folder / "gi.png"
        )

    return measure


SAME = "mean difference over mean light"
CASES = [
    Case(
        "mirrored-node",
        "an object under a node of scale (-1, 1, 1)",
        "the picture of mirrored vertices",
        SAME,
        0.005,
        node_scale("mirrored", (-1.0, 1.0, 1.0)),
    ),
    Case(
        "non-uniform-scale",
        "a node of scale (2, 0.5, 1.3)",
        "the picture of scaled vertices; smooth normals may differ inside triangles",
        SAME,
        0.01,
        node_scale("non_uniform", (2.0, 0.5, 1.3)),
    ),
    Case(
        "mirrored-non-uniform-scale",
        "a node of scale (1.7, -0.9, 0.6)",
        "the picture of such vertices",
        SAME,
        0.005,
        node_scale("mirrored_non_uniform", (1.7, -0.9, 0.6)),
    ),
    Case(
        "scene-of-1-mm", "Cornell 1 mm wide", "the picture of Cornell", SAME, 0.005, scaled("cornell_1mm", 0.0005)
    ),
    Case(
        "scene-of-10-km",
        "Cornell 10 km wide",
        "the picture of Cornell",
        SAME,
        0.005,
        scaled("cornell_10km", 5000.0),
    ),
    Case(
        "node-at-10^6",
        "Cornell of 2 m, 10^6 m from the origin on each axis",
        "the picture of Cornell",
        SAME,
        0.005,
        far_node,
    ),
    Case(
        "vertices-at-10^6",
        "vertices 10^6 units from the origin, where floats are exact to 1/16",
        "the picture at the origin",
        SAME,
        0.005,
        far_vertices,
    ),
]
