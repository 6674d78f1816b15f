#!/usr/bin/env python3
"""Checks the language of the repository: comments, words and links. Standard library only.

    tests/text/check_text.py    checks every file that git tracks; exit code 1 and a list where something is wrong
"""
import pathlib
import re
import subprocess
import sys

root = pathlib.Path(__file__).resolve().parents[2]

# A comment is a sentence that does not depend on the line before it.
comment_start = re.compile(r"^\s*(?://|#(?!!))+\s*(?:Of|What|Where|Whether|Which|How|Those|Likewise|And|But)\b")
commented_folders = ("jni/", "include/", "shaders/", "tests/", "tools/", "examples/", "scripts/", "cmake/")
code_suffixes = {".h", ".cpp", ".glsl", ".comp", ".frag", ".vert", ".geom", ".py", ".sh", ".cmake"}

# One term per concept (CONTRIBUTING.md): the word to avoid, its replacement, and the folders where it is avoided.
engine = ("jni/", "include/", "shaders/")
everywhere = ("",)
words = [
    (r"anew|remakes?|remade", "rebuild", everywhere),
    (r"shines?|shone", "emit, light, inject", everywhere),
    (r"settles?|settled|settling|stands? still|by and by", "converge", everywhere),
    (r"remembers?|remembered|forgets?|forgotten|forgetting", "keep in the history, invalidate", everywhere),
    (r"goes? round|lives? on", "a literal verb", everywhere),
    (r"looks? into", "gather from, trace cones to", everywhere),
    (r"made_|others_|bindOthers|drawn_", "cachedFor_, punctualLights_", engine),
    (r"hadRoom|makeRoom|withHeadRoom", "capacity, reserve", everywhere),
    (r"forgetWhatWasMade|setPoseNow|looksToAllSides|towardsBalance|memoryInChange|mostPairs", "see CONTRIBUTING.md", everywhere),
    (r"lamps?|glows?|glowing", "emitter", engine),
]
patterns = [(re.compile(rf"(?<![A-Za-z0-9_])(?:{pattern})(?![A-Za-z0-9_])", re.IGNORECASE), use, folders)
            for pattern, use, folders in words]
# Names that the words are part of: files of scenes, and options.
names = re.compile(r"lamp\.glb|lamp_|\blamp(?=[\"'`/])")

link = re.compile(r"(?<!!)\[[^\]]*\]\(([^)\s]+)\)|!\[[^\]]*\]\(([^)\s]+)\)")
heading = re.compile(r"^#+\s+(.*)$")


def comment_faults(name: str, lines: list[str]):
    if not name.startswith(commented_folders) or pathlib.Path(name).suffix not in code_suffixes:
        return
    for number, line in enumerate(lines, 1):
        if comment_start.match(line):
            yield number, "a comment is a sentence with a subject and a verb: " + line.strip()


def word_faults(name: str, lines: list[str]):
    # The changelog names what was renamed.
    if pathlib.Path(name).suffix not in code_suffixes | {".md", ".txt"} or name == "CHANGELOG.md":
        return
    active = [(pattern, use) for pattern, use, folders in patterns if name.startswith(folders)]
    for number, line in enumerate(lines, 1):
        text = names.sub("", line)
        for pattern, use in active:
            # A comment may name the thing itself ("a lamp below a ceiling"); code and messages use the term.
            if use == "emitter":
                text = text.partition("//")[0]
            if found := pattern.search(text):
                yield number, f'"{found.group()}": write {use}: {line.strip()}'


def anchors(markdown: str) -> set[str]:
    """The anchors of a page's headings, as GitHub makes them."""
    found = set()
    for line in markdown.splitlines():
        if match := heading.match(line):
            text = re.sub(r"[^\w\- ]", "", match.group(1).lower())
            found.add(text.replace(" ", "-"))
    return found


def link_faults(name: str, lines: list[str]):
    if not name.endswith(".md"):
        return
    folder = (root / name).parent
    for number, line in enumerate(lines, 1):
        for match in link.finditer(line):
            target = match.group(1) or match.group(2)
            if re.match(r"[a-z]+:", target):
                continue
            path, _, anchor = target.partition("#")
            file = (folder / path).resolve() if path else root / name
            if not file.exists():
                yield number, f"dead link: {target}"
            elif anchor and file.suffix == ".md" and anchor not in anchors(file.read_text()):
                yield number, f"no such heading: {target}"


def faults(name: str, text: str):
    lines = text.splitlines()
    for rule in (comment_faults, word_faults, link_faults):
        yield from rule(name, lines)


def main() -> int:
    listed = subprocess.run(["git", "ls-files", "-z"], cwd=root, check=True, capture_output=True, text=True).stdout
    count = 0
    for name in filter(None, listed.split("\0")):
        if name == "tests/text/check_text.py" or not (root / name).is_file():
            continue
        try:
            text = (root / name).read_text()
        except UnicodeDecodeError:
            continue
        for number, fault in faults(name, text):
            print(f"{name}:{number}: {fault}")
            count += 1
    print(f"{count} faults" if count else "comments, words and links: no faults")
    return 1 if count else 0


if __name__ == "__main__":
    sys.exit(main())
