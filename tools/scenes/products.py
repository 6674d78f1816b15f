"""A sphere, a cube and a bottle of one material on a plane, as in pictures of products."""
from . import shapes
from .glb import Glb, axis_angle

MATERIALS = {  # base colour, metallic
    "steel": ((0.56, 0.57, 0.58), 1.0),
    "gold": ((1.0, 0.77, 0.34), 1.0),
    "plastic": ((0.1, 0.28, 0.6), 0.0)}
SIDE = 4.0  # of the plane, in metres
BOTTLE = ((0, 0), (0.2, 0), (0.215, 0.01), (0.22, 0.03), (0.22, 0.5), (0.21, 0.58), (0.17, 0.65), (0.11, 0.7), (0.08, 0.74),
          (0.075, 0.78), (0.075, 0.88), (0.09, 0.885), (0.09, 0.93), (0.08, 0.94), (0, 0.94))


def build(material, roughness, ground=True):
    """The scene holds no light: it is meant to be lit by a picture of a sky, as patio.hdr."""
    glb = Glb("tools/eval.py")
    color, metallic = MATERIALS[material]
    product = glb.material(material, color, metallic=metallic, roughness=roughness)
    if ground:
        glb.part("ground", shapes.quads(((-SIDE / 2, 0, SIDE / 2), (SIDE, 0, 0), (0, 0, -SIDE))), glb.material("grey", (0.5,) * 3))
    glb.part("bottle", shapes.lathe(BOTTLE, 48), product, translation=[-0.05, 0, -0.35])
    glb.part("sphere", shapes.icosphere(0.3, 4), product, translation=[-0.4, 0.3, 0.25])
    glb.part("cube", shapes.box((0.45, 0.45, 0.45), None), product, translation=[0.4, 0, 0.2], rotation=axis_angle((0, 1, 0), 30))
    glb.camera("front", (0.25, 1.25, 3.0), (0.02, 0.38, 0), 31)
    return glb
