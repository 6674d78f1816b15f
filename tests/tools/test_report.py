"""tools/report.py: the page, in a real Chromium where there is one."""
from __future__ import annotations

import io
import json
import os
import re
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from browser import ROOT, Browser, why_missing
from PIL import Image

sys.path.insert(0, str(ROOT / "tools"))

from report.pictures import Album, error_palette, error_png, picture_png  # noqa: E402

PROGRAM = Path(os.environ.get("VCT_PROGRAM", ROOT / "build/desktop/vct"))
ARROW_RIGHT, HOME = "\ue014", "\ue011"

HARD_CASES = [
    {"name": "thin wall", "what": "a wall thinner than a voxel", "right_answer": "0 behind it", "preset": "thesis",
     "measured": 0.31, "unit": "of the light leaks", "bar": 0.01, "status": "known-failure", "note": "hollow",
     "picture": "thin.png"},
    {"name": "empty scene", "what": "nothing", "right_answer": "black <b>&</b> no crash", "preset": "thesis",
     "measured": 0, "unit": "", "bar": 0, "status": "pass", "note": "", "picture": None},
]
BENCH = {"version": 1, "scene": "assets/cornell.glb", "driver": {"renderer": "a driver"}, "machine": {"cpu": "a cpu"},
         "method": {"statistic": "mean of means"},
         "tables": {"5.2": {"title": "scenes 1 to 5", "columns": ["1", "2"], "rows": [
             {"platform": "Here", "source": "measured", "values": [1.5, 20.0]},
             {"platform": "Mobile", "source": "thesis", "values": [3.0, 40.0]}]}}}


STEPS = {step: {"median": 2.5} for step in ("shadow_map", "render_data", "voxelize_mipmap", "irradiance", "trace", "total")}
PRESETS = {**BENCH, "presets": [{"preset": "thesis", "settings": {"grid": 256}, "bytes": 80e6, "modes": {"gi": STEPS}},
                                {"preset": "mobile", "settings": {"grid": 64}, "bytes": 20e6, "modes": {"gi": STEPS}}],
           "ratios": [{"of": "thesis", "over": "mobile", "bytes": 4.0,
                       "modes": {"gi": dict.fromkeys(STEPS, 12.25) | {"irradiance": None}}}]}
SWIM = {"rms": 0.0123, "p99": 0.0456}
FOUND = {"steps": [{"frames": frames, "to_converged": {"relmse": 0.01 / frames, "flip": 0.1 / frames}} for frames in (1, 2, 4)],
         "frames_until": 2}
MOTION = {"version": 1, "size": [256, 256],
          "swim": {"cornell": {"mobile": {**SWIM, "floor": {"rms": 0.001, "p99": 0.002}}, "quality": {"failed": "a <reason>"}}},
          "lag": {"cornell, sun": {"mobile": {"mean": {"relmse": 0.02, "flip": 0.03}, "worst": {"flip": 0.05}}}},
          "convergence": {"cornell": {"mobile": {"nothing": {"gi": FOUND}, "moved sun": {"gi": FOUND | {"frames_until": None}}},
                                      "quality": {"failed": "no"}}}}


def python(script: str, *arguments: object) -> subprocess.CompletedProcess[str]:
    return subprocess.run([sys.executable, str(ROOT / "tools" / script), *map(str, arguments)], capture_output=True,
                          text=True, check=False)


