#!/usr/bin/env bash
# Judges your scene: each preset's picture, its times and its error against path tracing, on one page. Installs and builds
# what is missing. scripts/judge.sh --help lists the options.
set -euo pipefail
folder="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
for word in "$@"; do
    case "$word" in
        -h | --help) exec python3 "$folder/tools/eval.py" judge --help ;;
    esac
done
"$folder/scripts/setup.sh"
"$folder/scripts/python.sh"
source "$folder/scripts/progress.sh"
stoppable "$folder/scripts/build.sh" desktop vct
exec "$folder/.venv/bin/python" "$folder/tools/eval.py" judge "$@"
