"""Paths, the program under test, and small generated scenes."""
import os
import pathlib
import sys

import pytest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tools"))
sys.dont_write_bytecode = True  # tests run inside the source tree

from scenes import shapes  # noqa: E402
from scenes.glb import Glb  # noqa: E402
from truth.drawing import draw, make_world  # noqa: E402
from truth.scene import load_scene  # noqa: E402


@pytest.fixture
def root():
    return ROOT


# Fifteen steps of light have all bounces. The refinement that follows sixteen takes ten times as long, and the tests of the tools
# are not about it.
WITHOUT_REFINEMENT = """#!/bin/sh
case " $* " in
    *" --light-frames "* | *" thesis "* | *" phong "*) ;;
    " render "*) exec '{program}' "$@" --light-frames 15 ;;
esac
exec '{program}' "$@"
"""


@pytest.fixture(scope="session", autouse=True)
def unrefined(tmp_path_factory):
    """Puts a program that leaves the refinement out in the place of ctest's, also for the tools that the tests run. Returns the path
    of ctest's."""
    if path := os.environ.get("VCT_PROGRAM"):
        script = tmp_path_factory.mktemp("program") / "vct"
        script.write_text(WITHOUT_REFINEMENT.format(program=path))
        script.chmod(0o755)
        os.environ["VCT_PROGRAM"] = str(script)
    return path


@pytest.fixture(scope="session")
def program(unrefined):
    """The renderer under test."""
    path = os.environ.get("VCT_PROGRAM")
    if not path:
        pytest.skip("VCT_PROGRAM does not name the renderer")
    return path


class SceneMaker:
    """A glTF scene in a folder: `quad` and `place` add meshes, `load` writes and reads it."""

    def __init__(self, folder):
        self.path = folder / "scene.glb"
        self.glb = Glb("tests/tools")

    def place(self, shape, material, **node):
        self.glb.node("part", mesh=self.glb.mesh("part", self.glb.primitive(shape, material)), **node)

    def quad(self, origin, u, v, material, uv_size=None):
        """Adds a parallelogram that faces u x v."""
        shape = shapes.Shape()
        shapes.add_quad(shape, origin, u, v, uv_size)
        self.place(shape, material)

    def grey(self, albedo=0.5, **properties):
        return self.glb.material("grey", (albedo,) * 3, **properties)

    def load(self):
        if "extensions" not in self.glb.json:
            self.glb.directional_light("off", (0, -1, 0), (1, 1, 1), 0.0)
        self.path.write_bytes(self.glb.to_bytes())
        return load_scene(self.path)

    def draw(self, *kinds, size=(16, 16), samples=64, seed=0):
        """One picture per kind, (height, width, 3)."""
        scene = self.load()
        world = make_world(scene)
        pictures = [draw(world, scene, kind, size, samples, seed).image for kind in kinds]
        return pictures if len(pictures) > 1 else pictures[0]


@pytest.fixture
def maker(tmp_path):
    return SceneMaker(tmp_path)
