"""What a sweep varies: one row per setting. A new one needs a row, and the option, the file and the report follow."""
from __future__ import annotations

import hashlib
import itertools
import json
from collections.abc import Callable, Collection
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from truth.scene import sky_file

MODES = ("phong", "shadow-map", "ao", "gi", "gi-cone-shadow")


@dataclass(frozen=True)
class Setting:
    """One axis of the sweep, and how `vct render` is told about it."""

    name: str  # in sweep.json, as in timings.json
    option: str  # of tools/sweep.py: several values with commas
    flag: str  # of vct render: one value
    parse: Callable[[str], Any]
    default: tuple[Any, ...]
    quick: tuple[Any, ...]
    help: str
    # The modes whose result or time it changes; None: all. The other modes run at the first value only.
    changes: frozenset[str] | None = None
    # The value that all modes run with; the first where it is not among those asked for.
    usual: Any = None
    # What stands for `default` and `quick` with the presets that are named here.
    of_preset: dict[str, tuple[Any, ...]] = field(default_factory=dict, hash=False)


def grid_from_text(text: str) -> int | str:
    return text if text == "auto" else int(text)


SETTINGS: tuple[Setting, ...] = (
    Setting("backend", "--backends", "--backend", str, ("egl",), ("egl",), "drivers: egl, osmesa, zink"),
    Setting("preset", "--presets", "--preset", str, ("thesis", "mobile", "quality"), ("thesis", "mobile", "quality"),
            "sets of settings"),
    Setting("size", "--sizes", "--size", str, ("256x256",), ("64x64",), "pictures, WIDTHxHEIGHT"),
    Setting("grid", "--grids", "--grid", grid_from_text, (64, 128, 256, 512), (256,),
            "voxels along a side, or auto",
            of_preset={"mobile": (64,), "quality": (128,)}),
    # The reference's sun is 5 degrees wide: other angles show what the thesis's cone costs and gets wrong.
    Setting("cone_angle_deg", "--cone-angles", "--cone-angle", float, (2.5, 5.0, 7.5, 10.0), (5.0,),
            "shadow cone's full angle, degrees", changes=frozenset({"gi-cone-shadow"}), usual=5.0,
            of_preset={"mobile": (5.0,), "quality": (5.0,)}),
)


@dataclass(frozen=True)
class Point:
    """One process of `vct render`: a scene, a value of each setting, and the modes to render with them."""

    scene: Path
    settings: dict[str, Any] = field(hash=False)
    modes: tuple[str, ...]

    @property
    def name(self) -> str:
        values = " ".join(str(value) for value in self.settings.values())
        return f"{self.scene.stem} {values} {','.join(self.modes)}"

    def arguments(self) -> list[str]:
        """The settings as arguments of `vct render`."""
        sky = sky_file(self.scene)
        return [part for setting in SETTINGS for part in (setting.flag, str(self.settings[setting.name]))] + (
            ["--environment", str(sky)] if sky else [])

    def key(self, identity: dict[str, str]) -> str:
        """Names the point's result: the same settings, program and scene give the same key."""
        what = {"settings": self.settings, "modes": self.modes, "scene": self.scene.stem, **identity}
        return hashlib.sha256(json.dumps(what, sort_keys=True).encode()).hexdigest()[:16]


def usual_value(setting: Setting, values: tuple[Any, ...]) -> Any:
    """The value at which the modes run that the setting does not change."""
    return setting.usual if setting.usual in values else values[0]


Values = dict[str, tuple[Any, ...]]
PRESET = next(setting for setting in SETTINGS if setting.name == "preset")


def values_of_presets(given: Values, quick: bool) -> list[Values]:
    """For each preset the values of every setting: those given, else the preset's own, else the default."""
    def usual(setting: Setting, preset: str) -> tuple[Any, ...]:
        return setting.of_preset.get(preset, setting.quick if quick else setting.default)
    return [{setting.name: given.get(setting.name, usual(setting, preset)) for setting in SETTINGS} | {"preset": (preset,)}
            for preset in given.get("preset", usual(PRESET, ""))]


def points(scenes: list[Path], sets: list[Values], modes: tuple[str, ...],
           same_picture: Collection[str] = ()) -> list[Point]:
    """Every combination of each of the sets, scene by scene, less what says nothing new.

    That is: the modes that a setting does not change, and its other values where the scene is another one scaled.
    """
    return [point for scene in scenes for values in sets for point in combinations(scene, values, modes,
                                                                                   scene.stem in same_picture)]


def combinations(scene: Path, values: Values, modes: tuple[str, ...], scaled: bool) -> list[Point]:
    """One scene's. `scaled`: it is another scene, only larger or smaller."""
    usual = {setting.name: usual_value(setting, values[setting.name]) for setting in SETTINGS if setting.changes}
    mine = values | {name: (value,) for name, value in usual.items()} if scaled else values
    found = []
    for combination in itertools.product(*(mine[setting.name] for setting in SETTINGS)):
        chosen = {setting.name: value for setting, value in zip(SETTINGS, combination)}
        kept = tuple(mode for mode in modes if all(
            setting.changes is None or mode in setting.changes or chosen[setting.name] == usual[setting.name]
            for setting in SETTINGS))
        if kept:
            found.append(Point(scene, chosen, kept))
    return found
