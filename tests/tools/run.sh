#!/usr/bin/env bash
# Runs the tests of tools/ in .venv, which is made first where it is missing. ctest calls this script.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

scripts/python.sh
exec .venv/bin/python -B -m pytest --quiet -p no:cacheprovider --durations=5 tests/tools "$@"
