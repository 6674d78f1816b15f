"""docs/defects.md out of what the experiments gave."""
from __future__ import annotations

from typing import Any

INTRODUCTION = """\
# What the thesis's known defects cost

Made by `tools/defects.py` with the path-traced references in `references/`; do not edit by hand. Each experiment changes
one thing of the `thesis` preset (`vct render --experiment NAME`, or another scene) and leaves the rest, so that the
error of the algorithm can be told from the errors of its parts. {settings}; {driver}. Times are medians of 5 frames
in milliseconds, of this run only: a software driver's time says nothing beside another machine's, and what differs by
less than a fifth here is noise.

relMSE, bias and FLIP are of the indirect light alone against one path-traced bounce; `AO` and `shadow` are root mean
square errors against ray-cast ambient occlusion and against the visibility of a 5 degree sun.
"""

TEXTS = {
    "none": "**As published**: the `thesis` preset.",
    "coverage-opacity": "**1. A coarse voxel is opaque as soon as one child is.** Instead: as opaque as the share of "
                        "a flat surface that its children make, min(1, children / 4).",
    "rounded-mips": "**2. Colours are rounded down in each mip.** Instead: to nearest.",
    "long-shadow-steps": "**4. The shadow cone takes over 100 steps, most shorter than a voxel.** Instead: steps of "
                         "the cone's diameter, at least a voxel.",
    "near-start": "**5. Cones start 5 and 8 voxels along the normal and leave gaps.** Instead: one voxel, and samples "
                  "that touch, as the thesis's text has it.",
    "light-share": "**10. A coarse voxel shines with the mean of all its children as soon as one of them is lit.** Not in "
                   "the thesis's text; the published shader multiplies by sign(light). Instead: by light / count.",
    "second-atomic": "**8. A second image atomic per fragment.** Put back, to see what it cost.",
}
HEADER = ("| scene | relMSE | bias | FLIP | AO | shadow | V + M | trace, `gi` | trace, `gi-cone-shadow` |\n"
          "|---|---|---|---|---|---|---|---|---|\n")


def number(value: float | None, form: str = ".4f") -> str:
    return "-" if value is None else format(value, form)


def row(entry: dict[str, Any]) -> str:
    """One point of the sweep."""
    errors, modes = entry["errors"], entry["modes"]
    indirect = errors.get("indirect", {})
    steps = modes["gi-cone-shadow"]
    voxels = steps["voxelize"]["median"] + steps["mipmap"]["median"]
    return (f"| {entry['scene']} | {number(indirect.get('relmse'))} | {number(indirect.get('bias'), '+.2f')} "
            f"| {number(indirect.get('flip'), '.3f')} | {number(errors.get('ao', {}).get('rmse'), '.3f')} "
            f"| {number(errors.get('shadow', {}).get('rmse'), '.3f')} | {voxels:.1f} "
            f"| {modes['gi']['trace']['median']:.0f} | {steps['trace']['median']:.0f} |\n")


def page(sweep: dict[str, Any], experiments: list[str], red: dict[str, Any], solid: dict[str, dict[str, Any]]) -> str:
    """The whole file."""
    points = [entry for entry in sweep["points"] if entry["status"] == "done"]
    first = points[0]
    settings = f"{first['settings']['size']} pixels, {first['settings']['grid']}³ voxels, 5° shadow cone"
    driver = f"{first['driver']['renderer']} on {first['machine']['cpu']}"
    missing = [f"{entry['scene']}, {entry['settings']['experiment']}: {error['missing']}" for entry in points
               for error in entry["errors"].values() if "missing" in error]
    if missing:
        raise SystemExit("error: an error could not be measured: " + "; ".join(missing))
    text = INTRODUCTION.format(settings=settings, driver=driver)
    for experiment in experiments:
        name = "" if experiment == "none" else f" (`--experiment {experiment}`)"
        text += f"\n{TEXTS[experiment]}{name}\n\n{HEADER}"
        text += "".join(row(entry) for entry in points if entry["settings"]["experiment"] == experiment)
    text += f"""
**3. `imageAtomicMax` keeps the fragment with the largest red.** No other order was built; the Cornell box with red and
blue swapped in its materials, swapped back in the picture, shows the size of the bias: the two pictures of the indirect
light differ by relMSE {red['relmse']:.1e}, and the mean of the red channel by {red['red']:+.2%} (green
{red['green']:+.2%}, blue {red['blue']:+.2%}) where a fair choice would give 0.

**6. A degenerate triangle gave `normalize(0)`.** Cured: the geometry shader compares the components of the
unnormalised normal and drops a triangle without area; the tests hold it to that (`VoxelizerHardCases`).

**7. Objects are hollow.** The contact scene with its objects filled by nested shells closer than a voxel:

{HEADER}{row({**solid['hollow'], 'scene': 'hollow'})}{row({**solid['solid'], 'scene': 'solid'})}
**9. One struct pasted into ten files, one class for all passes.** Not measurable; `shaders/shared/layout.h` is read by
C++ and GLSL, and each pass is a file.
"""
    return text
