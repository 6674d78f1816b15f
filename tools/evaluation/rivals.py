"""Draws a scene with other renderers: Godot's GIProbe, Cycles, and the voxel cone tracing of three.js.

Each gets a job, a JSON file with the triangles, materials, camera and sun of the scene as the path-traced reference reads them.
It leaves its picture and report.json in the job's folder.
"""
import http.server
import json
import math
import os
import shutil
import signal
import subprocess
import tempfile
import threading
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

import program
from files import ROOT, Failed
from truth.exr import read_exr
from truth.materials import linear_from_srgb
from truth.scene import load_scene

FOLDER = ROOT / "tools/rivals"
THREE = "node_modules/three"
LONGEST_S = 1200  # of one picture
EXPOSURES = [4, 1 / 4, 1 / 32]  # of Godot's pictures, which have 8 bits: the brightest one that is not clipped counts
SAMPLES = 4  # of Godot's pictures, along each side of a pixel
Picture = np.ndarray
Settings = dict[str, Any]


def described(path: Path, size: tuple[int, int]) -> dict[str, Any]:
    """The scene in world space, as lists of numbers. Three points of a surface are a triangle, counter-clockwise in front."""
    scene = load_scene(path, size)
    materials = sorted(set(scene.material_of.tolist()))
    if scene.punctual or scene.sky is not None or any(scene.materials[i].textures or scene.materials[i].glossy or
                                                      scene.materials[i].double_sided for i in materials):
        raise Failed(f"{path.name} has point lights, a sky, textures, gloss or two-sided surfaces, which not all renderers here "
                     f"are given: choose another scene")
    corners = scene.positions * scene.side_world + scene.centre_world
    surfaces = []
    for index in materials:
        own, material = scene.material_of == index, scene.materials[index]
        surfaces.append({"albedo": list(map(float, material.base_color[:3])), "emission": list(map(float, material.emissive)),
                         "positions": corners[own].ravel().tolist(),
                         "normals": scene.normals[own].ravel().tolist()})
    return {"size": list(size), "surfaces": surfaces, "bounds": [corners.min((0, 1)).tolist(), corners.max((0, 1)).tolist()],
            "sun": {"towards": scene.sun.towards.tolist(), "irradiance": scene.sun.irradiance.tolist()},
            "camera": {"eye": scene.camera.eye_world.tolist(), "right_up_back": scene.camera.axes.tolist(),
                       "vertical_fov_deg": math.degrees(scene.camera.vertical_fov_rad)}}


def call(command: list[Any], timeout_s: float = LONGEST_S, **environment: str) -> None:
    """Runs a program, and ends it with all that it started where it takes too long or this program is stopped."""
    name = Path(command[0]).name
    with subprocess.Popen(list(map(str, command)), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          env={**os.environ, **environment}, start_new_session=True) as process:
        try:
            said = process.communicate(timeout=timeout_s)[0]
        except BaseException as stopped:
            os.killpg(process.pid, signal.SIGTERM)
            if isinstance(stopped, subprocess.TimeoutExpired):
                raise Failed(f"{name} was stopped after {timeout_s:g} s") from None
            raise
    if process.returncode != 0:
        raise Failed(f"{name} ended with exit status {process.returncode}: {program.last_words(said)}")


def merged(pictures: list[Picture]) -> Picture:
    """One linear picture of sRGB pictures (0 to 1) at falling EXPOSURES."""
    result = linear_from_srgb(pictures[-1]) / EXPOSURES[-1]
    for picture, exposure in list(zip(pictures, EXPOSURES))[-2::-1]:
        result = np.where((picture < 0.98).all(-1, keepdims=True), linear_from_srgb(picture) / exposure, result)
    height, width = result.shape[0] // SAMPLES, result.shape[1] // SAMPLES
    return result.reshape(height, SAMPLES, width, SAMPLES, 3).mean((1, 3)).astype(np.float32)


def godot(folder: Path, job: Path, out: Path) -> Picture:
    call(["xvfb-run", "-a", "-s", "-screen 0 1280x1024x24", "godot3", "--path", FOLDER / "godot"], VCT_JOB=str(job),
         LIBGL_ALWAYS_SOFTWARE="1")
    return merged([np.asarray(Image.open(out / f"{i}.png").convert("RGB")) / 255.0 for i in range(len(EXPOSURES))])


def cycles(folder: Path, job: Path, out: Path) -> Picture:
    call([folder / "cycles/bin/python", "-B", FOLDER / "draw_cycles.py", job])
    return read_exr(out / "picture.exr")


