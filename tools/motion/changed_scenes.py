"""Copies of a scene in which the light moves."""
from __future__ import annotations

import json
import struct
from pathlib import Path

from scenes.glb import Glb, axis_angle, product
from truth.gltf_file import GltfError

JSON_CHUNK = 0x4E4F534A
ONCE_AROUND_S = 10.0
KEYS_AROUND = 24


def read_glb(path: Path) -> Glb:
    """A scene that can be added to."""
    data = path.read_bytes()
    length, kind = struct.unpack_from("<II", data, 12)
    if kind != JSON_CHUNK:
        raise GltfError(f"{path}: does not start with its JSON; only .glb as tools/make_assets.py writes them can be changed")
    glb = Glb("")
    glb.json = json.loads(data[20:20 + length])
    glb.binary = bytearray(data[28 + length:])
    return glb


def sun_node(glb: Glb) -> int | None:
    """The node of the sun, which hangs on nothing; None where there is none, or where it is off."""
    lights = glb.json.get("extensions", {}).get("KHR_lights_punctual", {}).get("lights", [])
    for index in glb.json["scenes"][glb.json.get("scene", 0)]["nodes"]:
        use = glb.json["nodes"][index].get("extensions", {}).get("KHR_lights_punctual")
        light = lights[use["light"]] if use else {}
        if light.get("type") == "directional" and light.get("intensity", 1) > 0:
            return index
    return None


def has_sun(path: Path) -> bool:
    return sun_node(read_glb(path)) is not None


def light_once_around(path: Path, out: Path) -> Path:
    """Its height above the horizon stays, so that it comes from everywhere; the end is the beginning."""
    glb = read_glb(path)
    node = sun_node(glb)
    if node is None:
        raise GltfError(f"{path}: has no sun that could move")
    rotation = glb.json["nodes"][node].get("rotation", [0, 0, 0, 1])
    steps = range(KEYS_AROUND + 1)
    glb.animate("change", node, "rotation", [ONCE_AROUND_S * i / KEYS_AROUND for i in steps],
                [product(axis_angle((0, 1, 0), 360 * i / KEYS_AROUND), rotation) for i in steps])
    out.write_bytes(glb.to_bytes())
    return out
