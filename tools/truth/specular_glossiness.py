"""KHR_materials_pbrSpecularGlossiness in terms of metallic and roughness, as Khronos gives the conversion beside the
extension (examples/convert-between-workflows): the metallic of which both models have the same brightness.
"""
import dataclasses
from typing import Any

import numpy as np

DIELECTRIC = 0.04  # reflection along the normal of metallic-roughness at metallic 0


@dataclasses.dataclass
class SpecularGlossiness:
    diffuse: np.ndarray  # linear RGBA
    specular: np.ndarray  # linear RGB, reflection along the normal
    glossiness: float
    diffuse_info: dict[str, Any] | None
    specular_info: dict[str, Any] | None


def specular_glossiness(material: dict[str, Any]) -> SpecularGlossiness | None:
    found = material.get("extensions", {}).get("KHR_materials_pbrSpecularGlossiness")
    if found is None:
        return None
    return SpecularGlossiness(np.clip(found.get("diffuseFactor", [1, 1, 1, 1]), 0, 1), np.clip(found.get("specularFactor", [1, 1, 1]), 0, 1),
                              float(np.clip(found.get("glossinessFactor", 1), 0, 1)), found.get("diffuseTexture"),
                              found.get("specularGlossinessTexture"))


def brightness(color: np.ndarray) -> np.ndarray:
    return np.sqrt(color ** 2 @ np.array([0.299, 0.587, 0.114]))


def converted(diffuse: np.ndarray, specular: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Base colour (..., 3) and metallic (...) of diffuse and specular colours (..., 3)."""
    left = 1 - specular.max(-1)
    shine = brightness(specular)
    b = brightness(diffuse) * left / (1 - DIELECTRIC) + shine - 2 * DIELECTRIC
    root = np.sqrt(np.maximum(b * b - 4 * DIELECTRIC * (DIELECTRIC - shine), 0))
    metallic = np.where(shine < DIELECTRIC, 0.0, np.clip((root - b) / (2 * DIELECTRIC), 0, 1))
    of_diffuse = diffuse * (left / ((1 - DIELECTRIC) * np.maximum(1 - metallic, 1e-6)))[..., None]
    of_specular = (specular - DIELECTRIC * (1 - metallic)[..., None]) / np.maximum(metallic, 1e-6)[..., None]
    share = (metallic ** 2)[..., None]
    return np.clip((1 - share) * of_diffuse + share * of_specular, 0, 1), metallic


def converted_texels(factors: SpecularGlossiness, diffuse: np.ndarray | None, specular: np.ndarray | None) -> tuple[np.ndarray, np.ndarray]:
    """Of textures (height, width, 4), linear, of which one may be missing: base colour, and roughness and metallic in green
    and blue, (height, width, 4). In the size of the larger one; the other's texels are those that lie there."""
    given = [texels for texels in (diffuse, specular) if texels is not None]
    height, width = max((texels.shape[:2] for texels in given), key=lambda shape: shape[0] * shape[1])

    def laid(texels: np.ndarray | None) -> np.ndarray:
        if texels is None:
            return np.ones((height, width, 4))
        rows, columns = ((2 * np.arange(n) + 1) * own // (2 * n) for n, own in zip((height, width), texels.shape))
        return texels[rows[:, None], columns]

    of_diffuse, of_specular = laid(diffuse) * factors.diffuse, laid(specular) * [*factors.specular, factors.glossiness]
    base, metallic = converted(of_diffuse[..., :3], of_specular[..., :3])
    zero, one = np.zeros_like(metallic), np.ones_like(metallic)
    return np.concatenate([base, of_diffuse[..., 3:]], -1), np.stack([zero, 1 - of_specular[..., 3], metallic, one], -1)
