"""Loads a glTF scene as flat arrays of triangles, in the space in which it is path traced (trace space).

Trace space is the world, moved and scaled so that the voxel volume is the cube of side 1 around the origin. Scenes of 1 mm, of
10 km and far from the origin then keep the same precision and give the same picture.
"""
import dataclasses
import itertools
import math
import pathlib

import numpy as np

import program
from files import Failed

from .gltf_file import GltfFile
from .hdr import read_sky
from .materials import SLOTS, Material, Texture, load_materials, load_textures, transform_uv
from .packings import instance_transforms
from .pose import joint_matrices, morphed, posed, vertex_matrices

GRID, PADDING_VOXELS = 256, 2.5  # jni/engine/volume.cpp, at the grid of all measurements
AO_DISTANCE = 0.045  # of the volume's side (pipeline.md, step 5)


@dataclasses.dataclass
class Camera:
    name: str
    axes: np.ndarray  # rows: right, up, back; the same in the world and in trace space
    eye_world: np.ndarray
    eye: np.ndarray  # trace space
    vertical_fov_rad: float


@dataclasses.dataclass
class Sun:
    towards: np.ndarray  # unit
    irradiance: np.ndarray  # RGB, on a surface that faces it


@dataclasses.dataclass
class PunctualLight:
    """A point, a spot, or a directional light that is not the sun. Lengths in trace space are shares of the volume's side s, so an
    intensity in candela is divided by s^2: the irradiance I / d^2 is then the same as in the world."""
    position: np.ndarray | None  # None: directional
    towards: np.ndarray  # unit; light travels the other way
    intensity: np.ndarray  # RGB: irradiance on a surface that faces the light, at distance 1 unless directional
    range: float
    cone_scale: float  # fall-off: clip(cos * cone_scale + cone_offset, 0, 1)^2
    cone_offset: float


@dataclasses.dataclass
class Scene:
    path: pathlib.Path
    sha256: str
    side_world: float  # of the voxel volume, metres
    centre_world: np.ndarray
    positions: np.ndarray  # (triangles, 3 corners, 3), trace space; counter-clockwise is front
    normals: np.ndarray  # like positions, unit
    uvs: dict[str, np.ndarray]  # (triangles, 3, 2), transformed coordinates of each slot's texture
    colors: np.ndarray  # (triangles, 3, 4), vertex colours: linear RGBA factors of the base colour
    material_of: np.ndarray  # (triangles,)
    materials: list[Material]
    textures: list[Texture]
    camera: Camera
    sun: Sun
    punctual: list[PunctualLight]
    sky: np.ndarray | None  # (height, width, 3), radiance; None: black
    openings: np.ndarray  # (openings, 3, 3): corner and two sides of each, trace space

    @property
    def ao_distance_world(self) -> float:
        return AO_DISTANCE * self.side_world


def unit(v: np.ndarray) -> np.ndarray:
    """Along the last axis; a zero stays zero."""
    length = np.linalg.norm(v, axis=-1, keepdims=True)
    return np.divide(v, length, out=np.zeros_like(v, dtype=np.float64), where=length > 0)


def local_transform(node: dict) -> np.ndarray:
    if "matrix" in node:
        return np.array(node["matrix"], np.float64).reshape(4, 4).T
    x, y, z, w = unit(np.array(node.get("rotation", [0, 0, 0, 1]), np.float64))
    rotation = np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                         [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                         [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])
    matrix = np.eye(4)
    matrix[:3, :3] = rotation * np.array(node.get("scale", [1, 1, 1]), np.float64)
    matrix[:3, 3] = node.get("translation", [0, 0, 0])
    return matrix


def placed_nodes(document: dict) -> list[tuple[int, np.ndarray]]:
    """(index of the node, worldFromNode) of the default scene, parents first, children in the file's order."""
    nodes = document.get("nodes", [])
    if document.get("scenes"):
        roots = document["scenes"][document.get("scene", 0)].get("nodes", [])
    else:
        children = {c for n in nodes for c in n.get("children", [])}
        roots = [i for i in range(len(nodes)) if i not in children]
    placed, pending = [], [(i, np.eye(4)) for i in reversed(roots)]
    while pending:
        index, parent = pending.pop()
        world = parent @ local_transform(nodes[index])
        placed.append((index, world))
        pending += [(c, world) for c in reversed(nodes[index].get("children", []))]
    return placed


