"""Every hard case, in the order of the truth's list."""

from . import cones, light, limits, objects, scale, triangles, walls

CASES = [*triangles.CASES, *walls.CASES, *objects.CASES, *light.CASES, *cones.CASES, *scale.CASES, *limits.CASES]
ORDER_MATTERS = [*triangles.CASES, *objects.CASES]  # shuffled in a quick run too
