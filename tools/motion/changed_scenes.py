"""Copies of a scene in which the light moves, or an object."""
from __future__ import annotations

import json
import struct
from pathlib import Path
from typing import Any

from scenes.glb import Glb, axis_angle, product
from truth.gltf_file import GltfError

JSON_CHUNK = 0x4E4F534A
ONCE_AROUND_S = 10.0
KEYS_AROUND = 24
MOVED_DEG = 30.0
ANIMATION = "change"


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
    """The node of the light, which hangs on nothing; None where there is no light, or where it is off."""
    lights = glb.json.get("extensions", {}).get("KHR_lights_punctual", {}).get("lights", [])
    for index in glb.json["scenes"][glb.json.get("scene", 0)]["nodes"]:
        use = glb.json["nodes"][index].get("extensions", {}).get("KHR_lights_punctual")
        if use and lights[use["light"]].get("intensity", 1) > 0:
            return index
    return None


def has_sun(path: Path) -> bool:
    return sun_node(read_glb(path)) is not None


def written(glb: Glb, out: Path) -> Path:
    out.parent.mkdir(parents=True, exist_ok=True)
    out.write_bytes(glb.to_bytes())
    return out


def with_light(path: Path, out: Path, times_s: list[float], degrees: list[float], interpolation: str) -> Path:
    """The scene with its sun turned about the vertical by so much at those times."""
    glb = read_glb(path)
    node = sun_node(glb)
    if node is None:
        raise GltfError(f"{path}: has no sun that could move")
    rotation = glb.json["nodes"][node].get("rotation", [0, 0, 0, 1])
    glb.animate(ANIMATION, node, "rotation", times_s, [product(axis_angle((0, 1, 0), angle), rotation) for angle in degrees],
                interpolation)
    return written(glb, out)


def light_once_around(path: Path, out: Path) -> Path:
    """Its height above the horizon stays, so that it comes from everywhere; the end is the beginning."""
    steps = range(KEYS_AROUND + 1)
    return with_light(path, out, [ONCE_AROUND_S * i / KEYS_AROUND for i in steps], [360 * i / KEYS_AROUND for i in steps],
                      "LINEAR")


def light_that_jumps(path: Path, out: Path, at_s: float) -> Path:
    """From MOVED_DEG away to where the file has it, all at once."""
    return with_light(path, out, [0.0, at_s], [MOVED_DEG, 0.0], "STEP")


def box_that_jumps(path: Path, out: Path, at_s: float) -> Path:
    """moving.glb, in which the box alone moves: from the one end of its way to the other, all at once."""
    glb = read_glb(path)
    (box,) = [i for i, node in enumerate(glb.json["nodes"]) if node["name"] == "box"]
    here: list[Any] = glb.json["nodes"][box]["translation"]
    glb.json["animations"] = []
    glb.animate(ANIMATION, box, "translation", [0.0, at_s], [here, [-here[0], *here[1:]]], "STEP")
    return written(glb, out)
