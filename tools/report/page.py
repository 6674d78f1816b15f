"""The page: one file of HTML that holds its pictures and asks for nothing from outside."""
from __future__ import annotations

import datetime
import json
from pathlib import Path
from typing import Any

import files
import phone_tables
from motion.tables import tables as motion_tables
from report.html import Html, details, document, image, join, table, tag
from report.pictures import Album, small_png
from report.sweep_sections import METRICS, SweepSections, number
from tables import STEPS

FILE_VERSION = 1  # of the JSON of vct bench and of tools/motion.py
SOFTWARE = ("llvmpipe", "softpipe", "lavapipe", "swrast")


def joined(values: Any) -> str:
    """Each once, in order."""
    return "; ".join(dict.fromkeys(str(value) for value in values)) or "unknown"


def facts(sweep: dict[str, Any]) -> Html:
    """Driver, machine, commit, method: without them a time says nothing."""
    entries = sweep["points"]
    done = [entry for entry in entries if entry["status"] == "done"]
    days = sorted(entry["started"][:16].replace("T", " ") for entry in entries)
    rows = {
        "Driver": joined(f"{e['driver']['renderer']}, {e['driver']['version']} ({e['driver']['backend']})" for e in done),
        "Machine": joined(f"{e['machine']['cpu']}, {e['machine']['threads']} threads, {e['machine']['system']}" for e in done),
        "Program": f"commit {joined(run['commit'] for run in sweep['runs'])}",
        "Measured": f"{days[0]} to {days[-1]} UTC",
        "Timing": joined(f"{e['method']['clock']}; median of {e['method']['frames']} frames after "
                         f"{e['method']['warm_up_frames']} to warm up" for e in done),
        "Points": f"{len(done)} done, {len(entries) - len(done)} failed, in {len(sweep['runs'])} run(s)",
        "Page": f"made {datetime.datetime.now(datetime.timezone.utc):%Y-%m-%d %H:%M} UTC at {files.commit()}",
    }
    return tag("dl", *(tag("div", tag("dt", name), tag("dd", value)) for name, value in rows.items()))


def method(sweep: dict[str, Any]) -> Html:
    drivers = joined(entry["driver"]["renderer"] for entry in sweep["points"] if "driver" in entry)
    said = [
        "Every point is one fresh process of vct render. Each step of a frame lies between two glFinish, timed by the "
        "CPU's steady clock; 2 frames warm up, 5 count, and the voxels are made anew in each. docs/timings.md says more.",
        "The references are path traced by Mitsuba 3 from the same file, camera and light (tools/references.py). "
        "The reference of the soft shadow is a sun of 5 degrees: cones of other angles are judged against that one too.",
        "Errors are of the frames that were timed, with their one sample in each pixel. A pixel of a reference is the "
        "mean of many samples, so a part of every error is the steps at edges. A reference larger than the picture is "
        "averaged down to it.",
        "A setting that a mode does not feel is not varied for it: the cone angle changes the shadow of "
        "gi-cone-shadow alone, so the other modes are rendered at one angle.",
    ]
    if any(name in drivers.lower() for name in SOFTWARE):
        said.append(f"{drivers} is a software driver: its times are only comparable with others of the same run on "
                    "the same machine, and say nothing of a phone.")
    if len(sweep["runs"]) > 1:
        said.append(f"The points come from {len(sweep['runs'])} runs of the sweep: compare times across them with care.")
    noise = {name: scene["reference"].get("kinds", {}) for name, scene in sweep["scenes"].items()}
    kinds = list(dict.fromkeys(kind for found in noise.values() for kind in found))
    return join([*(tag("p", text) for text in said), table(["error", "what it is"], METRICS.values()),
                 tag("h3", "Noise of the references, as relMSE"), table(["scene", *kinds], (
                     [scene, *(number(found.get(kind, {}).get("noise_relmse")) for kind in kinds)] for scene, found in noise.items()))])


