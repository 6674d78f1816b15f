"""Sample positions: the first few dimensions of a pixel's samples are low-discrepancy, the rest is PCG32.

Additive recurrence with the generalised golden ratio (M. Roberts 2018, "The Unreasonable Effectiveness of
Quasirandom Sequences"), moved by an offset of each pixel and seed: every point is uniform, so an estimate has no
bias, and two seeds are independent. Fixed point of 32 bits keeps the precision at high sample numbers.
"""
from .engine import mi

DIMENSIONS = 7  # pixel 2, first direction or sun's disc 2, choice of an emitter 1, point on it 2


def steps(dimensions: int) -> list[int]:
    ratio = 2.0
    for _ in range(64):  # the root of x^(d+1) = x + 1
        ratio = (1 + ratio) ** (1 / (dimensions + 1))
    return [round(2 ** 32 * (ratio ** -(i + 1) % 1)) for i in range(dimensions)]


STEPS = steps(DIMENSIONS)


def pixel_offsets(pixel, seed):
    """One 32-bit offset per dimension, of this pixel and seed."""
    offsets = []
    for i in range(0, DIMENSIONS, 2):
        offsets += mi.sample_tea_32(pixel, seed ^ mi.UInt32(0x9E3779B9 * (i + 1) & 0xFFFFFFFF))
    return offsets[:DIMENSIONS]


def point(offsets, sample):
    """The numbers in [0, 1) of a pixel's sample."""
    return [mi.Float((offsets[i] + sample * mi.UInt32(STEPS[i])) >> 8) * 2.0 ** -24 for i in range(DIMENSIONS)]
