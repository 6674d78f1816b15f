"""HTML from Python: text is escaped, and what is HTML already is not."""
from __future__ import annotations

from collections.abc import Iterable, Sequence
from html import escape
from pathlib import Path


class Html(str):
    """Text that is HTML."""


def join(parts: Iterable[object]) -> Html:
    """None says nothing."""
    return Html("".join(part if isinstance(part, Html) else escape(str(part)) for part in parts if part is not None))


def tag(name: str, *children: object, **attributes: str) -> Html:
    """`class_` is the attribute `class`."""
    inside = "".join(f' {key.rstrip("_")}="{escape(value)}"' for key, value in attributes.items())
    return Html(f"<{name}{inside}>{join(children)}</{name}>")


def image(source: str, what: str, css_class: str | None = None) -> Html:
    return Html(f'<img src="{escape(source)}" alt="{escape(what)}"' + (f' class="{escape(css_class)}"' if css_class else "") + ">")


def table(head: Sequence[object], rows: Iterable[Sequence[object]]) -> Html:
    """The first cell of each row names it."""
    return tag("div", tag("table", tag("thead", tag("tr", *(tag("th", cell) for cell in head))),
                          tag("tbody", *(tag("tr", tag("th", first), *(tag("td", cell) for cell in cells))
                                         for first, *cells in rows))), class_="table")


def document(title: str, *body: object) -> str:
    """A whole page in the report's style, without scripts: its pictures are in it, or in its folder."""
    return "<!doctype html>\n" + tag(
        "html",
        tag("head", Html('<meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">'
                         '<meta http-equiv="Content-Security-Policy" content="default-src \'none\'; img-src \'self\' file: data:; '
                         'style-src \'unsafe-inline\'">'),
            tag("title", title), tag("style", Html((Path(__file__).parent / "style.css").read_text()))),
        tag("body", tag("h1", title), *body), lang="en")


def details(summary: object, *children: object, opened: bool = False) -> Html:
    return tag("details", tag("summary", summary), *children, **({"open": ""} if opened else {}))
