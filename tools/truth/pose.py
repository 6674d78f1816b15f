"""Poses nodes, joints and vertices at a moment of an animation (glTF 2.0, sections 3.7.3, 3.11 and appendix C).

Written from the specification; no code is shared with jni/scene/.
"""
import copy

import numpy as np

from .gltf_file import GltfFile


def slerp(a: np.ndarray, b: np.ndarray, u: float) -> np.ndarray:
    a, b = a / np.linalg.norm(a), b / np.linalg.norm(b)
    cosine = float(a @ b)
    if cosine < 0:  # take the shorter way
        b, cosine = -b, -cosine
    if cosine > 1 - 1e-9:
        return (1 - u) * a + u * b
    angle = np.arccos(cosine)
    return (np.sin((1 - u) * angle) * a + np.sin(u * angle) * b) / np.sin(angle)


def value_at(times: np.ndarray, values: np.ndarray, interpolation: str, rotates: bool, seconds: float) -> np.ndarray:
    """`values`: one row for each key, or with CUBICSPLINE three: in-tangent, value, out-tangent."""
    spline = interpolation == "CUBICSPLINE"
    keys = values[1::3] if spline else values
    after = int(np.searchsorted(times, seconds, side="right"))
    if after == 0:
        return keys[0]
    if after == len(times) or interpolation == "STEP":
        return keys[after - 1]
    before, length = after - 1, times[after] - times[after - 1]
    u = (seconds - times[before]) / length
    if not spline:
        return slerp(keys[before], keys[after], u) if rotates else (1 - u) * keys[before] + u * keys[after]
    leaving, arriving = values[3 * before + 2], values[3 * after]
    return ((2 * u ** 3 - 3 * u ** 2 + 1) * keys[before] + length * (u ** 3 - 2 * u ** 2 + u) * leaving
            + (-2 * u ** 3 + 3 * u ** 2) * keys[after] + length * (u ** 3 - u ** 2) * arriving)


def posed(file: GltfFile, seconds: float | None) -> dict:
    """The document with its nodes posed by the first animation; None is at rest."""
    document = file.json
    if seconds is None or not document.get("animations"):
        return document
    document = copy.deepcopy(document)
    animation = document["animations"][0]
    for channel in animation["channels"]:
        target, sampler = channel["target"], animation["samplers"][channel["sampler"]]
        if "node" not in target:
            continue
        node = document["nodes"][target["node"]]
        times = file.accessor(sampler["input"])[:, 0].astype(np.float64)
        values = file.accessor(sampler["output"]).astype(np.float64)
        interpolation = sampler.get("interpolation", "LINEAR")
        if target["path"] == "weights":
            values = values.reshape(len(times) * (3 if interpolation == "CUBICSPLINE" else 1), -1)
        node[target["path"]] = value_at(times, values, interpolation, target["path"] == "rotation", seconds).tolist()
    return document


def joint_matrices(file: GltfFile, document: dict, skin_index: int, worlds: dict[int, np.ndarray]) -> np.ndarray:
    """worldFromMesh of each joint, (joints, 4, 4). `worlds`: worldFromNode by the node's index."""
    skin = document["skins"][skin_index]
    inverse = (file.accessor(skin["inverseBindMatrices"]).astype(np.float64).reshape(-1, 4, 4).transpose(0, 2, 1)
               if "inverseBindMatrices" in skin else np.tile(np.eye(4), (len(skin["joints"]), 1, 1)))
    return np.stack([worlds[joint] @ inverse[i] for i, joint in enumerate(skin["joints"])])


def morphed(file: GltfFile, primitive: dict, weights: list[float], attribute: str, values: np.ndarray) -> np.ndarray:
    for target, weight in zip(primitive.get("targets", []), weights):
        if attribute in target and weight != 0:
            values = values + weight * file.accessor(target[attribute]).astype(np.float64)
    return values


def vertex_matrices(file: GltfFile, primitive: dict, joints: np.ndarray) -> np.ndarray:
    """worldFromMesh of each vertex, (vertices, 4, 4): the weighted mean of its four joints."""
    attributes = primitive["attributes"]
    weights = file.accessor(attributes["WEIGHTS_0"]).astype(np.float64)
    weights /= weights.sum(1, keepdims=True)
    indices = file.accessor(attributes["JOINTS_0"]).astype(np.int64)
    return np.einsum("vk,vkij->vij", weights, joints[indices])
