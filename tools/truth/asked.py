"""A scene with another camera, light, sky or emission than its own, given as the options of `vct render` are."""
import dataclasses
import math
import pathlib
import re

import numpy as np

from .gltf_file import GltfFile
from .hdr import read_sky
from .scene import PunctualLight, Scene, Sun, unit


def numbers(text: str) -> np.ndarray:
    """Three numbers with commas, or one for all three."""
    return np.broadcast_to([float(x) for x in text.split(",")], 3)


def seen_by(scene: Scene, view: dict) -> Scene:
    """`view`: as `vct info --print-camera` prints it."""
    eye = np.array(view["eye_world"])
    return dataclasses.replace(scene, camera=dataclasses.replace(
        scene.camera, name=view["name"], axes=np.array(view["right_up_back"]), eye_world=eye,
        eye=(eye - scene.centre_world) / scene.side_world, vertical_fov_rad=view["vertical_fov_rad"]))


def lit_by(scene: Scene, light: str | None, sky: str | None, environment: pathlib.Path | None, emission: float) -> Scene:
    """As in `vct`, a scene without lights has no sun under a given sky. Without `sky` and `environment` the sky is black, because
    `vct` does not read the .hdr file beside a scene either."""
    if (sky or environment) and not GltfFile(scene.path).json.get("extensions", {}).get("KHR_lights_punctual"):
        scene = dataclasses.replace(scene, sun=Sun(scene.sun.towards, np.zeros(3)))
    if light is not None:
        given = dict(re.findall(r"(\w+)=([^=]*?)(?=,\w+=|$)", light))
        color = numbers(given.get("color", "1,1,1"))
        lux = float(given["intensity"]) if "intensity" in given else float(scene.sun.irradiance.max()) or np.pi
        towards = unit(-numbers(given["direction"])) if "direction" in given else scene.sun.towards
        scene = dataclasses.replace(scene, sun=Sun(towards, color * lux))
    if emission != 1:
        scene = dataclasses.replace(scene, materials=[
            dataclasses.replace(material, emissive=material.emissive * emission) for material in scene.materials])
    if environment is not None:
        return dataclasses.replace(scene, sky=read_sky(environment))
    return dataclasses.replace(scene, sky=None if sky is None else np.tile(numbers(sky), (2, 4, 1)))


def lit_by_room_light(scene: Scene, candela: float, place_world: np.ndarray) -> Scene:
    """The scene with the point light that `vct` adds to a closed room, in place of the default sun."""
    light = PunctualLight((place_world - scene.centre_world) / scene.side_world, np.array([0.0, 1.0, 0.0]),
                          np.full(3, candela / scene.side_world ** 2), math.inf, 0.0, 1.0)
    return dataclasses.replace(scene, sun=Sun(scene.sun.towards, np.zeros(3)), punctual=[light])
