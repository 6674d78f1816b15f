"""check_engine.py PANE DARK NO_PANE TOOL: PNG pictures of examples/engine, with its pane, with the lamp off, and without the pane,
and the picture that `vct render` makes of the room. The pane is lit, and by the lamp above all; elsewhere it changes nothing. If
flip_evaluator is installed, as in .venv, the last two are compared by FLIP."""

import struct
import sys
import zlib


def pixels(path):
    """Rows of bytes and the number of bytes per pixel, of a PNG with 8 bits per channel that is not interlaced."""
    with open(path, "rb") as file:
        data = file.read()
    at, stream, header = 8, b"", None
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at : at + 8])
        body = data[at + 8 : at + 8 + length]
        header = struct.unpack(">IIBBBBB", body) if kind == b"IHDR" else header
        stream += body if kind == b"IDAT" else b""
        at += length + 12
    width, height, step = header[0], header[1], {2: 3, 6: 4}[header[3]]
    raw, rows, above = zlib.decompress(stream), [], bytes(width * step)
    for y in range(height):
        begin = y * (width * step + 1)
        row = bytearray(raw[begin + 1 : begin + 1 + width * step])
        for i in range(len(row)):
            a, b, c = (row[i - step], above[i], above[i - step]) if i >= step else (0, above[i], 0)
            distances = [(abs(b - c), a), (abs(a - c), b), (abs(a + b - 2 * c), c)]
            nearest = min(distances, key=lambda pair: pair[0])[1]
            row[i] = (row[i] + (0, a, b, (a + b) // 2, nearest)[raw[begin]]) & 255
        rows.append(bytes(row))
        above = row
    return rows, step


def mean(picture, columns, lines):
    rows, step = picture
    values = [rows[y][step * x + c] for y in lines for x in columns for c in range(3)]
    return sum(values) / len(values)


pane, dark, plain, tool = map(pixels, sys.argv[1:5])
inside, beside = (range(150, 168), range(95, 150)), (range(180, 200), range(95, 150))
assert mean(pane, *inside) > mean(plain, *inside) + 15, "the pane is not lit"
assert mean(pane, *inside) > 1.5 * mean(dark, *inside), "the lamp does not light the pane"
assert abs(mean(pane, *beside) - mean(plain, *beside)) < 0.1, "the pane changes the picture beside it"
try:
    import flip_evaluator
    import numpy
except ImportError:
    sys.exit()
engine, room = (numpy.array([numpy.frombuffer(row, numpy.uint8).reshape(-1, step)[:, :3] for row in rows]) / numpy.float32(255)
                for rows, step in (plain, tool))
flip = flip_evaluator.evaluate(room, engine, "LDR", inputsRGB=True, parameters={"ppd": 67})[1]
assert flip < 0.013, f"FLIP between the example and vct render is {flip:.4f}"
