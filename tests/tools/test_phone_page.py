"""tools/eval.py phone: the page of an archive that a phone could have sent. This machine's renderer stands in for the phone."""
import json
import subprocess
import sys
import tarfile

import pytest
from PIL import Image

STATE = """== before frames/mobile ==
$ dumpsys battery
  temperature: 310
$ dumpsys thermalservice
Thermal Status: 0

== after frames/mobile ==
  temperature: 385
Thermal Status: 2
"""


@pytest.fixture(scope="module")
def sent(tmp_path_factory):
    """A folder as `phone.sh all` makes it, of a phone that renders as this machine does."""
    import os

    from conftest import ROOT
    program = os.environ.get("VCT_PROGRAM")
    if not program:
        pytest.skip("VCT_PROGRAM does not name the renderer")
    folder = tmp_path_factory.mktemp("sent") / "Test_Phone-20260101-120000"
    bench = folder / "bench/thesis"
    scene = ROOT / "assets/cornell.glb"
    subprocess.run([program, "render", scene, "--preset", "thesis", "--mode", "all", "--grid", "64", "--size", "48x48", "--shadow-map",
                    "64", "--revoxelize", "--tone-map", "none", "--exposure", "1", "--out", bench, "--timings", bench / "timings.json"],
                   check=True, capture_output=True)
    screen = folder / "pictures"
    subprocess.run([program, "render", scene, "--preset", "mobile", "--mode", "gi-cone-shadow", "--size", "96x64", "--samples", "1",
                    "--out", screen], check=True, capture_output=True)
    shown = Image.open(screen / "gi-cone-shadow.png").convert("RGB")
    shown.resize((192, 128), Image.Resampling.BILINEAR).save(screen / "cornell-landscape.png")
    (screen / "gi-cone-shadow.png").unlink()
    (folder / "device").mkdir()
    (folder / "device/device.txt").write_text("[ro.soc.model]: [SM8650]\nGLES: Qualcomm, Adreno (TM) 750, OpenGL ES 3.2\n")
    (folder / "first-start").mkdir()
    (folder / "first-start/self-test.txt").write_text("I vct: self-test FAILED: driver: derivatives\n")
    (folder / "frames/mobile").mkdir(parents=True)
    rows = [f"{10 * i},{10 if i < 50 else 20},{8.5},{2 if i < 20 else 1.5},{.5 + i / 500:g}" for i in range(100)]
    (folder / "frames/mobile/frames.csv").write_text("\n".join(["end_ms,frame_ms,work_ms,divisor,headroom", *rows]) + "\n")
    (folder / "state.txt").write_text(STATE)
    stages = [{"name": "install", "passed": True, "problem": "", "seconds": 3.2},
              {"name": "bench/quality", "passed": False, "problem": "the app <ended>\nwithout a result", "seconds": 1.0}]
    (folder / "report.json").write_text(json.dumps({"version": 1, "stages": stages}))
    return folder


def page(root, archive, out, *more):
    return subprocess.run([sys.executable, "-B", root / "tools/eval.py", "phone", archive, "--out", out, *more],
                          capture_output=True, text=True, check=False)


def test_a_page_has_failures_times_frames_and_pictures(root, sent, tmp_path):
    archive = tmp_path / "sent.tar.gz"
    with tarfile.open(archive, "w:gz") as packed:
        packed.add(sent, arcname=sent.name)
    bounds = {"version": 1, "build": "", "scene": "cornell.glb", "size": [400, 400],
              "presets": {"thesis": {"gi": {"trace": 1.25, "mipmap": 0.25}}}}
    (tmp_path / "bounds.json").write_text(json.dumps(bounds))
    done = page(root, archive, tmp_path / "page", "--bounds", tmp_path / "bounds.json")
    assert done.returncode == 0, done.stdout + done.stderr
    text = done.stdout
    assert "Failed: bench/quality." in text and "the app <ended> / without a result" in text
    assert "Adreno (TM) 750" in text and "self-test FAILED: driver: derivatives" in text
    assert "| mobile | 100 | 10.0 10.0 20.0 20.0 | 8.5 | 8 | 2 1.5 | 0.50 to 0.70 | 0 -> 2, 31 -> 38.5 C |" in text
    timings = json.loads((sent / "bench/thesis/timings.json").read_text())
    trace = timings["modes"]["gi"]["steps"]["trace"]["median"]
    [row] = [line for line in text.splitlines() if line.startswith("| gi, trace |")]
    assert row.startswith(f"| gi, trace | {trace:.2f} | ") and row.endswith(" | 1.2 |")
    assert "| thesis-gi | 0/255 | 0.00 % |" in text
    [row] = [line for line in text.splitlines() if line.startswith("| screen-cornell-landscape |")]
    assert float(row.split("|")[3].strip(" %")) == 0.0, row
    html = (tmp_path / "page/index.html").read_text()
    assert "&lt;ended&gt;" in html and "http" not in html
    assert (tmp_path / "page/pictures/thesis-gi.png").is_file()


def test_a_wrong_picture_is_seen(root, sent, tmp_path):
    path = sent / "bench/thesis/gi.png"
    right = path.read_bytes()
    picture = Image.open(path).convert("RGB")
    picture.paste((255, 0, 255), (0, 0, 24, 12))
    picture.save(path)
    try:
        text = page(root, sent, tmp_path / "page").stdout
    finally:
        path.write_bytes(right)
    [row] = [line for line in text.splitlines() if line.startswith("| thesis-gi |")]
    largest, share = (float(cell.strip(" %").removesuffix("/255")) for cell in row.split("|")[2:4])
    assert largest > 100 and share > 10, row
    assert "| thesis-ao | 0/255 | 0.00 % |" in text


def test_what_is_no_archive_is_an_error(root, tmp_path):
    (tmp_path / "wrong.tar.gz").write_bytes(b"nothing")
    done = page(root, tmp_path / "wrong.tar.gz", tmp_path / "page")
    assert done.returncode == 1 and "cannot be read as an archive" in done.stderr
    assert not (tmp_path / "page").exists()
