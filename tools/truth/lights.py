"""The sun and the emissive triangles as lights of a surface."""
import math

import numpy as np

from .engine import dr, mi
from .scene import Scene
from .surfaces import RAY_OFFSET, Hit, Surface, Surfaces

SUN_HALF_ANGLE_RAD = math.radians(2.5)  # the 5 degree shadow cone's full opening


def leave(surface: Surface):
    return surface.position + RAY_OFFSET * surface.facing


def tangent_frame(axis):
    """Two unit vectors across `axis` (Duff et al. 2017, Building an Orthonormal Basis, Revisited)."""
    sign = dr.select(axis.z >= 0, 1.0, -1.0)
    a = -1 / (sign + axis.z)
    b = axis.x * axis.y * a
    return (mi.Vector3f(1 + sign * axis.x * axis.x * a, sign * b, -sign * axis.x),
            mi.Vector3f(b, sign + axis.y * axis.y * a, -axis.y))


class Sun:
    def __init__(self, scene: Scene):
        self.towards = mi.Vector3f(scene.sun.towards.tolist())
        self.radiance_unit = mi.Color3f((scene.sun.irradiance / math.pi).tolist())  # E/pi
        self.is_on = scene.sun.irradiance.max() > 0

    @staticmethod
    def cosine(surface: Surface, direction):
        """0 behind the surface and behind the triangle, which shadows itself there."""
        return dr.select(dr.dot(surface.facing, direction) > 0,
                         dr.maximum(dr.dot(surface.normal, direction), 0), 0)

    def direct(self, surfaces: Surfaces, surface: Surface, active):
        """Reflected light of the sun as a point: albedo E/pi n.l, or 0 in shadow."""
        if not self.is_on:
            return mi.Color3f(0)
        cosine = self.cosine(surface, self.towards)
        active = active & (cosine > 0)
        blocked = surfaces.blocked(leave(surface), self.towards, mi.Float(dr.inf), active)
        return dr.select(active & ~blocked, surface.albedo * self.radiance_unit * cosine, 0)

    def disc(self, surfaces: Surfaces, surface: Surface, random, active):
        """(n.w)+ of a uniform direction within the sun's disc, and the same where nothing blocks it."""
        cos_half = math.cos(SUN_HALF_ANGLE_RAD)
        cos_theta = 1 - random.x * (1 - cos_half)
        sin_theta = dr.safe_sqrt(1 - cos_theta * cos_theta)
        sine, cosine = dr.sincos(2 * math.pi * random.y)
        across, up = tangent_frame(self.towards)
        direction = sin_theta * cosine * across + sin_theta * sine * up + cos_theta * self.towards
        lit = self.cosine(surface, direction)
        active = active & (lit > 0)
        blocked = surfaces.blocked(leave(surface), direction, mi.Float(dr.inf), active)
        return dr.select(active, lit, 0), dr.select(active & ~blocked, lit, 0)

    def disc_light(self, surface: Surface, cosine):
        """Reflected light of a disc of radiance E / (pi sin^2 half), which gives a surface that faces it the irradiance E.

        Directions are uniform over 2 pi (1 - cos half), hence 2 (1 - cos half) / sin^2 half = 2 / (1 + cos half).
        """
        return surface.albedo * self.radiance_unit * cosine * (2 / (1 + math.cos(SUN_HALF_ANGLE_RAD)))


class Emitters:
    """Emissive triangles, chosen by area times emission; the two ways to reach one are weighed by the power heuristic
    (Veach 1997, 9.2)."""

    def __init__(self, scene: Scene, surfaces: Surfaces):
        p = scene.positions
        area = 0.5 * np.linalg.norm(np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]), axis=-1)
        power = area * np.array([m.emissive.mean() for m in scene.materials])[scene.material_of]
        self.any = surfaces.has_emission and power.sum() > 0
        if not self.any:
            return
        chance = power / power.sum()
        self._list = mi.UInt32(np.flatnonzero(power).astype(np.uint32))
        self._choice = mi.DiscreteDistribution(mi.Float(chance[power > 0].astype(np.float32)))
        self._density = mi.Float((chance / area).astype(np.float32))  # per area, of each triangle
        self._double = mi.Bool(np.array([scene.materials[i].double_sided for i in scene.material_of]))

    def _per_solid_angle(self, hit, distance2, cosine):
        density = dr.gather(mi.Float, self._density, hit.triangle, hit.valid)
        return density * distance2 / dr.maximum(cosine, 1e-6)

    def weight_of_hit(self, surfaces, surface: Surface, hit, origin, cosine_pdf):
        """The weight of an emitter that a cosine-distributed ray from `origin` met."""
        if not self.any:
            return mi.Float(1)
        way = surface.position - origin
        distance2 = dr.squared_norm(way)
        pdf = self._per_solid_angle(hit, distance2, dr.abs(dr.dot(surface.facing, way)) / dr.sqrt(distance2))
        return dr.square(cosine_pdf) / dr.maximum(dr.square(cosine_pdf) + dr.square(pdf), 1e-30)

    def light(self, surfaces: Surfaces, surface: Surface, choice, random, active):
        """The weighted irradiance / pi that `surface` gets from one point of one emitter."""
        if not self.any:
            return mi.Color3f(0)
        triangle = dr.gather(mi.UInt32, self._list, self._choice.sample(choice, active), active)
        root = dr.sqrt(random.x)
        hit = Hit(mi.Bool(active), triangle, root * (1 - random.y), root * random.y)
        facing = dr.gather(mi.Normal3f, surfaces._facing, triangle, active)
        point = surfaces._interpolate(surfaces._corners, hit, mi.Point3f)
        way = point - surface.position
        distance2 = dr.squared_norm(way)
        direction = way / dr.sqrt(dr.maximum(distance2, 1e-20))
        there = -dr.dot(facing, direction)
        there = dr.select(dr.gather(mi.Bool, self._double, triangle, active), dr.abs(there), there)
        here = dr.select(dr.dot(surface.facing, direction) > 0, dr.dot(surface.normal, direction), 0)
        active = active & (here > 0) & (there > 0) & ~surfaces.is_hole(hit)
        side = dr.select(dr.dot(facing, direction) < 0, RAY_OFFSET, -RAY_OFFSET)
        start, end = leave(surface), point + side * facing
        length = dr.norm(end - start)
        active &= ~surfaces.blocked(start, (end - start) / length, length, active)
        pdf = self._per_solid_angle(hit, distance2, there)
        cosine_pdf = here / math.pi
        weight = dr.square(pdf) / dr.maximum(dr.square(cosine_pdf) + dr.square(pdf), 1e-30)
        return dr.select(active, surfaces.emission(hit) * (cosine_pdf / pdf * weight), 0)
