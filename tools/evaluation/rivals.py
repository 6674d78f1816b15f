"""Draws a scene with other renderers: Godot's GIProbe, Cycles, and the voxel cone tracing of three.js.

Each gets a job, a JSON file with the triangles, materials, camera and sun of the scene as the path-traced reference read them.
It writes its picture and report.json into the job's folder.
"""
import http.server
import json
import math
import os
import subprocess
import tempfile
import threading
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

from files import ROOT, Failed
from truth.exr import read_exr
from truth.materials import linear_from_srgb
from truth.scene import load_scene

FOLDER = ROOT / "tools/rivals"
EXPOSURES = [8, 1, 1 / 8, 1 / 64]  # of Godot's pictures, which have 8 bits: the brightest one that is not clipped counts
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
                         "positions": np.round(corners[own], 7).ravel().tolist(),
                         "normals": np.round(scene.normals[own], 7).ravel().tolist()})
    return {"size": list(size), "surfaces": surfaces, "bounds": [corners.min((0, 1)).tolist(), corners.max((0, 1)).tolist()],
            "sun": {"towards": scene.sun.towards.tolist(), "irradiance": scene.sun.irradiance.tolist()},
            "camera": {"eye": scene.camera.eye_world.tolist(), "right_up_back": scene.camera.axes.tolist(),
                       "vertical_fov_deg": math.degrees(scene.camera.vertical_fov_rad)}}


def call(command: list[Any], timeout_s: float = 900, **environment: str) -> None:
    try:
        done = subprocess.run(list(map(str, command)), capture_output=True, text=True, timeout=timeout_s, check=False,
                              env={**os.environ, **environment})
    except subprocess.TimeoutExpired:
        raise Failed(f"{Path(command[0]).name} was stopped after {timeout_s:g} s") from None
    if done.returncode != 0:
        raise Failed(f"{Path(command[0]).name} ended with exit status {done.returncode}: {done.stderr.strip()[-500:]}")


def merged(pictures: list[Picture]) -> Picture:
    """One linear picture of sRGB pictures (0 to 1) at falling EXPOSURES."""
    result = linear_from_srgb(pictures[-1]) / EXPOSURES[-1]
    for picture, exposure in list(zip(pictures, EXPOSURES))[-2::-1]:
        result = np.where((picture < 0.98).all(-1, keepdims=True), linear_from_srgb(picture) / exposure, result)
    height, width = result.shape[0] // SAMPLES, result.shape[1] // SAMPLES
    return result.reshape(height, SAMPLES, width, SAMPLES, 3).mean((1, 3)).astype(np.float32)


def godot(job: Path, out: Path) -> Picture:
    call(["xvfb-run", "-a", "-s", "-screen 0 1280x1024x24", "godot3", "--path", FOLDER / "godot"], VCT_JOB=str(job),
         LIBGL_ALWAYS_SOFTWARE="1")
    return merged([np.asarray(Image.open(out / f"{i}.png").convert("RGB")) / 255.0 for i in range(len(EXPOSURES))])


def cycles(python: Path, job: Path, out: Path) -> Picture:
    call([python, "-B", FOLDER / "draw_cycles.py", job])
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


def three(three_js: Path, job: Path, out: Path) -> Picture:
    server, ended = page_server(three_js, job, out)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    with tempfile.TemporaryDirectory() as profile:
        browser = subprocess.Popen(["chromium", "--headless=new", "--no-sandbox", f"--user-data-dir={profile}", "--enable-unsafe-webgpu",
                                    "--use-webgpu-adapter=swiftshader", "--use-angle=swiftshader", "--use-vulkan=swiftshader",
                                    "--enable-features=Vulkan", "--disable-vulkan-surface", "--disable-dev-shm-usage",
                                    f"http://127.0.0.1:{server.server_port}/"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        try:
            if not ended.wait(900):
                raise Failed("the page in chromium was stopped after 900 s")
        finally:
            browser.terminate()
            browser.wait()
            server.shutdown()
    failed = json.loads((out / "report.json").read_text()).get("failed")
    if failed:
        raise Failed(f"the page in chromium failed: {failed}")
    size = json.loads(job.read_text())["scene"]["size"]
    return np.fromfile(out / "picture.bin", np.float32).reshape(size[1], size[0], 3)
