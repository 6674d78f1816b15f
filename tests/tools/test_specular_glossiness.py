"""Conversion of specular and glossiness to metallic and roughness, where the answer is known."""
import numpy as np
import pytest

from truth.specular_glossiness import SpecularGlossiness, converted, converted_texels

DIELECTRIC = 0.04


@pytest.mark.parametrize("metallic", [0.0, 0.3, 1.0])
def test_a_metallic_grey_is_converted_to_itself(metallic: float):
    """Takes the diffuse and specular colours of the same grey surface."""
    base = 0.5
    specular = np.full(3, DIELECTRIC * (1 - metallic) + base * metallic)
    # The extension's diffuse light is diffuse (1 - max(specular)); that of metallic-roughness base (1 - .04) (1 - metallic).
    diffuse = np.full(3, base * (1 - DIELECTRIC) * (1 - metallic) / (1 - specular[0]))
    color, found = converted(diffuse, specular)
    assert found == pytest.approx(metallic, abs=1e-6)
    np.testing.assert_allclose(color, base, atol=1e-6)


def test_gold_keeps_its_colour():
    color, metallic = converted(np.zeros(3), np.array([1.0, 0.77, 0.34]))
    assert metallic == pytest.approx(1.0)
    np.testing.assert_allclose(color, [1.0, 0.77, 0.34], atol=1e-6)


def test_textures_of_two_sizes_are_combined():
    factors = SpecularGlossiness(np.ones(4), np.ones(3), 0.5, {}, {})
    diffuse = np.zeros((1, 2, 4))
    diffuse[0, :, 0], diffuse[..., 3] = [0.2, 0.8], 1
    specular = np.zeros((2, 4, 4))
    specular[..., 3] = np.linspace(0, 1, 8).reshape(2, 4)
    color, gloss = converted_texels(factors, diffuse, specular)
    assert color.shape == gloss.shape == (2, 4, 4)
    np.testing.assert_allclose(color[1, :, 0], np.array([0.2, 0.2, 0.8, 0.8]) / (1 - DIELECTRIC))
    np.testing.assert_allclose(gloss[..., 1], 1 - 0.5 * specular[..., 3])
    np.testing.assert_array_equal(gloss[..., 2], 0)