@pytest.fixture(scope="module")
def page(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Of a small sweep with a point that fails, hard cases and the thesis's tables."""
    if not PROGRAM.exists():
        pytest.skip("vct is not built: scripts/build.sh desktop vct")
    folder = tmp_path_factory.mktemp("report")
    swept = python("sweep.py", "--quick", "--program", PROGRAM, "--out", folder / "sweep", "--presets", "thesis",
                   "--grids", "64,128,100", "--cone-angles", "5,10", "--modes", "gi,gi-cone-shadow,ao")
    assert swept.returncode == 1, swept.stderr  # 100 is no grid.
    swept = python("sweep.py", "--quick", "--program", PROGRAM, "--out", folder / "sweep", "--presets", "mobile",
                   "--modes", "gi,gi-cone-shadow,ao")
    assert swept.returncode == 0, swept.stderr
    Image.new("RGB", (8, 8), (200, 30, 30)).save(folder / "thin.png")
    (folder / "hard.json").write_text(json.dumps(HARD_CASES))
    (folder / "bench.json").write_text(json.dumps(BENCH))
    (folder / "motion.json").write_text(json.dumps(MOTION))
    (folder / "presets.json").write_text(json.dumps(PRESETS))
    done = python("report.py", "--sweep", folder / "sweep/sweep.json", "--presets", folder / "presets.json", "--hard-cases",
                  folder / "hard.json", "--bench", folder / "bench.json", "--motion", folder / "motion.json", "--out",
                  folder / "index.html")
    assert done.returncode == 0, done.stderr
    return folder / "index.html"


@pytest.fixture(scope="module")
def browser(page: Path) -> Iterator[Browser]:
    if why := why_missing():
        pytest.skip(why)
    with Browser() as window:
        yield window


@pytest.fixture
def opened(browser: Browser, page: Path) -> Iterator[Browser]:
    """The page, fresh. Whatever a test does, the console stays empty and nothing but the page is asked for."""
    browser.console(), browser.requests()
    browser.open(page)
    yield browser
    assert browser.console() == []
    asked = [url for url in browser.requests() if not url.startswith("data:")]
    assert asked == [page.resolve().as_uri()]


def test_the_page_is_one_small_file_that_names_nothing_outside(page: Path):
    text = page.read_text()
    assert len(text) < 15e6
    addresses = set(re.findall(r"https?://[^\s\"'`<)]+", text))
    assert addresses <= {"http://www.w3.org/2000/svg"}  # The name of SVG, not an address that is asked for.
    assert str(ROOT) not in text


def test_plots_have_their_points_a_front_and_axes(opened: Browser):
    assert opened.run("return document.querySelectorAll('#plot-grid .plot').length") == 1
    # Mode gi of the thesis's preset at two grids, the cone angle is not its business; and of another preset.
    assert opened.run("return document.querySelectorAll('.plot .dot').length") == 3
    colours = opened.run("return [...document.querySelectorAll('.plot .dot')].map(d => d.getAttribute('fill'))")
    assert len(set(colours)) == 2
    assert opened.run("return document.querySelectorAll('.plot .ring').length") >= 1
    assert opened.run("return document.querySelector('.plot .front').getTotalLength() >= 0")
    assert opened.run("return document.querySelectorAll('.plot text').length") > 6
    assert opened.run("return document.querySelector('.plot .dot').getBoundingClientRect().width") > 5
    opened.run("const s = document.getElementById('plot-measure'); s.value = 'soft';"
               "s.dispatchEvent(new Event('change'))")
    assert opened.run("return document.querySelectorAll('.plot .dot').length") == 4


def test_every_error_and_time_can_be_plotted(opened: Browser):
    drawn = opened.run("""
        const counts = [];
        for (const id of ["plot-measure", "plot-metric", "plot-time", "plot-colour", "plot-shape"])
          for (const option of document.getElementById(id).options) {
            document.getElementById(id).value = option.value;
            document.getElementById(id).dispatchEvent(new Event("change"));
            counts.push(document.querySelectorAll(".plot svg").length);
          }
        return counts;""")
    assert len(drawn) > 12


def test_a_point_tells_its_numbers_and_opens_its_pictures(opened: Browser):
    opened.run("document.querySelectorAll('.plot .dot')[1].focus()")
    tip = opened.run("const tip = document.getElementById('tip'); return tip.hidden ? '' : tip.textContent")
    assert "ms" in tip and "relMSE" in tip
    key = opened.run("return document.activeElement.dataset.key")
    opened.keys(f".dot[data-key='{key}']", "\ue007")  # Enter
    assert opened.run("return document.getElementById('view-config').value") == key
    assert opened.run("return document.querySelectorAll('.plot .chosen').length") == 1


def test_the_slider_moves_by_key_and_by_pointer(opened: Browser):
    clip = "return document.getElementById('stage-over').style.clipPath"
    assert "50%" in opened.run(clip)
    opened.keys("#slider", HOME)
    assert "100%" in opened.run(clip)
    opened.keys("#slider", ARROW_RIGHT)
    assert "99.5%" in opened.run(clip)
    opened.click(".stage")  # Its middle.
    assert 49 < float(opened.run("return document.getElementById('slider').value")) < 51
    sizes = opened.run("return [...document.querySelectorAll('.stage img')].map(i => [i.complete, i.naturalWidth])")
    assert sizes == [[True, 64], [True, 64]]


def test_the_flip_shows_one_picture_then_the_other(opened: Browser):
    opened.click("[data-way=flip]")
    shown = "return [document.getElementById('stage-over').style.visibility, document.getElementById('stage-tag').textContent]"
    assert opened.run(shown) == ["hidden", "vct"]
    opened.click("#flip")
    assert opened.run(shown) == ["visible", "reference"]
    opened.keys("#flip", "f")
    assert opened.run(shown) == ["hidden", "vct"]
    opened.click("#flip-turns")
    end = time.monotonic() + 5
    while opened.run(shown)[0] == "hidden" and time.monotonic() < end:
        time.sleep(0.05)
    assert opened.run(shown)[0] == "visible"


def test_side_by_side_has_picture_reference_and_error(opened: Browser):
    opened.click("[data-way=side]")
    captions = opened.run("return [...document.querySelectorAll('.side figcaption')].map(c => c.textContent)")
    assert captions == ["vct", "reference", "error"]
    sources = opened.run("return [...document.querySelectorAll('.side img')].map(i => i.src)")
    assert len(set(sources)) == 3


def test_tables_voxels_and_facts_are_there(opened: Browser):
    text = opened.run("return document.body.innerText")
    for said in ("glFinish", "Tr cones", "I irradiance", "thesis / mobile", "12.3", "the frames that were timed", "level 0", "G-buffer depth", "together", "scenes 1 to 5", "Mobile", "40.0",
                 "software driver", "reference's own noise"):
        assert said in text, said
    facts = opened.run("return document.getElementById('facts').innerText").lower()
    for said in ("driver", "machine", "commit", "timing"):
        assert said in facts, said
    assert "--grid 100" in opened.run("return document.getElementById('failed-points').textContent")


def test_the_summary_has_a_row_for_each_preset(opened: Browser):
    rows = opened.run("return [...document.querySelectorAll('#summary-body tbody tr')].map(row => row.textContent)")
    assert len(rows) == 2 and rows[0].startswith("cornellthesis") and rows[1].startswith("mobile")
    assert "not measured" not in "".join(rows)


def test_light_over_frames_has_its_three_tables(opened: Browser):
    rows = opened.run("return [...document.querySelectorAll('#motion-body tr')].map(r => [...r.children].map(c => c.textContent))")
    steps = ["0.0100 / 0.100", "0.0050 / 0.050", "0.0025 / 0.025"]
    assert rows == [["scene", "mobile", "quality", "floor"], ["cornell", "1.2 % / 4.6 %", "failed: a <reason>", "0.1 % / 0.2 %"],
                    ["what moves", "mobile"], ["cornell, sun", "0.02000 / 0.030 (0.050)"],
                    ["scene", "preset", "from", "1", "2", "4", "frames until"], ["cornell", "mobile", "nothing", *steps, "2"],
                    ["cornell", "mobile", "moved sun", *steps, "more"], ["cornell", "quality", "failed: no", *"––––"]]


def test_hard_cases_can_be_filtered_and_cannot_inject(opened: Browser):
    shown = "return [...document.querySelectorAll('#hard-body .card')].filter(c => !c.hidden).map(c => c.dataset.status)"
    assert opened.run(shown) == ["known-failure", "pass"]
    opened.click("[data-filter=known-failure]")
    assert opened.run(shown) == ["known-failure"]
    cards = opened.run("return document.getElementById('hard-body').textContent")
    assert "0.310 of the light leaks" in cards and "black <b>&</b> no crash" in cards
    assert opened.run("return document.querySelector('#hard-body .card img').naturalWidth") == 8


def test_nothing_is_wider_than_a_phone_or_hidden_in_the_dark(opened: Browser):
    opened.size(375, 700)
    opened.dark(True)
    try:
        assert opened.run("return document.documentElement.scrollWidth") <= 375
        ground = opened.run("return getComputedStyle(document.body).backgroundColor")
        assert all(int(value) < 60 for value in re.findall(r"\d+", ground))
        dot = opened.run("const box = document.querySelector('.plot .dot').getBoundingClientRect();"
                         "return [box.left, box.right]")
        assert 0 < dot[0] < dot[1] < 375
    finally:
        opened.dark(False)
        opened.size(1280, 900)


def test_the_error_picture_is_black_where_right_and_red_where_too_bright():
    reference = np.full((2, 3, 3), 0.5)
    picture = reference * np.array([1.0, 4.0, 0.0])[None, :, None]
    pixels = np.asarray(Image.open(io.BytesIO(error_png(picture, reference))).convert("RGB"))
    right, bright, dark = pixels[0]
    assert right.tolist() == [0, 0, 0]
    assert bright[0] == 255 and bright[2] == 0 and dark[2] > 200 and dark[0] == 0
    assert len(error_palette()) == 49 * 3


def test_the_album_stays_within_its_bytes():
    album = Album(3000)
    noise = np.random.default_rng(1).random((16, 16, 3))
    kept = [album.add(str(number), lambda: picture_png(noise, 1.0, False)) for number in range(5)]
    assert kept == [True, True, False, False, False]
    assert sum(map(len, album.pictures.values())) <= 3000 and album.refused == 3


@pytest.mark.parametrize("content, said", [("{", "cannot be read"), ('{"version": 1}', "version 1"),
                                           ('{"version": 2, "points": []}', "no points")])
def test_a_bad_sweep_is_one_sentence(tmp_path: Path, content: str, said: str):
    (tmp_path / "sweep.json").write_text(content)
    done = python("report.py", "--sweep", tmp_path / "sweep.json", "--out", tmp_path / "index.html")
    assert done.returncode != 0 and said in done.stderr and "Traceback" not in done.stderr
    assert not (tmp_path / "index.html").exists()
