"""The lights of KHR_lights_punctual other than the sun, which have no size.

A surface that faces a light has the irradiance I a(d) c^2 of a point or spot light and E of a directional one, where d
is the distance, a(d) = max(min(1 - (d / range)^4, 1), 0) / d^2, and c = clip(cos * scale + offset, 0, 1) the fall-off
of a spot between its inner and its outer angle, 1 for all others.
"""
import numpy as np

from .engine import dr, mi
from .lights import Sun, leave
from .scene import Scene
from .surfaces import Surface, Surfaces


class Punctual:
    def __init__(self, scene: Scene):
        lights = scene.punctual
        self.count = len(lights)
        if not lights:
            return

        def vectors(kind, values):
            return kind(np.ascontiguousarray(np.stack(values, 1).astype(np.float32)))

        self._directional = mi.Bool(np.array([light.position is None for light in lights]))
        self._position = vectors(mi.Point3f, [np.zeros(3) if light.position is None else light.position for light in lights])
        self._towards = vectors(mi.Vector3f, [light.towards for light in lights])
        self._intensity = vectors(mi.Color3f, [light.intensity for light in lights])
        self._per_range = mi.Float(np.array([1 / light.range for light in lights], np.float32))
        self._cone_scale = mi.Float(np.array([light.cone_scale for light in lights], np.float32))
        self._cone_offset = mi.Float(np.array([light.cone_offset for light in lights], np.float32))

    def _arriving(self, surface: Surface, index, active):
        """Direction to a light, its irradiance on a surface that faces it, and its distance, all without any shadow."""
        directional = dr.gather(mi.Bool, self._directional, index, active)
        axis = dr.gather(mi.Vector3f, self._towards, index, active)
        way = dr.gather(mi.Point3f, self._position, index, active) - surface.position
        distance2 = dr.maximum(dr.squared_norm(way), 1e-20)
        distance = dr.sqrt(distance2)
        direction = dr.select(directional, axis, way / distance)
        near = dr.square(dr.square(distance * dr.gather(mi.Float, self._per_range, index, active)))
        cone = dr.clip(dr.dot(axis, direction) * dr.gather(mi.Float, self._cone_scale, index, active)
                       + dr.gather(mi.Float, self._cone_offset, index, active), 0, 1)
        falloff = dr.square(cone) * dr.clip(1 - near, 0, 1) / distance2
        intensity = dr.gather(mi.Color3f, self._intensity, index, active)
        return direction, intensity * dr.select(directional, 1, falloff), dr.select(directional, dr.inf, distance)

    def reflected(self, surfaces: Surfaces, surface: Surface, reflectance, active):
        """`reflectance`: of a direction, the BRDF times n.l. One shadow ray to each light, so there is no noise."""
        return self._sum(surfaces, surface, reflectance, active) if self.count else mi.Color3f(0)

    @dr.syntax
    def _sum(self, surfaces: Surfaces, surface: Surface, reflectance, active):
        result, index = mi.Color3f(0), mi.UInt32(0)
        while index < self.count:
            direction, irradiance, distance = self._arriving(surface, index, active)
            meant = active & (dr.max(irradiance) > 0) & (Sun.cosine(surface, direction) > 0)
            blocked = surfaces.blocked(leave(surface), direction, distance, meant)
            result += dr.select(meant & ~blocked, reflectance(direction) * irradiance, 0)
            index += 1
        return result
