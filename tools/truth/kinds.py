"""The kinds of references: each function estimates the value of the surface that a camera ray meets.

All surfaces are Lambert surfaces of their base colour, except for `full` and `glossy`. The sky is black where the scene has no
picture of it. A single-sided back reflects and emits nothing, and blocks light; only the camera sees through it.
`tools/eval.py references --help` describes the kinds in words.
"""
import math

from .engine import dr, mi
from .glossy import brdf_of, reflected_punctual, reflected_sun
from .lights import Emitters, Sun, leave, tangent_frame
from .openings import Openings
from .punctual import Punctual
from .scene import AO_DISTANCE, Scene
from .sky import Sky
from .surfaces import Surface, Surfaces

FIRST_ROULETTE, LARGEST_SURVIVAL, MOST_BOUNCES = 3, 0.95, 128


class World:
    def __init__(self, scene: Scene):
        self.surfaces, self.sun = Surfaces(scene), Sun(scene)
        self.emitters = Emitters(scene, self.surfaces)
        self.sky = Sky(scene.sky)
        self.punctual = Punctual(scene)
        self.openings = Openings(scene)

    def direct(self, surface: Surface, active):
        """The light that a Lambert surface reflects from all lights that have no size."""
        return self.sun.direct(self.surfaces, surface, active) + self.lambert_punctual(surface, active)

    def lambert_punctual(self, surface: Surface, active):
        def reflectance(direction):
            return surface.albedo * (Sun.cosine(surface, direction) / math.pi)

        return self.punctual.reflected(self.surfaces, surface, reflectance, active)


def cosine_direction(surface: Surface, a, b):
    """A cosine-distributed direction about the interpolated normal, its density, and whether it leaves the triangle."""
    radius, (sine, cosine) = dr.sqrt(a), dr.sincos(2 * math.pi * b)
    height = dr.safe_sqrt(1 - a)
    across, up = tangent_frame(surface.normal)
    direction = radius * cosine * across + radius * sine * up + height * surface.normal
    return direction, height / math.pi, dr.dot(surface.facing, direction) > 0


def bounce_direction(world, surface: Surface, a, b, random):
    """Returns the values of cosine_direction and two weights of the light from that direction. The first is 1 where the
    direction crosses an opening, the second where it crosses none; in a scene without openings both are 1."""
    direction, pdf, leaves = cosine_direction(surface, a, b)
    if not world.openings:
        return direction, pdf, leaves, mi.Float(1), mi.Float(1)
    direction, pdf, weight, crosses = world.openings.redirect(surface, direction, pdf, random.next_float32(),
                                                              random.next_float32(), random.next_float32())
    leaves = dr.dot(surface.facing, direction) > 0
    return direction, pdf, leaves, dr.select(crosses, 1, weight), dr.select(crosses, weight, 1)


def weighted(world, light, weight):
    """Returns `light` times `weight`; without openings every weight is 1 and the product is left out."""
    return light * weight if world.openings else light


def coverage(world, surface, numbers, random, active):
    return dr.select(active, mi.Color3f(1), 0)


def albedo(world, surface, numbers, random, active):
    return surface.albedo


def direct(world, surface, numbers, random, active):
    return surface.emission + world.direct(surface, active)


def indirect(world, surface, numbers, random, active):
    direction, pdf, leaves, inside, crossing = bounce_direction(world, surface, numbers[2], numbers[3], random)
    hit = world.surfaces.meet(leave(surface), direction, active & leaves)
    there = world.surfaces.surface(hit, direction)
    weight = world.emitters.weight_of_hit(world.surfaces, there, hit, surface.position, pdf)
    gathered = dr.select(hit.valid, there.emission * weight + world.direct(there, hit.valid), 0)
    gathered += world.sky.radiance(direction, active & leaves & ~hit.valid)
    gathered = weighted(world, gathered, inside * crossing)
    gathered += world.emitters.light(world.surfaces, surface, numbers[4], mi.Point2f(numbers[5], numbers[6]), active)
    return surface.albedo * gathered


