"""Packed files give the scenes that they were packed from: by Draco, by meshoptimizer, as instances."""
import ctypes
import io
import pathlib
from collections.abc import Callable
from typing import Any

import DracoPy
import numpy as np
import PIL.Image
import pytest

from files import Failed
from scenes.glb import Glb
from truth.packings import meshoptimizer
from truth.scene import load_scene

SIDE = 9
KINDS = {np.dtype("f4"): 5126, np.dtype("u4"): 5125, np.dtype("i1"): 5120}


def builder() -> Glb:
    """A file with a camera, so that the program is not asked for a view."""
    glb = Glb("tests/tools")
    glb.camera("eye", (0, 0, 9), (0, 0, 0), 57)
    return glb


def accessor(glb: Glb, rows: np.ndarray, view: int | None, **more: Any) -> int:
    found = {"componentType": KINDS[rows.dtype], "count": len(rows), "type": ("SCALAR", "", "VEC3", "VEC4")[rows.shape[1] - 1]}
    return glb._append("accessors", found | ({} if view is None else {"bufferView": view}) | more)


def plain_accessor(glb: Glb, rows: np.ndarray) -> int:
    return accessor(glb, rows, glb._view(rows.tobytes()))


def place(glb: Glb, indices: int, positions: int, normals: int, **more: Any) -> Glb:
    attributes = {"POSITION": positions, "NORMAL": normals}
    glb.node("field", mesh=glb.mesh("field", {"indices": indices, "attributes": attributes, **more}))
    return glb


def write(glb: Glb, path: pathlib.Path) -> pathlib.Path:
    path.write_bytes(glb.to_bytes())
    return path


def field() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Positions, normals and indices of a bumpy field."""
    x, y = (v.ravel() / (SIDE - 1) for v in np.meshgrid(np.arange(SIDE), np.arange(SIDE)))
    positions = np.stack([4 * x, 0.3 * np.sin(9 * x) * np.cos(7 * y), 3 * y], 1).astype(np.float32)
    normals = np.stack([-0.6 * np.cos(9 * x), np.ones_like(x), 0.7 * np.sin(7 * y)], 1)
    corners = np.arange(SIDE * SIDE).reshape(SIDE, SIDE)
    a, b, c, d = corners[:-1, :-1], corners[1:, :-1], corners[:-1, 1:], corners[1:, 1:]
    indices = np.stack([a, b, c, c, b, d], -1).reshape(-1, 1).astype(np.uint32)
    return positions, (normals / np.linalg.norm(normals, axis=1, keepdims=True)).astype(np.float32), indices


def plain() -> Glb:
    glb = builder()
    positions, normals, indices = field()
    return place(glb, *(plain_accessor(glb, rows) for rows in (indices, positions, normals)))


def draco() -> Glb:
    glb = builder()
    positions, normals, indices = field()
    stream = DracoPy.encode(positions, indices.reshape(-1, 3), quantization_bits=16, normals=normals.astype(np.float64))
    ids = {a["attribute_type"]: a["unique_id"] for a in DracoPy.decode(stream).attributes}
    return place(glb, *(accessor(glb, rows, None) for rows in (indices, positions, normals)),
                 extensions={"KHR_draco_mesh_compression": {"bufferView": glb._view(stream),
                                                            "attributes": {"POSITION": ids[0], "NORMAL": ids[1]}}})


def stream_of(encoder: str, rows: np.ndarray, *after_count: int) -> bytes:
    """Uses meshoptimizer's own encoder. `after_count`: its arguments after the number of rows."""
    stream = ctypes.create_string_buffer(4096 + 8 * rows.nbytes)
    encode = getattr(meshoptimizer(), encoder)
    encode.restype = ctypes.c_size_t
    size = encode(stream, ctypes.c_size_t(len(stream)), rows.tobytes(), *(ctypes.c_size_t(n) for n in (len(rows), *after_count)))
    assert size > 0
    return stream.raw[:size]


