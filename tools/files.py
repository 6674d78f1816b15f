"""Where the repository's files lie, what a result depends on beside its settings, and how results are read and written."""
from __future__ import annotations

import hashlib
import importlib.metadata
import json
import os
import subprocess
from collections.abc import Iterable
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[1]


def file_sha256(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()


def program_sha256(program: Path) -> str:
    """Of the program and of the shaders, which it reads when it runs."""
    return files_sha256(program.read_bytes(), (ROOT / "shaders").rglob("*"))


def path_tracer_sha256() -> str:
    """Of the sources in tools/truth, and of what they are made of."""
    versions = " ".join(f"{package} {importlib.metadata.version(package)}" for package in ("mitsuba", "drjit"))
    return files_sha256(versions.encode(), (ROOT / "tools/truth").glob("*.py"))


def files_sha256(first: bytes, paths: Iterable[Path]) -> str:
    """Of bytes, and of the names and contents of the repository's files among `paths`."""
    digest = hashlib.sha256(first)
    for path in sorted(paths):
        if path.is_file():
            digest.update(str(path.relative_to(ROOT)).encode() + b"\0" + path.read_bytes())
    return digest.hexdigest()


def commit() -> str:
    """`git describe`; `unknown` where this is no clone."""
    found = subprocess.run(["git", "describe", "--always", "--dirty", "--tags"], cwd=ROOT, capture_output=True,
                           text=True, check=False)
    return found.stdout.strip() if found.returncode == 0 else "unknown"


def shown(path: Path) -> str:
    """A path as written into files: relative to the repository, or the name alone where it lies elsewhere."""
    full = path.resolve()
    return full.relative_to(ROOT).as_posix() if full.is_relative_to(ROOT) else full.name


def read_json(path: Path, **versions: int) -> dict[str, Any]:
    """An object that has one of the members, and the version that goes with it; else ends the program with a sentence."""
    try:
        data = json.loads(path.read_text())
    except (OSError, ValueError) as error:
        raise SystemExit(f"error: {path} cannot be read: {error}") from None
    found = data.get("version") if isinstance(data, dict) else None
    if not any(member in data and found == version for member, version in versions.items()):
        known = " or ".join(f"version {version} with {member}" for member, version in versions.items())
        raise SystemExit(f"error: {path} has version {found}; this program reads {known}: make it anew")
    return data


def write_whole(path: Path, data: bytes | str) -> None:
    """Writes the whole file or leaves the old one."""
    path.parent.mkdir(parents=True, exist_ok=True)
    beside = path.with_name(path.name + ".tmp")
    beside.write_bytes(data.encode() if isinstance(data, str) else data)
    os.replace(beside, path)
