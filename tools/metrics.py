"""The error of a picture against a reference, both linear RGB.

relmse    mean of (x - r)^2 / (r^2 + 0.01)
bias      mean(x) / mean(r) - 1; none where the reference is black
rmse      root of the mean of (x - r)^2: for values, such as occlusion and shadow
p999      99.9th percentile of |x - r|
sparks    pixels more than twice as bright as anything in the 5x5 around them in the reference: neither a mean nor FLIP
          sees a line one pixel wide
flip      mean FLIP of the two as sRGB pictures, 67 pixels per degree
hdr_flip  mean HDR-FLIP, in exposures that are fixed per scene (reference.json) or follow from the reference

`at_noise_floor`: the picture cannot be told from a perfect one by this reference. A perfect picture's relMSE is the
reference's own noise; one whose error is smaller than that noise stays below twice of it.
"""
import math

import flip_evaluator
import numpy as np

from truth.exr import PictureError

EPSILON = 0.01  # of relMSE
PIXELS_PER_DEGREE = 67
LUMINANCE = np.array([0.2126, 0.7152, 0.0722])  # ITU-R BT.709
SPARK, DARKEST_SPARK = 2.0, 0.01  # times as bright; what is darker than that luminance counts as so bright


def srgb_from_linear(x: np.ndarray) -> np.ndarray:
    """IEC 61966-2-1; clipped to 0..1."""
    x = np.clip(x, 0.0, 1.0)
    return np.where(x <= 0.0031308, 12.92 * x, 1.055 * np.power(x, 1 / 2.4) - 0.055)


def relmse(image: np.ndarray, reference: np.ndarray) -> float:
    return float(np.mean((image - reference) ** 2 / (reference ** 2 + EPSILON)))


def noise_of_halves(a: np.ndarray, b: np.ndarray) -> float:
    """relMSE of the mean of two independent halves: that mean's variance is that of half their difference."""
    mean = 0.5 * (a + b)
    return float(np.mean((0.5 * (a - b)) ** 2 / (mean ** 2 + EPSILON)))


def automatic_exposures(reference: np.ndarray) -> dict:
    """HDR-FLIP's own choice (Andersson et al. 2021, eq. 2 and 3), rounded to quarter stops, over pixels with light.

    From the brightest pixel to the median one at 85 % of the ACES curve's range: x is where
    (a x^2 + b x) / (d x^2 + e x + f) = 0.85.
    """
    a, b, d, e, f = 0.6 * 0.6 * 2.51, 0.6 * 0.03, 0.6 * 0.6 * 2.43, 0.6 * 0.59, 0.14
    p, q, r = a - 0.85 * d, b - 0.85 * e, -0.85 * f
    x = (-q + math.sqrt(q * q - 4 * p * r)) / (2 * p)
    luminance = np.asarray(reference, np.float64) @ LUMINANCE
    lit = luminance[luminance > 1e-4]
    if lit.size == 0:
        return {"start": 0.0, "stop": 1.0, "count": 2}
    start, stop = (round(4 * math.log2(x / y)) / 4 for y in (lit.max(), np.median(lit)))
    return {"start": start, "stop": stop, "count": max(2, math.ceil(stop - start))}


def check(image: np.ndarray, reference: np.ndarray) -> None:
    if image.shape != reference.shape:
        raise PictureError("the picture is {1}x{0} and the reference {3}x{2} pixels: they must be the same".format(
            *image.shape[:2], *reference.shape[:2]))
    for name, picture in (("picture", image), ("reference", reference)):
        bad = np.argwhere(~np.isfinite(picture).all(-1))
        if len(bad):
            y, x = bad[0]
            raise PictureError(f"the {name} is not finite in {len(bad)} pixels, the first at x={x}, y={y}")


def sparks(image: np.ndarray, reference: np.ndarray) -> np.ndarray:
    """(height, width): true where a pixel outshines all that is near it in the reference."""
    light = np.pad(reference @ LUMINANCE, 2, mode="edge")
    brightest = np.lib.stride_tricks.sliding_window_view(light, (5, 5)).max((-1, -2))
    return image @ LUMINANCE > SPARK * np.maximum(brightest, DARKEST_SPARK)


def flip_map(image: np.ndarray, reference: np.ndarray) -> np.ndarray:
    """FLIP per pixel, (height, width), 0 to 1."""
    return _flip(srgb_from_linear(image), srgb_from_linear(reference), "LDR")


def hdr_flip_map(image: np.ndarray, reference: np.ndarray, exposures: dict) -> np.ndarray:
    """HDR-FLIP per pixel, (height, width), 0 to 1."""
    return _flip(np.maximum(image, 0), np.maximum(reference, 0), "HDR", startExposure=exposures["start"],
                 stopExposure=exposures["stop"], numExposures=exposures["count"], tonemapper="ACES")


def _flip(image: np.ndarray, reference: np.ndarray, kind: str, **parameters: object) -> np.ndarray:
    pair = [np.ascontiguousarray(picture, np.float32) for picture in (reference, image)]
    found = flip_evaluator.evaluate(*pair, kind, applyMagma=False, parameters={"ppd": PIXELS_PER_DEGREE, **parameters})[0]
    return found.reshape(image.shape[:2])


def compare(image: np.ndarray, reference: np.ndarray, exposures: dict | None = None,
            noise_relmse: float | None = None, mask: np.ndarray | None = None, flip: bool = True) -> dict:
    """All metrics of the module's description. `exposures`: {"start", "stop", "count"} in stops.

    `mask`: (height, width), true where pixels count. `flip=False` leaves out the two slow ones.
    """
    image, reference = np.asarray(image, np.float64), np.asarray(reference, np.float64)
    check(image, reference)
    chosen = np.ones(image.shape[:2], bool) if mask is None else np.asarray(mask, bool)
    if chosen.shape != image.shape[:2]:
        raise PictureError("the mask does not have the picture's size")
    if not chosen.any():
        raise PictureError("the mask leaves no pixel")
    x, r = image[chosen], reference[chosen]
    mean = float(r.mean())
    result = {"relmse": relmse(x, r), "bias": float(x.mean()) / mean - 1 if mean > 0 else None,
              "rmse": float(np.sqrt(np.mean((x - r) ** 2))), "p999": float(np.percentile(np.abs(x - r), 99.9)),
              "sparks": int(sparks(image, reference)[chosen].sum())}
    if flip:
        exposures = exposures or automatic_exposures(reference)
        low, high = flip_map(image, reference), hdr_flip_map(image, reference, exposures)
        result |= {"flip": float(low[chosen].mean(dtype=np.float64)),
                   "hdr_flip": float(high[chosen].mean(dtype=np.float64)), "exposures": exposures}
    if noise_relmse is not None:
        result |= {"noise_relmse": noise_relmse, "at_noise_floor": result["relmse"] <= 2 * noise_relmse}
    return result
