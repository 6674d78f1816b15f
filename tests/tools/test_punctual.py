"""The lights of KHR_lights_punctual in the references, against closed forms."""
import math

import numpy as np
import pytest

from test_references import DOWN, floor, look_down, shown_x
from truth.scene import load_scene

EYE, DEGREES = 3.0, 50


def seen_floor(maker, **options):
    """An empty floor of albedo 0.5, seen from above: one picture per kind."""
    floor(maker, maker.grey(0.5), **options)
    look_down(maker, height=EYE, degrees=DEGREES)


SIZE, FINE = 32, 8
PICTURE = {"size": (SIZE, SIZE), "samples": 1024}


def positions():
    """World x and z of points within the pixels, FINE a side: the pictures are means over pixels."""
    return np.meshgrid(*[shown_x(SIZE * FINE, EYE, DEGREES)] * 2)


def of_pixels(values):
    return values.reshape(SIZE, FINE, SIZE, FINE).mean((1, 3))


def near(picture, expected, **tolerance):
    np.testing.assert_allclose(picture, expected, **({"rtol": 4e-3} | tolerance))


def test_a_point_lights_a_plane_by_the_cube_of_the_cosine(maker):
    """I cos^3 / h^2, in candela and metres, wherever the scene lies and however large its volume is."""
    seen_floor(maker)
    maker.glb.point_light("light", (0.3, 0.8, -0.2), (1, 0.5, 0.25), 7.0)
    direct, sun, full, indirect, glossy = maker.draw("direct", "sun", "full", "indirect", "glossy", **PICTURE)
    x, z = positions()
    cosine = 0.8 / np.sqrt((x - 0.3) ** 2 + (z + 0.2) ** 2 + 0.8 ** 2)
    expected = 0.5 / math.pi * 7 / 0.8 ** 2 * cosine ** 3
    near(direct, of_pixels(expected)[..., None] * [1, 0.5, 0.25])
    np.testing.assert_allclose(sun, direct, rtol=1e-5)  # without a size in `sun` too
    np.testing.assert_allclose(full, direct, rtol=1e-5)
    assert indirect.max() == 0 and glossy.max() == 0


def test_nodes_move_lights_without_scaling_them_and_a_range_ends_them(maker):
    seen_floor(maker)
    arm = maker.glb.node("arm", translation=[0, 1.5, 0], scale=[3, 3, 3])
    maker.glb.point_light("light", (0, -0.25, 0), (1, 1, 1), 7.0, arm, range=1.5)
    direct = maker.draw("direct", **PICTURE)[..., 0]
    x, z = positions()
    d = np.sqrt(x ** 2 + z ** 2 + 0.75 ** 2)
    expected = of_pixels(0.5 / math.pi * 7 * 0.75 / d ** 3 * np.maximum(1 - (d / 1.5) ** 4, 0))
    near(direct, expected, atol=1e-3)
    assert (expected == 0).sum() > 10 and direct[expected == 0].max() < 1e-4


def test_a_spot_fades_between_its_angles_and_ends_at_the_outer_one(maker):
    seen_floor(maker)
    inner, outer = math.radians(15), math.radians(35)
    maker.glb.spot_light("spot", (0.2, 1.5, 0.1), DOWN, (1, 1, 1), 7.0, inner, outer)
    direct = maker.draw("direct", **PICTURE)[..., 0]
    x, z = positions()
    cosine = 1.5 / np.sqrt((x - 0.2) ** 2 + (z - 0.1) ** 2 + 1.5 ** 2)
    whole = 0.5 / math.pi * 7 / 1.5 ** 2 * cosine ** 3
    fade = np.clip((cosine - math.cos(outer)) / (math.cos(inner) - math.cos(outer)), 0, 1) ** 2
    near(direct, of_pixels(whole * fade), atol=1e-3)
    outside, inside = of_pixels(fade) == 0, of_pixels(fade) == 1
    assert direct[outside].max() < 1e-6 and outside.sum() > 100
    near(direct[inside], of_pixels(whole)[inside])
    assert inside.sum() > 30


def test_a_spot_has_the_default_angles_and_points_along_its_node(maker):
    """It faces a wall: 45 degrees around its axis, full intensity on the axis only."""
    maker.quad((1, -2, -2), (0, 0, 4), (0, 4, 0), maker.grey(0.5))  # it faces -x
    maker.glb.camera("eye", (-3, 0, 0), (1, 0, 0), 40)
    maker.glb.spot_light("spot", (0, 0, 0), (1, 0, 0), (1, 1, 1), 7.0)
    direct = maker.draw("direct", **PICTURE)[..., 0]
    along = shown_x(SIZE * FINE, 4, 40)
    z, y = np.meshgrid(along, along)
    cosine = 1 / np.sqrt(1 + y ** 2 + z ** 2)
    fade = np.clip((cosine - math.sqrt(0.5)) / (1 - math.sqrt(0.5)), 0, 1) ** 2
    near(direct, of_pixels(0.5 / math.pi * 7 * cosine ** 3 * fade), atol=1e-3)
    assert direct[16, 16] > 1 and direct[0, 0] == 0


