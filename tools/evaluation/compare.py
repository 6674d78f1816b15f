"""Compares the presets with other renderers on the same scenes, cameras and lights, against path tracing by Mitsuba.

    tools/eval.py compare                                      tables of all renderers (about an hour on two cores)
    tools/eval.py compare --scenes cornell --rivals godot      only these
    tools/eval.py compare --page docs/comparison.md            also writes the tables and the picture of that page

The renderers are not part of the project. Install those that should take part; the others are skipped, which is said:

    apt-get install godot3 xvfb                                Godot 3.2, whose GIProbe is a voxel cone tracer (OpenGL ES 3)
    apt-get install chromium                                   the browser for three.js; it draws WebGPU with SwiftShader
    npm install --prefix out/rivals three@0.187.0              three.js and its voxel cone tracing, VXGI
    python3.11 -m venv out/rivals/cycles && out/rivals/cycles/bin/pip install bpy==4.5.15
                                                               Blender's path tracer Cycles: a check of the reference

A renderer draws each scene with direct light alone, which shows whether camera and light agree, and then with every setting of
RIVALS in tools/evaluation/rivals.py. The tables show the setting with the least relMSE in each scene, and all that were tried.
The presets have the same settings in all scenes. Times are those of a frame in which only the camera moves, on llvmpipe; three.js runs on another driver, so it has none.
Pictures that are still valid are kept. The presets and the settings shown of Godot are drawn again in each call, so that all times
are of one run.
"""
import argparse
import io
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw, ImageFont

import metrics
import program
from files import ROOT, Failed, file_sha256, files_sha256, find_scene, scene_sha256, write_whole
from tables import fraction, markdown, milliseconds, percent
from truth.exr import read_exr, write_exr

from . import measures, options
from .pictures import shown
from .progress import say
from .rivals import FOLDER, RIVALS, SAMPLES, Settings
from .store import Result, Store, Task

SCENES = ("cornell", "corridor", "contact", "lamp")
BEGIN, END = "<!-- figures -->\n", "<!-- end of figures -->\n"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    options.add_store(parser)
    options.add_presets(parser)
    parser.add_argument("--scenes", type=lambda text: text.split(","), default=list(SCENES), metavar="NAMES",
                        help=f"with commas: scenes with references and without textures, point lights and sky (default: {','.join(SCENES)})")
    parser.add_argument("--rivals", type=options.names(RIVALS, "renderer"), default=list(RIVALS),
                        help=f"with commas (default: {','.join(RIVALS)})")
    parser.add_argument("--installed", type=Path, default=ROOT / "out/rivals", help="folder of node_modules and cycles (default: out/rivals)")
    parser.add_argument("--page", type=Path, metavar="FILE.md", help="replace the tables between its marks, and images/comparison.jpg beside it")


def label(settings: Settings) -> str:
    return ", ".join(f"{name} {value}" for name, value in settings.items())


def preset_task(scene: Path, preset: str) -> Task:
    """Errors of a picture with as many samples per pixel as the others have, and the time of a single frame."""
    references = measures.References(scene)

    def measure(out: Path) -> Result:
        asked = ["--preset", preset, "--mode", "gi", "--size", "{}x{}".format(*references.size), "--exposure", 1, *program.NO_SKY]
        timings = program.render_timed(scene, out / "timed", *asked)
        program.render(scene, out, "--samples", SAMPLES**2, *asked)
        return {"scene": scene.stem, "preset": preset, "grid": timings["settings"]["grid"], "cpu": timings["machine"]["cpu"],
                "driver": timings["driver"]["renderer"], "frame_ms": timings["modes"]["gi"]["steps"]["total"]["median"],
                "errors": metrics.compare(read_exr(out / "gi.exr"), references.picture(["full"]))}
    key = {"scene": scene_sha256(scene), "references": references.key(), "metrics": file_sha256(Path(metrics.__file__))}
    return Task("compare", f"{scene.stem}-{preset}", key, measure, preset)


