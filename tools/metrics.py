"""The error of a picture against a reference, both linear RGB.

relmse  mean of (x - r)^2 / (r^2 + 0.01)
bias    mean(x) / mean(r) - 1; none where the reference is black
rmse    root of the mean of (x - r)^2: for shares, such as occlusion and shadow
flip    mean FLIP of the two pictures as they are displayed, 67 pixels per degree: how different they look to a person who flips
        between them
"""
from types import EllipsisType

import flip_evaluator
import numpy as np

from files import Failed

EPSILON = 0.01  # of relMSE
PIXELS_PER_DEGREE = 67
Pixels = np.ndarray | EllipsisType  # those that count, as a mask (height, width); `...` is all


def srgb_from_linear(x: np.ndarray) -> np.ndarray:
    """IEC 61966-2-1; clipped to 0..1."""
    x = np.clip(x, 0.0, 1.0)
    return np.where(x <= 0.0031308, 12.92 * x, 1.055 * np.power(x, 1 / 2.4) - 0.055)


def neutral(linear: np.ndarray) -> np.ndarray:
    """The tone mapping of shaders/shared/tone_map.h, from linear radiance to linear 0 to 1."""
    linear = np.clip(np.nan_to_num(linear), 0, 1e30)
    reflected, desaturation = 0.04, 0.15
    compressed_from = 0.8 - reflected
    least = linear.min(axis=2, keepdims=True)
    color = linear - np.where(least < 2 * reflected, least - 6.25 * least**2, reflected)
    peak = np.maximum(color.max(axis=2, keepdims=True), 1e-9)
    room = 1 - compressed_from
    compressed = 1 - room**2 / (np.maximum(peak, compressed_from) + room - compressed_from)
    colored = 1 / (desaturation * (peak - compressed) + 1)
    bright = compressed + (color * (compressed / peak) - compressed) * colored
    return np.where(peak <= compressed_from, color, bright)


def displayed(linear: np.ndarray, exposure: float | None) -> np.ndarray:
    """The sRGB picture, 0 to 1, that `vct render` writes at this exposure; without one, light as it is, up to 1."""
    return srgb_from_linear(np.nan_to_num(linear) if exposure is None else neutral(linear * exposure))


def automatic_exposure(radiance: np.ndarray) -> float:
    """The exposure that `vct render --exposure auto` takes (jni/image/tone_map.h): the geometric mean of the luminance becomes
    middle grey, and two digits are kept. `radiance`: (..., 3)."""
    luminance = radiance.astype(np.float64) @ (0.2126, 0.7152, 0.0722)
    luminance = np.sort(luminance[(luminance > 0) & np.isfinite(luminance)])
    if not len(luminance):
        return 1.0
    bright = luminance[int(0.99 * (len(luminance) - 1))]
    mean = np.exp(np.log(luminance[luminance > 1e-3 * bright]).mean())
    return float(f"{0.18 / mean:.1e}")


def relmse(image: np.ndarray, reference: np.ndarray) -> float:
    return float(np.mean((image - reference) ** 2 / (reference ** 2 + EPSILON)))


def noise_of_halves(a: np.ndarray, b: np.ndarray) -> float:
    """relMSE of the mean of two independent halves: the variance of that mean is the variance of half their difference."""
    mean = 0.5 * (a + b)
    return float(np.mean((0.5 * (a - b)) ** 2 / (mean ** 2 + EPSILON)))


def check(image: np.ndarray, reference: np.ndarray) -> None:
    if image.shape != reference.shape:
        raise Failed("the picture is {1}x{0} and the reference {3}x{2} pixels: they must be the same".format(
            *image.shape[:2], *reference.shape[:2]))
    for name, picture in (("picture", image), ("reference", reference)):
        bad = np.argwhere(~np.isfinite(picture).all(-1))
        if len(bad):
            y, x = bad[0]
            raise Failed(f"the {name} is not finite in {len(bad)} pixels, the first at x={x}, y={y}")


def flip_mean(image: np.ndarray, reference: np.ndarray, pixels: Pixels, exposure: float | None) -> float:
    pair = [np.ascontiguousarray(displayed(picture, exposure), np.float32) for picture in (reference, image)]
    found = flip_evaluator.evaluate(*pair, "LDR", applyMagma=False, parameters={"ppd": PIXELS_PER_DEGREE})[0]
    return float(found[pixels].mean(dtype=np.float64))


def compare(image: np.ndarray, reference: np.ndarray, flip: bool = True, pixels: Pixels = ...,
            exposure: float | None = None) -> dict:
    """All metrics of the module's description, as means over `pixels`; FLIP is that of the `displayed` pictures.
    `flip=False` leaves out the slow one."""
    image, reference = np.asarray(image, np.float64), np.asarray(reference, np.float64)
    check(image, reference)
    seen, right = image[pixels], reference[pixels]
    mean = float(right.mean())
    result = {"relmse": relmse(seen, right), "bias": float(seen.mean()) / mean - 1 if mean > 0 else None,
              "rmse": float(np.sqrt(np.mean((seen - right) ** 2)))}
    return result | ({"flip": flip_mean(image, reference, pixels, exposure)} if flip else {})
