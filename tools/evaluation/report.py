"""Makes one page of all results in a folder: OUT/index.html, with its pictures in OUT/page/.

    tools/eval.py report
    tools/eval.py report --out out/judge/my

The page opens from disk, has no script and asks for nothing from outside. It shows each preset's picture beside path tracing with
its error, and light over frames.
"""
import argparse
from html import escape
from pathlib import Path
from urllib.parse import quote

from files import Failed, write_whole

from . import motion, options, pictures, render
from .progress import begin, say
from .store import Store

KINDS = {"render": "Pictures", **motion.TITLES}


def add_arguments(parser: argparse.ArgumentParser) -> None:
    options.add_store(parser)


def html_of(markdown: str) -> str:
    """The tables of the terminal as HTML, and the lines between them as paragraphs."""
    html = ""
    for block in markdown.split("\n\n"):
        rows = [line.strip("| ").split(" | ") for line in block.splitlines() if line.startswith("| ")]
        tags = ["th"] + ["td"] * len(rows)
        html += "".join(f"<p>{escape(line)}</p>" for line in block.splitlines() if not line.startswith("|"))
        html += "<table>" + "".join("<tr>" + "".join(f"<{tag}>{escape(cell.strip())}</{tag}>" for cell in row) + "</tr>"
                                    for tag, row in zip(tags, rows)) + "</table>" if rows else ""
    return html


def picture(store: Store, name: str, data: bytes) -> str:
    write_whole(store.folder / "page" / f"{name}.png", data)
    return f'<img src="page/{quote(name)}.png" alt="{escape(name)}">'


def section(store: Store, kind: str) -> str:
    results = store.results_of(kind)
    failed = "".join(f"<li>{escape(entry['name'])}: {escape(entry['failed'])}"
                     f"{'; its earlier result is kept' if 'result' in entry else ''}</li>"
                     for entry in store.entries_of(kind) if "failed" in entry)
    body = f'<ul class="fail">{failed}</ul>' if failed else ""
    if results and kind == "render":
        body += html_of(f"{render.machine(results)}\n{render.table(results)}\n{render.noise_note(results)}")
        sheets = pictures.sheets(store, results, errors=True)
        body += "".join(picture(store, scene, pictures.png(image)) for scene, image in sheets.items())
    elif results:
        body += html_of(motion.table(kind, results))
    return body


def write(store: Store, title: str) -> None:
    begin("drawing the page")
    sections = {name: section(store, kind) for kind, name in KINDS.items()}
    write_whole(store.folder / "index.html", "".join([
        '<!doctype html><html lang="en"><head><meta charset="utf-8">',
        f"<title>{escape(title)}</title><style>{(Path(__file__).parent / 'page.css').read_text()}</style></head><body>",
        f"<h1>{escape(title)}</h1><p>vct of commit {escape(store.data.get('commit', 'unknown'))}.</p>",
        *(f"<p>{escape(note)}</p>" for note in store.data.get("notes", [])),
        f"<pre>{escape(render.MEANINGS)}</pre>",
        *(f"<h2>{name}</h2>{text}" for name, text in sections.items() if text), "</body></html>\n"]))


def run(asked: argparse.Namespace) -> int:
    store = Store(asked.out)
    if not store.entries:
        raise Failed(f"{store.path} has no results yet: run tools/eval.py render first")
    write(store, "Voxel cone tracing: time and error")
    say(f"{len(store.entries)} results")
    print(asked.out / "index.html")
    return 0
