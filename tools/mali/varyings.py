"""A vertex shader in the place of vertex and geometry shader, which panfrost cannot compile."""
from __future__ import annotations

import re

OUTPUT = re.compile(r"^(flat )?out (?P<type>float|vec[234]) (?P<name>\w+);")


def passing_vertex_shader(geometry: str) -> str:
    """Writes what the geometry shader's source declares as outputs, each from an attribute.

    Preprocessor lines stay, so that each variant passes what its own fragment shader reads.
    """
    preamble = geometry[:geometry.index("#line")]  # version, precisions and the variant's defines
    head = [line for line in preamble.splitlines() if not line.startswith("#extension")]
    body = geometry[geometry.index("layout(triangles) in;"):]
    declarations, statements = [], []
    number = 0
    for line in body[:body.index("void main()")].splitlines():
        if line.startswith("#"):
            declarations.append(line)
            statements.append(line)
        elif output := OUTPUT.match(line):
            number += 1  # no two the same: the linker would make one of them
            declarations.append(line)
            statements.append(f"    {output['name']} = {output['type']}(vertex * {number}.5);")
    if not number:
        raise ValueError("the geometry shader declares no outputs")
    return "\n".join([*head, "layout(location = 0) in vec4 vertex;", *declarations, "void main() {",
                      "    gl_Position = vertex;", *statements, "}", ""])
