"""The glossy surfaces of the references against Mitsuba's own microfacets and against answers that need no renderer."""
import math

import numpy as np
import pytest

from truth.engine import dr, mi
from truth.glossy import Brdf

SAMPLES = 200_000


def randoms(seed=0):
    numbers = np.random.default_rng(seed)
    return [mi.Float(numbers.random(SAMPLES, dtype=np.float32)) for _ in range(3)]


def seen_at(cosine):
    return mi.Vector3f(math.sqrt(1 - cosine * cosine), 0, cosine)


def brdf(base, metallic, roughness, cosine):
    return Brdf(mi.Normal3f(0, 0, 1), mi.Color3f(base), mi.Float(metallic), mi.Float(roughness), seen_at(cosine))


def mitsubas(roughness):
    """A conductor that reflects all light, which is Schlick's term with F0 = 1."""
    return mi.load_dict({"type": "roughconductor", "distribution": "ggx", "alpha": roughness ** 2, "material": "none"})


@pytest.mark.parametrize("roughness", [0.2, 0.5, 0.8])
@pytest.mark.parametrize("cosine", [0.2, 0.9])
def test_a_white_metal_is_mitsubas_rough_conductor(roughness, cosine):
    a, b, choice = randoms()
    theirs = mitsubas(roughness)
    at = dr.zeros(mi.SurfaceInteraction3f, SAMPLES)
    at.wi, at.n, at.sh_frame = seen_at(cosine), mi.Normal3f(0, 0, 1), mi.Frame3f(mi.Normal3f(0, 0, 1))
    out = mi.warp.square_to_cosine_hemisphere(mi.Point2f(a, b))
    _, mine, density = brdf(1, 1, roughness, cosine).evaluate(out)
    np.testing.assert_allclose(np.array(mine.x), np.array(theirs.eval(mi.BSDFContext(), at, out).x), rtol=2e-3,
                               atol=1e-5)
    np.testing.assert_allclose(np.array(density), np.array(theirs.pdf(mi.BSDFContext(), at, out)), rtol=2e-3, atol=1e-5)


@pytest.mark.parametrize("base, metallic, roughness", [(0.9, 1, 0.3), (0.6, 0, 0.4), (0.5, 0.5, 0.7)])
def test_both_sampling_methods_agree_with_the_evaluated_brdf(base, metallic, roughness):
    a, b, choice = randoms()
    surface = brdf(base, metallic, roughness, 0.6)
    _, alone = surface.specular_direction(a, b)
    direction, together = surface.sample(choice, a, b)
    diffuse, specular, density = surface.evaluate(direction)
    estimate = np.array(dr.select(density > 0, specular.x / density, 0))
    assert np.mean(estimate) == pytest.approx(np.mean(np.array(alone.x)), rel=0.01)
    cosine = mi.Vector3f(mi.warp.square_to_uniform_hemisphere(mi.Point2f(a, b)))
    diffuse, specular, _ = surface.evaluate(cosine)
    everywhere = 2 * math.pi * np.mean(np.array(diffuse.x + specular.x))
    assert np.mean(np.array(together.x)) == pytest.approx(everywhere, rel=0.02)
    assert 0 < everywhere <= 1.001


def test_without_gloss_the_brdf_is_lamberts():
    a, b, choice = randoms()
    direction, weight = brdf(0.5, 0, 1.0, 0.3).sample(choice, a, b)
    np.testing.assert_allclose(np.array(weight.x), 0.5, rtol=1e-4)
    assert np.array(direction.z).mean() == pytest.approx(2 / 3, abs=0.01)  # cosine-distributed


def floor_under_emitter(maker, **gloss):
    """Seen head-on from above, through the back of an emitter of radiance 1."""
    maker.quad((-1, 0, 1), (2, 0, 0), (0, 0, -2), maker.glb.material("metal", (0.9, 0.6, 0.3), **gloss))
    maker.quad((-40, 1, -40), (80, 0, 0), (0, 0, 80), maker.grey(0, emissive=((1, 1, 1), 1.0, None)))
    maker.glb.node("eye", translation=[0, 3, 0], rotation=[-math.sqrt(0.5), 0, 0, math.sqrt(0.5)],
                   camera=maker.glb._append("cameras", {"type": "perspective", "perspective": {
                       "yfov": math.radians(5), "znear": 0.1}}))


def test_a_mirror_reflects_the_scene_before_it_in_its_colour(maker):
    floor_under_emitter(maker, metallic=1.0, roughness=0.05)
    glossy, full = maker.draw("glossy", "full")
    np.testing.assert_allclose(glossy.mean((0, 1)), [0.9, 0.6, 0.3], rtol=0.002)
    np.testing.assert_allclose(full, glossy, rtol=0.002)  # a metal has no diffuse light


def test_a_metal_of_roughness_one_reflects_by_its_brdf(maker):
    floor_under_emitter(maker, metallic=1.0, roughness=1.0)
    glossy, full = maker.draw("glossy", "full", samples=512)
    # Head-on with alpha = 1 the albedo is F0 times the integral of c / (c + 1) over the cosine c.
    np.testing.assert_allclose(full.mean((0, 1)), np.array([0.9, 0.6, 0.3]) * (1 - math.log(2)), rtol=0.02)
    np.testing.assert_allclose(full, glossy, rtol=0.002)  # a metal has no diffuse light


def test_a_dielectric_reflects_a_twenty_fifth_head_on(maker):
    floor_under_emitter(maker, metallic=0.0, roughness=0.05)
    assert maker.draw("glossy").mean() == pytest.approx(0.04, rel=0.01)


def test_a_lone_metal_reflects_the_sun_alone(maker):
    floor_under_emitter(maker, metallic=1.0, roughness=0.5)
    del maker.glb.json["scenes"][0]["nodes"][1]  # the emitter
    maker.glb.directional_light("sun", (0, -1, 0), (1, 1, 1), math.pi)
    glossy, full = maker.draw("glossy", "full")
    assert glossy.max() == 0
    # Head-on D = 1 / (pi alpha^2) and G = 1: F0 pi D / 4.
    np.testing.assert_allclose(full.mean((0, 1)), np.array([0.9, 0.6, 0.3]) / (4 * 0.0625), rtol=0.02)