def measured_by(data: dict[str, Any]) -> Html:
    return tag("p", f"Of {data['scene']}, milliseconds; {data['method']['statistic']}. {data['driver']['renderer']}, "
                    f"{data['machine']['cpu']}.")


def bench(path: Path) -> Html:
    data = files.read_json(path, tables=FILE_VERSION)
    return join([measured_by(data), *(part for title, head, rows in phone_tables.bench_tables([("here", data)])
                                      for part in (tag("h3", title), table(head, rows)))])


def presets(path: Path) -> Html:
    data = files.read_json(path, presets=FILE_VERSION)
    steps = {"voxelize_mipmap": "voxelize + mipmap", **STEPS}
    parts = [measured_by(data)]
    for mode in data["presets"][0]["modes"]:
        shown = [step for step in steps if step in data["presets"][0]["modes"][mode]]
        rows = [[f"{one['preset']}, {one['settings']['grid']}³", *(number(one["modes"][mode][step]["median"]) for step in shown),
                 number(one["bytes"] / 1e6)] for one in data["presets"]]
        rows += [[f"{one['of']} / {one['over']}", *(number(one["modes"][mode][step]) for step in shown), number(one["bytes"])]
                 for one in data["ratios"]]
        parts.append(details(mode, table(["preset", *(steps[step] for step in shown), "GL memory, MB"], rows), opened=True))
    return join(parts)


def motion(path: Path) -> Html:
    return join(part for one in motion_tables(files.read_json(path, size=FILE_VERSION))
                for part in (tag("h3", one.name), tag("p", one.what), table(one.head, one.rows)))


def hard_cases(path: Path, album: Album) -> Html:
    """What fails comes first; a case that fails stays in the list."""
    rows = sorted(json.loads(path.read_text()), key=lambda row: ("fail", "known-failure", "pass").index(row["status"]))
    cards = []
    for row in rows:
        picture = path.parent / row["picture"] if row["picture"] else None
        shown = album.address(lambda: small_png(picture, 320)) if picture and picture.is_file() else None
        size = tag("p", f"{number(row['measured'])} {row['unit']}; bar {row['bar']:g}; preset {row['preset']}")
        cards.append(tag("article", tag("h3", f"{row['name']}: ", tag("span", row["status"].replace("-", " "), class_=row["status"])),
                         tag("p", f"{row['what']}. Right: {row['right_answer']}."), size, tag("p", row["note"]),
                         image(shown, row["name"]) if shown else None))
    return join([tag("p", "A known failure is one of the published algorithm itself, with its size."),
                 tag("div", *cards, class_="cards")])


def page(sweep: dict[str, Any], folder: Path, references: Path, album: Album, given: dict[str, Path | None]) -> str:
    """`given`: what there is beside the sweep, by its option of tools/report.py."""
    of_sweep = SweepSections(sweep, folder, references, album)
    hard = given["hard_cases"] and hard_cases(given["hard_cases"], album)  # before the sweep's many pictures take the room
    sections = {"Summary": of_sweep.summary(), "Time against error": of_sweep.time_against_error(), "Pictures": of_sweep.pictures(),
                "Tables": of_sweep.tables(), "Presets side by side": given["presets"] and presets(given["presets"]),
                "The thesis's tables": given["bench"] and bench(given["bench"]),
                "Light over frames": given["motion"] and motion(given["motion"]), "Hard cases": hard, "Method": method(sweep)}
    sections = {name: body for name, body in sections.items() if body}
    title = "Voxel cone tracing: speed against error"
    return document(
        title,
        tag("p", "Every picture of the renderer vct has two numbers here: the time it took, and how far it is from a "
                 "path-traced picture of the same scene."),
        facts(sweep), tag("nav", *(tag("a", name, href=f"#{number}") for number, name in enumerate(sections))),
        *(tag("section", tag("h2", name, id=str(number)), body) for number, (name, body) in enumerate(sections.items())))
