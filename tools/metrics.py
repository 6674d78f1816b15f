"""The error of a picture against a reference, both linear RGB.

relmse  mean of (x - r)^2 / (r^2 + 0.01)
bias    mean(x) / mean(r) - 1; none where the reference is black
rmse    root of the mean of (x - r)^2: for shares, such as occlusion and shadow
flip    mean FLIP of the two as sRGB pictures, 67 pixels per degree: how different they look to a person who flips between them
"""
import flip_evaluator
import numpy as np

from truth.exr import PictureError

EPSILON = 0.01  # of relMSE
PIXELS_PER_DEGREE = 67


def srgb_from_linear(x: np.ndarray) -> np.ndarray:
    """IEC 61966-2-1; clipped to 0..1."""
    x = np.clip(x, 0.0, 1.0)
    return np.where(x <= 0.0031308, 12.92 * x, 1.055 * np.power(x, 1 / 2.4) - 0.055)


def relmse(image: np.ndarray, reference: np.ndarray) -> float:
    return float(np.mean((image - reference) ** 2 / (reference ** 2 + EPSILON)))


def noise_of_halves(a: np.ndarray, b: np.ndarray) -> float:
    """relMSE of the mean of two independent halves: the variance of that mean is the variance of half their difference."""
    mean = 0.5 * (a + b)
    return float(np.mean((0.5 * (a - b)) ** 2 / (mean ** 2 + EPSILON)))


def check(image: np.ndarray, reference: np.ndarray) -> None:
    if image.shape != reference.shape:
        raise PictureError("the picture is {1}x{0} and the reference {3}x{2} pixels: they must be the same".format(
            *image.shape[:2], *reference.shape[:2]))
    for name, picture in (("picture", image), ("reference", reference)):
        bad = np.argwhere(~np.isfinite(picture).all(-1))
        if len(bad):
            y, x = bad[0]
            raise PictureError(f"the {name} is not finite in {len(bad)} pixels, the first at x={x}, y={y}")


def flip_mean(image: np.ndarray, reference: np.ndarray) -> float:
    pair = [np.ascontiguousarray(srgb_from_linear(picture), np.float32) for picture in (reference, image)]
    found = flip_evaluator.evaluate(*pair, "LDR", applyMagma=False, parameters={"ppd": PIXELS_PER_DEGREE})[0]
    return float(found.mean(dtype=np.float64))


def compare(image: np.ndarray, reference: np.ndarray, flip: bool = True) -> dict:
    """All metrics of the module's description; `flip=False` leaves out the slow one."""
    image, reference = np.asarray(image, np.float64), np.asarray(reference, np.float64)
    check(image, reference)
    mean = float(reference.mean())
    result = {"relmse": relmse(image, reference), "bias": float(image.mean()) / mean - 1 if mean > 0 else None,
              "rmse": float(np.sqrt(np.mean((image - reference) ** 2)))}
    return result | ({"flip": flip_mean(image, reference)} if flip else {})
