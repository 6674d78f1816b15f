"""Unpacks compressed parts of glTF files: meshes by Draco, buffer views by meshoptimizer, instances of a node.

The extensions are KHR_draco_mesh_compression, EXT_ and KHR_meshopt_compression and EXT_mesh_gpu_instancing. The libraries' own
decoders do the work.
"""
import ctypes
import ctypes.util
import functools
from typing import Any

import DracoPy
import numpy as np

MESHOPT = ("EXT_meshopt_compression", "KHR_meshopt_compression")
FILTERS = {"OCTAHEDRAL": "Oct", "QUATERNION": "Quat", "EXPONENTIAL": "Exp"}


@functools.cache
def meshoptimizer() -> ctypes.CDLL:
    name = ctypes.util.find_library("meshoptimizer")
    if name is None:
        raise ValueError("it is packed by meshoptimizer, which is not installed: apt install libmeshoptimizer-dev")
    return ctypes.CDLL(name)


def meshopt_of(view: dict[str, Any]) -> dict[str, Any] | None:
    extensions = view.get("extensions", {})
    return next((extensions[name] for name in MESHOPT if name in extensions), None)


def unpack_view(packed: dict[str, Any], data: bytes) -> bytes:
    """Decodes the stream of a buffer view."""
    count, stride, mode = packed["count"], packed["byteStride"], packed["mode"]
    unpacked = ctypes.create_string_buffer(count * stride)
    arguments = (unpacked, ctypes.c_size_t(count), ctypes.c_size_t(stride))
    decoder = {"ATTRIBUTES": "VertexBuffer", "TRIANGLES": "IndexBuffer", "INDICES": "IndexSequence"}[mode]
    if getattr(meshoptimizer(), f"meshopt_decode{decoder}")(*arguments, data, ctypes.c_size_t(len(data))) != 0:
        raise ValueError(f"a stream of meshoptimizer ({mode}) is damaged")
    if packed.get("filter", "NONE") != "NONE":
        getattr(meshoptimizer(), f"meshopt_decodeFilter{FILTERS[packed['filter']]}")(*arguments)
    return unpacked.raw


def unpack_primitive(packed: dict[str, Any], data: bytes) -> tuple[np.ndarray, dict[str, np.ndarray]]:
    """Decodes one primitive: indices (triangles * 3, 1), and rows (vertices, width) of each attribute."""
    mesh = DracoPy.decode(data)
    by_id = {attribute["unique_id"]: attribute["data"] for attribute in mesh.attributes}
    attributes = {name: np.asarray(by_id[unique]) for name, unique in packed["attributes"].items()}
    return (np.asarray(mesh.faces).reshape(-1, 1),
            {name: rows.reshape(len(rows), -1) for name, rows in attributes.items()})


def instance_transforms(file: Any, node: dict[str, Any]) -> list[dict[str, list[float]]]:
    """Translation, rotation and scale of each instance of a node; a node without instances has one that is empty."""
    attributes = node.get("extensions", {}).get("EXT_mesh_gpu_instancing", {}).get("attributes")
    if attributes is None:
        return [{}]
    rows = {name.lower(): file.accessor(attributes[name]).astype(np.float64).tolist()
            for name in ("TRANSLATION", "ROTATION", "SCALE") if name in attributes}
    return [dict(zip(rows, values)) for values in zip(*rows.values())]
