"""Reads and writes OpenEXR pictures as float32 arrays (height, width, 3): linear RGB, the first row at the top."""
import os
import pathlib

import numpy as np
import OpenEXR

from files import Failed


def read_exr(path: pathlib.Path | str) -> np.ndarray:
    """Channels R, G, B, or Y three times; half or float."""
    if not os.path.isfile(path):
        raise Failed(f"{path}: no such file")
    try:
        with OpenEXR.File(str(path), separate_channels=True) as file:
            planes = {name: channel.pixels for name, channel in file.channels().items()}
    except Exception as error:  # the binding throws RuntimeError, TypeError and ValueError
        raise Failed(f"{path}: not a readable EXR ({error})") from error
    names = "RGB" if all(c in planes for c in "RGB") else "YYY"
    if not all(c in planes for c in names):
        raise Failed(f"{path}: has neither the channels R, G and B nor Y")
    return np.stack([planes[c] for c in names], -1).astype(np.float32)


def write_exr(path: pathlib.Path | str, image: np.ndarray, kind: type = np.float16) -> None:
    """ZIP. The file is written beside its place and renamed, so a stopped run leaves no half file. `kind`: of the numbers."""
    values = np.ascontiguousarray(np.clip(image, -65504, 65504), kind)
    header = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}
    beside = f"{path}.tmp"
    with OpenEXR.File(header, {c: np.ascontiguousarray(values[..., i]) for i, c in enumerate("RGB")}) as file:
        file.write(beside)
    os.replace(beside, path)