def hidden_nodes(document: dict) -> set[int]:
    """The indices of nodes that KHR_node_visibility hides, and of all nodes below them."""
    nodes = document.get("nodes", [])
    pending = [i for i, node in enumerate(nodes)
               if not node.get("extensions", {}).get("KHR_node_visibility", {}).get("visible", True)]
    hidden = set()
    while pending:
        hidden.add(index := pending.pop())
        pending += nodes[index].get("children", [])
    return hidden


def triangle_corners(mode: int, order: np.ndarray) -> np.ndarray:
    """(triangles, 3) vertex indices of a primitive (glTF 3.7.2.1). Points and lines (modes 0 to 3) have none."""
    n = len(order)
    if mode == 4:
        return order[:n - n % 3].reshape(-1, 3)
    if mode < 4 or n < 3:
        return np.empty((0, 3), np.int64)
    i = np.arange(n - 2)
    if mode == 5:  # every second triangle of a strip is listed the other way round
        return np.stack([order[i], order[i + 1 + i % 2], order[i + 2 - i % 2]], 1)
    return np.stack([order[i + 1], order[i + 2], np.full(n - 2, order[0])], 1)


def primitive_arrays(file: GltfFile, primitive: dict, world: np.ndarray, material: Material,
                     weights: list[float], joints: np.ndarray | None) -> tuple | None:
    """World positions, normals, colours and uvs by slot, each (triangles, 3, ...), of one primitive; None where it has no triangle.
    `world`: from the node's space; where the node has a skin, its `joints` count instead."""
    attributes = primitive["attributes"]
    if "POSITION" not in attributes:
        return None
    file.unpack(primitive)
    position = morphed(file, primitive, weights, "POSITION", file.accessor(attributes["POSITION"]).astype(np.float64))
    order = (file.accessor(primitive["indices"])[:, 0].astype(np.int64) if "indices" in primitive
             else np.arange(len(position)))
    corners = triangle_corners(primitive.get("mode", 4), order)
    if len(corners) == 0:
        return None
    skinned = joints is not None and "JOINTS_0" in attributes
    matrices = vertex_matrices(file, primitive, joints) if skinned else np.broadcast_to(world, (len(position), 4, 4))
    linear, mirrored = matrices[:, :3, :3], np.linalg.det(matrices[0, :3, :3]) < 0
    positions = (np.einsum("vij,vj->vi", linear, position) + matrices[:, :3, 3])[corners]
    if mirrored:  # a mirrored node reverses the winding of its triangles (3.7.4)
        corners, positions = corners[:, ::-1], positions[:, ::-1]
    flat = unit(np.cross(positions[:, 1] - positions[:, 0], positions[:, 2] - positions[:, 0]))
    flat = np.repeat(flat[:, None], 3, 1)
    if "NORMAL" in attributes:
        # Cofactors: the inverse transpose times the determinant, finite where a scale is 0.
        columns = [linear[:, :, k] for k in range(3)]
        cofactors = np.stack([np.cross(columns[1], columns[2]), np.cross(columns[2], columns[0]),
                              np.cross(columns[0], columns[1])], 2) * (-1 if mirrored else 1)
        normal = morphed(file, primitive, weights, "NORMAL", unit(file.accessor(attributes["NORMAL"]).astype(np.float64)))
        normals = unit(np.einsum("vij,vj->vi", cofactors, normal))[corners]
        normals = np.where(np.any(normals != 0, -1, keepdims=True), normals, flat)
    else:
        normals = flat

    def uv(slot):
        source = material.textures.get(slot)
        name = f"TEXCOORD_{source.tex_coord}" if source else None
        if name not in attributes:
            return np.zeros((len(corners), 3, 2))
        return transform_uv(source, file.accessor(attributes[name]).astype(np.float64))[corners]

    colors = np.ones((len(corners), 3, 4))
    if "COLOR_0" in attributes:
        stored = np.clip(file.accessor(attributes["COLOR_0"]).astype(np.float64), 0, 1)
        colors[..., :stored.shape[1]] = stored[corners]
    return positions, normals, colors, {slot: uv(slot) for slot in SLOTS}