def task(scene: Path, name: str, settings: Settings, folder: Path) -> Task:
    """One picture by another renderer. Without GI it is compared with the reference of direct light."""
    references, rival = measures.References(scene), RIVALS[name]
    is_direct = settings == rival.direct
    identity = f"{scene.stem}-{name}-" + ("direct" if is_direct else str(rival.variants.index(settings)))

    def measure(out: Path) -> Result:
        picture, report = rival.run(folder, scene, references.size, settings)
        write_exr(out / "picture.exr", picture)
        errors = metrics.compare(picture, references.picture(["direct" if is_direct else "full"]))
        return {"scene": scene.stem, "rival": name, "settings": settings, "direct": is_direct, "errors": errors,
                "picture": f"compare-{identity}/picture.exr", **report}
    key = {"scene": scene_sha256(scene), "references": references.key(), "settings": settings,
           "installed": [file_sha256(path) for pattern in rival.files for path in sorted(folder.glob(pattern))],
           "code": files_sha256(Path(__file__).with_name("rivals.py").read_bytes(), FOLDER.glob(rival.sources)),
           "metrics": file_sha256(Path(metrics.__file__))}
    return Task("compare", identity, key, measure, name, uses_program=False)


def best(results: Sequence[Result], scene: str) -> Result:
    """The picture of all light with the least relMSE."""
    return min((one for one in results if one["scene"] == scene and not one["direct"]), key=lambda one: one["errors"]["relmse"])


def errors_of(errors: dict[str, float]) -> list[str]:
    return [fraction(errors["relmse"], 4), percent(errors["bias"]), fraction(errors["flip"], 3)]


def figures(presets: Sequence[Result], drawn: dict[str, list[Result]]) -> str:
    """All tables, as Markdown. `drawn`: results by the name of the renderer."""
    scenes = list(dict.fromkeys(one["scene"] for one in presets))
    rows, better = [], []
    for scene in scenes:
        own = [one for one in presets if one["scene"] == scene]
        rows += [[scene, f"`{one['preset']}`, {one['grid']}³", *errors_of(one["errors"]), milliseconds(one["frame_ms"])] for one in own]
        for name, results in drawn.items():
            one = best(results, scene)
            rows.append([scene, RIVALS[name].title, *errors_of(one["errors"]),
                         milliseconds(one["frame_ms"]) if "frame_ms" in one else "–"])
            better += [f"- {scene}: {RIVALS[name].title} has a lower {title} than `{preset['preset']}` ({fraction(mine, 4)} against "
                       f"{fraction(theirs, 4)})." for preset in own for metric, title in (("relmse", "relMSE"), ("flip", "FLIP"))
                       if not RIVALS[name].traces_paths
                       and (mine := one["errors"][metric]) < (theirs := preset["errors"][metric])]
    direct = [[one["scene"], RIVALS[name].title, *errors_of(one["errors"])] for name, results in drawn.items()
              for one in results if one["direct"]]
    tried = [[RIVALS[name].title, label(settings),
              *(fraction(one["errors"]["relmse"], 4) + (" (shown)" if one is best(results, one["scene"]) else "")
                for scene in scenes for one in results if one["scene"] == scene and one["settings"] == settings)]
             for name, results in drawn.items() for settings in RIVALS[name].variants]
    versions = [f"{RIVALS[name].title}: version {results[0]['version']}, on {results[0]['driver'].strip()}" for name, results in drawn.items()]
    return "\n".join([
        "All light, against path tracing by Mitsuba 3:\n", markdown(["scene", "renderer", "relMSE", "bias", "FLIP", "frame, camera moving"], rows),
        f"Presets: on {presets[0]['driver']}, {presets[0]['cpu']}. {'. '.join(versions)}.\n",
        "Where another renderer is closer to the reference than a preset:\n", "\n".join(better or ["- in none of these pictures."]) + "\n",
        "Direct light alone, against the same by Mitsuba 3:\n", markdown(["scene", "renderer", "relMSE", "bias", "FLIP"], direct),
        "relMSE of each setting that was tried:\n",
        markdown(["renderer", "settings", *scenes], tried)])


