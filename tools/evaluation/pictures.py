"""PNGs of linear pictures: shown, compared, and beside each other."""
import io
from collections.abc import Sequence

import numpy as np
from PIL import Image, ImageDraw, ImageFont

import metrics
from files import ROOT
from tables import fraction, milliseconds, percent
from truth.exr import read_exr

from .measures import averaged_down, voxels
from .store import Result, Store

CELL, GAP, TEXT, HEAD = 512, 16, 84, 40  # of a sheet, in its pixels; small pictures are enlarged to CELL


def png(image: Image.Image) -> bytes:
    out = io.BytesIO()
    image.save(out, "PNG", optimize=True)
    return out.getvalue()


def shown(linear: np.ndarray, exposure: float | None) -> Image.Image:
    return Image.fromarray((metrics.displayed(linear, exposure) * 255 + 0.5).astype(np.uint8))


def error_image(picture: np.ndarray, reference: np.ndarray) -> Image.Image:
    """Black where right, red to yellow where too bright, blue to cyan where too dark.

    Full colour at an error of 100 % of the reference, or of 0.1 where that is darker (the weights of relMSE). The colour follows
    the root of the error, so that 1 % is still visible.
    """
    error = np.mean((picture - reference) / np.sqrt(reference**2 + metrics.EPSILON), axis=2)
    strength = np.sqrt(np.minimum(np.abs(error), 1.0))
    first, second = np.minimum(2 * strength, 1), np.maximum(2 * strength - 1, 0)
    bright = np.stack([first, second, np.zeros_like(first)], -1)
    return Image.fromarray(np.round(255 * np.where((error > 0)[..., None], bright, bright[..., ::-1])).astype(np.uint8))


def captions(result: Result) -> list[str]:
    errors = result["camera"]["errors"]["gi"]
    camera, changing = (milliseconds(result[state]["ms"]["gi"]) for state in ("camera", "changing"))
    return [f"{camera}, camera moving; {changing}, all changing",
            f"relMSE {fraction(errors['relmse'], 4)}   bias {percent(errors['bias'])}   FLIP {fraction(errors['flip'], 2)}"]


def sheet(store: Store, results: Sequence[Result], errors: bool = False) -> Image.Image:
    """One scene: each preset's picture and path tracing as FLIP compares them; with `errors` the errors below."""
    own = store.folder / results[0]["reference"]
    reference = averaged_down(read_exr(own if own.is_file() else ROOT / results[0]["reference"]), results[0]["size"])
    exposure = results[0].get("exposure")
    cells = [(f"{one['preset']}, {voxels(one)}".replace("³", "^3"),  # which the font lacks
              read_exr(store.pictures_of(one) / "gi.exr"), captions(one)) for one in results]
    cells.append(("path traced", reference, [f"{results[0]['scene']}: all bounces of light", "by Mitsuba 3"]))
    width, height = (side * max(1, CELL // results[0]["size"][0]) for side in results[0]["size"])
    canvas = Image.new("RGB", ((width + GAP) * len(cells) + GAP, HEAD + (height + TEXT) * (2 if errors else 1)), "white")
    draw, large, small = ImageDraw.Draw(canvas), ImageFont.load_default(26), ImageFont.load_default(18)

    def paste(image: Image.Image, x: int, y: int, lines: Sequence[str]) -> None:
        canvas.paste(image.resize((width, height), Image.Resampling.NEAREST), (x, y))
        for number, text in enumerate(lines):
            draw.text((x, y + height + 8 + 26 * number), text, "black", small)
    for column, (name, picture, lines) in enumerate(cells):
        x = GAP + column * (width + GAP)
        draw.text((x, 6), name, "black", large)
        paste(shown(picture, exposure), x, HEAD, lines)
        if errors and picture is not reference:
            paste(error_image(picture, reference), x, HEAD + height + TEXT, ["too bright: red, yellow; too dark: blue, cyan"])
    return canvas


def sheets(store: Store, results: Sequence[Result], errors: bool = False) -> dict[str, Image.Image]:
    scenes = dict.fromkeys(one["scene"] for one in results)
    return {scene: sheet(store, [one for one in results if one["scene"] == scene], errors) for scene in scenes}


def stacked(parts: Sequence[Image.Image]) -> bytes:
    """A PNG of the images below each other."""
    canvas = Image.new("RGB", (max(part.width for part in parts), sum(part.height for part in parts)), "white")
    for number, part in enumerate(parts):
        canvas.paste(part, (0, sum(before.height for before in parts[:number])))
    return png(canvas)
