"""Reads pictures of skies: Radiance (.hdr) and OpenEXR files, equirectangular, of linear radiance."""
import pathlib

import numpy as np

from files import Failed

from .exr import read_exr


def read_sky(path: pathlib.Path) -> np.ndarray:
    try:
        picture = read_radiance(path) if path.suffix == ".hdr" else read_exr(path)
    except (Failed, RuntimeError) as error:
        raise Failed(f"{path} is not a picture of a sky: {error}") from error
    if picture.shape[1] != 2 * picture.shape[0] or not np.isfinite(picture).all() or picture.min() < 0:
        raise Failed(f"{path} is not a picture of a sky: it must be twice as wide as high, and nowhere negative or infinite")
    return picture


def read_radiance(path: pathlib.Path) -> np.ndarray:
    from .engine import mi  # here, because loading Mitsuba takes seconds
    bitmap = mi.Bitmap(str(path)).convert(mi.Bitmap.PixelFormat.RGB, mi.Struct.Type.Float32, srgb_gamma=False)
    return np.array(bitmap, np.float64)
