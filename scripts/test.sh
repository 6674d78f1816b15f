#!/usr/bin/env bash
# Builds and checks the Android app where there is an NDK; then builds and runs every test, plain and under the
# sanitizers. Ends with ctest's summary: of the last run, or of the first that failed.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# A few at a time: each test of a context brings its own driver threads and up to a few hundred MB of voxels.
jobs="$(nproc)"
export CTEST_PARALLEL_LEVEL="${CTEST_PARALLEL_LEVEL:-$((jobs < 4 ? jobs : 4))}"

scripts/setup.sh
scripts/apk.sh --or-skip
for preset in desktop asan; do
    scripts/build.sh "$preset"
    echo "$preset: testing"
    [[ $preset != asan ]] ||
        echo "asan: left out: accuracy, pictures and other drivers, which are the same C++ (tests/CMakeLists.txt)"
    ctest --preset "$preset" --output-on-failure
done
