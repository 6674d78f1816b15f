"""Intersects rays with the scene's triangles and evaluates the surface there. Positions are in trace space (scene.py)."""
import dataclasses

import numpy as np

from .engine import dr, mi
from .materials import SLOTS
from .scene import Scene

# Rays start this far off their surface: 1/200 of a voxel at grid 256, and far above float's rounding in a cube of
# side 1.
RAY_OFFSET = 2e-5


def unit_vector(v):
    """Normalizes by a square root and a division. dr.normalize and dr.rsqrt start from an approximation that differs between
    processors: with them AVX2 and AVX-512 machines would make references of different bytes."""
    return v / dr.sqrt(dr.squared_norm(v))


class Hit:
    """The point at which a ray met a triangle. `valid` is false where it met none."""
    DRJIT_STRUCT = {"valid": mi.Bool, "triangle": mi.UInt32, "b1": mi.Float, "b2": mi.Float}

    def __init__(self, valid=None, triangle=None, b1=None, b2=None):
        self.valid, self.triangle, self.b1, self.b2 = valid, triangle, b1, b2


@dataclasses.dataclass
class Surface:
    """The surface at a hit, turned to the side from which it was seen. A single-sided back reflects and emits nothing."""
    position: object  # Point3f
    facing: object  # Normal3f, of the triangle
    normal: object  # Normal3f, interpolated: cosines are taken with it
    albedo: object  # Color3f, linear
    emission: object  # Color3f, radiance
    # Only in scenes with glossy materials:
    seen_from: object = None  # Vector3f, unit
    metallic: object = None  # Float
    roughness: object = None  # Float


def corner_arrays(values: np.ndarray, kind: type) -> list:
    return [kind(np.ascontiguousarray(values[:, k].T.astype(np.float32))) for k in range(3)]