def meshopt() -> Glb:
    """The normals are octahedra of 8 bits."""
    glb = builder()
    positions, normals, indices = field()
    octahedra = np.zeros((len(normals), 4), np.int8)
    octahedra[:, :2] = np.round(127 * normals[:, [0, 2]] / np.abs(normals).sum(1, keepdims=True))  # about +y: x, z, y
    octahedra[:, 2] = 127

    def packed(rows: np.ndarray, stream: bytes, mode: str, filter_name: str = "NONE", **more: Any) -> int:
        view = glb._view(stream)
        views, facts = glb.json["bufferViews"], {"byteStride": rows.strides[0], "count": len(rows), "mode": mode, "filter": filter_name}
        views[view] = {"buffer": 0, "byteLength": rows.nbytes, "extensions": {"EXT_meshopt_compression": views[view] | facts}}
        return accessor(glb, rows, view, **more)

    place(glb, packed(indices, stream_of("meshopt_encodeIndexBuffer", indices), "TRIANGLES"),
          packed(positions, stream_of("meshopt_encodeVertexBuffer", positions, 12), "ATTRIBUTES"),
          packed(octahedra, stream_of("meshopt_encodeVertexBuffer", octahedra, 4), "ATTRIBUTES", "OCTAHEDRAL", normalized=True,
                 type="VEC3"))
    # An octahedron is about +z: the file's y and z change places.
    glb.json["bufferViews"][-1]["byteStride"] = 4
    return glb


def sorted_triangles(positions: np.ndarray, digits: int) -> np.ndarray:
    """Sorts them, as packing may rotate a triangle's corners and change the order."""
    rounded = np.round(positions, digits) + 0.0
    turned = np.array([np.roll(t, -min(range(3), key=lambda k: tuple(t[k])), axis=0) for t in rounded])
    return turned[np.lexsort(turned.reshape(len(turned), -1).T[::-1])]


@pytest.mark.parametrize(("packed", "digits"), [(draco, 3), (meshopt, 6)])
def test_the_triangles_are_the_same(tmp_path: pathlib.Path, packed: Callable[[], Glb], digits: int):
    expected, scene = load_scene(write(plain(), tmp_path / "plain.glb")), load_scene(write(packed(), tmp_path / "packed.glb"))
    assert len(scene.positions) == 2 * (SIDE - 1) ** 2
    found, right = (sorted_triangles(one.positions, digits) for one in (scene, expected))
    np.testing.assert_allclose(found, right, atol=2 * 0.1 ** digits)


def test_a_damaged_stream_is_named(tmp_path: pathlib.Path):
    glb = meshopt()
    glb.binary[40:80] = bytes(40)
    with pytest.raises(Failed, match="damaged"):
        load_scene(write(glb, tmp_path / "damaged.glb"))


def test_instances_have_their_own_places_and_scales(tmp_path: pathlib.Path):
    glb = plain()
    glb.json["nodes"][1]["extensions"] = {"EXT_mesh_gpu_instancing": {"attributes": {
        "TRANSLATION": plain_accessor(glb, np.array([[0, 0, 0], [10, 0, 0], [0, 0, 20]], np.float32)),
        "SCALE": plain_accessor(glb, np.array([[1, 1, 1], [2, 2, 2], [1, 1, 1]], np.float32))}}}
    scene = load_scene(write(glb, tmp_path / "instances.glb"))
    assert len(scene.positions) == 3 * 2 * (SIDE - 1) ** 2
    world = scene.positions * scene.side_world + scene.centre_world
    np.testing.assert_allclose(world.reshape(3, -1, 3).max(1)[:, [0, 2]], [[4, 3], [18, 6], [4, 23]], atol=1e-5)


def test_webp_textures_are_read(tmp_path: pathlib.Path):
    glb = plain()
    file = io.BytesIO()
    PIL.Image.new("RGB", (4, 2), (255, 0, 0)).save(file, "WEBP", lossless=True)
    glb.json |= {"images": [{"bufferView": glb._view(file.getvalue()), "mimeType": "image/webp"}],
                 "textures": [{"extensions": {"EXT_texture_webp": {"source": 0}}}]}
    np.testing.assert_array_equal(load_scene(write(glb, tmp_path / "webp.glb")).textures[0].texels[0, 0], [1, 0, 0, 1])
