"""Which point of a floor a pixel shows, and closed forms for what that point sees."""
from __future__ import annotations

import math

import numpy as np

from scenes.hard_cases import View


def floor_points(view: View, size: int, y: float = 0.0) -> tuple[np.ndarray, np.ndarray]:
    """x and z where each pixel's ray meets the plane at height y; nan where it does not."""
    eye, target = np.array(view.eye, float), np.array(view.target, float)
    forward = (target - eye) / np.linalg.norm(target - eye)
    right = np.cross(forward, (0.0, 1.0, 0.0))
    right /= np.linalg.norm(right)
    up = np.cross(right, forward)
    ndc = (np.arange(size) + 0.5) / size * 2 - 1
    reach = math.tan(math.radians(view.fov_deg) / 2)
    rays = forward + reach * (ndc[None, :, None] * right - ndc[:, None, None] * up)
    with np.errstate(divide="ignore", invalid="ignore"):
        t = (y - eye[1]) / rays[..., 1]
        t[t <= 0] = np.nan
    return eye[0] + t * rays[..., 0], eye[2] + t * rays[..., 2]


def on_floor(image: np.ndarray, view: View, x: tuple[float, float], z: float, y: float = 0.0) -> np.ndarray:
    """The pixels of a picture that show the floor between x[0] and x[1], and no further than z from the middle."""
    at_x, at_z = floor_points(view, len(image), y)
    return image[(at_x > x[0]) & (at_x < x[1]) & (np.abs(at_z) < z)]


def openness_beside_wall(distance: float, reach: float) -> float:
    """Cosine-weighted share of the hemisphere that a tall, wide wall at `distance` leaves open within `reach`.

    By Nusselt's analogue: directions that meet the wall within the reach project to the part x > distance / reach
    of the unit disc.
    """
    c = min(distance / reach, 1.0)
    return 1.0 - (math.acos(c) - c * math.sqrt(1.0 - c * c)) / math.pi


def openness_under_ceiling(height: float, reach: float) -> float:
    """The same under an endless ceiling: a ray at angle t meets it after height / cos t."""
    return min((height / reach) ** 2, 1.0)


def rectangle_form_factor(half_side: float, height: float) -> float:
    """From a floor element to the square centred above it (Howell, catalogue of view factors, B-3; four corners)."""
    a = half_side / height
    root = math.sqrt(1.0 + a * a)
    return 4.0 / math.pi * (a / root) * math.atan(a / root)
