"""A walled patio with a portico, lit by a sky only: one half sees much of it, the other half little."""
from . import shapes
from .glb import Glb, axis_angle
from .radiance import picture


def build():
    """The scene holds no light: it is meant to be lit by patio.hdr."""
    glb = Glb("tools/make_assets.py")
    paving, white, clay, blue = (glb.material(*m) for m in (
        ("paving", (0.55, 0.5, 0.42)), ("white", (0.78, 0.76, 0.72)), ("clay", (0.6, 0.24, 0.12)),
        ("blue", (0.12, 0.25, 0.55))))

    # Floor, back, left and right; the front (+Z) is open for the camera.
    glb.part("floor", shapes.quads(((-2, 0, 2), (4, 0, 0), (0, 0, -4))), paving)
    glb.part("back", shapes.quads(((-2, 0, -2), (4, 0, 0), (0, 2.4, 0))), white)
    glb.part("left", shapes.quads(((-2, 0, 2), (0, 0, -4), (0, 2.4, 0))), white)
    glb.part("right", shapes.quads(((2, 0, -2), (0, 0, 4), (0, 2.4, 0))), clay)
    glb.part("roof", shapes.box((4, 0.15, 1.5), None), white, translation=[0, 2.25, -1.25])
    for i, x in enumerate((-1.1, 1.1)):
        glb.part(f"column {i}", shapes.cylinder(0.16, 2.25, 32), white, translation=[x, 0, -0.75])
    glb.part("ball", shapes.icosphere(0.35, 3), white, translation=[0.75, 0.35, 0.65])
    glb.part("bench", shapes.box((1.2, 0.45, 0.5), None), blue, translation=[-0.8, 0, 0.55],
             rotation=axis_angle((0, 1, 0), 20))

    glb.camera("front", (0.5, 1.7, 5.2), (-0.05, 1.05, 0), 46)
    return glb


def sky():
    """A clear evening: bluer and darker towards the zenith, brown below the horizon, and a warm glow without a sun in
    it, 25 degrees above the horizon in the front on the right."""
    brightest = (0.74, 0.42, 0.52)

    def radiance(x, y, z):
        if y < 0:
            return 0.16, 0.12, 0.08
        low = (1 - y) * (1 - y)
        near = max(x * brightest[0] + y * brightest[1] + z * brightest[2], 0.0) ** 24
        return 0.3 + 0.5 * low + 7.0 * near, 0.45 + 0.35 * low + 3.8 * near, 0.9 + 0.1 * low + 1.2 * near

    return picture(64, radiance)
