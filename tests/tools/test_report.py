"""tools/report.py: the page of a small sweep, read back as HTML."""
import io
import json
import subprocess
import sys
from html.parser import HTMLParser

import numpy as np
import pytest
from PIL import Image

from report.pictures import Album, error_png, picture_png

HARD_CASES = [
    {"name": "empty scene", "what": "nothing", "right_answer": "black <b>&</b> no crash", "preset": "thesis",
     "measured": 0, "unit": "", "bar": 0, "status": "pass", "note": "", "picture": None},
    {"name": "thin wall", "what": "a wall thinner than a voxel", "right_answer": "0 behind it", "preset": "thesis",
     "measured": 0.31, "unit": "of the light leaks", "bar": 0.01, "status": "known-failure", "note": "hollow",
     "picture": "thin.png"}]
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
MOTION = {"version": 1, "size": [256, 256],
          "swim": {"cornell": {"mobile": {"rms": 0.0123, "p99": 0.0456, "floor": {"rms": 0.001, "p99": 0.002}},
                               "quality": {"failed": "a <reason>"}}},
          "lag": {"cornell, sun": {"mobile": {"mean": {"relmse": 0.02, "flip": 0.03}, "worst": {"flip": 0.05}}}}}


class Page(HTMLParser):
    """The page's rows of cells, its text and the addresses that it names; every element is closed where it belongs."""

    def __init__(self, text):
        super().__init__()
        self.open, self.rows, self.addresses, self.names, self.text = [], [], [], set(), ""
        self.feed(text)
        assert self.open == []

    def handle_starttag(self, tag, attributes):
        self.names.add(tag)
        self.addresses += [value for name, value in attributes if name in ("src", "href")]
        if tag not in ("img", "meta"):
            self.open.append(tag)
        if tag == "tr":
            self.rows.append([])
        elif tag in ("td", "th"):
            self.rows[-1].append("")

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        self.text += data
        if "td" in self.open or "th" in self.open:
            self.rows[-1][-1] += data


def tool(root, script, *arguments):
    return subprocess.run([sys.executable, str(root / "tools" / script), *map(str, arguments)], capture_output=True,
                          text=True, check=False)


@pytest.fixture(scope="module")
def page(program, tmp_path_factory, pytestconfig):
    """Of a small sweep with a point that fails, and all that there can be beside it."""
    folder, root = tmp_path_factory.mktemp("report"), pytestconfig.rootpath
    for presets, more, status in (("thesis", ["--grids", "64,100"], 1), ("mobile", [], 0)):  # 100 is no grid
        swept = tool(root, "sweep.py", "--quick", "--program", program, "--out", folder / "sweep", "--presets", presets, *more)
        assert swept.returncode == status, swept.stderr
    Image.new("RGB", (8, 8), (200, 30, 30)).save(folder / "thin.png")
    given = {"hard-cases": HARD_CASES, "bench": BENCH, "presets": PRESETS, "motion": MOTION}
    for name, content in given.items():
        (folder / f"{name}.json").write_text(json.dumps(content))
    done = tool(root, "report.py", "--sweep", folder / "sweep/sweep.json", "--out", folder / "index.html",
                *(part for name in given for part in (f"--{name}", folder / f"{name}.json")))
    assert done.returncode == 0, done.stderr
    text = (folder / "index.html").read_text()
    assert str(root) not in text and len(text) < 15e6
    return Page(text)


def test_the_page_names_nothing_outside_and_has_no_script(page):
    assert page.addresses and all(address.startswith(("data:image/", "#")) for address in page.addresses)
    assert "script" not in page.names


def test_the_summary_has_each_preset_and_the_failed_point(page):
    rows = [row for row in page.rows if row[0] == "cornell" and row[1] in ("thesis", "mobile")]
    assert [row[1] for row in rows[:2]] == ["thesis", "mobile"]
    assert all(float(cell) > 0 for row in rows[:2] for cell in row[2:6])
    assert "--grid: 100 not in" in page.text and "1 failed" in page.text


def test_pictures_and_plots_are_pictures(page):
    plots = [address for address in page.addresses if address.startswith("data:image/svg+xml")]
    assert len(plots) == 7  # one for each measure
    assert sum(address.startswith("data:image/png") for address in page.addresses) == 2 * (7 + 5) + 1  # and a hard case's


def test_tables_and_facts_are_there(page):
    for said in ("glFinish", "one sample in each pixel", "software driver", "Noise of the references", "19,8"):
        assert said in page.text, said
    assert any(row[:2] == ["thesis, 64x64, 64³, 5°", "gi-cone-shadow"] and len(row) == 11 for row in page.rows)
    for row in (["Mobile (thesis)", "3.00", "40.00"], ["thesis / mobile", "12.2", "12.2", "12.2", "–", "12.2", "12.2", "4"]):
        assert row in page.rows, row


def test_light_over_frames_has_its_two_tables(page):
    for row in (["scene", "mobile", "quality", "floor"], ["cornell", "1.2 % / 4.6 %", "failed: a <reason>", "0.1 % / 0.2 %"],
                ["what moves", "mobile"], ["cornell, sun", "0.02000 / 0.030 (0.050)"]):
        assert row in page.rows, row


def test_hard_cases_start_with_failures_and_cannot_inject(page):
    assert page.text.index("thin wall: known failure") < page.text.index("empty scene: pass")
    assert "0.31 of the light leaks; bar 0.01" in page.text and "black <b>&</b> no crash" in page.text
    assert "b" not in page.names


def test_the_error_picture_is_black_where_right_and_red_where_too_bright():
    reference = np.full((2, 4, 3), 0.5)
    picture = reference * np.array([1.0, 1.04, 4.0, 0.0])[None, :, None]
    right, a_little, bright, dark = np.asarray(Image.open(io.BytesIO(error_png(picture, reference))).convert("RGB")).astype(int)[0]
    assert right.tolist() == [0, 0, 0] and a_little[0] > 80 and a_little[2] == 0
    assert bright.tolist() == [255, 255, 0] and dark[2] > 200 and dark[0] == 0


def test_the_album_stays_within_its_bytes():
    album = Album(3000)
    noise = np.random.default_rng(1).random((16, 16, 3))
    addresses = [album.address(lambda: picture_png(noise, 1.0)) for _ in range(5)]
    kept = [address for address in addresses if address]
    assert 1 <= len(kept) < 5 and sum(map(len, kept)) <= 3000
    assert (album.kept, album.refused) == (len(kept), 5 - len(kept))


@pytest.mark.parametrize("content, said", [("{", "cannot be read"), ('{"version": 1}', "version 1"),
                                           ('{"version": 2, "points": []}', "no points")])
def test_a_bad_sweep_is_one_sentence(root, tmp_path, content, said):
    (tmp_path / "sweep.json").write_text(content)
    done = tool(root, "report.py", "--sweep", tmp_path / "sweep.json", "--out", tmp_path / "index.html")
    assert done.returncode != 0 and said in done.stderr and "Traceback" not in done.stderr
    assert not (tmp_path / "index.html").exists()
