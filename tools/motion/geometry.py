"""Where the surface points of one frame are in another one, by the true geometry. Pure computations, no renderer.

Positions are in a space in which the scene is about as large as 1; x and y are in pixels from the upper left corner of
the picture, so that the first pixel's centre is at 0.5.
"""
from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

# Two points are of one surface where one lies as near to the other's tangent plane as this share of a pixel there, and
# where their normals differ by no more than the angle: neighbours on a ball of a few dozen pixels do.
PLANE_PIXELS = 0.25
SAME_NORMAL = math.cos(math.radians(15))


@dataclass(frozen=True)
class View:
    """A camera without roll."""

    eye: np.ndarray
    axes: np.ndarray  # rows: right, up, back
    vertical_fov_rad: float
    size: tuple[int, int]  # width, height

    @property
    def pixel(self) -> float:
        """Of a surface at distance 1 that faces the camera, in the middle of the picture."""
        return 2 * math.tan(0.5 * self.vertical_fov_rad) / self.size[1]

    def directions(self) -> np.ndarray:
        """(height, width, 3): through the pixels' centres, of length 1 along the view."""
        x, y = np.arange(self.size[0]) + 0.5, np.arange(self.size[1]) + 0.5
        right, up, back = self.axes
        across, down = (x - self.size[0] / 2) * self.pixel, (self.size[1] / 2 - y) * self.pixel
        return across[None, :, None] * right + down[:, None, None] * up - back

    def project(self, points: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """x, y and the distance along the view; what lies behind the camera has none above 0."""
        across, down, back = np.moveaxis((points - self.eye) @ self.axes.T, -1, 0)
        depth = np.where(back < 0, -back, np.nan)
        return (self.size[0] / 2 + across / depth / self.pixel, self.size[1] / 2 - down / depth / self.pixel,
                np.nan_to_num(depth))


@dataclass(frozen=True)
class Seen:
    """What a view's rays through the pixels' centres meet, each (height, width, ...)."""

    view: View
    position: np.ndarray
    normal: np.ndarray  # unit
    valid: np.ndarray


@dataclass(frozen=True)
class Carried:
    """Pixels of a frame and where their points are in another one: the upper left of four pixels, and the share of the
    way to the next across and down."""

    mask: np.ndarray  # (height, width): the pixels that could be carried
    row: np.ndarray
    column: np.ndarray
    down: np.ndarray
    across: np.ndarray


def carry(new: Seen, old: Seen) -> Carried:
    """The points that `new` sees, in `old`: those in the picture whose four pixels all lie on the same surface, so that
    nothing hides them and no edge runs between."""
    width, height = old.view.size
    x, y, depth = old.view.project(new.position)
    with np.errstate(invalid="ignore"):
        inside = new.valid & (depth > 0) & (x >= 0.5) & (x < width - 0.5) & (y >= 0.5) & (y < height - 0.5)
    x, y = np.where(inside, x, 0.5) - 0.5, np.where(inside, y, 0.5) - 0.5
    column = np.minimum(np.floor(x).astype(int), width - 2)
    row = np.minimum(np.floor(y).astype(int), height - 2)
    near = PLANE_PIXELS * old.view.pixel * depth
    mask = inside.copy()
    for i, j in ((0, 0), (0, 1), (1, 0), (1, 1)):
        position, normal = old.position[row + i, column + j], old.normal[row + i, column + j]
        mask &= old.valid[row + i, column + j]
        mask &= np.abs(((position - new.position) * new.normal).sum(-1)) <= near
        mask &= (normal * new.normal).sum(-1) >= SAME_NORMAL
    return Carried(mask, row[mask], column[mask], (y - row)[mask], (x - column)[mask])


def sampled(image: np.ndarray, carried: Carried) -> np.ndarray:
    """(points, channels): the other frame's values where the points are in it, bilinearly."""
    row, column, down, across = carried.row, carried.column, carried.down[:, None], carried.across[:, None]
    above = image[row, column] * (1 - across) + image[row, column + 1] * across
    below = image[row + 1, column] * (1 - across) + image[row + 1, column + 1] * across
    return above * (1 - down) + below * down


def relative_change(new: np.ndarray, old: np.ndarray, mean: float) -> np.ndarray:
    """(points,): the length of the difference of two colours over the mean of theirs and a tenth of the picture's mean.

    The mean of both, so that a point which goes dark counts as one that lights up, and by 2 at most.
    """
    scale = 0.5 * (np.linalg.norm(new, axis=-1) + np.linalg.norm(old, axis=-1)) + 0.1 * mean
    return np.divide(np.linalg.norm(new - old, axis=-1), scale, out=np.zeros(len(new)), where=scale > 0)


def field(seen: Seen) -> np.ndarray:
    """Light that is known not to change: a smooth function of position and normal, (height, width, 3).

    A wave is a quarter of the scene long and swings by half of the mean.
    """
    wave = np.sin(2 * math.pi * 4 * seen.position + np.array([0.3, 1.1, 2.3])).mean(-1, keepdims=True)
    turned = seen.normal @ np.array([0.5, 0.7, 0.3])[:, None]
    tints = np.array([1.0, 0.8, 0.6])
    return np.where(seen.valid[..., None], (1 + 0.5 * wave + 0.2 * turned) * tints, 0)


def turn(view: View, angle: float) -> View:
    """About the vertical, which keeps the picture level."""
    c, s = math.cos(angle), math.sin(angle)
    return replace(view, axes=view.axes @ np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]]).T)


MOVES: dict[str, Callable[[View, float], View]] = {
    "sideways": lambda view, amount: replace(view, eye=view.eye + amount * view.axes[0]),
    "forward": lambda view, amount: replace(view, eye=view.eye - amount * view.axes[2]),
    "turning": turn,
}


def amount_for(move: Callable[[View, float], View], seen: Seen, pixels: float) -> float:
    """How far one frame moves, so that what is seen is displaced by so many pixels in the mean over the picture."""
    small = 1e-3 * seen.view.pixel
    x, y, _ = seen.view.project(seen.position[seen.valid])
    moved_x, moved_y, depth = move(seen.view, small).project(seen.position[seen.valid])
    distance = np.hypot(moved_x - x, moved_y - y)[depth > 0]
    return small * pixels / float(distance.mean())
