"""Converts KHR_materials_pbrSpecularGlossiness to metallic and roughness, as Khronos does beside the extension
(examples/convert-between-workflows): it takes the metallic for which both models have the same brightness.
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
    factors = (np.clip(found.get(f"{name}Factor", default), 0, 1) for name, default in (
        ("diffuse", [1, 1, 1, 1]), ("specular", [1, 1, 1]), ("glossiness", 1.0)))
    return SpecularGlossiness(*factors, found.get("diffuseTexture"), found.get("specularGlossinessTexture"))


def brightness(color: np.ndarray) -> np.ndarray:
    return np.sqrt(color ** 2 @ np.array([0.299, 0.587, 0.114]))


def converted(diffuse: np.ndarray, specular: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Base colour (..., 3) and metallic (...) of diffuse and specular colours (..., 3)."""
    left = 1 - specular.max(-1)
    reflection = brightness(specular)
    b = brightness(diffuse) * left / (1 - DIELECTRIC) + reflection - 2 * DIELECTRIC
    root = np.sqrt(np.maximum(b * b - 4 * DIELECTRIC * (DIELECTRIC - reflection), 0))
    metallic = np.where(reflection < DIELECTRIC, 0.0, np.clip((root - b) / (2 * DIELECTRIC), 0, 1))
    of_diffuse = diffuse * (left / ((1 - DIELECTRIC) * np.maximum(1 - metallic, 1e-6)))[..., None]
    of_specular = (specular - DIELECTRIC * (1 - metallic)[..., None]) / np.maximum(metallic, 1e-6)[..., None]
    share = (metallic ** 2)[..., None]
    return np.clip((1 - share) * of_diffuse + share * of_specular, 0, 1), metallic


def converted_texels(factors: SpecularGlossiness, diffuse: np.ndarray | None,
                     specular: np.ndarray | None) -> tuple[np.ndarray, np.ndarray]:
    """Converts linear textures (height, width, 4), of which one may be missing, to base colour, and to roughness and metallic in
    green and blue. The results have the size of the larger texture; the smaller one is sampled by its nearest texel."""
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
