"""motion.json as Markdown."""
from __future__ import annotations

from typing import Any

Entries = dict[str, dict[str, dict[str, Any]]]  # by scene and preset


def percent(value: float) -> str:
    return f"{100 * value:.1f} %"


def presets_of(entries: Entries) -> list[str]:
    return list(dict.fromkeys(preset for scene in entries.values() for preset in scene))


def lines(head: list[str], rows: list[list[str]]) -> str:
    shown = [head, ["---"] * len(head), *rows]
    return "\n".join("| " + " | ".join(cells) + " |" for cells in shown) + "\n"


def cells(of_scene: dict[str, dict[str, Any]], presets: list[str], text: Any) -> list[str]:
    """One per preset; what failed and what was not measured say so."""
    return ["–" if preset not in of_scene else "failed" if "failed" in of_scene[preset] else text(of_scene[preset])
            for preset in presets]


def pair(value: dict[str, float]) -> str:
    return f"{percent(value['rms'])} / {percent(value['p99'])}"


def swim(entries: Entries) -> str:
    presets = presets_of(entries)
    rows = []
    for scene, of_scene in entries.items():
        floors = [entry["floor"] for entry in of_scene.values() if "floor" in entry]
        rows.append([scene, *cells(of_scene, presets, pair), pair(floors[0]) if floors else "–"])
    return ("Change of the received light per frame, camera of 1.3 pixels a frame: RMS / 99th percentile\n\n"
            + lines(["scene", *(f"`{preset}`" for preset in presets), "the measure's floor"], rows))


def lag(entries: Entries) -> str:
    presets = presets_of(entries)

    def text(entry: dict[str, Any]) -> str:
        mean, worst = entry["mean"], entry["worst"]
        return f"{mean['relmse']:.5f} / {mean['flip']:.3f} ({worst['flip']:.3f})"
    rows = [[scene, *cells(of_scene, presets, text)] for scene, of_scene in entries.items()]
    return ("Frames in motion against the still picture of their moment, after 16 frames: mean relMSE / mean FLIP (largest FLIP)"
            "\n\n" + lines(["what moves", *(f"`{preset}`" for preset in presets)], rows))


def until(found: dict[str, Any]) -> str:
    if "frames_until" not in found:
        return "–"
    return "more" if found["frames_until"] is None else str(found["frames_until"])


def convergence_row(scene: str, preset: str, case: str, found: dict[str, Any]) -> list[str]:
    steps = [step["to_converged"] for step in found["steps"]]
    return [scene, f"`{preset}`", case, *(f"{step['relmse']:.4f} / {step['flip']:.3f}" for step in steps), until(found)]


def convergence(entries: Entries) -> str:
    rows, counts = [], []
    for scene, of_scene in entries.items():
        for preset, cases in of_scene.items():
            for case, found in cases.items():
                if case == "failed":
                    rows.append([scene, f"`{preset}`", "failed"])
                    continue
                counts = [step["frames"] for step in found["gi"]["steps"]]
                rows.append(convergence_row(scene, preset, case, found["gi"]))
    width = 4 + len(counts)
    return ("Mode 4 after so many frames against its converged still picture: relMSE / FLIP; and from how many frames on that is "
            "less than a tenth of the converged one's own relMSE against path tracing, and the mean within 3 %\n\n"
            + lines(["scene", "preset", "from", *map(str, counts), "frames until"],
                    [row + ["–"] * (width - len(row)) for row in rows]))


PARTS = {"swim": swim, "lag": lag, "convergence": convergence}


def page(data: dict[str, Any]) -> str:
    """All that was measured."""
    return "\n".join(table(data[part]) for part, table in PARTS.items() if data.get(part))
