"""The path tracer against closed forms."""
import io
import math

import numpy as np
import PIL.Image
import pytest

from metrics import noise_of_halves
from scenes import radiance, shapes
from truth.drawing import draw, make_world
from truth.scene import triangle_corners

DOWN = (0, -1, 0)


def floor(maker, material, half=2.0):
    maker.quad((-half, 0, half), (2 * half, 0, 0), (0, 0, -2 * half), material)


def look_down(maker, x=0.0, height=3.0, degrees=20):
    """Adds a camera whose picture has +x to the right and -z up."""
    maker.glb.node("eye", translation=[x, height, 0], rotation=[-math.sqrt(0.5), 0, 0, math.sqrt(0.5)],
                   camera=maker.glb._append("cameras", {"type": "perspective", "perspective": {
                       "yfov": math.radians(degrees), "znear": 0.1}}))


def shown_x(size, height, degrees):
    """World x of the pixel centres of a row of `look_down` in a square picture, from its middle."""
    return ((np.arange(size) + 0.5) / size * 2 - 1) * height * math.tan(math.radians(degrees) / 2)


def test_a_lit_plane_is_albedo_times_irradiance_over_pi_times_cosine(maker):
    floor(maker, maker.grey(0.5))
    look_down(maker)
    maker.glb.directional_light("sun", (0.6, -0.8, 0), (1, 0.5, 0.25), 5.0)
    direct, sun, full, indirect, shadow, ao = maker.draw("direct", "sun", "full", "indirect", "shadow", "ao")
    expected = 0.5 * np.array([1, 0.5, 0.25]) * 5.0 / math.pi * 0.8
    np.testing.assert_allclose(direct, np.broadcast_to(expected, direct.shape), rtol=1e-5)
    np.testing.assert_allclose(full, direct, rtol=1e-5)  # a plane does not light itself
    # A disc gives the irradiance of its centre, which is its mean direction.
    np.testing.assert_allclose(sun.mean((0, 1)), expected, rtol=1e-3)
    assert indirect.max() == 0
    assert shadow.min() == 1 and ao.min() == 1


def test_a_sky_that_grows_along_the_axes_lights_each_side_by_its_closed_form(maker):
    """Radiance (1 + d) / 2 in red towards +X, green towards +Y, blue towards +Z: a surface with the normal n receives
    1/2 + n/3. A floor does not show a sky's rotation about the vertical: the next test does."""
    maker.path.with_suffix(".hdr").write_bytes(radiance.picture(128, lambda *d: [(1 + c) / 2 for c in d]))
    floor(maker, maker.grey(0.5))
    look_down(maker)
    full, indirect = maker.draw("full", "indirect", samples=256)
    expected = 0.5 * np.array([1 / 2, 1 / 2 + 1 / 3, 1 / 2])
    np.testing.assert_allclose(full.mean((0, 1)), expected, rtol=0.01)
    np.testing.assert_allclose(indirect.mean((0, 1)), expected, rtol=0.01)


def test_the_sky_is_behind_the_scene(maker):
    """Looking down past a small floor: straight down is the nadir, and +x is to the right."""
    maker.path.with_suffix(".hdr").write_bytes(radiance.picture(128, lambda x, y, z: [(1 + x) / 2, (1 + y) / 2, (1 + z) / 2]))
    floor(maker, maker.grey(), half=0.01)
    look_down(maker, degrees=60)
    full, direct = maker.draw("full", "direct", samples=4)
    edge = math.tan(math.radians(30)) * 15 / 16
    x = edge / math.sqrt(1 + edge * edge)
    assert full[8, 15, 0] == pytest.approx((1 + x) / 2, abs=0.03) and full[8, 0, 0] == pytest.approx((1 - x) / 2, abs=0.03)
    assert full[0, 8, 2] == pytest.approx((1 - x) / 2, abs=0.03)  # -z is up
    assert direct.max() == 0