def sheet(store: Store, presets: Sequence[Result], drawn: dict[str, list[Result]]) -> bytes:
    """A JPEG: one row for each scene, and a column for path tracing, each preset and each other renderer."""
    scenes = list(dict.fromkeys(one["scene"] for one in presets))
    rows = []
    for scene in scenes:
        cells = [("Mitsuba 3", read_exr(ROOT / "references" / scene / "full.exr"))]
        cells += [(one["preset"], read_exr(store.pictures(f"compare-{scene}-{one['preset']}") / "gi.exr")) for one in presets
                  if one["scene"] == scene]
        cells += [(RIVALS[name].title, read_exr(store.folder / "pictures" / best(results, scene)["picture"]))
                  for name, results in drawn.items()]
        rows.append(cells)
    width, height = rows[0][0][1].shape[1], rows[0][0][1].shape[0]
    canvas = Image.new("RGB", ((width + 6) * len(rows[0]), (height + 6) * len(rows) + 26), "white")
    draw, font = ImageDraw.Draw(canvas), ImageFont.load_default(18)
    for y, cells in enumerate(rows):
        for x, (title, picture) in enumerate(cells):
            canvas.paste(shown(np.asarray(picture), None), (x * (width + 6), 26 + y * (height + 6)))
            if y == 0:
                draw.text((x * (width + 6) + 4, 2), title, "black", font)
    out = io.BytesIO()
    canvas.save(out, "JPEG", quality=90)
    return out.getvalue()


def page_with(page: str, figures: str) -> str:
    """The page with other figures between its marks."""
    if page.count(BEGIN) != 1 or page.count(END) != 1 or page.index(BEGIN) > page.index(END):
        raise Failed(f"the page has no lines '{BEGIN.strip()}' and '{END.strip()}' in this order, between which the figures belong")
    return page[:page.index(BEGIN) + len(BEGIN)] + "\n" + figures + "\n" + page[page.index(END):]


def run(asked: argparse.Namespace) -> int:
    if asked.page:
        page_with(asked.page.read_text(), "")  # fails before the long work
    scenes = [find_scene(scene) for scene in asked.scenes]
    taking_part = []
    for name in asked.rivals:
        if lacking := RIVALS[name].lacks(asked.installed):
            say(f"{RIVALS[name].title} is skipped, because it needs {' and '.join(lacking)}: eval.py compare --help says how to install it")
        else:
            taking_part.append(name)
    store = Store(asked.out)
    own = [preset_task(scene, preset) for scene in scenes for preset in asked.presets]
    theirs = {name: [task(scene, name, settings, asked.installed) for scene in scenes
                     for settings in (RIVALS[name].direct, *RIVALS[name].variants)
                     if settings != RIVALS[name].direct or any(measures.References(scene).about["light"]["irradiance"])]
              for name in taking_part}
    drawn = {name: store.run(tasks) for name, tasks in theirs.items()}
    presets = store.run(own, again=True)
    tasks = [*own, *(task for tasks in theirs.values() for task in tasks)]
    if not store.failures(tasks) and "godot" in drawn:
        shown_tasks = [task for task, one in zip(theirs["godot"], drawn["godot"]) if one is best(drawn["godot"], one["scene"])]
        store.run(shown_tasks, again=True)
        drawn["godot"] = store.run(theirs["godot"])
    if failed := store.failures(tasks):
        say(f"no tables are written, because {', '.join(failed)} failed")
        return 1
    tables = figures(presets, drawn)
    print(tables, end="")
    if asked.page and len(taking_part) < len(RIVALS):
        say(f"{asked.page} is left as it is: it needs all of {', '.join(RIVALS)}")
        return 1
    if asked.page:
        write_whole(asked.page.parent / "images/comparison.jpg", sheet(store, presets, drawn))
        write_whole(asked.page, page_with(asked.page.read_text(), tables))
    return 0
