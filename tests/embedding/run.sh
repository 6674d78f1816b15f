#!/usr/bin/env bash
# run.sh BUILD: installs the library that BUILD made, builds examples/embed against it and nothing else, and runs it
# without a window. ctest runs this.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
cmake --install "$1" --prefix "$folder/installed" >"$folder/log"
cmake -S examples/embed -B "$folder/build" -DCMAKE_PREFIX_PATH="$folder/installed" >"$folder/log"
cmake --build "$folder/build" >"$folder/log" 2>&1 || {
    cat "$folder/log"
    exit 1
}
"$folder/build/embed" --headless 1 --out "$folder/first.ppm"
"$folder/build/embed" --headless 16 --out "$folder/later.ppm"
"$folder/build/triangle" "$folder/triangle.ppm"
exec python3 tests/embedding/check.py "$folder/first.ppm" "$folder/later.ppm" "$folder/triangle.ppm" docs/embedding.md \
    examples/embed/triangle.cpp examples/embed/main.cpp
