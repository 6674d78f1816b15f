"""Glossy surfaces: glTF 2.0's metallic-roughness BRDF (appendix B.2 and B.3).

A surface of roughness r, base colour b and metallic m has F0 = mix(0.04 f, b, m), F90 = mix(f, 1, m), Schlick's
F = F0 + (F90 - F0) (1 - v.h)^5, and the BRDF (1 - F) (1 - m) b / pi + F D G / (4 n.l n.v), with GGX of alpha = r^2 and
separable masking. Here f is 1 up to the roughness 0.9 and falls to 0 at 1, where a material that is no metal is a Lambert
surface. glTF has f = 1.
"""
import math

from .engine import dr, mi
from .lights import leave, tangent_frame
from .surfaces import unit_vector

SMALLEST_ALPHA = 1e-3


class Brdf:
    """The BRDF of one point, seen from the direction `seen` (unit, away from the surface)."""

    def __init__(self, normal, base, metallic, roughness, seen):
        self.normal, self.seen = mi.Vector3f(normal), seen
        fade = dr.clip((1 - roughness) * 10, 0, 1)
        self.glossy = (roughness < 1) | (metallic > 0)
        self.f0 = 0.04 * fade * (1 - metallic) + base * metallic
        self.f90 = fade * (1 - metallic) + metallic
        self.diffuse = base * (1 - metallic)
        self.alpha = dr.maximum(roughness * roughness, SMALLEST_ALPHA)
        self.cos_seen = dr.maximum(dr.dot(normal, seen), 1e-4)
        # The probability that `sample` takes a specular direction.
        self.specular_chance = dr.select(self.glossy, 0.5 + 0.5 * metallic, 0)

    def _fresnel(self, cosine):
        return self.f0 + (self.f90 - self.f0) * (1 - dr.clip(cosine, 0, 1)) ** 5

    def _masking(self, cosine):
        a2 = dr.square(self.alpha)
        return 2 * cosine / (cosine + dr.sqrt(a2 + (1 - a2) * dr.square(cosine)))

    def evaluate(self, direction):
        """(diffuse, specular, density): both times n.l; the density is that of `sample`."""
        cosine = dr.maximum(dr.dot(self.normal, direction), 0)
        halfway = unit_vector(self.seen + direction)
        cos_half, a2 = dr.maximum(dr.dot(self.normal, halfway), 0), dr.square(self.alpha)
        ndf = a2 / (math.pi * dr.square(dr.square(cos_half) * (a2 - 1) + 1))
        fresnel = self._fresnel(dr.dot(self.seen, halfway))
        visible = self._masking(self.cos_seen) * ndf / (4 * self.cos_seen)  # the density of visible normals' mirrors
        diffuse = (1 - fresnel) * self.diffuse * (cosine / math.pi)
        specular = fresnel * visible * self._masking(cosine)
        density = self.specular_chance * visible + (1 - self.specular_chance) * cosine / math.pi
        up = cosine > 0
        return dr.select(up, diffuse, 0), dr.select(up & self.glossy, specular, 0), dr.select(up, density, 0)

    def specular_direction(self, a, b):
        """The mirror direction about a visible normal (Heitz 2018, Sampling the GGX Distribution of Visible Normals),
        and F G / G1 there: the arriving light times this estimates the specularly reflected light."""
        across, along = tangent_frame(self.normal)
        seen = mi.Vector3f(dr.dot(self.seen, across), dr.dot(self.seen, along), self.cos_seen)
        stretched = unit_vector(mi.Vector3f(self.alpha * seen.x, self.alpha * seen.y, seen.z))
        flat = dr.square(stretched.x) + dr.square(stretched.y)
        scale = 1 / dr.sqrt(dr.maximum(flat, 1e-20))
        t1 = dr.select(flat > 1e-14, mi.Vector3f(-stretched.y * scale, stretched.x * scale, 0), mi.Vector3f(1, 0, 0))
        t2 = dr.cross(stretched, t1)
        radius, (sine, cosine) = dr.sqrt(a), dr.sincos(2 * math.pi * b)
        p1, s = radius * cosine, 0.5 * (1 + stretched.z)
        p2 = (1 - s) * dr.safe_sqrt(1 - p1 * p1) + s * radius * sine
        n = p1 * t1 + p2 * t2 + dr.safe_sqrt(1 - p1 * p1 - p2 * p2) * stretched
        local = unit_vector(mi.Vector3f(self.alpha * n.x, self.alpha * n.y, dr.maximum(n.z, 1e-6)))
        halfway = local.x * across + local.y * along + local.z * self.normal
        direction = unit_vector(mi.Vector3f(2 * dr.dot(self.seen, halfway) * halfway - self.seen))
        height = dr.dot(self.normal, direction)
        weight = self._fresnel(dr.dot(self.seen, halfway)) * self._masking(dr.maximum(height, 1e-4))
        return direction, dr.select(height > 0, weight, 0)

    def sample(self, choice, a, b):
        """(direction, BRDF times n.l over its density)."""
        mirrored, _ = self.specular_direction(a, b)
        radius, (sine, cosine) = dr.sqrt(a), dr.sincos(2 * math.pi * b)
        across, along = tangent_frame(self.normal)
        scattered = radius * cosine * across + radius * sine * along + dr.safe_sqrt(1 - a) * self.normal
        direction = dr.select(choice < self.specular_chance, mirrored, mi.Vector3f(scattered))
        diffuse, specular, density = self.evaluate(direction)
        return direction, dr.select(density > 1e-12, (diffuse + specular) / density, 0)


def brdf_of(surface):
    return Brdf(surface.normal, surface.albedo, surface.metallic, surface.roughness, surface.seen_from)


def reflected_punctual(world, surface, brdf, active):
    def reflectance(direction):
        diffuse, specular, _ = brdf.evaluate(direction)
        return diffuse + specular

    return world.punctual.reflected(world.surfaces, surface, reflectance, active)


def reflected_sun(world, surface, brdf, active):
    """Reflected light of the sun as a point."""
    if not world.sun.is_on:
        return mi.Color3f(0)
    diffuse, specular, _ = brdf.evaluate(world.sun.towards)
    active = active & (world.sun.cosine(surface, world.sun.towards) > 0)
    blocked = world.surfaces.blocked(leave(surface), world.sun.towards, mi.Float(dr.inf), active)
    return dr.select(active & ~blocked, (diffuse + specular) * world.sun.radiance_unit * math.pi, 0)
