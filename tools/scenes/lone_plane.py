"""One lit plane and nothing else: a surface does not light itself, so the indirect light on it is exactly 0."""
import math

from . import shapes
from .glb import Glb


def build():
    glb = Glb("tools/make_assets.py")
    white = glb.material("white", (0.8, 0.8, 0.8))
    glb.part("plane", shapes.quads(((-1, 0, 1), (2, 0, 0), (0, 0, -2))), white)
    glb.camera("above", (0, 1.5, 2.2), (0, -0.1, 0), 42)
    glb.directional_light("sun", (-0.4, -1.0, -0.3), (1, 1, 1), round(math.pi, 6))
    return glb
