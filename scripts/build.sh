#!/usr/bin/env bash
# build.sh PRESET [TARGET]: configures and builds a preset of CMakePresets.json. Prints errors and warnings only.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

preset="$1"
target="${2:-all}"
start=$SECONDS
echo "$preset: configuring and building (minutes the first time)"
log="$(mktemp)"
trap 'rm -f "$log"' EXIT
cmake --preset "$preset" --log-level=WARNING >"$log" 2>&1 || {
    cat "$log" >&2
    exit 1
}
# Ninja's default is two jobs more than there are processors, and builds with sanitizers need much memory.
cmake --build --preset "$preset" --target "$target" --parallel "$(nproc)" -- --quiet
echo "$preset: built in $((SECONDS - start)) s"
