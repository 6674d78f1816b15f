"""sweep.json: read, kept and written after every point."""
from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from files import read_json, write_whole

VERSION = 2


class Store:
    """The file of a sweep. Finished points stay in it from one run to the next."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self.data: dict[str, Any] = {"version": VERSION, "points": []}
        if path.exists():
            self.data = read(path)
        self.entries: dict[str, dict[str, Any]] = {entry["key"]: entry for entry in self.data["points"]}

    def finished(self, key: str) -> dict[str, Any] | None:
        """The entry of a point that need not run again; a failed one runs again."""
        entry = self.entries.get(key)
        return entry if entry and entry["status"] == "done" else None

    def put(self, entry: dict[str, Any]) -> None:
        self.entries[entry["key"]] = entry
        self.save()

    def drop_stale(self, program_sha256: str, scenes: dict[str, str]) -> int:
        """Forgets what another program or another state of a scene gave; says how many points those were."""
        def current(entry: dict[str, Any]) -> bool:
            return (entry["program_sha256"] == program_sha256
                    and scenes.get(entry["scene"], entry["scene_sha256"]) == entry["scene_sha256"])
        kept = {key: entry for key, entry in self.entries.items() if current(entry)}
        dropped = len(self.entries) - len(kept)
        self.entries = kept
        return dropped

    def save(self) -> None:
        self.data["points"] = list(self.entries.values())
        used = {entry["run"] for entry in self.data["points"]}
        self.data["runs"] = [run for run in self.data.get("runs", []) if run["run"] in used]
        write_whole(self.path, json.dumps(self.data, indent=1) + "\n")


def read(path: Path) -> dict[str, Any]:
    return read_json(path, points=VERSION)
