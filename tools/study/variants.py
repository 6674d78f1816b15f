"""Variants of a scene file that isolate a defect without touching the renderer."""
from __future__ import annotations

import copy
import json
import struct
from collections.abc import Callable
from pathlib import Path
from typing import Any

JSON_CHUNK = 0x4E4F534A


def edit_glb(source: Path, target: Path, edit: Callable[[dict[str, Any]], None]) -> Path:
    """Writes `source` with its JSON changed by `edit`; the binary chunk stays."""
    data = source.read_bytes()
    length, kind = struct.unpack_from("<II", data, 12)
    assert kind == JSON_CHUNK, f"{source} does not start with its JSON"
    document = json.loads(data[20:20 + length])
    edit(document)
    text = json.dumps(document, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    rest = data[20 + length:]
    header = struct.pack("<III", 0x46546C67, 2, 20 + len(text) + len(rest))
    target.parent.mkdir(parents=True, exist_ok=True)
    target.write_bytes(header + struct.pack("<II", len(text), JSON_CHUNK) + text + rest)
    return target


def swap_red_and_blue(document: dict[str, Any]) -> None:
    """Untextured colours only."""
    for material in document["materials"]:
        red, green, blue, alpha = material["pbrMetallicRoughness"]["baseColorFactor"]
        material["pbrMetallicRoughness"]["baseColorFactor"] = [blue, green, red, alpha]


def fill_objects(document: dict[str, Any], shells: int = 48) -> None:
    """Nests smaller copies into every object but the floor, closer than a voxel: solid instead of hollow."""
    nodes = document["nodes"]
    for node in [node for node in nodes if "mesh" in node and node.get("name") != "floor"]:
        for k in range(1, shells):
            shell = copy.deepcopy(node)
            shell["name"] = f"{node['name']} shell {k}"
            shell["scale"] = [k / shells] * 3
            document["scenes"][document.get("scene", 0)]["nodes"].append(len(nodes))
            nodes.append(shell)
