#!/usr/bin/env bash
# Checks the format of C++ and GLSL, then runs the tests of tools/, in .venv, which is made first where it is missing. ctest
# calls this script, and counts it as two processes.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

scripts/python.sh
scripts/format.sh --check
exec .venv/bin/python -B -m pytest --quiet -p no:cacheprovider -n 2 --dist worksteal --durations=5 tests/tools "$@"