def test_the_sun_is_five_degrees_wide(maker):
    """The penumbra of an edge at height 1 above a floor, by the share of a disc cut by a line."""
    floor(maker, maker.grey())
    maker.quad((-5, 1, 5), (5, 0, 0), (0, 0, -10), maker.grey())  # covers x < 0
    look_down(maker, height=0.9, degrees=0.8)  # from below the sheet; the picture is 0.2 wide
    maker.glb.directional_light("sun", DOWN, (1, 1, 1), math.pi)
    shadow = maker.draw("shadow", size=(64, 4), samples=512)[..., 0].mean(0)
    x = 16 * shown_x(64, height=0.9, degrees=0.8)
    c = np.clip(x / math.tan(math.radians(2.5)), -1, 1)
    expected = 1 - (np.arccos(c) - c * np.sqrt(1 - c * c)) / math.pi
    np.testing.assert_allclose(shadow, expected, atol=0.02)


def test_a_white_furnace_has_its_closed_form(maker):
    material = maker.grey(0.5, emissive=((1, 1, 1), 1.0, None))
    box = shapes.box((2, 2, 2), 1)
    box.indices = [i for t in zip(box.indices[::3], box.indices[2::3], box.indices[1::3]) for i in t]  # inside out
    box.normals = [tuple(-x for x in n) for n in box.normals]
    maker.place(box, material)
    maker.glb.camera("inside", (0.3, 1.2, 0.8), (0, 0.5, -1), 80)
    coverage, direct, indirect, full = maker.draw("coverage", "direct", "indirect", "full", samples=256)
    assert coverage.min() == 1
    np.testing.assert_allclose(direct, 1, rtol=1e-6)
    np.testing.assert_allclose(indirect, 0.5, rtol=0.05)
    assert indirect.mean() == pytest.approx(0.5, rel=2e-3)  # albedo
    assert full.mean() == pytest.approx(2.0, rel=5e-3)  # 1 / (1 - albedo)


def test_ambient_occlusion_beside_a_wall_has_its_closed_form(maker):
    """Cosine-weighted directions are uniform in the unit disc (Malley), and the wall at distance x is nearer than d
    where the disc's coordinate is above c = x / d: the segment (acos c - c sqrt(1 - c^2)) / pi is occluded."""
    grey = maker.grey()
    floor(maker, grey, 2.0)
    maker.quad((1, 0, -2), (0, 0, 4), (0, 4, 0), grey)  # it faces -x
    look_down(maker, x=0.9, height=1.0, degrees=11)
    scene = maker.load()
    ao = maker.draw("ao", size=(32, 4), samples=1024)[..., 0].mean(0)
    distance = 1 - (0.9 + 8 * shown_x(32, height=1.0, degrees=11))  # 8: the picture is eight times as wide as high
    c = distance / scene.ao_distance_world
    assert scene.ao_distance_world == pytest.approx(0.045 * 4 * 256 / 251)
    on_floor = distance > 0.02
    c = np.minimum(c[on_floor], 1)
    expected = 1 - (np.arccos(c) - c * np.sqrt(1 - c * c)) / math.pi
    assert expected.min() < 0.85  # some of the floor is occluded
    np.testing.assert_allclose(ao[on_floor], expected, atol=0.03)


def test_an_emitter_lights_by_its_form_factor(maker):
    """A square of side 2a at height h over the middle: F = 4/pi (a/s atan(a/s)), s = sqrt(a^2 + h^2)
    (Howell, A Catalog of Radiation Heat Transfer Configuration Factors, B-4, four times)."""
    floor(maker, maker.grey(0.5), 3.0)
    a, h = 0.5, 0.7
    maker.quad((-a, h, -a), (2 * a, 0, 0), (0, 0, 2 * a), maker.grey(0.0, emissive=((1, 0.5, 0.25), 3.0, None)))
    look_down(maker, height=0.6, degrees=2)
    indirect, full = maker.draw("indirect", "full", samples=1024, size=(8, 8))
    s = math.hypot(a, h)
    expected = 0.5 * np.array([3, 1.5, 0.75]) * 4 / math.pi * (a / s * math.atan(a / s))
    np.testing.assert_allclose(indirect.mean((0, 1)), expected, rtol=5e-3)
    np.testing.assert_allclose(full.mean((0, 1)), expected, rtol=5e-3)  # the emitter is black: no second bounce


