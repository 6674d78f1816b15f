"""The result store: one folder with results.json and pictures/.

Each result has an identity, such as `render-cornell-mobile`, and a key, which holds everything that it depends on. A result
whose key has not changed is not measured again, so the same command continues a run that was stopped.
"""
from __future__ import annotations

import json
import shutil
import sys
import time
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import program
from files import Failed, commit, read_json, write_whole

VERSION = 1
Result = dict[str, Any]


@dataclass
class Task:
    kind: str  # the section of the page that shows the result: "render", "swim", ...
    name: str  # unique within the kind
    key: dict[str, Any]  # inputs other than the program
    measure: Callable[[Path], Result]  # takes an empty folder for its pictures
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
            self.data = read_json(self.path, results=VERSION)
        self.entries: dict[str, dict[str, Any]] = self.data["results"]

    def pictures(self, identity: str) -> Path:
        return self.folder / "pictures" / identity

    def entries_of(self, kind: str) -> list[dict[str, Any]]:
        return [entry for entry in self.entries.values() if entry["kind"] == kind]

    def results_of(self, kind: str) -> list[Result]:
        return [entry["result"] for entry in self.entries_of(kind) if "result" in entry]

    def run(self, tasks: list[Task], again: bool = False) -> list[Result]:
        """Measures what is missing (or `again` everything), stores each result at once, and continues after a task that fails.
        Returns the results that there are, in the order of the tasks; `failures` names the others."""
        build = program.build_sha256()
        if old := [identity for identity, entry in self.entries.items() if entry["key"]["build"] not in (None, build)]:
            say(f"{len(old)} results of another build of vct are removed from {self.path}")
            self._remove(old)
        seconds: list[float] = []
        for number, task in enumerate(tasks, 1):
            place = f"[{number}/{len(tasks)}] {task.kind}: {task.name}"
            key = json.loads(json.dumps({**task.key, "build": build if task.uses_program else None}))
            known = self.entries.get(task.identity)
            if known and known["key"] == key and "result" in known and not again:
                say(f"{place}: unchanged")
                continue
            left = sum(seconds) / len(seconds) * (len(tasks) - number + 1) if seconds else 0
            say(place + (f", about {left:.0f} s left" if left > 2 else ""))
            start = time.monotonic()
            if self.entries.pop(task.identity, None):
                self.save()  # its pictures are about to be replaced
            self.entries[task.identity] = {"kind": task.kind, "name": task.name, "key": key, **self._measured(task)}
            seconds.append(time.monotonic() - start)
            if program.build_sha256() != build:
                raise Failed("vct or its shaders changed during the run: run the same command again")
            self.save()
        return [entry["result"] for task in tasks if "result" in (entry := self.entries[task.identity])]

    def _measured(self, task: Task) -> dict[str, Any]:
        folder = self.pictures(task.identity)
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        try:
            return {"result": task.measure(folder)}
        except Failed as why:
            say(f"error: {task.kind} of {task.name}: {why}")
            return {"failed": str(why)}
        finally:
            if not task.keeps_pictures:
                shutil.rmtree(folder)

    def failures(self, tasks: list[Task]) -> list[str]:
        return [task.name for task in tasks if "failed" in self.entries[task.identity]]

    def keep_only(self, tasks: list[Task]) -> None:
        self._remove(self.entries.keys() - {task.identity for task in tasks})

    def _remove(self, identities: Iterable[str]) -> None:
        for identity in identities:
            del self.entries[identity]
            shutil.rmtree(self.pictures(identity), ignore_errors=True)

    def save(self) -> None:
        self.data["commit"] = commit()
        write_whole(self.path, json.dumps(self.data, indent=1) + "\n")


class Countdown:
    """Prints every few seconds how much of one long task is done and how long the rest may take."""

    INTERVAL_S = 4.0

    def __init__(self, total: int) -> None:
        self.total, self.done = total, 0
        self.start = self.told = time.monotonic()

    def advance(self, count: int) -> None:
        self.done += count
        now = time.monotonic()
        if now - self.told >= self.INTERVAL_S and self.done < self.total:
            self.told = now
            left = (now - self.start) * (self.total - self.done) / self.done
            say(f"  {100 * self.done // self.total} %, about {left:.0f} s left")


def say(text: str) -> None:
    print(text, file=sys.stderr, flush=True)
