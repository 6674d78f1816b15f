"""check.py FIRST LATER PAGE SOURCE: two pictures of examples/embed are not black and differ as the sun has moved, and
the C++ of the page stands in the source."""

import re
import sys


def pixels(path):
    with open(path, "rb") as file:
        header, data = file.read().split(b"\n255\n", 1)
    width, height = map(int, header.split()[1:])
    assert len(data) == 3 * width * height, f"{path} is cut off"
    return data


def lines(text):
    return "\n".join(line.strip() for line in text.splitlines() if line.strip())


first, later = pixels(sys.argv[1]), pixels(sys.argv[2])
for path, data in zip(sys.argv[1:3], (first, later)):
    lit = sum(value > 16 for value in data) / len(data)
    assert lit > 0.5, f"{path}: only {100 * lit:.0f} % of it is not black"
changed = sum(abs(a - b) > 16 for a, b in zip(first, later)) / len(first)
assert changed > 0.05, f"the sun has moved, and only {100 * changed:.1f} % of the picture has changed"

with open(sys.argv[3], encoding="utf-8") as page, open(sys.argv[4], encoding="utf-8") as source:
    code = lines(source.read())
    blocks = re.findall(r"```cpp\n(.*?)```", page.read(), re.DOTALL)
assert blocks, "the page has no C++"
for block in blocks:
    assert lines(block) in code, f"this stands in the page, but not in {sys.argv[4]}:\n{block}"
