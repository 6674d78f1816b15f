#!/usr/bin/env bash
# Formats C++ and GLSL by .clang-format; with --check changes nothing, lists what differs, and fails if anything does.
# clang-format is the one of tools/requirements.txt, in .venv: another version breaks lines elsewhere.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

case "${1:-}" in
    "") action=(-i) ;;
    --check) action=(--dry-run -Werror) ;;
    *)
        echo "format: error: '$1' is unknown; scripts/format.sh [--check]" >&2
        exit 2
        ;;
esac
[[ -x .venv/bin/clang-format ]] || scripts/python.sh
git ls-files -z -- '*.h' '*.cpp' | xargs -0 .venv/bin/clang-format "${action[@]}"
# The order of includes matters in a shader.
git ls-files -z -- '*.glsl' '*.comp' '*.frag' '*.vert' '*.geom' |
    xargs -0 .venv/bin/clang-format --sort-includes=0 "${action[@]}"
