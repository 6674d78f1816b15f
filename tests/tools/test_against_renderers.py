"""The path tracer against two renderers that share no code with it: `vct`, and Mitsuba's own path tracer."""
import io
import math

import numpy as np
import PIL.Image
import pytest

from files import ROOT
from program import render
from truth.drawing import draw, make_world
from truth.engine import mi
from truth.exr import read_exr
from truth.scene import load_scene

SIZE = (128, 128)


@pytest.fixture(scope="module", params=[("cornell", None), ("courtyard", None), ("walker", 1.4)], ids=lambda p: p[0])
def both(request, program, tmp_path_factory):
    """(folder of vct's pictures, scene, world) of one scene, at a moment of its animation where it has one."""
    name, seconds = request.param
    path, out = ROOT / f"assets/{name}.glb", tmp_path_factory.mktemp(name)
    render(path, out, "--size", f"{SIZE[0]}x{SIZE[1]}", "--preset", "thesis", "--mode", "gi",
           "--grid", 128, "--shadow-map", 2048, "--debug-views", "--light-parts",
           *(("--time", seconds) if seconds is not None else ()))
    scene = load_scene(path, seconds=seconds)
    return out, scene, make_world(scene)


def of_kind(both, kind, samples):
    return draw(both[2], both[1], kind, SIZE, samples, 0).image


def test_silhouettes_lie_on_the_same_pixels(both):
    """The renderer samples the pixel's centre, which lies in a surface that covers more than half of the pixel."""
    seen = read_exr(both[0] / "debug_views/g_buffer_albedo.exr").max(-1) > 0
    covered = of_kind(both, "coverage", 64)[..., 0]
    assert 0.3 < seen.mean() < 0.99
    assert np.mean(seen != (covered > 0.5)) < 0.003
    assert not np.any(seen & (covered == 0)) and not np.any(~seen & (covered == 1))


def test_edges_within_the_picture_are_not_shifted(both):
    """The squared difference of the albedo is clearly the least without a shift, along both axes."""
    mine, theirs = of_kind(both, "albedo", 64), read_exr(both[0] / "debug_views/g_buffer_albedo.exr")
    difference = {(dx, dy): np.mean((np.roll(theirs, (dy, dx), (0, 1)) - mine) ** 2)
                  for dx in (-1, 0, 1) for dy in (-1, 0, 1)}
    still = difference.pop((0, 0))
    assert still < 0.6 * min(difference.values())
    # A shift of a tenth of a pixel would show as a difference of opposite neighbours.
    for a, b in (((1, 0), (-1, 0)), ((0, 1), (0, -1))):
        assert abs(difference[a] - difference[b]) < 0.15 * (difference[a] + difference[b])


def test_lit_surfaces_are_equally_bright(both):
    """Mode gi without its bounce is albedo E/pi n.l times occlusion where nothing is in shadow. The albedo is divided out on both
    sides, because a texture at one point of a pixel is not its mean over the pixel."""
    direct, albedo = of_kind(both, "direct", 64), of_kind(both, "albedo", 64)
    shadow = of_kind(both, "shadow", 64)[..., 0]
    root = read_exr(both[0] / "debug_views/g_buffer_albedo.exr")
    occlusion = read_exr(both[0] / "ambient_occlusion.exr")[..., :1]
    bright = (albedo.min(-1) > 0.03) & (root.min(-1) > 0.03)
    inside = bright & (occlusion[..., 0] > 0.9)
    inside[[0, -1]] = inside[:, [0, -1]] = False
    mine = direct / np.maximum(albedo, 1e-3)
    for dy in (-1, 0, 1):  # every neighbour is lit from the same angle, so no edge is near
        for dx in (-1, 0, 1):
            near = np.abs(np.roll(mine, (dy, dx), (0, 1)) - mine).max(-1)
            inside &= (np.roll(shadow, (dy, dx), (0, 1)) == 1) & (near < 0.02)
    theirs = (read_exr(both[0] / "gi.exr") - read_exr(both[0] / "indirect_light.exr"))[inside]
    ratio = (theirs / root[inside] / occlusion[inside] / mine[inside]).ravel()
    assert len(ratio) > 1000
    assert abs(np.median(ratio) - 1) < 0.003
    assert np.mean(np.abs(ratio - 1) < 0.01) > 0.95


def waves(side, slope):
    """A normal map that repeats: slopes of `slope` along x, twice as many and half as steep along y."""
    along = 2 * np.pi * (np.arange(side) + 0.5) / side
    normal = np.ones((side, side, 3))
    normal[..., 0], normal[..., 1] = slope * np.sin(along)[None], 0.5 * slope * np.sin(2 * along)[:, None]
    normal /= np.linalg.norm(normal, axis=-1, keepdims=True)
    buffer = io.BytesIO()
    PIL.Image.fromarray(np.round(127.5 * (normal + 1)).astype(np.uint8)).save(buffer, "PNG")
    return buffer.getvalue()


