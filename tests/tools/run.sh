#!/usr/bin/env bash
# Checks the format of C++ and GLSL, then runs the tests of tools/, in .venv, which is made first where it is missing. ctest
# calls this script, and counts it as two processes.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

scripts/python.sh
scripts/format.sh --check
pytest=(.venv/bin/python -B -m pytest --quiet -p no:cacheprovider --durations=5)
# The window's pictures are compared while light converges in time, so nothing may run beside it.
"${pytest[@]}" tests/tools/test_view.py
exec "${pytest[@]}" -n 2 --dist worksteal --ignore tests/tools/test_view.py tests/tools "$@"