def find_camera(document: dict, placed: list, path: pathlib.Path,
                size: tuple[int, int]) -> tuple[str, np.ndarray, np.ndarray, float]:
    """Name, axes, eye and field of view (rad) of the first perspective camera, without scale and mirroring. Where there is none,
    or where it is made for a wider picture, `vct` is asked for its view of this size."""
    for node, world in placed:
        camera = document["cameras"][node["camera"]] if "camera" in node else {}
        if camera.get("type") != "perspective":
            continue
        if camera["perspective"].get("aspectRatio", 0) > size[0] / size[1]:
            break
        back = unit(world[:3, 2])
        right = unit(np.cross(world[:3, 1], back))
        axes = np.stack([right, np.cross(back, right), back])
        return camera.get("name", node.get("name", "")), axes, world[:3, 3], camera["perspective"]["yfov"]
    try:
        chosen = program.camera(path, size)
    except Failed as failed:
        raise Failed(f"{path} has no camera, and vct finds no view of it: {failed}") from failed
    return chosen["name"], np.array(chosen["right_up_back"]), np.array(chosen["eye_world"]), chosen["vertical_fov_rad"]


def placed_lights(document: dict, placed: list) -> list[tuple[dict, np.ndarray]]:
    """(light, worldFromNode) of KHR_lights_punctual, in the order of the nodes."""
    lights = document.get("extensions", {}).get("KHR_lights_punctual", {}).get("lights", [])
    uses = [(node.get("extensions", {}).get("KHR_lights_punctual"), world) for node, world in placed]
    return [(lights[use["light"]], world) for use, world in uses if use]


def light_color(light: dict) -> np.ndarray:
    """Colour times intensity, in lux or candela."""
    return np.maximum(np.array(light.get("color", [1, 1, 1]), np.float64), 0) * max(light.get("intensity", 1.0), 0.0)


def find_lights(document: dict, placed: list, centre: np.ndarray, side: float,
                has_other_light: bool) -> tuple[Sun, list[PunctualLight]]:
    """The sun is the first directional light. A scene without any light has the renderer's default sun; one that only has points
    and spots, or that `has_other_light`, has a black one."""
    lights, sun, rest = placed_lights(document, placed), None, []
    for light, world in lights:
        if light["type"] not in ("directional", "point", "spot"):
            continue
        towards, color = unit(world[:3, 2]), light_color(light)
        if light["type"] == "directional" and sun is None:
            sun = Sun(towards, color)
        elif light["type"] == "directional":
            rest.append(PunctualLight(None, towards, color, math.inf, 0.0, 1.0))
        else:
            scale, offset = cone_falloff(light.get("spot", {})) if light["type"] == "spot" else (0.0, 1.0)
            rest.append(PunctualLight((world[:3, 3] - centre) / side, towards, color / side ** 2,
                                      light.get("range", math.inf) / side, scale, offset))
    return sun or Sun(unit(np.array([0.5, 1.0, 0.75])), np.full(3, 0.0 if rest or has_other_light else math.pi)), rest


def cone_falloff(spot: dict) -> tuple[float, float]:
    """Scale and offset of the fall-off, as the extension recommends."""
    inner, outer = (math.cos(spot.get(name, usual)) for name, usual in (("innerConeAngle", 0.0), ("outerConeAngle", math.pi / 4)))
    scale = 1 / max(0.001, inner - outer)
    return scale, -outer * scale