def test_a_single_sided_back_is_clear_to_the_camera_and_stops_light(maker):
    floor(maker, maker.grey(0.25))
    maker.quad((-1, 1, -1), (2, 0, 0), (0, 0, 2), maker.grey(0.9))  # faces down
    look_down(maker)
    maker.glb.directional_light("sun", DOWN, (1, 1, 1), math.pi)
    albedo, direct, indirect = maker.draw("albedo", "direct", "indirect")
    np.testing.assert_allclose(albedo, 0.25, rtol=1e-6)  # the floor, not the sheet
    assert direct.max() == 0 and indirect.max() == 0


def test_a_double_sided_sheet_is_lit_on_the_side_that_is_seen(maker):
    sheet = maker.grey(0.5)
    maker.glb.json["materials"][sheet]["doubleSided"] = True
    maker.quad((-1, 1, -1), (2, 0, 0), (0, 0, 2), sheet)  # its back is seen
    look_down(maker)
    maker.glb.directional_light("sun", DOWN, (1, 1, 1), math.pi)
    np.testing.assert_allclose(maker.draw("direct"), 0.5, rtol=1e-5)


def png(pixels):
    out = io.BytesIO()
    PIL.Image.fromarray(np.array(pixels, np.uint8)).save(out, "PNG")
    return out.getvalue()


def test_holes_let_the_camera_and_the_sun_through(maker):
    floor(maker, maker.grey(0.25))
    left_open = png([[(255, 255, 255, 0), (255, 255, 255, 255)]])
    sheet = maker.glb.material("sheet", (1, 1, 1), maker.glb.texture("t", left_open, 33071, nearest=True), cutoff=0.5)
    maker.quad((-2, 1, 2), (4, 0, 0), (0, 0, -4), sheet, (1, 1))
    look_down(maker)
    maker.glb.directional_light("sun", DOWN, (1, 1, 1), math.pi)
    albedo, direct, shadow = maker.draw("albedo", "direct", "shadow")
    left, right = np.s_[:, :7], np.s_[:, 9:]
    np.testing.assert_allclose(albedo[left], 0.25, rtol=1e-6)
    np.testing.assert_allclose(albedo[right], 1, rtol=1e-6)
    np.testing.assert_allclose(direct[left], 0.25, rtol=1e-5)  # the sun came through the hole
    assert shadow[:, :2].min() == 1
    ao = maker.draw("ao")
    assert ao.min() == 1


def test_a_pane_that_transmits_and_a_hidden_node_are_not_there(maker):
    floor(maker, maker.grey(0.25))
    for name in ("pane", "hidden"):
        maker.quad((-2, 1, 2), (4, 0, 0), (0, 0, -4), maker.glb.material(name, (1, 1, 1)))
    maker.glb.json["materials"][-2]["extensions"] = {"KHR_materials_transmission": {"transmissionFactor": 0.9}}
    hidden = len(maker.glb.json["nodes"]) - 1
    maker.glb.json["scenes"][0]["nodes"].remove(hidden)
    parent = maker.glb.node("parent", extensions={"KHR_node_visibility": {"visible": False}})
    maker.glb.json["nodes"][parent]["children"] = [hidden]
    look_down(maker)
    maker.glb.directional_light("sun", DOWN, (1, 1, 1), math.pi)
    albedo, direct = maker.draw("albedo", "direct")
    np.testing.assert_allclose(albedo, 0.25, rtol=1e-6)
    np.testing.assert_allclose(direct, 0.25, rtol=1e-5)


def test_textures_are_decoded_wrapped_and_transformed(maker):
    # One row: dark red, white. Scale 2 repeats it twice, offset 0.25 turns the first quarter white.
    texture = maker.glb.texture("t", png([[(128, 0, 0, 255), (255, 255, 255, 255)]]), 10497, nearest=True)
    material = maker.glb.material("m", (0.5, 0.5, 0.5), texture, uv_scale=2.0)  # the writer's offset is (0.25, 0)
    maker.quad((-1, 0, 1), (2, 0, 0), (0, 0, -2), material, (1, 1))
    look_down(maker, height=1 / math.tan(math.radians(10)))  # the picture is the quad
    albedo = maker.draw("albedo", samples=16)
    dark = 0.5 * ((128 / 255 + 0.055) / 1.055) ** 2.4
    columns = (np.arange(16) + 0.5) / 16 * 2 + 0.25
    expected = np.where(columns % 1 < 0.5, dark, 0.5)
    np.testing.assert_allclose(albedo[8, :, 0], expected, rtol=1e-4)
    np.testing.assert_allclose(albedo[8, :, 1], np.where(expected == 0.5, 0.5, 0), atol=1e-6)


