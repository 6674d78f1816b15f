"""The result store: one folder with results.json and pictures/.

Each result has an identity, such as `render-cornell-mobile`, and a key, which holds everything that it depends on. A result
whose key has not changed is not measured again, so the same command continues a run that was stopped.
"""
from __future__ import annotations

import json
import shutil
import tempfile
import time
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from pathlib import Path
from statistics import fmean
from typing import Any

import program
from files import Failed, commit, read_json, write_whole

from .progress import begin, end, say

VERSION = 1
Result = dict[str, Any]


@dataclass
class Task:
    kind: str  # the section of the page that shows the result: "render", "swim", ...
    name: str  # unique within the kind
    key: dict[str, Any]  # inputs other than the program
    measure: Callable[[Path], Result]  # takes an empty folder for its pictures
    preset: str = ""  # tasks of one kind and preset take about the same time
    uses_program: bool = True
    keeps_pictures: bool = True

    @property
    def identity(self) -> str:
        return f"{self.kind}-{self.name}"


class Store:
    def __init__(self, folder: Path) -> None:
        self.folder, self.path = folder, folder / "results.json"
        self.data: dict[str, Any] = {"version": VERSION, "results": {}}
        if self.path.is_file():
            self.data = read_json(self.path, "results", VERSION)
        self.entries: dict[str, dict[str, Any]] = self.data["results"]

    def pictures(self, identity: str) -> Path:
        return self.folder / "pictures" / identity

    def pictures_of(self, result: Result) -> Path:
        """The pictures of a result that this store returned."""
        return self.pictures(next(identity for identity, entry in self.entries.items() if entry.get("result") is result))

    def entries_of(self, kind: str) -> list[dict[str, Any]]:
        return [entry for entry in self.entries.values() if entry["kind"] == kind]

    def results_of(self, kind: str) -> list[Result]:
        return [entry["result"] for entry in self.entries_of(kind) if "result" in entry]

    def run(self, tasks: list[Task], again: bool = False) -> list[Result]:
        """Measures what is missing (or `again` everything), stores each result at once, and continues after a task that fails,
        whose earlier result is kept. Returns the results of the other tasks in their order; `failures` names those that failed."""
        build = program.build_sha256()
        keys = [json.loads(json.dumps({**task.key, "build": build if task.uses_program else None})) for task in tasks]
        missing = [task for task, key in zip(tasks, keys) if again or not self._has(task, key)]
        seconds: dict[tuple[str, str], list[float]] = {}
        for number, (task, key) in enumerate(zip(tasks, keys), 1):
            place = f"[{number}/{len(tasks)}] {task.kind}: {task.name}"
            if task not in missing:
                self.entries[task.identity].pop("failed", None)  # with other options
                say(f"{place}: unchanged")
                continue
            left = [fmean(seconds.get((one.kind, one.preset), [0])) for one in missing[missing.index(task):]]
            say(place + (f", about {sum(left):.0f} s left" if all(left) and sum(left) > 2 else ""))
            begin(f"{task.kind}: {task.name}")
            start = time.monotonic()
            self._measure(task, key, build)
            end()
            seconds.setdefault((task.kind, task.preset), []).append(time.monotonic() - start)
        return [self.entries[task.identity]["result"] for task in tasks if "failed" not in self.entries[task.identity]]

    def _has(self, task: Task, key: dict[str, Any]) -> bool:
        known = self.entries.get(task.identity, {})
        return known.get("key") == key and "result" in known

    def _measure(self, task: Task, key: dict[str, Any], build: str) -> None:
        """Stores a result and its pictures when both are complete; before that, the earlier ones stay as they are."""
        entry, folder = {"kind": task.kind, "name": task.name, "key": key}, self.pictures(task.identity)
        folder.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(prefix="unfinished-", dir=folder.parent) as unfinished:
            pictures = Path(unfinished) / "pictures"
            pictures.mkdir()
            try:
                entry["result"] = task.measure(pictures)
            except Failed as why:
                say(f"error: {task.kind} of {task.name}: {why}")
                self.entries[task.identity] = {**entry, **self.entries.get(task.identity, {}), "failed": str(why)}
            else:
                if program.build_sha256() != build:
                    raise Failed("vct or its shaders changed during the run: run the same command again")
                self._remove_builds_except(build)
                if task.identity in self.entries:
                    self._remove([task.identity])
                    self.save()
                if task.keeps_pictures:
                    pictures.rename(folder)
                self.entries[task.identity] = entry
        self.save()

    def _remove_builds_except(self, build: str) -> None:
        """Removes the results of other builds, but for those that could not be replaced."""
        if old := [identity for identity, entry in self.entries.items()
                   if entry["key"]["build"] not in (None, build) and not {"failed", "result"} <= entry.keys()]:
            say(f"{len(old)} results of another build of vct are removed from {self.path}")
            self._remove(old)

    def failures(self, tasks: list[Task]) -> list[str]:
        return [task.name for task in tasks if "failed" in self.entries[task.identity]]

    def say_failures(self, tasks: list[Task]) -> None:
        """Repeats at the end, as the last line, what a long run printed in its midst."""
        if failed := [f"{task.name} ({self.entries[task.identity]['failed'].splitlines()[-1]})" for task in tasks
                      if "failed" in self.entries[task.identity]]:
            say(f"error: {len(failed)} of {len(tasks)} failed: {', '.join(failed)}")

    def keep_failures_only(self, tasks: list[Task]) -> None:
        """Removes the earlier results of tasks that failed."""
        for task in tasks:
            if "failed" in self.entries[task.identity] and self.entries[task.identity].pop("result", None):
                shutil.rmtree(self.pictures(task.identity), ignore_errors=True)

    def keep_only(self, tasks: list[Task]) -> None:
        self._remove(self.entries.keys() - {task.identity for task in tasks})

    def _remove(self, identities: Iterable[str]) -> None:
        for identity in identities:
            del self.entries[identity]
            shutil.rmtree(self.pictures(identity), ignore_errors=True)

    def save(self) -> None:
        self.data["commit"] = commit()
        write_whole(self.path, json.dumps(self.data, indent=1) + "\n")