def page_server(three_js: Path, job: Path, out: Path) -> tuple[http.server.ThreadingHTTPServer, threading.Event]:
    """Serves the page, its job and three.js on this machine, and stores what the page sends. The event is set with the report."""
    files = {"/": FOLDER / "three.html", "/job.json": job}
    posts = {"/picture": out / "picture.bin", "/report": out / "report.json"}
    ended = threading.Event()

    class Handler(http.server.SimpleHTTPRequestHandler):
        def translate_path(self, path: str) -> str:
            inside = (three_js / path.removeprefix("/three/")).resolve()
            return str(files.get(path) or (inside if inside.is_relative_to(three_js.resolve()) else "/nowhere"))

        def guess_type(self, path: str) -> str:
            return "text/html" if str(path).endswith(".html") else super().guess_type(path)

        def do_POST(self) -> None:
            posts[self.path].write_bytes(self.rfile.read(int(self.headers["Content-Length"])))
            self.send_response(204)
            self.end_headers()
            if self.path == "/report":
                ended.set()

        def log_message(self, *_: object) -> None:
            pass
    return http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler), ended


def three(folder: Path, job: Path, out: Path) -> Picture:
    server, ended = page_server(folder / THREE, job, out)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    flags = ["--headless=new", "--disable-dev-shm-usage", "--enable-unsafe-webgpu", "--enable-features=Vulkan", "--use-vulkan=swiftshader",
             "--use-webgpu-adapter=swiftshader", "--use-angle=swiftshader", "--disable-vulkan-surface",
             *(["--no-sandbox"] if os.geteuid() == 0 else [])]  # chromium refuses to run as root with it
    with tempfile.TemporaryDirectory() as profile:
        browser = subprocess.Popen(["chromium", *flags, f"--user-data-dir={profile}", f"http://127.0.0.1:{server.server_port}/"],
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        try:
            end = time.monotonic() + LONGEST_S
            while not ended.wait(1):
                if browser.poll() is not None or time.monotonic() > end:
                    raise Failed(f"chromium ended or took more than {LONGEST_S} s before it had drawn the picture")
        finally:
            browser.terminate()
            browser.wait()
            server.shutdown()
    failed = json.loads((out / "report.json").read_text()).get("failed")
    if failed:
        raise Failed(f"the page in chromium failed: {failed}")
    width, height = json.loads(job.read_text())["scene"]["size"]
    return np.fromfile(out / "picture.bin", np.float32).reshape(height, width, 3)


@dataclass(frozen=True)
class Rival:
    title: str
    sources: str  # of its own in tools/rivals, as a pattern
    draw: Callable[[Path, Path, Path], Picture]  # (folder of what was installed, job, folder for files)
    direct: Settings  # for direct light alone
    variants: tuple[Settings, ...]  # for all light; of each scene the one with the least error is shown
    programs: tuple[str, ...]  # that must be installed
    files: tuple[str, ...]  # that must be in the folder, as patterns; they tell the version
    traces_paths: bool = False

    def lacks(self, folder: Path) -> list[str]:
        return [f"the program {name}" for name in self.programs if not shutil.which(name)] + [
            str(folder / name) for name in self.files if not list(folder.glob(name))]

    def run(self, folder: Path, scene: Path, size: tuple[int, int], settings: Settings) -> tuple[Picture, dict[str, Any]]:
        """Its picture, and its report: driver, version, and frame_ms and bake_ms of Godot."""
        with tempfile.TemporaryDirectory() as work:
            job = Path(work) / "job.json"
            job.write_text(json.dumps({"scene": described(scene, size), "settings": settings, "out": work, "exposures": EXPOSURES,
                                       "samples": SAMPLES}))
            picture = self.draw(folder.resolve(), job, Path(work))
            return picture, json.loads((Path(work) / "report.json").read_text())


def variants(names: str, *rows: tuple[float, ...]) -> tuple[Settings, ...]:
    return tuple(dict(zip(names.split(), row)) for row in rows)


# The first settings of three and godot are the defaults of these programs.
RIVALS = {
    "three": Rival("three.js, VXGI", "three.html", three, {"frames": 16},
                   variants("frames resolution directional bounces cones angle", (16, 128, False, 1, 3, 40), (64, 64, True, 2, 4, 40),
                            (16, 128, True, 2, 4, 40)),
                   ("chromium",), (f"{THREE}/package.json", f"{THREE}/examples/jsm/lighting/vxgi/VXGINode.js")),
    "godot": Rival("Godot 3.2, GIProbe", "godot/*.*", godot, {},
                   variants("subdiv dynamic_range propagation offset_voxels", (128, 4, 0.7, 0), (128, 1, 0.7, 8), (128, 1, 0.4, 8),
                            (128, 1, 0, 8)),
                   ("godot3", "xvfb-run"), ()),
    "cycles": Rival("Cycles", "draw_cycles.py", cycles, {"samples": 64, "bounces": 0}, variants("samples bounces", (256, 128)), (),
                     ("cycles/bin/python", "cycles/lib/python3*/site-packages/bpy-*.dist-info/METADATA"), traces_paths=True),
}
