"""Files of skies: Radiance pictures and OpenEXR files, equirectangular, of linear radiance."""
import pathlib

import numpy as np

from .exr import PictureError, read_exr


class SkyError(Exception):
    """A picture that is no sky; the message names it and the cause."""


def decode_row(data: bytes, at: int, width: int) -> tuple[np.ndarray, int]:
    """(width, 4) bytes of a run-length encoded row, and where the next one begins."""
    row, at = np.empty((4, width), np.uint8), at + 4
    for plane in row:
        x = 0
        while x < width:
            code, at = data[at], at + 1
            count, step = (code - 128, 1) if code > 128 else (code, code)
            if count == 0 or x + count > width:
                raise ValueError("a damaged row")
            plane[x:x + count] = np.frombuffer(data[at:at + step], np.uint8)
            x, at = x + count, at + step
    return row.T, at


def read_radiance(data: bytes) -> np.ndarray:
    """(height, width, 3) of a Radiance picture."""
    header, rest = data.split(b"\n\n", 1)
    size, body = rest.split(b"\n", 1)
    words = size.split()
    if not header.startswith(b"#?") or (words[0], words[2]) != (b"-Y", b"+X"):
        raise ValueError("not a Radiance picture of the usual orientation")
    height, width = int(words[1]), int(words[3])
    if width >= 8 and body[:2] == b"\2\2" and body[2] < 128:
        rows, at = [], 0
        for _ in range(height):
            row, at = decode_row(body, at, width)
            rows.append(row)
        codes = np.stack(rows)
    else:
        codes = np.frombuffer(body[:4 * width * height], np.uint8).reshape(height, width, 4)
    scale = np.where(codes[..., 3] > 0, np.ldexp(1.0, codes[..., 3].astype(np.int32) - 136), 0.0)
    return codes[..., :3] * scale[..., None]


def read_sky(path: pathlib.Path) -> np.ndarray:
    try:
        picture = read_radiance(path.read_bytes()) if path.suffix == ".hdr" else read_exr(path)
    except (OSError, ValueError, IndexError, PictureError) as error:
        raise SkyError(f"{path}: not a picture of a sky: {error}") from error
    if picture.shape[1] != 2 * picture.shape[0] or not np.isfinite(picture).all() or picture.min() < 0:
        raise SkyError(f"{path}: a sky is twice as wide as high, and nowhere negative or infinite")
    return picture
