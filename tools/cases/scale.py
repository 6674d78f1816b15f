"""Size, place and node transforms: the same scene told differently gives the same picture."""
from __future__ import annotations

from functools import partial

from scenes import cornell, shapes
from scenes.hard_cases import OVERVIEW, RED, SUN, Part, Vector, View, box, floor, make, wrapped

from .case import LIGHT, Case
from .run import Measured, Vct


def same(vct: Vct, name: str, scene: bytes, other_name: str, other: bytes) -> Measured:
    return vct.difference(name, scene, other_name, other, ("gi", "gi-cone-shadow", "indirect_light"), mode="gi,gi-cone-shadow")


def scaled(name: str, scale: float, vct: Vct) -> Measured:
    return same(vct, name, cornell.build(scale).to_bytes(), "cornell", cornell.build().to_bytes())


def far_node(vct: Vct) -> Measured:
    """Cornell of 2 m under a node that moves all of it by 10^6 m along every axis."""
    far = wrapped(cornell.build(), {"translation": [1e6, 1e6, -1e6]})
    return same(vct, "cornell_far", far.to_bytes(), "cornell", cornell.build().to_bytes())


def moved(p: Vector, by: Vector) -> Vector:
    return tuple(c + o for c, o in zip(p, by))


def far_vertices(vct: Vct) -> Measured:
    """Vertices around 10^6 in the file itself, where a float is exact to 1/16: objects placed on that raster."""
    def scene(offset: Vector) -> bytes:
        whole = [floor(), box((12, 19, 12))]
        for shape in whole:
            shape.positions = [moved(p, offset) for p in shape.positions]
        view = View(moved(OVERVIEW.eye, offset), moved(OVERVIEW.target, offset), OVERVIEW.fov_deg)
        return make([Part(whole[0]), Part(whole[1], RED)], SUN, view)
    return same(vct, "vertices_far", scene((1_000_000.0, 500_000.0, -1_000_000.0)), "vertices_near", scene((0.0, 0.0, 0.0)))


def _lopsided() -> shapes.Shape:
    """No symmetry: an L of two boxes and a ball."""
    shape = box((10, 4, 6))
    for other, by in ((box((4, 12, 5)), (-3, 0, 0.3)), (shapes.icosphere(2.5, 2), (3.2, 6.4, 0.9))):
        first = len(shape.positions)
        shape.positions += [moved(p, by) for p in other.positions]
        shape.normals += other.normals
        shape.indices += [first + i for i in other.indices]
    return shape


def _baked(shape: shapes.Shape, scale: Vector, move: Vector) -> shapes.Shape:
    """The node's work done on the vertices: normals by the inverse, corners turned round where it mirrors."""
    turn = scale[0] * scale[1] * scale[2] < 0
    order = shape.indices if not turn else [i for a, b, c in zip(*[iter(shape.indices)] * 3) for i in (a, c, b)]
    return shapes.Shape([tuple(s * c + m for s, c, m in zip(scale, p, move)) for p in shape.positions],
                        [shapes.unit(tuple(c / s for s, c in zip(scale, n))) for n in shape.normals], [], order)


def node_scale(name: str, scale: Vector, vct: Vct) -> Measured:
    move, color = (2.3, 0.2 if scale[1] > 0 else 14.2, 1.15), (0.6, 0.3, 0.1)
    by_node = Part(_lopsided(), color, place={"translation": list(move), "scale": list(scale)})
    by_vertex = Part(_baked(_lopsided(), scale, move), color)
    return same(vct, name, make([Part(floor()), by_node]), f"{name}_baked", make([Part(floor()), by_vertex]))


CORNELL = "the picture of Cornell"
CASES = [
    Case("mirrored-node", "an object under a node of scale (-1, 1, 1)", "the picture of mirrored vertices", LIGHT, 0.005,
         partial(node_scale, "mirrored", (-1.0, 1.0, 1.0))),
    Case("non-uniform-scale", "a node of scale (2, 0.5, 1.3)",
         "the picture of scaled vertices; smooth normals may differ inside triangles", LIGHT, 0.01,
         partial(node_scale, "non_uniform", (2.0, 0.5, 1.3))),
    Case("mirrored-non-uniform-scale", "a node of scale (1.7, -0.9, 0.6)", "the picture of such vertices", LIGHT, 0.005,
         partial(node_scale, "mirrored_non_uniform", (1.7, -0.9, 0.6))),
    Case("scene-of-1-mm", "Cornell 1 mm wide", CORNELL, LIGHT, 0.005, partial(scaled, "cornell_1mm", 0.0005)),
    Case("scene-of-10-km", "Cornell 10 km wide", CORNELL, LIGHT, 0.005, partial(scaled, "cornell_10km", 5000.0)),
    Case("node-at-10^6", "Cornell of 2 m, 10^6 m from the origin on each axis", CORNELL, LIGHT, 0.005, far_node),
    Case("vertices-at-10^6", "vertices 10^6 units from the origin, where floats are exact to 1/16", "the picture at the origin",
         LIGHT, 0.005, far_vertices),
]
