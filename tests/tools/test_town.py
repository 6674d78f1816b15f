"""The generated town: closed buildings, and the limits that it promises."""
from collections import Counter

import pytest

from scenes import town
from scenes.blocks import Blocks

PARTS = {**{f"house {kind}": lambda kind=kind: town.house(*kind) for kind in town.HOUSES.values()},
         "stair house": town.stair_house, "court": town.court, "bell tower": town.bell_tower, "stall": town.stall,
         "ground and wall": town.ground_and_wall}


def triangles(shapes):
    for shape in shapes.values():
        points = [tuple(round(c, 5) for c in p) for p in shape.positions]
        for i in range(0, len(shape.indices), 3):
            yield [points[k] for k in shape.indices[i:i + 3]]


def open_edges(shapes):
    """Edges that are not passed equally often in both directions."""
    passed = Counter(edge for a, b, c in triangles(shapes) for edge in ((a, b), (b, c), (c, a)))
    return [(a, b) for (a, b), count in passed.items() if passed[b, a] != count]


def volume(shapes):
    return sum((a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6
               for a, b, c in triangles(shapes))


@pytest.mark.parametrize("name", PARTS)
def test_parts_are_closed(name):
    assert open_edges(PARTS[name]()) == []


def test_a_carved_block_has_the_volume_that_is_left():
    blocks = Blocks()
    blocks.fill("outside", (0, 0, 0), (4, 3, 2))
    blocks.fill("inside", (0.1, 0.1, 0.1), (3.9, 2.9, 1.9))
    blocks.carve((0.2, 0.2, 0.2), (3.8, 2.8, 1.8))
    blocks.carve((1, 1, 0), (2, 2, 0.2))
    shapes = blocks.shapes()
    assert set(shapes) == {"outside", "inside"}
    assert open_edges(shapes) == []
    assert volume(shapes) == pytest.approx(4 * 3 * 2 - 3.6 * 2.6 * 1.6 - 0.2)
    shapes["outside"].indices = shapes["outside"].indices[3:]
    assert open_edges(shapes)


def test_a_roof_faces_outward():
    assert volume({"roof": town.gable(10, 9, 3)}) == pytest.approx(10 * 0.18 * 11 + 0.5 * 10 * (3 - 0.18) * 11)


def test_the_town_keeps_its_limits():
    glb = town.build()
    assert 20_000 <= glb.triangle_count() <= 60_000
    assert len(glb.json["extensions"]["KHR_lights_punctual"]["lights"]) <= 16
    assert [camera["name"] for camera in glb.json["cameras"]] == ["street", "court", "interior", "stairs"]
