"""check.py FIRST LATER TRIANGLE PAGE SOURCE...: pictures of examples/embed. The first two are not black and differ as the
sun has moved; the third shows a triangle, its shadow and its light on the floor. Each piece of code of the page stands in one
of the sources."""

import re
import sys


def pixels(path):
    with open(path, "rb") as file:
        header, data = file.read().split(b"\n255\n", 1)
    width, height = map(int, header.split()[1:])
    assert len(data) == 3 * width * height, f"{path} is cut off"
    return data, width


def lines(text):
    return "\n".join(line.strip() for line in text.splitlines() if line.strip())


def check_moving(first_path, later_path):
    first, later = pixels(first_path)[0], pixels(later_path)[0]
    for path, data in ((first_path, first), (later_path, later)):
        lit = sum(value > 16 for value in data) / len(data)
        assert lit > 0.5, f"{path}: only {100 * lit:.0f} % of it is not black"
    changed = sum(abs(a - b) > 16 for a, b in zip(first, later)) / len(first)
    assert changed > 0.05, f"the sun has moved, and only {100 * changed:.1f} % of the picture has changed"


def check_triangle(path):
    data, width = pixels(path)

    def at(x, y):
        return tuple(data[3 * (y * width + x) :][:3])

    # Pixels from the top left: the floor right of the triangle, where its shadow lies, and as far to its left; then right
    # before it, and in the near corner.
    surface, shadow, mirrored, before, corner = at(320, 240), at(415, 245), at(225, 245), at(320, 288), at(40, 460)
    assert surface[0] > 3 * max(surface[1:]), f"the triangle is not red: {surface}"
    assert max(shadow) < 0.75 * min(mirrored), f"the floor is {shadow} in the shadow and {mirrored} out of it"
    redness, far = before[0] / before[1], corner[0] / corner[1]
    assert redness > 1.05 * far, f"the floor is no redder by the triangle ({before}) than far from it ({corner})"


def check_page(page_path, source_paths):
    code = []
    for path in source_paths:
        with open(path, encoding="utf-8") as source:
            code.append(lines(source.read()))
    with open(page_path, encoding="utf-8") as page:
        blocks = re.findall(r"```(?:cpp|glsl)\n(.*?)```", page.read(), re.DOTALL)
    assert blocks, "the page has no code"
    for block in blocks:
        assert any(lines(block) in text for text in code), f"this is on the page, but in none of {source_paths}:\n{block}"
    for path, text in zip(source_paths, code):
        assert any(lines(block) in text for block in blocks), f"the page has nothing of {path}"


check_moving(*sys.argv[1:3])
check_triangle(sys.argv[3])
check_page(sys.argv[4], sys.argv[5:])