def test_normal_maps_are_read_alike(program, maker, tmp_path):
    """A floor under a slanting sun whose texture coordinates run against the world's x, and are mirrored on one half."""
    glb = maker.glb
    map_ = glb.texture("waves", waves(64, 0.4), 10497)
    material = maker.grey(0.6)
    glb.json["materials"][material]["normalTexture"] = {"index": map_, "scale": 0.8}
    maker.quad((1, 0, -3), (-1, 0, 0), (0, 0, 2), material, (1, 2))
    maker.quad((0, 0, -3), (-1, 0, 0), (0, 0, 2), material, (-1, 2))
    maker.quad((-1, 0, -3), (2, 0, 0), (0, 1, 0), maker.grey(0.1))
    glb.camera("above", (0.2, 3, 0.5), (0, 0, -2), 40)
    glb.directional_light("sun", (0.5, -1, 0.3), (1, 1, 1), 3.0)
    scene = maker.load()
    render(maker.path, tmp_path, "--size", "128x128", "--preset", "mobile", "--mode", "gi", "--grid", 64,
           "--light-parts", "--debug-views")
    albedo = read_exr(tmp_path / "debug_views/g_buffer_albedo.exr")
    mine = (read_exr(tmp_path / "gi.exr") - read_exr(tmp_path / "indirect_light.exr"))[..., 0]
    theirs = draw(make_world(scene), scene, "direct", SIZE, 64, 0).image[..., 0]
    lit = (np.abs(albedo[..., 0] - 0.6) < 0.01) & (theirs > 0.25)
    floor = lit.copy()
    for shift, axis in ((1, 0), (-1, 0), (1, 1), (-1, 1)):  # a pixel at an edge shows the floor only in part
        floor &= np.roll(lit, shift, axis)
    assert floor.sum() > 2000 and theirs[floor].std() > 0.04
    difference = (mine - theirs)[floor]
    assert abs(difference.mean()) < 0.005
    assert np.abs(difference).max() < 0.02  # the map turns no pixel into its own shadow


def test_full_light_is_that_of_mitsubas_own_path_tracer(root):
    """Cornell has no masks and no textures: its plugins model it as well."""
    scene = load_scene(root / "assets/cornell.glb")
    description = {"type": "scene", "sun": {
        "type": "directional", "direction": (-scene.sun.towards).tolist(),
        "irradiance": {"type": "rgb", "value": scene.sun.irradiance.tolist()}}}
    for i in np.unique(scene.material_of):
        chosen = scene.material_of == i
        count = int(chosen.sum())
        properties = mi.Properties()
        properties["bsdf"] = mi.load_dict({"type": "diffuse", "reflectance": {
            "type": "rgb", "value": scene.materials[i].base_color[:3].tolist()}})
        mesh = mi.Mesh(f"part{i}", 3 * count, count, has_vertex_normals=True, props=properties)
        parameters = mi.traverse(mesh)
        parameters["vertex_positions"] = mi.Float(scene.positions[chosen].astype(np.float32).ravel())
        parameters["vertex_normals"] = mi.Float(scene.normals[chosen].astype(np.float32).ravel())
        parameters["faces"] = mi.UInt32(np.arange(3 * count, dtype=np.uint32))
        parameters.update()
        description[f"part{i}"] = mesh
    size, camera = 64, scene.camera
    to_world = np.eye(4)
    to_world[:3, :3] = (camera.axes * [[-1], [1], [-1]]).T  # Mitsuba's camera: +z forward, +x to the left
    to_world[:3, 3] = camera.eye
    description["sensor"] = {
        "type": "perspective", "to_world": mi.ScalarTransform4f(to_world), "fov_axis": "y",
        "fov": math.degrees(camera.vertical_fov_rad), "near_clip": 1e-3, "far_clip": 1e3,
        "film": {"type": "hdrfilm", "width": size, "height": size, "rfilter": {"type": "box"},
                 "pixel_format": "rgb", "component_format": "float32"}}
    description["integrator"] = {"type": "path", "max_depth": 32, "hide_emitters": True}
    theirs = np.array(mi.render(mi.load_dict(description), spp=256, seed=1))
    mine = draw(make_world(scene), scene, "full", (size, size), 256, 0).image
    np.testing.assert_allclose(mine.mean((0, 1)), theirs.mean((0, 1)), rtol=0.01)
    blocks = [p.reshape(8, 8, 8, 8, 3).mean((1, 3)) for p in (mine, theirs)]
    assert np.mean((blocks[0] - blocks[1]) ** 2 / (blocks[1] ** 2 + 0.01)) < 5e-4


def test_a_scaled_scene_is_the_same_to_the_path_tracer(root):
    """So cornell_1mm and cornell_10km can use Cornell's references."""
    cornell = load_scene(root / "assets/cornell.glb")
    for name in ("cornell_1mm", "cornell_10km"):
        scaled = load_scene(root / f"assets/{name}.glb")
        np.testing.assert_allclose(scaled.positions, cornell.positions, atol=2e-6)
        np.testing.assert_allclose(scaled.normals, cornell.normals, atol=1e-5)
        np.testing.assert_allclose(scaled.camera.eye, cornell.camera.eye, atol=2e-6)
        np.testing.assert_allclose(scaled.sun.irradiance, cornell.sun.irradiance)