def find_openings(placed: list, centre: np.ndarray, side: float) -> np.ndarray:
    """Nodes whose `extras.opening` holds two vectors: a parallelogram from the node's origin, through which light enters a room
    (openings.py)."""
    found = [[(world[:3, 3] - centre) / side, *(world[:3, :3] @ np.array(node["extras"]["opening"], np.float64).T / side).T]
             for node, world in placed if isinstance(node.get("extras"), dict) and "opening" in node["extras"]]
    return np.array(found).reshape(-1, 3, 3)


def sky_file(path: pathlib.Path) -> pathlib.Path | None:
    """The picture of the sky over a scene: the .hdr file of its name beside it."""
    sky = path.with_suffix(".hdr")
    return sky if sky.is_file() else None


def load_scene(path: pathlib.Path, size: tuple[int, int] = (256, 256), seconds: float | None = None) -> Scene:
    """`size`: that of the picture, on whose shape a view may depend. `seconds`: the moment of the first animation, as for
    `vct render --time`; None is at rest."""
    file = GltfFile(path)
    try:
        return build(file, size, seconds)
    except (KeyError, IndexError, TypeError, ValueError, OSError) as error:
        raise Failed(f"{path} cannot be read as a scene: {error!r}") from error


def build(file: GltfFile, size: tuple[int, int], seconds: float | None) -> Scene:
    document = posed(file, seconds)
    materials, worlds = load_materials(document), placed_nodes(document)
    placed = [(document["nodes"][index], world) for index, world in worlds]
    hidden = hidden_nodes(document)
    visible = [(document["nodes"][index], world) for index, world in worlds if index not in hidden]
    parts, material_of = [], []
    for node, world in visible:
        if "mesh" not in node:
            continue
        mesh = document["meshes"][node["mesh"]]
        weights = node.get("weights", mesh.get("weights", []))
        joints = joint_matrices(file, document, node["skin"], dict(worlds)) if "skin" in node else None
        instances = [world @ local_transform(instance) for instance in instance_transforms(file, node)]
        for instance, primitive in itertools.product(instances, mesh["primitives"]):
            material = primitive.get("material", len(materials) - 1)  # the last one is the default material
            arrays = primitive_arrays(file, primitive, instance, materials[material], weights, joints)
            if arrays:
                parts.append(arrays)
                material_of.append(np.full(len(arrays[0]), material))
    if parts:
        positions, normals, colors = (np.concatenate(part) for part in list(zip(*parts))[:3])
        uvs = {slot: np.concatenate([part[3][slot] for part in parts]) for slot in SLOTS}
        owner = np.concatenate(material_of)
        low, high = positions.min((0, 1)), positions.max((0, 1))
    else:
        positions = normals = np.empty((0, 3, 3))
        uvs = {slot: np.empty((0, 3, 2)) for slot in SLOTS}
        colors = np.empty((0, 3, 4))
        owner, low, high = np.empty(0, np.int64), np.zeros(3), np.zeros(3)
    longest = (high - low).max()
    side = (longest if longest > 0 else 1.0) * GRID / (GRID - 2 * PADDING_VOXELS)
    centre = 0.5 * (low + high)

    positions = (positions - centre) / side
    area2 = np.linalg.norm(np.cross(positions[:, 1] - positions[:, 0], positions[:, 2] - positions[:, 0]), axis=-1)
    keep = area2 > 1e-14  # a triangle without area stops no ray
    name, axes, eye, fov = find_camera(document, placed, file.path, size)
    # The renderer gives its default sun to a scene whose emission comes from textures only, or that is not a room.
    has_emitters = any(materials[i].emissive.max() > 0 and "emissive" not in materials[i].textures for i in set(owner.tolist()))
    lights_itself = has_emitters and program.camera(file.path, size)["lights_itself"]
    sky = read_sky(sky_file(file.path)) if sky_file(file.path) else None
    return Scene(file.path, file.sha256, side, centre, positions[keep], normals[keep],
                 {slot: values[keep] for slot, values in uvs.items()}, colors[keep], owner[keep], materials,
                 load_textures(file, materials), Camera(name, axes, eye, (eye - centre) / side, fov),
                 *find_lights(document, visible, centre, side, lights_itself or sky is not None), sky,
                 find_openings(placed, centre, side))
