"""What the rays through the pixels' centres meet, as arrays: the true positions and normals behind a picture."""
import numpy as np

from .engine import mi
from .scene import Scene
from .surfaces import Surfaces, unit_vector


class TrueGeometry:
    """Of one scene; loads it once for many views."""

    def __init__(self, scene: Scene) -> None:
        self.surfaces = Surfaces(scene)

    def __call__(self, eye: np.ndarray, directions: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Positions and interpolated normals (height, width, 3), in trace space, and where there are any (height, width).

        `directions`: (height, width, 3), of any length. Backs of single-sided triangles are looked through, as by the camera.
        """
        shape = directions.shape
        along = unit_vector(mi.Vector3f(np.ascontiguousarray(directions.reshape(-1, 3).T.astype(np.float32))))
        # The eye as an array too: as a number it would be part of the program, which each new view would compile again.
        start = mi.Point3f(np.ascontiguousarray(np.broadcast_to(eye[:, None], (3, shape[0] * shape[1])).astype(np.float32)))
        hit = self.surfaces.meet(start, along, mi.Bool(True), camera=True)
        found = self.surfaces.surface(hit, along)
        position, normal = (np.array(v, np.float64).T.reshape(shape) for v in (found.position, found.normal))
        return position, normal, np.array(hit.valid, bool).reshape(shape[:2])
