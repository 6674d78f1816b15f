"""Writes skies as Radiance pictures (.hdr), equirectangular: the centre is towards +X, the top +Y, right of the centre +Z."""
import math
import struct


def rgbe(color):
    """Three mantissas of 8 bits and the exponent of the largest."""
    largest = max(color)
    if largest < 1e-32:
        return bytes(4)
    exponent = math.frexp(largest)[1]
    return struct.pack("4B", *(int(c * 2.0 ** (8 - exponent)) for c in color), exponent + 128)


def picture(width, radiance):
    """`radiance`: a function of the direction x, y, z that returns red, green and blue."""
    height = width // 2
    pixels = bytearray()
    for row in range(height):
        polar = math.pi * (row + 0.5) / height
        for column in range(width):
            azimuth = math.pi * (2 * (column + 0.5) / width - 1)
            x, y, z = math.sin(polar) * math.cos(azimuth), math.cos(polar), math.sin(polar) * math.sin(azimuth)
            pixels += rgbe(radiance(x, y, z))
    return f"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {height} +X {width}\n".encode() + bytes(pixels)
