"""Reads a glTF 2.0 file: its JSON, and buffers, accessors and images as numpy arrays.

Written from the glTF 2.0 specification, sections 3.6 (buffers, accessors) and 3.8 (textures); no code is shared
with jni/scene/.
"""
import base64
import hashlib
import io
import json
import pathlib
import struct
import urllib.parse

import numpy as np
import PIL.Image

from files import Failed

from . import packings

COMPONENT_TYPES = {5120: np.int8, 5121: np.uint8, 5122: np.int16, 5123: np.uint16, 5125: np.uint32, 5126: np.float32}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT2": 4, "MAT3": 9, "MAT4": 16}
GLB_MAGIC, JSON_CHUNK, BIN_CHUNK = 0x46546C67, 0x4E4F534A, 0x004E4942


class GltfFile:
    """`json` is the document; the methods resolve its indices."""

    def __init__(self, path: pathlib.Path):
        self.path = pathlib.Path(path)
        try:
            data = self.path.read_bytes()
        except OSError as error:
            raise Failed(f"{path}: {error.strerror}") from error
        self.sha256 = hashlib.sha256(data).hexdigest()
        self._binary = b""
        try:
            self.json = self._parse(data)
        except (ValueError, struct.error) as error:
            raise Failed(f"{path}: not a glTF 2.0 file: {error}") from error
        self._buffers: dict[int, bytes] = {}
        self._unpacked_views: dict[int, bytes] = {}
        self._unpacked_rows: dict[int, np.ndarray] = {}  # of accessors

    def _parse(self, data: bytes) -> dict:
        if data[:4] != struct.pack("<I", GLB_MAGIC):
            return json.loads(data)
        document, at = None, 12
        while at + 8 <= len(data):
            length, kind = struct.unpack_from("<II", data, at)
            chunk = data[at + 8:at + 8 + length]
            if kind == JSON_CHUNK and document is None:
                document = json.loads(chunk)
            elif kind == BIN_CHUNK and not self._binary:
                self._binary = chunk
            at += 8 + length
        if document is None:
            raise ValueError("no JSON chunk")
        return document

    def _resource(self, uri: str) -> bytes:
        if uri.startswith("data:"):
            return base64.b64decode(uri.split(",", 1)[1])
        return (self.path.parent / urllib.parse.unquote(uri)).read_bytes()

    def buffer(self, index: int) -> bytes:
        if index not in self._buffers:
            uri = self.json["buffers"][index].get("uri")
            self._buffers[index] = self._binary if uri is None else self._resource(uri)
        return self._buffers[index]

    def _view(self, index: int) -> tuple[bytes, int]:
        """The bytes that hold a view, and the offset at which it begins."""
        view = self.json["bufferViews"][index]
        packed = packings.meshopt_of(view)
        if packed is None:
            return self.buffer(view["buffer"]), view.get("byteOffset", 0)
        if index not in self._unpacked_views:
            start = packed.get("byteOffset", 0)
            stream = self.buffer(packed["buffer"])[start:start + packed["byteLength"]]
            self._unpacked_views[index] = packings.unpack_view(packed, stream)
        return self._unpacked_views[index], 0

    def unpack(self, primitive: dict) -> None:
        """Decodes a primitive packed by Draco. Call it before reading its accessors, which then return the decoded rows."""
        packed = primitive.get("extensions", {}).get("KHR_draco_mesh_compression")
        if packed is None or primitive["indices"] in self._unpacked_rows:
            return
        view = self.json["bufferViews"][packed["bufferView"]]
        data, start = self._view(packed["bufferView"])
        indices, attributes = packings.unpack_primitive(packed, data[start:start + view["byteLength"]])
        self._unpacked_rows[primitive["indices"]] = indices
        for name, rows in attributes.items():
            self._unpacked_rows[primitive["attributes"][name]] = rows

    def _rows(self, view_index: int, offset: int, count: int, kind: type, width: int) -> np.ndarray:
        """`count` rows of `width` numbers of a buffer view, rows `byteStride` apart."""
        view = self.json["bufferViews"][view_index]
        size = np.dtype(kind).itemsize
        stride = view.get("byteStride", size * width)
        data, start = self._view(view_index)
        return np.ndarray((count, width), np.dtype(kind).newbyteorder("<"), data, start + offset,
                          (stride, size)).astype(kind)

    def accessor(self, index: int) -> np.ndarray:
        """(count, width); normalized integers become float64 (3.6.2.2), sparse ones are filled in (3.6.2.3)."""
        accessor = self.json["accessors"][index]
        kind, width, count = COMPONENT_TYPES[accessor["componentType"]], WIDTHS[accessor["type"]], accessor["count"]
        if index in self._unpacked_rows:
            rows = self._unpacked_rows[index].copy()
        elif "bufferView" in accessor:
            rows = self._rows(accessor["bufferView"], accessor.get("byteOffset", 0), count, kind, width)
        else:
            rows = np.zeros((count, width), kind)
        if "sparse" in accessor:
            sparse = accessor["sparse"]
            at, values = sparse["indices"], sparse["values"]
            where = self._rows(at["bufferView"], at.get("byteOffset", 0), sparse["count"],
                               COMPONENT_TYPES[at["componentType"]], 1)[:, 0]
            rows[where] = self._rows(values["bufferView"], values.get("byteOffset", 0), sparse["count"], kind, width)
        if accessor.get("normalized"):
            return np.maximum(rows.astype(np.float64) / np.iinfo(kind).max, -1.0)
        return rows

    def image(self, index: int) -> np.ndarray:
        """(height, width, 4), 8 bits, as stored; the first row is the top."""
        image = self.json["images"][index]
        if "bufferView" in image:
            view = self.json["bufferViews"][image["bufferView"]]
            data, start = self._view(image["bufferView"])
            data = data[start:start + view["byteLength"]]
        else:
            data = self._resource(image["uri"])
        return np.asarray(PIL.Image.open(io.BytesIO(data)).convert("RGBA"))
