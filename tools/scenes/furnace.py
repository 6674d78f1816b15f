"""A white furnace: a closed box whose inside emits radiance 1 everywhere and has no other light."""
from . import shapes
from .glb import Glb

ALBEDO = 0.8


def build():
    """Every point receives radiance 1 from every side, so one bounce gives indirect light of exactly ALBEDO."""
    glb = Glb("tools/make_assets.py")
    white = glb.material("glowing white", (ALBEDO,) * 3, emissive=((1.0, 1.0, 1.0), 1, None))
    glb.part("box", shapes.room(1), white)
    glb.camera("inside", (0.55, 0.3, 0.8), (-0.25, -0.2, -0.8), 75, (0.01, 100.0))
    glb.directional_light("sun", (-0.5, -1.0, -0.4), (1, 1, 1), 0.0)
    return glb
