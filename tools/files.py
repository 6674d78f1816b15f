"""Paths of the repository, hashes of what a result depends on, and reading and writing of results."""
from __future__ import annotations

import hashlib
import importlib.metadata
import json
import os
import subprocess
import urllib.parse
from collections.abc import Iterable
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[1]
WITHOUT_REFERENCE = {"moving", "studio", "walker", "town"}  # of the first camera at rest: they move, or have references by camera
SCALED = {"cornell_1mm": "cornell", "cornell_10km": "cornell"}  # the same picture at another scale, so the same references


class Failed(Exception):
    """Something gave no result. The message names the file or step, the cause and a remedy."""


def static_scenes() -> list[Path]:
    """The scenes of assets/ that have references of their own."""
    return [path for path in sorted((ROOT / "assets").glob("*.glb")) if path.stem not in WITHOUT_REFERENCE | SCALED.keys()]


def find_scene(text: str) -> Path:
    """A scene by its name in assets/ or by its path."""
    path = Path(text) if text.endswith((".glb", ".gltf")) else ROOT / "assets" / f"{text}.glb"
    if not path.is_file():
        names = ", ".join(sorted(path.stem for path in (ROOT / "assets").glob("*.glb")))
        raise Failed(f"there is no scene '{text}': give a .glb or .gltf file, or one of {names}")
    return path


def view_name(scene: Path, camera: str | None) -> str:
    """Names the results of a scene, or of one of its cameras."""
    return f"{scene.stem}-{camera}" if camera else scene.stem


def reference_folder(scene: Path, root: Path = ROOT / "references", camera: str | None = None) -> Path:
    return root / view_name(scene.with_stem(SCALED.get(scene.stem, scene.stem)), camera)


def file_sha256(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()


def scene_sha256(path: Path) -> str:
    """Hashes a glTF file with the buffers and images that it names."""
    from truth.gltf_file import GltfFile  # needs numpy; phone.py, which needs none, imports this module too
    digest = hashlib.sha256(path.read_bytes())
    document = GltfFile(path).json
    for source in [*document.get("buffers", []), *document.get("images", [])]:
        uri = source.get("uri", "data:")
        named = path.parent / urllib.parse.unquote(uri)
        if not uri.startswith("data:") and named.is_file():
            digest.update(uri.encode() + b"\0" + named.read_bytes())
    return digest.hexdigest()


def path_tracer_sha256() -> str:
    """Hashes the sources in tools/truth and the versions of the packages that they use."""
    versions = " ".join(f"{package} {importlib.metadata.version(package)}" for package in ("mitsuba", "drjit"))
    return files_sha256(versions.encode(), (ROOT / "tools/truth").glob("*.py"))


def files_sha256(first: bytes, paths: Iterable[Path]) -> str:
    """Hashes `first`, then the names and contents of files of the repository."""
    digest = hashlib.sha256(first)
    for path in sorted(paths):
        if path.is_file():
            digest.update(str(path.relative_to(ROOT)).encode() + b"\0" + path.read_bytes())
    return digest.hexdigest()


def commit() -> str:
    """`git describe`, or `unknown` outside of a clone."""
    found = subprocess.run(["git", "describe", "--always", "--dirty", "--tags"], cwd=ROOT, capture_output=True,
                           text=True, check=False)
    return found.stdout.strip() if found.returncode == 0 else "unknown"


def shown(path: Path) -> str:
    """A path as messages and files show it: relative to the repository where it lies in it."""
    full = path.resolve()
    return full.relative_to(ROOT).as_posix() if full.is_relative_to(ROOT) else str(path)


def read_json(path: Path, member: str, version: int) -> dict[str, Any]:
    """Reads an object that has this member and this version."""
    try:
        data = json.loads(path.read_text())
    except (OSError, ValueError) as error:
        raise Failed(f"{path} cannot be read: {error}") from None
    found = data.get("version") if isinstance(data, dict) else None
    if found != version or member not in data:
        raise Failed(f"{path} has version {found}, and this program reads version {version} with '{member}': delete the file and "
                     "measure again")
    return data


def write_whole(path: Path, data: bytes | str) -> None:
    """Writes the whole file, or leaves the old one as it is."""
    path.parent.mkdir(parents=True, exist_ok=True)
    temporary = path.with_name(path.name + ".tmp")
    temporary.write_bytes(data.encode() if isinstance(data, str) else data)
    os.replace(temporary, path)
