"""Pictures of the page: PNG in base64, tone-mapped alike where they are compared, within a stated number of bytes."""
from __future__ import annotations

import base64
import io
from collections.abc import Callable
from pathlib import Path

import numpy as np
from PIL import Image

import metrics

# Steps of the error's colours on each side of 0; few, so that the PNG stays small.
ERROR_STEPS = 24


def exposure_for(reference: np.ndarray) -> float:
    """Brings the brightest hundredth of a reference's pixels just under white."""
    bright = float(np.percentile(reference.max(axis=2), 99))
    return 0.9 / bright if bright > 1e-6 else 1.0


def png(image: Image.Image) -> bytes:
    out = io.BytesIO()
    image.save(out, "PNG", optimize=True)
    return out.getvalue()


def picture_png(linear: np.ndarray, exposure: float, palette: bool) -> bytes:
    """With a palette of 256 colours it takes less than half the room."""
    shown = metrics.srgb_from_linear(np.nan_to_num(linear * exposure))
    image = Image.fromarray((shown * 255 + 0.5).astype(np.uint8))
    return png(image.quantize(256, dither=Image.Dither.NONE) if palette else image)


def error_palette() -> list[int]:
    """The colours of metrics.error_picture, from 100 % too dark to 100 % too bright: 2 ERROR_STEPS + 1 of them."""
    root = np.arange(-ERROR_STEPS, ERROR_STEPS + 1) / ERROR_STEPS
    error = np.repeat((np.sign(root) * root**2)[None, :, None], 3, axis=2)
    return metrics.error_picture(error * np.sqrt(metrics.EPSILON), np.zeros_like(error)).ravel().tolist()


def error_png(picture: np.ndarray, reference: np.ndarray) -> bytes:
    """metrics.error_picture in few colours."""
    error = np.mean((picture - reference) / np.sqrt(reference**2 + metrics.EPSILON), axis=2)
    root = np.sign(error) * np.sqrt(np.minimum(np.abs(error), 1.0))
    image = Image.fromarray((root * ERROR_STEPS + ERROR_STEPS).round().astype(np.uint8), mode="P")
    image.putpalette(error_palette())
    return png(image)


def small_png(path: Path, side: int) -> bytes:
    """A picture file, made smaller where it is larger than `side`."""
    with Image.open(path) as image:
        image = image.convert("RGB")
        image.thumbnail((side, side))
        return png(image)


class Album:
    """The page's pictures by name, and how many bytes of it they may still take."""

    def __init__(self, budget: int) -> None:
        self.left = budget
        self.pictures: dict[str, str] = {}
        self.refused = 0

    def add(self, name: str, make: Callable[[], bytes]) -> bool:
        """Makes the picture where it is not there yet; False where there is no room."""
        if name in self.pictures:
            return True
        if self.left <= 0:
            self.refused += 1
            return False
        data = "data:image/png;base64," + base64.b64encode(make()).decode()
        if len(data) > self.left:
            self.refused += 1
            return False
        self.left -= len(data)
        self.pictures[name] = data
        return True