def tangents_of(positions: np.ndarray, uvs: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Tangents of the triangles, (n, 3), unit: the direction in which the first texture coordinate grows, 0 where coordinates
    do not change. And the handedness, (n,): the sign by which +Y of a normal map (up in the picture) is normal x tangent."""
    edge, uv = positions[:, 1:] - positions[:, :1], uvs[:, 1:] - uvs[:, :1]
    determinant = uv[:, 0, 0] * uv[:, 1, 1] - uv[:, 0, 1] * uv[:, 1, 0]
    # The second coordinate falls upwards: not mirrored where the determinant is negative.
    tangent = edge[:, 0] * uv[:, 1:, 1] - edge[:, 1] * uv[:, :1, 1]
    tangent = tangent * np.sign(determinant)[:, None]
    length = np.linalg.norm(tangent, axis=-1, keepdims=True)
    return np.divide(tangent, length, out=np.zeros_like(tangent), where=length > 0), np.where(determinant < 0, 1.0, -1.0)


class Surfaces:
    def __init__(self, scene: Scene):
        count = len(scene.positions)
        mesh = mi.Mesh("scene", 3 * count, count)
        parameters = mi.traverse(mesh)
        parameters["vertex_positions"] = mi.Float(scene.positions.astype(np.float32).ravel())
        parameters["faces"] = mi.UInt32(np.arange(3 * count, dtype=np.uint32))
        parameters.update()
        self._scene = mi.load_dict({"type": "scene", "mesh": mesh})
        self._corners = corner_arrays(scene.positions, mi.Point3f)
        self._normals = corner_arrays(scene.normals, mi.Normal3f)
        edges = scene.positions[:, 1:] - scene.positions[:, :1]
        facing = np.cross(edges[:, 0], edges[:, 1])
        facing /= np.linalg.norm(facing, axis=-1, keepdims=True)
        self._facing = mi.Normal3f(np.ascontiguousarray(facing.T.astype(np.float32)))
        self._has_colors = bool(np.any(scene.colors != 1))
        if self._has_colors:
            self._colors = corner_arrays(scene.colors, mi.Vector4f)
        self._load_materials(scene)
        self._load_textures(scene)

    def _load_materials(self, scene: Scene) -> None:
        m = scene.materials
        used = set(scene.material_of.tolist())
        self.has_holes = any(m[i].cutoff >= 0 for i in used)
        self.has_emission = any(m[i].emissive.max() > 0 for i in used)
        self._material = mi.UInt32(scene.material_of.astype(np.uint32))
        self._base = mi.Vector4f(np.stack([x.base_color for x in m], 1).astype(np.float32))
        self._emissive = mi.Color3f(np.stack([x.emissive for x in m], 1).astype(np.float32))
        self.has_gloss = any(m[i].glossy for i in used)
        self._metallic = mi.Float(np.array([x.metallic for x in m], np.float32))
        self._roughness = mi.Float(np.array([x.roughness for x in m], np.float32))
        # Each slot in use has its coordinates at the corners, and the texture of each material, -1 for none.
        self._slots = {slot: (corner_arrays(scene.uvs[slot], mi.Point2f), mi.Int32(np.array(
            [x.textures[slot].texture if slot in x.textures else -1 for x in m], np.int32)))
            for slot in SLOTS if any(slot in m[i].textures for i in used)}
        if "normal" in self._slots:
            self._normal_scale = mi.Float(np.array([x.normal_scale for x in m], np.float32))
            tangents, ups = tangents_of(scene.positions, scene.uvs["normal"])
            self._tangents = mi.Vector3f(np.ascontiguousarray(tangents.T.astype(np.float32)))
            self._handedness = mi.Float(ups.astype(np.float32))
        self._cutoff = mi.Float(np.array([x.cutoff for x in m], np.float32))
        self._double = mi.Bool(np.array([x.double_sided for x in m]))

    def _load_textures(self, scene: Scene) -> None:
        t = scene.textures
        if not t:
            return
        texels = np.concatenate([x.texels.reshape(-1, 4) for x in t]).astype(np.float32)
        starts = np.cumsum([0] + [x.texels.shape[0] * x.texels.shape[1] for x in t])[:-1]
        self._texels = mi.Vector4f(np.ascontiguousarray(texels.T))
        self._texture_start = mi.UInt32(starts.astype(np.uint32))
        self._texture_size = mi.Point2i(np.array([x.texels.shape[1::-1] for x in t], np.int32).T.copy())
        self._texture_wrap = mi.Point2i(np.array([(x.wrap_s, x.wrap_t) for x in t], np.int32).T.copy())
        self._texture_nearest = mi.Bool(np.array([x.nearest for x in t]))

    def _texel(self, slot, hit, material):
        """Linear RGBA of the slot's texture, bilinear or nearest; 1 where the material has none."""
        corners, textures = self._slots[slot]
        index = dr.gather(mi.Int32, textures, material, hit.valid)
        uv = self._interpolate(corners, hit, mi.Point2f)
        active = hit.valid & (index >= 0)
        i = mi.UInt32(dr.maximum(index, 0))
        size = dr.maximum(dr.gather(mi.Point2i, self._texture_size, i, active), 1)  # idle lanes must not divide by 0
        wrap = dr.gather(mi.Point2i, self._texture_wrap, i, active)
        start = dr.gather(mi.UInt32, self._texture_start, i, active)
        nearest = dr.gather(mi.Bool, self._texture_nearest, i, active)
        at = uv * mi.Point2f(size) - dr.select(nearest, 0, 0.5)
        base = dr.floor(at)
        fraction = dr.select(nearest, mi.Point2f(0), at - base)
        base = mi.Point2i(base)

        def wrapped(k, n, mode):
            once = ((k % n) + n) % n
            twice = ((k % (2 * n)) + 2 * n) % (2 * n)
            mirrored = dr.select(twice < n, twice, 2 * n - 1 - twice)
            return dr.select(mode == 0, once, dr.select(mode == 1, mirrored, dr.clip(k, 0, n - 1)))

        result = mi.Vector4f(0)
        for dx in (0, 1):
            for dy in (0, 1):
                x, y = wrapped(base.x + dx, size.x, wrap.x), wrapped(base.y + dy, size.y, wrap.y)
                weight = (fraction.x if dx else 1 - fraction.x) * (fraction.y if dy else 1 - fraction.y)
                result += weight * dr.gather(mi.Vector4f, self._texels, start + mi.UInt32(y * size.x + x), active)
        return dr.select(active, result, 1)

    def _interpolate(self, corners, hit, kind):
        at = [dr.gather(kind, c, hit.triangle, hit.valid) for c in corners]
        return at[0] * (1 - hit.b1 - hit.b2) + at[1] * hit.b1 + at[2] * hit.b2

    def _base_color(self, hit, material):
        color = dr.gather(mi.Vector4f, self._base, material, hit.valid)
        if self._has_colors:
            color *= self._interpolate(self._colors, hit, mi.Vector4f)
        if "base_color" in self._slots:
            color *= self._texel("base_color", hit, material)
        return color

    def is_hole(self, hit):
        if not self.has_holes:
            return mi.Bool(False)
        material = dr.gather(mi.UInt32, self._material, hit.triangle, hit.valid)
        return hit.valid & (self._base_color(hit, material).w < dr.gather(mi.Float, self._cutoff, material, hit.valid))

    def is_culled(self, hit, direction):
        """True on the back of a single-sided triangle, which the camera does not see."""
        material = dr.gather(mi.UInt32, self._material, hit.triangle, hit.valid)
        facing = dr.gather(mi.Normal3f, self._facing, hit.triangle, hit.valid)
        return hit.valid & (dr.dot(facing, direction) >= 0) & ~dr.gather(mi.Bool, self._double, material, hit.valid)

    def _nearest(self, origin, direction, reach, active):
        found = self._scene.ray_intersect_preliminary(mi.Ray3f(origin, direction, reach, 0, []), active=active)
        return Hit(active & found.is_valid(), found.prim_index, found.prim_uv.x, found.prim_uv.y)

    def _beyond(self, hit, direction):
        """A point just behind a hit, along `direction`."""
        facing = dr.gather(mi.Normal3f, self._facing, hit.triangle, hit.valid)
        side = dr.select(dr.dot(facing, direction) < 0, -RAY_OFFSET, RAY_OFFSET)
        return self._interpolate(self._corners, hit, mi.Point3f) + side * facing

    @dr.syntax
    def meet(self, origin, direction, active, camera: bool = False):
        """The first surface along a ray: holes let all rays through, single-sided backs let the camera's rays through."""
        hit = self._nearest(origin, direction, mi.Float(dr.inf), active)
        if dr.hint(self.has_holes or camera, mode="scalar"):
            again = self.is_hole(hit)
            if dr.hint(camera, mode="scalar"):
                again |= self.is_culled(hit, direction)
            while again:
                hit = self._nearest(self._beyond(hit, direction), direction, mi.Float(dr.inf), again)
                again = self.is_hole(hit)
                if dr.hint(camera, mode="scalar"):
                    again |= self.is_culled(hit, direction)
        return hit

    @dr.syntax
    def blocked(self, origin, direction, reach, active):
        """True where anything but holes lies nearer than `reach`. Backs block as fronts do."""
        result = mi.Bool(False)
        if dr.hint(self.has_holes, mode="scalar"):
            start, left = mi.Point3f(origin), mi.Float(reach)
            going = mi.Bool(active)
            while going:
                hit = self._nearest(start, direction, left, going)
                hole = self.is_hole(hit)
                result |= hit.valid & ~hole
                beyond = self._beyond(hit, direction)
                left -= dr.dot(beyond - start, direction)
                start = mi.Point3f(beyond)
                going = hole & (left > 0)
        else:
            result = self._scene.ray_test(mi.Ray3f(origin, direction, reach, 0, []), active=active) & active
        return result

    def surface(self, hit, direction) -> Surface:
        material = dr.gather(mi.UInt32, self._material, hit.triangle, hit.valid)
        facing = dr.gather(mi.Normal3f, self._facing, hit.triangle, hit.valid)
        normal = self._mapped(hit, material, unit_vector(self._interpolate(self._normals, hit, mi.Normal3f)))
        back = dr.dot(facing, direction) > 0
        seen = hit.valid & (~back | dr.gather(mi.Bool, self._double, material, hit.valid))
        turn = dr.select(back, -1.0, 1.0)
        base = self._base_color(hit, material)
        surface = Surface(self._interpolate(self._corners, hit, mi.Point3f), facing * turn, normal * turn,
                          dr.select(seen, mi.Color3f(base.x, base.y, base.z), 0),
                          dr.select(seen, self.emission(hit, material), 0))
        if self.has_gloss:
            surface.seen_from = -direction
            surface.metallic = dr.gather(mi.Float, self._metallic, material, hit.valid)
            surface.roughness = dr.gather(mi.Float, self._roughness, material, hit.valid)
            if "gloss" in self._slots:
                texel = self._texel("gloss", hit, material)
                surface.roughness *= texel.y
                surface.metallic *= texel.z
            surface.roughness = dr.select(seen, surface.roughness, 1)
            surface.metallic = dr.select(seen, surface.metallic, 0)
        return surface

    def _mapped(self, hit, material, normal):
        """Turns the front's normal by the material's normal map."""
        if "normal" not in self._slots:
            return normal
        texel = self._texel("normal", hit, material)
        index = dr.gather(mi.Int32, self._slots["normal"][1], material, hit.valid)
        scale = dr.gather(mi.Float, self._normal_scale, material, hit.valid)
        along = dr.gather(mi.Vector3f, self._tangents, hit.triangle, hit.valid)
        tangent = along - mi.Vector3f(normal) * dr.dot(normal, along)
        mapped = (index >= 0) & (dr.squared_norm(tangent) > 0)
        tangent = unit_vector(dr.select(mapped, tangent, mi.Vector3f(1, 0, 0)))
        up = dr.cross(mi.Vector3f(normal), tangent) * dr.gather(mi.Float, self._handedness, hit.triangle, hit.valid)
        turned = (scale * (2 * texel.x - 1) * tangent + scale * (2 * texel.y - 1) * up +
                  (2 * texel.z - 1) * mi.Vector3f(normal))
        return dr.select(mapped, mi.Normal3f(unit_vector(turned)), normal)

    def emission(self, hit, material=None):
        """Radiance of the front. The caller decides which side a hit is on."""
        if not self.has_emission:
            return mi.Color3f(0)
        if material is None:
            material = dr.gather(mi.UInt32, self._material, hit.triangle, hit.valid)
        color = dr.gather(mi.Color3f, self._emissive, material, hit.valid)
        if "emissive" in self._slots:
            texel = self._texel("emissive", hit, material)
            color *= mi.Color3f(texel.x, texel.y, texel.z)
        return color
