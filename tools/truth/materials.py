"""Reads glTF materials: base colour, metallic and roughness, normal map, alpha mask, emission, sides.

glTF 2.0 3.8 and 3.9, KHR_texture_transform, KHR_materials_emissive_strength. BLEND counts as MASK with cutoff 0.5,
as the renderer under test states in its warning.
"""
import dataclasses
import math

import numpy as np

from .gltf_file import GltfFile
from .specular_glossiness import SpecularGlossiness, converted, converted_texels, specular_glossiness

WRAPS = {10497: 0, 33648: 1, 33071: 2}  # repeat, mirrored repeat, clamp to edge
NEAREST = 9728
SLOTS = ("base_color", "emissive", "gloss", "normal")  # textures of a material


@dataclasses.dataclass
class TextureUse:
    texture: int
    tex_coord: int
    matrix: np.ndarray  # 2x2: uv' = matrix uv + offset
    offset: np.ndarray


@dataclasses.dataclass
class Material:
    base_color: np.ndarray  # linear RGBA
    metallic: float
    roughness: float
    emissive: np.ndarray  # radiance, strength included
    cutoff: float  # holes where alpha is below; -1: none
    double_sided: bool
    normal_scale: float
    textures: dict[str, TextureUse]  # by slot; `gloss`: green times roughness, blue times metallic
    textured_gloss: SpecularGlossiness | None = None  # until its textures are read

    @property
    def glossy(self) -> bool:
        return self.roughness < 1 or self.metallic > 0 or "gloss" in self.textures


@dataclasses.dataclass
class Texture:
    texels: np.ndarray  # (height, width, 4), linear RGBA
    wrap_s: int
    wrap_t: int
    nearest: bool


def linear_from_srgb(x: np.ndarray) -> np.ndarray:
    """IEC 61966-2-1."""
    return np.where(x <= 0.04045, x / 12.92, ((x + 0.055) / 1.055) ** 2.4)


def texture_use(info: dict) -> TextureUse:
    transform = info.get("extensions", {}).get("KHR_texture_transform", {})
    # The rotation's sign is that of the extension's example and of the Khronos sample viewer.
    c, s = math.cos(transform.get("rotation", 0.0)), math.sin(transform.get("rotation", 0.0))
    matrix = np.array([[c, s], [-s, c]]) @ np.diag(np.array(transform.get("scale", [1, 1]), np.float64))
    return TextureUse(info["index"], transform.get("texCoord", info.get("texCoord", 0)), matrix,
                      np.array(transform.get("offset", [0, 0]), np.float64))


def transform_uv(source: TextureUse, uv: np.ndarray) -> np.ndarray:
    return uv @ source.matrix.T + source.offset


def load_material(material: dict) -> Material:
    surface = material.get("pbrMetallicRoughness", {})
    textures = dict(zip(SLOTS, (surface.get("baseColorTexture"), material.get("emissiveTexture"),
                                surface.get("metallicRoughnessTexture"), material.get("normalTexture"))))
    strength = material.get("extensions", {}).get("KHR_materials_emissive_strength", {}).get("emissiveStrength", 1.0)
    cutoff = {"MASK": material.get("alphaCutoff", 0.5), "BLEND": 0.5}.get(material.get("alphaMode"), -1.0)
    base_color = np.clip(surface.get("baseColorFactor", [1.0, 1.0, 1.0, 1.0]), 0, 1)
    transmission = material.get("extensions", {}).get("KHR_materials_transmission", {})
    if transmission.get("transmissionFactor", 0) >= 0.5 and "transmissionTexture" not in transmission:
        base_color[3], cutoff = 0, 0.5  # a hole, as for the renderer
    return Material(base_color,
                    float(np.clip(surface.get("metallicFactor", 1), 0, 1)),
                    float(np.clip(surface.get("roughnessFactor", 1), 0, 1)),
                    np.clip(material.get("emissiveFactor", [0, 0, 0]), 0, 1) * max(strength, 0.0),
                    cutoff, material.get("doubleSided", False), (textures["normal"] or {}).get("scale", 1.0),
                    {slot: texture_use(info) for slot, info in textures.items() if info is not None})


def load_specular_glossiness(material: Material, source: SpecularGlossiness) -> None:
    laid_by = source.diffuse_info or source.specular_info
    for slot in ("base_color", "gloss"):
        material.textures.pop(slot, None)
        if laid_by is not None:
            material.textures[slot] = texture_use(laid_by)
    if laid_by is not None:
        material.base_color, material.metallic, material.roughness = np.ones(4), 1.0, 1.0
        material.textured_gloss = source
        return
    base, metallic = converted(source.diffuse[:3], source.specular)
    material.base_color = np.append(base, source.diffuse[3])
    material.metallic, material.roughness = float(metallic), 1 - source.glossiness


def load_materials(document: dict) -> list[Material]:
    """The file's, then the default material (glTF 3.9.2)."""
    sources = [*document.get("materials", []), {}]
    materials = [load_material(source) for source in sources]
    for material, source in zip(materials, sources):
        if (gloss := specular_glossiness(source)) is not None:
            load_specular_glossiness(material, gloss)
    return materials


def image_of(texture: dict) -> int:
    """Prefers WebP over the plain source, as the renderer does."""
    extensions = texture.get("extensions", {})
    if "EXT_texture_webp" in extensions:
        return extensions["EXT_texture_webp"]["source"]
    if "source" not in texture:
        raise ValueError("a texture is neither PNG, JPEG nor WebP, and others are not read here")
    return texture["source"]


def load_textures(file: GltfFile, materials: list[Material]) -> list[Texture]:
    """The file's textures as colours, and after them, where needed, as plain numbers, to which `materials` then refer."""
    textures, numbers = [], []
    for texture in file.json.get("textures", []):
        stored = file.image(image_of(texture)).astype(np.float64) / 255
        texels = np.concatenate([linear_from_srgb(stored[..., :3]), stored[..., 3:]], -1)
        sampler = file.json["samplers"][texture["sampler"]] if "sampler" in texture else {}
        textures.append(Texture(texels, WRAPS[sampler.get("wrapS", 10497)], WRAPS[sampler.get("wrapT", 10497)],
                                sampler.get("magFilter") == NEAREST))
        numbers.append(dataclasses.replace(textures[-1], texels=stored))
    uses = [material.textures[slot] for material in materials for slot in ("gloss", "normal") if slot in material.textures]
    for use in uses:
        use.texture += len(textures)
    result = textures + numbers if uses else list(textures)
    for material in materials:
        if (source := material.textured_gloss) is None:
            continue
        pictures = [textures[info["index"]] if info else None for info in (source.diffuse_info, source.specular_info)]
        texels = converted_texels(source, *(picture.texels if picture else None for picture in pictures))
        material.textures["base_color"].texture, material.textures["gloss"].texture = len(result), len(result) + 1
        result += [dataclasses.replace(pictures[0] or pictures[1], texels=each) for each in texels]
        material.textured_gloss = None
    return result
