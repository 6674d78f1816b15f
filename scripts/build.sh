#!/usr/bin/env bash
# build.sh PRESET [TARGET]: configures and builds a preset of CMakePresets.json and prints only what goes wrong.
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
# Not Ninja's own default of one job more than there are processors and two: the sanitizers take memory.
cmake --build --preset "$preset" --target "$target" --parallel "$(nproc)" -- --quiet
echo "$preset: built in $((SECONDS - start)) s"
