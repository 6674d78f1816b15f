"""Draws small palette PNGs. They are stored uncompressed, because zlib's output differs between its versions."""
import struct
import zlib


def png(rows, palette):
    """`rows` of palette indices; `palette` of (r, g, b) or (r, g, b, a), sRGB in [0, 255]."""
    height, width = len(rows), len(rows[0])
    raw = b"".join(b"\0" + bytes(row) for row in rows)
    blocks = [raw[i:i + 65535] for i in range(0, len(raw), 65535)]
    stream = b"\x78\x01" + b"".join(
        struct.pack("<BHH", i == len(blocks) - 1, len(b), len(b) ^ 0xFFFF) + b
        for i, b in enumerate(blocks)) + struct.pack(">I", zlib.adler32(raw))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    alpha = bytes(c[3] if len(c) > 3 else 255 for c in palette)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 3, 0, 0, 0))
            + chunk(b"PLTE", bytes(x for c in palette for x in c[:3]))
            + (chunk(b"tRNS", alpha) if alpha.strip(b"\xff") else b"")
            + chunk(b"IDAT", stream) + chunk(b"IEND", b""))


def noise(*key):
    """A fixed pseudo-random number in [0, 255]."""
    return zlib.crc32(struct.pack(f"<{len(key)}i", *key)) >> 24


def bricks(size=128):
    """Eight courses of four bricks, every second course shifted by half a brick."""
    palette = [(188, 180, 168), (158, 82, 62), (170, 92, 68), (146, 74, 58), (178, 104, 78), (134, 70, 60)]
    course, length, mortar = size // 8, size // 4, 2

    def texel(x, y):
        row = y // course
        x = (x + row % 2 * length // 2) % size
        if x % length < mortar or y % course < mortar:
            return 0
        return 1 + noise(x // length, row) % 5

    return png([[texel(x, y) for x in range(size)] for y in range(size)], palette)


def paving(size=128):
    """Two by two slabs in two tones, grained, with dark joints."""
    palette = [(70, 66, 60), (196, 188, 172), (206, 198, 182), (122, 128, 134), (134, 140, 146)]

    def texel(x, y):
        half = size // 2
        if x % half < 2 or y % half < 2:
            return 0
        return 1 + 2 * ((x // half + y // half) % 2) + noise(x // 2, y // 2) % 2

    return png([[texel(x, y) for x in range(size)] for y in range(size)], palette)


def trellis(size=128):
    """Diagonal slats with leaves on them, holes between: alpha is 0 or 255."""
    palette = [(60, 90, 40, 0), (150, 112, 70), (70, 128, 48), (98, 156, 60)]
    leaves = [(noise(i, 1) % size, noise(i, 2) % size, 1 if i % 2 else -1, 2 + i % 2) for i in range(26)]

    def texel(x, y):
        for cx, cy, lean, tone in leaves:
            # Wrapped distance, so that the texture tiles.
            dx = (x - cx + size // 2) % size - size // 2
            dy = (y - cy + size // 2) % size - size // 2
            along, across = dx + lean * dy, dx - lean * dy
            if 3 * along * along + 14 * across * across < 600:
                return tone
        return 1 if (x + y) % 32 < 5 or (x - y) % 32 < 5 else 0

    return png([[texel(x, y) for x in range(size)] for y in range(size)], palette)


def lantern(size=32):
    """A bright pane in a black frame with a cross bar."""
    palette = [(0, 0, 0), (255, 255, 255)]

    def texel(x, y):
        frame = min(x, y, size - 1 - x, size - 1 - y) < 4
        return 0 if frame or abs(2 * x - size + 1) < 3 or abs(2 * y - size + 1) < 3 else 1

    return png([[texel(x, y) for x in range(size)] for y in range(size)], palette)