@dr.syntax
def lambert_full(world, surface, numbers, random, active):
    result = mi.Color3f(surface.emission)
    throughput = mi.Color3f(surface.albedo)
    # The weight of the openings that the path crossed. It is kept apart: roulette by it would end most of these paths.
    crossed = mi.Float(1)
    position, facing = mi.Point3f(surface.position), mi.Normal3f(surface.facing)
    normal = mi.Normal3f(surface.normal)
    a, b, choice, e1, e2 = [mi.Float(x) for x in numbers[2:7]]
    bounce = mi.UInt32(0)
    active = mi.Bool(active)
    while active:
        here = Surface(position, facing, normal, throughput, mi.Color3f(0))
        lit = world.direct(here, active)  # throughput stands in albedo's place
        emitted = throughput * world.emitters.light(world.surfaces, here, choice, mi.Point2f(e1, e2), active)
        result += weighted(world, lit + emitted, crossed)

        survival = dr.minimum(dr.max(throughput), LARGEST_SURVIVAL)
        roulette = bounce >= FIRST_ROULETTE
        throughput[roulette] = throughput / dr.maximum(survival, 1e-6)
        active &= ~roulette | (random.next_float32() < survival)

        direction, pdf, leaves, inside, crossing = bounce_direction(world, here, a, b, random)
        throughput = weighted(world, throughput, inside)
        crossed *= crossing
        hit = world.surfaces.meet(leave(here), direction, active & leaves)
        there = world.surfaces.surface(hit, direction)
        weight = world.emitters.weight_of_hit(world.surfaces, there, hit, here.position, pdf)
        result += weighted(world, dr.select(hit.valid, throughput * there.emission * weight, 0), crossed)
        result += weighted(world, throughput * world.sky.radiance(direction, active & leaves & ~hit.valid), crossed)
        throughput *= there.albedo
        position, facing, normal = there.position, there.facing, there.normal
        bounce += 1
        active &= hit.valid & (dr.max(throughput) > 0) & (bounce < MOST_BOUNCES)
        a, b, choice = random.next_float32(), random.next_float32(), random.next_float32()
        e1, e2 = random.next_float32(), random.next_float32()
    return result


def lambert_light_along(world, surface, direction, numbers, random, active):
    """The light that arrives from `direction` after any number of bounces between Lambert surfaces."""
    leaves = active & (dr.dot(surface.facing, direction) > 0)
    hit = world.surfaces.meet(leave(surface), direction, leaves)
    there = world.surfaces.surface(hit, direction)
    fresh = [random.next_float32() for _ in numbers]
    sky = world.sky.radiance(direction, leaves & ~hit.valid)
    return dr.select(hit.valid, lambert_full(world, there, fresh, random, hit.valid), sky)


def full(world, surface, numbers, random, active):
    if not world.surfaces.has_gloss:
        return lambert_full(world, surface, numbers, random, active)
    brdf = brdf_of(surface)
    direction, weight = brdf.sample(numbers[4], numbers[2], numbers[3])
    return (surface.emission + reflected_sun(world, surface, brdf, active) + reflected_punctual(world, surface, brdf, active)
            + weight * lambert_light_along(world, surface, direction, numbers, random, active))


def glossy(world, surface, numbers, random, active):
    if not world.surfaces.has_gloss:
        return mi.Color3f(0)
    brdf = brdf_of(surface)
    direction, weight = brdf.specular_direction(numbers[2], numbers[3])
    return weight * lambert_light_along(world, surface, direction, numbers, random, active & brdf.glossy)


def ao(world, surface, numbers, random, active):
    direction, _, leaves = cosine_direction(surface, numbers[2], numbers[3])
    blocked = world.surfaces.blocked(leave(surface), direction, mi.Float(AO_DISTANCE), active & leaves)
    return dr.select(active & leaves & ~blocked, mi.Color3f(1), 0)


def sun(world, surface, numbers, random, active):
    _, lit = world.sun.disc(world.surfaces, surface, mi.Point2f(numbers[2], numbers[3]), active)
    return surface.emission + world.sun.disc_light(surface, lit) + world.lambert_punctual(surface, active)


def shadow(world, surface, numbers, random, active):
    faces = active & (world.sun.cosine(surface, world.sun.towards) > 0)
    _, lit = world.sun.disc(world.surfaces, surface, mi.Point2f(numbers[2], numbers[3]), faces)
    return dr.select(lit > 0, mi.Color3f(1), 0)


SHOWS_SKY = {"indirect", "full"}  # show the sky behind the scene, as the renderer does
ESTIMATORS = {f.__name__: f for f in (coverage, albedo, direct, indirect, full, glossy, ao, sun, shadow)}
