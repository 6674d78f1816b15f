"""Pictures of the page: PNG in base64, tone-mapped alike where they are compared, within a stated number of bytes."""
from __future__ import annotations

import base64
import io
import math
from collections.abc import Callable
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw, ImageFont

import metrics


def exposure_for(reference: np.ndarray) -> float:
    """Brings the brightest hundredth of a reference's pixels just under white."""
    bright = float(np.percentile(reference.max(axis=2), 99))
    return 0.9 / bright if bright > 1e-6 else 1.0


def png(image: Image.Image, colours: int = 256) -> bytes:
    """With a palette it takes less than half the room."""
    out = io.BytesIO()
    image.quantize(colours, dither=Image.Dither.NONE).save(out, "PNG", optimize=True)
    return out.getvalue()


def picture_png(linear: np.ndarray, exposure: float) -> bytes:
    shown = metrics.srgb_from_linear(np.nan_to_num(linear * exposure))
    return png(Image.fromarray((shown * 255 + 0.5).astype(np.uint8)))


def error_png(picture: np.ndarray, reference: np.ndarray) -> bytes:
    """Black where right, red to yellow where too bright, blue to cyan where too dark.

    Full colour at an error of 100 % of the reference, or of 0.1 where that is darker (the weights of relMSE); the root of
    the error, so that 1 % is still seen.
    """
    error = np.mean((picture - reference) / np.sqrt(reference**2 + metrics.EPSILON), axis=2)
    strength = np.sqrt(np.minimum(np.abs(error), 1.0))
    first, second = np.minimum(2 * strength, 1), np.maximum(2 * strength - 1, 0)
    bright = np.stack([first, second, np.zeros_like(first)], -1)
    shown = np.round(255 * np.where((error > 0)[..., None], bright, bright[..., ::-1])).astype(np.uint8)
    return png(Image.fromarray(shown), 48)


def error_scale_png(height: int = 256) -> bytes:
    """The colours of error_png: a bar with the errors that they stand for beside it, brightest on top."""
    top, bar, room = 8, 18, 58  # pixels
    reference = np.ones((height, bar, 3))
    # The colours go by the root of the error, and so does the bar.
    place = np.linspace(1, -1, height)[:, None, None]
    colours = Image.open(io.BytesIO(error_png(reference + np.sign(place) * place**2 * math.sqrt(1 + metrics.EPSILON), reference)))
    canvas = Image.new("RGB", (bar + room, height + 2 * top), "white")
    canvas.paste(colours.convert("RGB"), (0, top))
    draw, font = ImageDraw.Draw(canvas), ImageFont.load_default(14)
    for percent in (100, 50, 25, 10, 0, -10, -25, -50, -100):
        share = math.copysign(math.sqrt(abs(percent) / 100), percent)
        draw.text((bar + 6, top + (1 - share) * (height - 1) / 2), f"{percent:+d} %" if percent else "0", "black", font, anchor="lm")
    return png(canvas)


def small_png(path: Path, side: int) -> bytes:
    """A picture file, made smaller where it is larger than `side`."""
    with Image.open(path) as image:
        image = image.convert("RGB")
        image.thumbnail((side, side))
        return png(image)


class Album:
    """How many bytes of pictures the page may still take, and how many had no room."""

    def __init__(self, budget: int) -> None:
        self.left = budget
        self.kept = self.refused = 0

    def address(self, make: Callable[[], bytes]) -> str | None:
        """One that holds the picture; None where there is no room."""
        data = "data:image/png;base64," + base64.b64encode(make()).decode() if self.left > 0 else None
        if data is None or len(data) > self.left:
            self.refused += 1
            return None
        self.left -= len(data)
        self.kept += 1
        return data
