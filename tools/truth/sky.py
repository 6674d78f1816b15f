"""Light from a picture of the sky, everywhere outside the scene (convention: jni/engine/environment.h)."""
import math

import numpy as np

from .engine import dr, mi


class Sky:
    """The sky is black where there is no picture."""

    def __init__(self, picture: np.ndarray | None):
        self.any = picture is not None
        if not self.any:
            return
        self._height, self._width = picture.shape[:2]
        self._pixels = mi.Color3f(np.ascontiguousarray(picture.reshape(-1, 3).T.astype(np.float32)))

    def radiance(self, direction, active):
        """Bilinear, for directions of unit length; wraps around the picture's sides, but not over its poles."""
        if not self.any:
            return mi.Color3f(0)
        x = (0.5 + dr.atan2(direction.z, direction.x) / (2 * math.pi)) * self._width - 0.5
        y = dr.safe_acos(direction.y) / math.pi * self._height - 0.5
        left, top = dr.floor(x), dr.floor(y)
        result = mi.Color3f(0)
        for i in (0, 1):
            for j in (0, 1):
                column = (mi.Int32(left) + i + self._width) % self._width
                row = dr.clip(mi.Int32(top) + j, 0, self._height - 1)
                weight = (x - left if i else 1 - x + left) * (y - top if j else 1 - y + top)
                result += weight * dr.gather(mi.Color3f, self._pixels, mi.UInt32(row * self._width + column), active)
        return dr.select(active, result, 0)