def test_a_blocker_casts_a_sharp_shadow_that_grows_with_the_distance(maker):
    seen_floor(maker)
    # 0.4 wide, half-way between floor and light: 0.8 wide on the floor. The camera looks through its back.
    maker.quad((-0.2, 0.6, -0.2), (0.4, 0, 0), (0, 0, 0.4), maker.grey(0.5))
    maker.glb.point_light("light", (0, 1.2, 0), (1, 1, 1), 7.0)
    direct = maker.draw("direct", **PICTURE)[..., 0]
    x, z = positions()
    lit = np.maximum(abs(x), abs(z)) > 0.4
    shadow, clear = of_pixels(lit) == 0, of_pixels(lit) == 1
    assert direct[shadow].max() == 0 and shadow.sum() > 50
    cosine = 1.2 / np.sqrt(x ** 2 + z ** 2 + 1.2 ** 2)
    near(direct[clear], of_pixels(0.5 / math.pi * 7 / 1.2 ** 2 * cosine ** 3)[clear])


def test_a_surface_behind_a_point_light_casts_no_shadow_before_it(maker):
    seen_floor(maker)
    maker.quad((-2, 1, -2), (4, 0, 0), (0, 0, 4), maker.grey(0.0))  # a black ceiling above the light, clear to the camera
    maker.glb.point_light("light", (0, 0.9, 0), (1, 1, 1), 7.0)
    x, z = positions()
    near(maker.draw("direct", **PICTURE)[..., 0],
         of_pixels(0.5 / math.pi * 7 * 0.9 / (x ** 2 + z ** 2 + 0.81) ** 1.5))


def test_further_directional_lights_are_points_and_add_to_the_sun(maker):
    seen_floor(maker)
    maker.glb.directional_light("sun", (0.6, -0.8, 0), (1, 0, 0), 2.0)
    maker.glb.directional_light("moon", DOWN, (0, 1, 0), 3.0)
    maker.glb.point_light("off", (0, 1, 0), (1, 1, 1), 0.0)
    scene = maker.load()
    np.testing.assert_allclose(scene.sun.irradiance, [2, 0, 0])
    direct, sun = maker.draw("direct", "sun")
    np.testing.assert_allclose(direct, np.broadcast_to(0.5 / math.pi * np.array([1.6, 3, 0]), direct.shape), rtol=1e-5)
    np.testing.assert_allclose(sun[..., 1:], direct[..., 1:], rtol=1e-5)


def test_a_further_directional_light_casts_a_shadow(maker):
    floor(maker, maker.grey(0.5))
    maker.quad((-2, 1, -2), (2, 0, 0), (0, 0, 4), maker.grey(0.5))  # above x < 0; the camera looks through its back
    look_down(maker)
    maker.glb.directional_light("sun", DOWN, (1, 1, 1), 0.0)
    maker.glb.directional_light("moon", DOWN, (1, 1, 1), math.pi)
    direct = maker.draw("direct")[..., 0]
    assert direct[:, :7].max() == 0
    np.testing.assert_allclose(direct[:, 9:], 0.5, rtol=1e-5)


def test_only_scenes_without_lights_have_the_default_sun(maker, tmp_path):
    seen_floor(maker)
    maker.path.write_bytes(maker.glb.to_bytes())
    assert load_scene(maker.path).sun.irradiance.max() == pytest.approx(math.pi)
    maker.glb.point_light("light", (0, 1, 0), (1, 1, 1), 1.0)
    assert maker.load().sun.irradiance.max() == 0


def test_bounces_of_a_point_light_in_a_white_ball_have_closed_forms(maker):
    """In the middle of a ball of radius R with inner albedo a, E = I / R^2 everywhere: direct light is a E / pi, one bounce a
    times as much, all bounces 1 / (1 - a)."""
    from scenes import shapes
    ball = shapes.icosphere(1.5, 4)
    ball.indices = [i for t in zip(ball.indices[::3], ball.indices[2::3], ball.indices[1::3]) for i in t]  # inside out
    ball.normals = [tuple(-x for x in n) for n in ball.normals]
    maker.place(ball, maker.grey(0.6), translation=[5, 1, 0])
    maker.glb.point_light("light", (5, 1, 0), (1, 1, 1), 9.0)
    maker.glb.camera("inside", (5.3, 1.2, 0.8), (5, 1, -1), 80)
    direct, indirect, full = maker.draw("direct", "indirect", "full", samples=128)
    expected = 0.6 / math.pi * 9 / 1.5 ** 2
    np.testing.assert_allclose(direct, expected, rtol=0.01)  # the facets are slightly nearer than the ball
    assert indirect.mean() == pytest.approx(0.6 * expected, rel=0.01)
    assert full.mean() == pytest.approx(expected / 0.4, rel=0.015)


def test_only_the_full_picture_has_the_highlight_of_a_point_light(maker):
    floor(maker, maker.glb.material("metal", (0.9, 0.6, 0.3), metallic=1.0, roughness=0.5))
    look_down(maker, height=3.0, degrees=1)
    maker.glb.point_light("light", (0, 2, 0), (1, 1, 1), 4 * math.pi)
    glossy, full = maker.draw("glossy", "full")
    assert glossy.max() == 0
    # Head-on D = 1 / (pi alpha^2) and G = 1: F0 D E / 4 with E = pi.
    np.testing.assert_allclose(full.mean((0, 1)), np.array([0.9, 0.6, 0.3]) / (4 * 0.0625), rtol=0.02)