def test_strips_and_fans_are_the_triangles_of_the_specification():
    order = np.array([10, 11, 12, 13, 14])
    assert triangle_corners(5, order).tolist() == [[10, 11, 12], [11, 13, 12], [12, 13, 14]]
    assert triangle_corners(6, order).tolist() == [[11, 12, 10], [12, 13, 10], [13, 14, 10]]
    assert triangle_corners(4, order).tolist() == [[10, 11, 12]]
    assert all(len(triangle_corners(mode, order)) == 0 for mode in (0, 1, 2, 3))
    assert len(triangle_corners(5, order[:2])) == 0


def test_a_scene_without_triangles_is_black(maker):
    maker.glb.camera("eye", (0, 0, 1), (0, 0, 0), 40)
    maker.glb.json.pop("meshes")
    assert maker.draw("full", samples=2).max() == 0


def test_a_mirrored_and_stretched_ball_is_lit_as_its_ellipsoid(maker):
    ball = shapes.icosphere(1.0, 3)
    maker.place(ball, maker.grey(1.0), scale=[-1, 0.5, 1])
    look_down(maker, degrees=10)
    maker.glb.directional_light("sun", (-0.6, -0.8, 0), (1, 1, 1), math.pi)
    scene = maker.load()
    edges = scene.positions[:, 1:] - scene.positions[:, :1]
    facing = np.cross(edges[:, 0], edges[:, 1])
    assert (np.einsum("tc,tkc->tk", facing, scene.normals) > 0).all()
    row = maker.draw("direct", size=(32, 32))[15:17, :, 0].mean(0)
    x = shown_x(32, height=2.5, degrees=10)  # on the top, at height 0.5
    n = np.stack([x, 2 * np.sqrt(1 - x * x)])  # gradient of x^2 + 4 y^2
    expected = (n / np.linalg.norm(n, axis=0)).T @ np.array([0.6, 0.8])
    np.testing.assert_allclose(row, expected, atol=0.02)


def test_paths_through_an_opening_keep_the_mean_and_lower_the_noise(maker):
    """A floor under a ceiling with a hole and an emitter above it, with and without the node that names the hole."""
    grey = maker.grey(0.5)
    floor(maker, grey, 1.0)
    h = 0.05  # half of the hole's side
    for origin, u, v in (((-1, 1, -1), (1 - h, 0, 0), (0, 0, 2)), ((h, 1, -1), (1 - h, 0, 0), (0, 0, 2)),
                         ((-h, 1, -1), (2 * h, 0, 0), (0, 0, 1 - h)), ((-h, 1, h), (2 * h, 0, 0), (0, 0, 1 - h))):
        maker.quad(origin, u, v, grey)  # faces down
    maker.quad((-1, 2, -1), (2, 0, 0), (0, 0, 2), grey)  # the camera sees it through the hole; it is lit from below
    emitter = maker.grey(0.0, emissive=((1, 0.5, 0.25), 20.0, None))
    maker.quad((0.5, 1.2, 0.3), (0.3, 0, 0), (0, 0, -0.3), emitter)  # faces up
    look_down(maker, height=0.9, degrees=30)
    scene = maker.load()
    plain = draw(make_world(scene), scene, "full", (16, 16), 8192, 0)
    maker.glb.node("hole", translation=[-h, 1, -h], extras={"opening": [[2 * h, 0, 0], [0, 0, 2 * h]]})
    scene = maker.load()
    assert len(scene.openings) == 1
    sent = draw(make_world(scene), scene, "full", (16, 16), 8192, 0)
    assert sent.image.mean() == pytest.approx(plain.image.mean(), rel=0.05)
    assert noise_of_halves(*sent.halves) < 0.1 * noise_of_halves(*plain.halves)
